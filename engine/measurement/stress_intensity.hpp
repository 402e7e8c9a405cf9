#pragma once

#include "engine/measurement/near_tip.hpp"

#include <array>
#include <optional>
#include <vector>

namespace rift::measurement {

/// Stress intensities of a field of displacements.
struct StressIntensity {
  double opening = 0, sliding = 0;  // K_I, K_II [Pa m^1/2]
  double release_rate = 0;          // [J/m2], of the two
  double misfit = 0;                // rms of what the fit leaves over rms of what it explains beyond a shift
  double ahead = 0;                 // of the field's tip from where the places are relative to [m]
  int points = 0;                   // that were fitted
};

/// What is fitted, and where.
struct IntensityFit {
  double inner = 0, outer = 0;  // radii around the tip [m]
  double beside_faces = 0;      // what is nearer to the faces is left out [m]
  int terms = 6;                // of each mode beyond the shifts
};

/// Least squares of the terms of NearTip: all that the displacements hold, turns and the stress along the
/// crack among it. Nothing where fewer points than three times the unknowns lie between the radii.
/// @param[in] from_tip     N places relative to the tip, x ahead [m]
/// @param[in] displacement N, in the same axes [m]
std::optional<StressIntensity> fit_intensity(const NearTip& field,
                                             const std::vector<Eigen::Vector2d>& from_tip,
                                             const std::vector<Eigen::Vector2d>& displacement,
                                             const IntensityFit& fit);

/// The same with the tip where the misfit is the least, within `reach` behind and ahead of where the places
/// are relative to [m], to some hundredth of it: a crack's field has its tip somewhere in its damage zone.
/// Nothing where the least misfit is at an end.
std::optional<StressIntensity> locate_intensity(const NearTip& field,
                                                const std::vector<Eigen::Vector2d>& from_tip,
                                                const std::vector<Eigen::Vector2d>& displacement,
                                                const IntensityFit& fit, const std::array<double, 2>& reach);

}  // namespace rift::measurement

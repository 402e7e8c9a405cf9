#pragma once

#include "engine/theory/wave_speeds.hpp"

#include <Eigen/Core>

#include <array>
#include <optional>
#include <vector>

namespace rift::measurement {

/// An isotropic plate as what is around a tip that runs through it sees it.
struct ElasticPlate {
  double young_modulus = 0, poisson_ratio = 0;  // [Pa]
  double density = 0;                           // [kg/m3]
  theory::Plane plane = theory::Plane::stress;
};

enum class Mode { opening, sliding };

/// The n-th term of the displacement around a tip that runs steadily along x with free faces, u ~ r^(n/2)
/// [Nishioka and Atluri 1983, from the potentials of Freund 1990, ch. 4]. With beta_1^2 = 1 - (v/c_d)^2,
/// beta_2^2 = 1 - (v/c_s)^2, r_k e^(i theta_k) = x + i beta_k y and
/// c_k, s_k = r_k^(n/2) (cos, sin)(n theta_k / 2), it is of opening
///
///   u_x = B (c_1 - h c_2),  u_y = B (- beta_1 s_1 + (h / beta_2) s_2),  h = h_I for odd n, h_II for even n
///
/// and of sliding
///
///   u_x = B (s_1 - h s_2),  u_y = B (beta_1 c_1 - (h / beta_2) c_2),  h = h_II for odd n, h_I for even n
///
/// with h_I = 2 beta_1 beta_2 / (1 + beta_2^2), h_II = (1 + beta_2^2) / 2, scaled so that n = 1 is the
/// displacement [m] per K_I or K_II = 1 Pa m^1/2. n = 0 is a shift, 2 in sliding a turn, 2 in opening the
/// stress along the crack.
class NearTip {
 public:
  /// @param[in] speed  of the tip [m/s], below the Rayleigh speed (asserted). Below 0.05 c_s the field is
  /// that of 0.05 c_s, which differs by some 1e-3 of it: at rest the two potentials fall together.
  NearTip(const ElasticPlate& plate, double speed);

  Eigen::Vector2d displacement(Mode mode, int term, const Eigen::Vector2d& from_tip) const;

  /// G of the stress intensities [J/m2, Pa m^1/2]: (A_I K_I^2 + A_II K_II^2) / E'   [Freund 1990, 5.3]
  double release_rate(double k_opening, double k_sliding) const;

 private:
  double beta1_, beta2_, shear_modulus_, rayleigh_;  // the last: D = 4 beta1 beta2 - (1 + beta2^2)^2
};

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

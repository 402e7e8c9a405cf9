#pragma once

#include "engine/base/numbers.hpp"
#include "engine/claims/claims.hpp"

#include <cmath>
#include <vector>

/// Findings beyond the paper: the damage zone that agrees best, the energy that the lattice itself takes, and
/// Broberg's own problem   [model.md §9].
namespace rift::claims {

/// One relaxation and damage zone in the paper's plate, at several velocities.
struct MapCell {
  double relaxation = 0, zone = 0;         // p and r_l
  std::vector<double> v, ratio, distance;  // |ratio - Broberg|
  double wall_s = 0;                       // of all its scenarios
};
std::vector<MapCell> map_of(const Evidence& evidence);

/// Ratio of the steady strip at a velocity, one entry per specimen.
struct EfficiencyPoint {
  double v = 0;
  std::vector<double> ratio, along;  // and its scatter along the window
};
std::vector<EfficiencyPoint> efficiency(const Evidence& evidence, double relaxation, double zone);

/// Lengths of the damage zones of the strip, ascending [mean radii].
std::vector<double> zones_of(const Evidence& evidence);

/// Share of the wake's kinetic energy, rotation counted in, in motion of one size: within cells of this side
/// [mean radii], but of smaller ones as wholes   [Wake]. The last is all larger motion.
struct WakeBand {
  double cell = 0, share = 0;
};
std::vector<WakeBand> wake_bands(const SummaryRow& row);

/// Broberg's own problem at one velocity, zone and number of elements, the mean over its specimens, beside
/// the efficiency of the strip there (NaN: none).
struct BrobergProblem {
  double v = 0, zone = 0, elements = 0;
  double radius_m = 0, half_length_m = 0;  // in the middle of the window
  double broberg = 0;
  std::vector<double> ratio;  // of each specimen
  double efficiency = NAN, efficiency_scatter = NAN;

  double over_efficiency() const { return base::mean_of(ratio) / efficiency; }
};
std::vector<BrobergProblem> broberg_problem(const Evidence& evidence);

/// Ratio over efficiency, from two sizes straight on to R / a = 0. The scatter is what the specimens' scatter
/// makes of it, relative; where there is one specimen of a size it is taken to scatter as the others.
struct Extrapolated {
  double v = 0, zone = 0, limit = 0, broberg = 0, scatter = 0;
};
std::vector<Extrapolated> extrapolated(const std::vector<BrobergProblem>& points);

/// The findings, in the form of claims.
std::vector<Claim> beyond_the_paper();

}  // namespace rift::claims

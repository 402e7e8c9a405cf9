#pragma once

#include "engine/claims/claims.hpp"

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

/// The findings, in the form of claims.
std::vector<Claim> beyond_the_paper();

}  // namespace rift::claims

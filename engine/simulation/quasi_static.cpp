#include "engine/simulation/quasi_static.hpp"

#include "engine/lattice/statics.hpp"
#include "engine/lattice/stiffness.hpp"

namespace rift::simulation {
namespace {

/// Of the plate at rest with its beams as the first lane's law leaves them when the tip is at `tip` [J].
double energy_cut_to(const Prepared& p, double tip, const base::FractionTold& told) {
  const lattice::Kinematics kinematics = p.preset.scene.solver.kinematics;
  const scene::Scene::Loading& loading = p.preset.scene.loading;
  const lattice::Pull pull(p.pulled, loading.tilt, loading.shear);
  lattice::Lattice lattice = p.lattice;
  std::vector<char> present(lattice.beam.size(), 1);
  for (const fracture::Crossing& c : fracture::crossings(p.path, lattice)) {
    const double left = fracture::stiffness_left(p.lane.front().scenario.law, tip, c.position);
    present[c.beam] = left > 0.0;
    lattice::Beam& beam = lattice.beam[c.beam];
    beam.axial *= left, beam.bending *= left, beam.twist *= left;
  }
  const std::vector<lattice::Vector6> q =
      kinematics == lattice::Kinematics::linear
          ? lattice::stretched_at_rest(lattice, present, pull, told)
          : lattice::stretched_at_rest_corotational(lattice, present, pull, told);
  double energy = 0.0;
  for (std::size_t b = 0; b < present.size(); ++b)
    if (present[b]) energy += lattice::energy_of_beam(lattice, static_cast<int>(b), kinematics, q);
  return energy;
}

}  // namespace

std::vector<double> quasi_static_rates(const Prepared& p, const std::vector<double>& tip,
                                       const base::FractionTold& told) {
  const auto solving = [&](std::size_t k) -> base::FractionTold {
    return [&told, k, all = static_cast<double>(tip.size())](double done) {
      return !told || told((static_cast<double>(k) + done) / all);
    };
  };
  std::vector<double> rate;
  double before = energy_cut_to(p, tip.front(), solving(0));
  for (std::size_t k = 1; k < tip.size(); ++k) {
    const double now = energy_cut_to(p, tip[k], solving(k));
    rate.push_back((before - now) / (p.scale.thickness * (tip[k] - tip[k - 1]) * p.scale.tips));
    before = now;
  }
  return rate;
}

double quasi_static_ratio(const Prepared& p, const std::array<double, 2>& window,
                          const base::FractionTold& told) {
  const double faces = p.scale.thickness * (window[1] - window[0]) * p.scale.tips;
  const double before = energy_cut_to(p, window[0], [&](double done) { return !told || told(0.5 * done); });
  const double after =
      energy_cut_to(p, window[1], [&](double done) { return !told || told(0.5 + 0.5 * done); });
  return (before - after) / (faces * fracture::mean_g_i0(p.scale, window[0], window[1]));
}

}  // namespace rift::simulation

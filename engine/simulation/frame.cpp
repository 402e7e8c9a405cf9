#include "engine/simulation/frame.hpp"

#include <algorithm>
#include <array>
#include <utility>
#include <vector>

namespace rift::simulation {
namespace {

std::array<float, 3> narrow(const lattice::Vector6& v) {
  return {static_cast<float>(v[0]), static_cast<float>(v[1]), static_cast<float>(v[2])};
}

template <class Real>
std::vector<float> elastic_by_element(const ensemble::Ensemble<Real>& ensemble, int lane,
                                      double energy_unit) {
  const lattice::Lattice& lattice = ensemble.lattice();
  std::vector<double> factor(lattice.ends.size(), 1.0);
  for (int k = 0; k < static_cast<int>(ensemble.met().size()); ++k)
    factor[ensemble.met()[k].beam] = ensemble.factor(k, lane);
  std::vector<double> energy(lattice.centre.size(), 0.0);
  for (int b = 0; b < static_cast<int>(factor.size()); ++b) {
    if (factor[b] == 0.0) continue;
    const double half = 0.5 * factor[b] * ensemble.beam_energy(b, lane) * energy_unit;
    for (const int i : lattice.ends[b]) energy[i] += half;
  }
  return {energy.begin(), energy.end()};
}

template <class Real>
std::vector<float> damage_by_beam(const ensemble::Ensemble<Real>& ensemble, int lane) {
  std::vector<std::pair<int, float>> by_beam;
  for (int k = 0; k < static_cast<int>(ensemble.met().size()); ++k)
    by_beam.emplace_back(ensemble.met()[k].beam, static_cast<float>(ensemble.factor(k, lane)));
  std::sort(by_beam.begin(), by_beam.end());
  std::vector<float> damage;
  for (const auto& [beam, factor] : by_beam) damage.push_back(factor);
  return damage;
}

}  // namespace

template <class Real>
results::Frame frame_of(ensemble::Ensemble<Real>& ensemble, int lane, std::span<const std::string> fields,
                        const LaneUnits& units) {
  const int n = static_cast<int>(ensemble.lattice().centre.size());
  results::Frame frame;
  frame.step = ensemble.steps_done(lane);
  frame.time_s = ensemble.time(lane) * units.time;
  frame.tip_m =
      ensemble.cracking() ? ensemble.tip(lane) : ensemble.scenario(lane).history.stretch.front().position;
  for (const std::string& field : fields) {
    if (field == "displacement")
      for (int i = 0; i < n; ++i) frame.displacement.push_back(narrow(ensemble.motion(i, lane)));
    if (field == "velocity")
      for (int i = 0; i < n; ++i) frame.velocity.push_back(narrow(ensemble.velocity(i, lane) / units.time));
    if (field == "damage") frame.damage_factor = damage_by_beam(ensemble, lane);
    if (field == "energy") frame.elastic_energy = elastic_by_element(ensemble, lane, units.energy);
  }
  return frame;
}

template results::Frame frame_of(ensemble::Ensemble<double>&, int, std::span<const std::string>,
                                 const LaneUnits&);
template results::Frame frame_of(ensemble::Ensemble<float>&, int, std::span<const std::string>,
                                 const LaneUnits&);

}  // namespace rift::simulation

#include "engine/simulation/lane.hpp"

#include "engine/scene/derived.hpp"

#include <algorithm>
#include <array>
#include <limits>
#include <utility>
#include <vector>

namespace rift::simulation {
namespace {

/// Speed over a zone's length from the start on, without the rest before it.
double speed_of_lead(const history::CrackHistory& course, double start, double zone) {
  constexpr double left = 0.01;  // of the zone: the tip has left
  const double from = history::time_of_arrival(course, start + left * zone),
               to = history::time_of_arrival(course, start + zone);
  return (1.0 - left) * zone / (to - from);
}

LaneHistory measured_history(const scene::Scene& scene, double zone, const LaneUnits& units) {
  const history::CrackHistory course = scene::smoothed_history(scene).history;
  LaneHistory lane;
  if (zone > 0.0) {
    const double speed = speed_of_lead(course, scene.crack.start, zone);
    lane.lead = zone / speed;
    lane.history.stretch.push_back({0.0, scene.crack.start - zone, speed * units.time});
  }
  for (const history::CrackStretch& s : course.stretch)
    lane.history.stretch.push_back({(lane.lead + s.time) / units.time, s.position, s.speed * units.time,
                                    s.acceleration * units.time * units.time});
  return lane;
}

}  // namespace

LaneHistory lane_history(const scene::Scene& scene, double zone, double rayleigh_speed,
                         const LaneUnits& units) {
  if (!scene.crack.history.empty()) return measured_history(scene, zone, units);
  std::vector<history::SpeedUntil> pieces;
  for (const scene::VelocityPiece& piece : scene.crack.velocity)
    pieces.push_back({scene::speed_m_s(piece.speed, rayleigh_speed) * units.time,
                      piece.until.value_or(std::numeric_limits<double>::infinity())});
  return {history::history_of(scene.crack.start - zone, pieces)};
}

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

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

std::array<float, 3> narrow(const Eigen::Vector3d& v) {
  return {static_cast<float>(v[0]), static_cast<float>(v[1]), static_cast<float>(v[2])};
}

std::vector<float> damage_by_beam(const ensemble::Ensemble& ensemble, int lane) {
  std::vector<std::pair<int, float>> by_beam;
  for (int k = 0; k < static_cast<int>(ensemble.damageable().size()); ++k)
    by_beam.emplace_back(ensemble.damageable()[k].beam, static_cast<float>(ensemble.factor(k, lane)));
  std::sort(by_beam.begin(), by_beam.end());
  std::vector<float> damage;
  for (const auto& [beam, factor] : by_beam) damage.push_back(factor);
  return damage;
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

results::Sample sample_of(const fracture::EnergyBalance& balance) {
  results::Sample sample;
  sample.elastic_j = balance.elastic;
  sample.kinetic_translation_j = balance.kinetic_translation;
  sample.kinetic_rotation_j = balance.kinetic_rotation;
  sample.step_correction_j = balance.step_correction;
  sample.fracture_j = balance.fracture;
  sample.damping_j = balance.damping;
  sample.numerical_damping_j = balance.numerical_damping;
  sample.contact_j = balance.contact;
  sample.work_external_j = balance.work_external;
  sample.residual = balance.error;
  return sample;
}

results::Frame frame_of(ensemble::Ensemble& ensemble, int lane, std::span<const std::string> fields) {
  const int n = static_cast<int>(ensemble.lattice().centre.size());
  results::Frame frame;
  frame.step = ensemble.steps_done(lane);
  frame.time_s = ensemble.time(lane);
  for (const std::string& field : fields) {
    if (field == "displacement")
      for (int i = 0; i < n; ++i) frame.displacement.push_back(narrow(ensemble.motion(i, lane).head<3>()));
    if (field == "velocity")
      for (int i = 0; i < n; ++i) frame.velocity.push_back(narrow(ensemble.velocity(i, lane).head<3>()));
    if (field == "rotation")
      for (int i = 0; i < n; ++i) frame.rotation.push_back(narrow(ensemble.motion(i, lane).tail<3>()));
    if (field == "damage") frame.damage_factor = damage_by_beam(ensemble, lane);
    if (field == "energy") {
      const std::vector<double> energy = ensemble.elastic_by_element(lane);
      frame.elastic_energy.assign(energy.begin(), energy.end());
    }
  }
  return frame;
}

}  // namespace rift::simulation

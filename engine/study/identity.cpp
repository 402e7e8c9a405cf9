#include "engine/study/identity.hpp"

#include "engine/ensemble/instruction_set.hpp"
#include "engine/history/crack_history.hpp"
#include "engine/scene/derived.hpp"
#include "engine/scene/parameters.hpp"
#include "engine/scene/scenarios.hpp"
#include "engine/simulation/schedule.hpp"

#include <fmt/format.h>

#define XXH_INLINE_ALL
#include <xxhash.h>

#include <algorithm>
#include <limits>
#include <vector>

namespace rift::study {
namespace {

/// How a scene is shown says nothing of its numbers.
std::string text_without_film(scene::Scene scene) {
  scene.film = scene::default_scene().film;
  return scene::preset_text(scene);
}

}  // namespace

std::string hash_text(std::string_view text) {
  return fmt::format("{:016x}", XXH3_64bits(text.data(), text.size()));
}

std::vector<scene::Scene> scenes_of_study(const scene::Preset& preset) {
  std::vector<scene::Scene> scenes;
  for (const scene::StudyRow& row : preset.study) {
    scenes.push_back(row.scene);
    scenes.back().output.frames = 0;
  }
  return scenes;
}

scene::StudyRow study_row_of(const scene::Scene& scene) {
  scene::StudyRow row{scene, {}};
  for (const scene::Axis& axis : scene::axes())
    row.axes.emplace_back(axis.name, scene::axis_text(scene, axis));
  return row;
}

std::string result_key(const scene::Scene& scene, const std::string& version) {
  return fmt::format("{}\nversion {}\ninstruction set {}\n", text_without_film(scene), version,
                     ensemble::name_of(ensemble::instruction_set()));
}

std::string study_hash(const scene::Preset& preset) {
  std::string text = "version " RIFT_VERSION "\n";
  for (const scene::Scene& scene : scenes_of_study(preset)) text += text_without_film(scene);
  return hash_text(text);
}

namespace {

constexpr double beams_per_element = 3.0;
constexpr double critical_radii = 0.63;        // critical step x c_r / R
constexpr double preparation_steps = 10000.0;  // packing and static solve last as long as so many steps

double crack_time(const scene::Scene& scene) {
  if (!scene.crack.history.empty())
    return history::time_of_arrival(scene::smoothed_history(scene).history, scene::crack_end(scene));
  std::vector<history::SpeedUntil> pieces;
  for (const scene::VelocityPiece& piece : scene.crack.velocity)
    pieces.push_back({scene::speed_m_s(piece.speed, scene::rayleigh_speed(scene)),
                      piece.until.value_or(std::numeric_limits<double>::infinity())});
  return history::time_of_arrival(
      history::history_of(scene.crack.start - scene::expected_zone_m(scene), pieces),
      scene::crack_end(scene));
}

double estimated_step(const scene::Scene& scene) {
  if (scene.solver.dt) return *scene.solver.dt;
  const double critical =
      critical_radii * scene::expected_mean_radius_m(scene) / scene::rayleigh_speed(scene);
  if (scene.solver.dt_fraction) return *scene.solver.dt_fraction * critical;
  return simulation::default_step(critical, scene::expected_zone_m(scene),
                                  scene::highest_velocity(scene) * scene::rayleigh_speed(scene));
}

}  // namespace

Length estimated_length(const scene::Scene& scene) {
  const double step = estimated_step(scene);
  double steps = crack_time(scene) / step;
  if (scene.loading.method == scene::LoadingMethod::ramp)
    steps += scene.loading.ramp_steps + scene.loading.hold_steps;
  return {step, static_cast<std::int64_t>(std::min(steps, simulation::most_steps))};  // more are refused
}

double estimated_step_cost(const scene::Scene& scene) {
  const double damping = scene.damping.region == scene::DampingRegion::all       ? 4.0
                         : scene.damping.region == scene::DampingRegion::surface ? 1.5
                                                                                 : 1.0;
  const double turning = scene.solver.kinematics == lattice::Kinematics::corotational ? 3.5 : 1.0;
  return damping * turning * beams_per_element * scene.specimen.elements;
}

double estimated_cost(const scene::Scene& scene) {
  return estimated_step_cost(scene) * static_cast<double>(estimated_length(scene).steps);
}

double estimated_preparation(const scene::Scene& scene) {
  return beams_per_element * scene.specimen.elements * preparation_steps;
}

}  // namespace rift::study

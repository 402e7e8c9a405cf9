#include "engine/study/cost.hpp"

#include "engine/history/crack_history.hpp"
#include "engine/scene/derived.hpp"
#include "engine/simulation/schedule.hpp"
#include "engine/simulation/time_step.hpp"

#include <algorithm>
#include <limits>
#include <vector>

namespace rift::study {
namespace {

constexpr double beams_per_element = 3.0;
constexpr double critical_radii = 0.63;        // critical step x c_r / R
constexpr double preparation_steps = 10000.0;  // packing and static solve last as long as so many steps

double crack_time(const scene::Scene& scene) {
  if (!scene.crack.history.empty())
    return history::time_of_arrival(scene::measured_course(scene).history, scene::crack_end(scene));
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

#include "engine/simulation/prepare.hpp"

#include "engine/calibration/calibrate.hpp"
#include "engine/interrupted.hpp"
#include "engine/lattice/cached_packing.hpp"
#include "engine/lattice/stiffness.hpp"
#include "engine/mechanics/statics.hpp"
#include "engine/scene/derived.hpp"
#include "engine/simulation/change_lane.hpp"
#include "engine/simulation/lane_history.hpp"
#include "engine/theory/griffith.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <functional>
#include <span>
#include <utility>

namespace rift {
namespace {

using Clock = std::chrono::steady_clock;

double seconds_since(Clock::time_point start) {
  return std::chrono::duration<double>(Clock::now() - start).count();
}

void tell(const StageProgress& progress, std::string_view stage, double done) {
  if (progress && !progress(stage, done)) throw Interrupted(std::string(stage));
}

std::vector<Vector6> cached_motions(const std::string& key, std::size_t elements, Cache& cache,
                                    bool& from_cache, const std::function<std::vector<Vector6>()>& solve) {
  std::vector<Vector6> q(elements);
  if (const auto numbers = recall(cache, "statics", key); numbers && numbers->size() == 6 * elements) {
    for (std::size_t i = 0; i < elements; ++i) q[i] = Eigen::Map<const Vector6>(numbers->data() + 6 * i);
    return q;
  }
  from_cache = false;
  q = solve();
  remember(cache, "statics", key, {q.front().data(), 6 * elements});
  return q;
}

MicroMaterial reference_micro(const Preset& preset, Cache& cache, const StageProgress& progress) {
  const Scene& scene = preset.scene;
  const Scene::Material& m = scene.material;
  if (m.stiffness == StiffnessChoice::explicit_values)
    return {*m.micro_young_modulus, *m.micro_poisson_ratio, *m.micro_radius_ratio};
  if (m.stiffness != StiffnessChoice::calibrated) return bulk_micro_material;
  try {
    return calibrate(scene, m.young_modulus, m.poisson_ratio, cache,
                     [&](double done) { return !progress || progress("calibration", done); })
        .micro;
  } catch (const OutOfReach& error) {
    throw InputError({issue_at(preset, "material.poisson_ratio", error.what())});
  } catch (const PackingError& error) {
    throw InputError({issue_at(preset, "calibration.elements", error.what())});
  }
}

/// Whether the beams' modulus is scaled to the specimen's own.
bool is_scaled(const Scene& scene) {
  return scene.material.stiffness == StiffnessChoice::in_situ ||
         scene.material.stiffness == StiffnessChoice::bulk;
}

/// What the clamped strip of a continuum with the preset's E and nu would show [Pa].
double continuum_strip_modulus(const Scene& scene) {
  const double nu = scene.material.poisson_ratio;
  return scene.material.young_modulus / (1.0 - nu * nu);
}

std::vector<Vector6> scaled(const std::vector<Vector6>& unit, double displacement) {
  std::vector<Vector6> q(unit);
  for (Vector6& v : q) v *= displacement;
  return q;
}

double energy_of_all(const Lattice& lattice, Kinematics kinematics, const std::vector<char>& present,
                     const std::vector<Vector6>& q) {
  double energy = 0.0;
  for (std::size_t b = 0; b < lattice.beam.size(); ++b)
    if (present[b]) energy += energy_of_beam(lattice, static_cast<int>(b), kinematics, q);
  return energy;
}

void build_specimen(Prepared& p, Cache& cache, const StageProgress& progress) {
  const Scene& scene = p.preset.scene;
  const auto start = Clock::now();
  const PackingRequest request = request_of(scene);
  const auto refuse = [&](const char* key, const PackingError& error) {
    return InputError({issue_at(p.preset, key, error.what())});
  };
  Packing packing;
  try {
    packing = cached_packing(request, cache, p.packing_from_cache,
                             [&](double done) { return !progress || progress("packing", done); });
  } catch (const PackingError& error) {
    throw refuse(scene.specimen.solid_fraction ? "specimen.solid_fraction" : "specimen.coordination", error);
  }
  try {
    p.specimen = make_plate(packing, request.box, scene.specimen.contact_tolerance);
  } catch (const PackingError& error) {
    throw refuse("specimen.elements", error);
  }
  p.wall_packing_s = seconds_since(start);
}

/// Solutions of the statics, each known by all that it depends on. All stiffnesses carry the same factor
/// E_mu, so E_mu is not among it and all are solved with the same one, to the same bits; the linear ones are
/// for 1 m and serve any displacement.
struct Statics {
  const Lattice lattice;
  const Scene& scene;
  Cache& cache;
  bool& from_cache;
  std::string lattice_key;

  std::vector<Vector6> unit(const std::vector<char>& present, const std::string& notch,
                            const Pull& pull = {1.0}) {
    return cached_motions("statics 2 of " + lattice_key + notch + key_of(pull), lattice.centre.size(), cache,
                          from_cache, [&] { return stretched_at_rest(lattice, present, pull); });
  }
  std::vector<Vector6> at_rest(const std::vector<char>& present, const std::string& notch,
                               double displacement) {
    const Scene::Loading& l = scene.loading;
    if (scene.solver.kinematics == Kinematics::linear)
      return scaled(unit(present, notch, {1.0, l.tilt, l.shear}), displacement);
    const Pull pull(displacement, l.tilt, l.shear);
    const std::string key = fmt::format("corotational statics 1 of {}{} by {:a}{}", lattice_key, notch,
                                        pull.middle, key_of(pull));
    return cached_motions(key, lattice.centre.size(), cache, from_cache,
                          [&] { return stretched_at_rest_corotational(lattice, present, pull); });
  }
  /// What of a pull is not along y and even.
  static std::string key_of(const Pull& pull) {
    std::string key;
    if (pull.tilt != 0.0) key += fmt::format(" tilt {:a}", pull.tilt);
    if (pull.shear != 0.0) key += fmt::format(" shear {:a}", pull.shear);
    return key;
  }
};

/// The displacement under which the top grip pulls with a force [N], by secants from the linear one: a
/// lattice of any kinematics is nearly linear between grips. Throws StaticsError.
/// @param[in] lattice  with the beams' own modulus
double displacement_under(double force, Statics& statics, const Lattice& lattice,
                          const std::vector<char>& present, const std::string& notch) {
  constexpr int most = 20;
  constexpr double good = 1e-10;  // of the force
  const Scene::Loading& l = statics.scene.loading;
  const double unit_force =
      grip_force(lattice, present, Kinematics::linear, statics.unit(present, notch, {1.0, l.tilt, l.shear}));
  if (!(unit_force > 0.0))
    throw StaticsError(l.shear != 0.0
                           ? "no displacement with this loading.shear pulls: the plate turns the other way"
                           : "the notch leaves the grips nothing to pull");
  double displacement = force / unit_force;
  const Kinematics kinematics = statics.scene.solver.kinematics;
  if (kinematics == Kinematics::linear) return displacement;
  for (int k = 0; k < most; ++k) {
    const double pull =
        grip_force(lattice, present, kinematics, statics.at_rest(present, notch, displacement));
    if (std::abs(pull - force) <= good * std::abs(force)) return displacement;
    displacement *= force / pull;
  }
  throw StaticsError(fmt::format("no displacement holds a force of {:g} N", force));
}

/// @param[in] strip  energy of the pre-stressed strip over its area [J/m2]
RateScale scale_against(const Scene& scene, const Lattice& lattice, double strip) {
  RateScale scale{.thickness = lattice.box.thickness,
                  .g_i0 = strip,
                  .length = lattice.box.length,
                  .tips = scene.crack.tips};
  if (scene.output.g_i0_reference == ReleaseRateReference::griffith) {
    const Scene::Material& m = scene.material;
    scale.g_i0 = 0.0;
    scale.g_i0_slope = theory::griffith_slope(strip, lattice.box.height, m.poisson_ratio, m.plane);
  }
  return scale;
}

/// Which beams a notch cuts, for the key of a cached solution.
std::string notch_key(const Scene& scene) {
  std::string path;
  if (scene.crack.path.point.empty())
    path = fmt::format("{:a}", path_height_m(scene));
  else
    for (const auto& [x, y] : path_points_m(scene)) path += fmt::format("({:a} {:a})", x, y);
  return fmt::format(" path {} notch {:a}{}", path, scene.crack.start,
                     scene.crack.tips == 2 ? " from the middle" : "");
}

/// Micro modulus, pre-stress and G_I0. The modulus and G_I0 belong to the strip without its notch; the
/// modulus is that of small strains with either kinematics.
void build_prestress(Prepared& p, Cache& cache, const StageProgress& progress) {
  const Scene& scene = p.preset.scene;
  const Kinematics kinematics = scene.solver.kinematics;
  const auto start = Clock::now();
  p.micro = reference_micro(p.preset, cache, progress);
  tell(progress, "pre-stress", 0.0);
  p.statics_from_cache = true;
  p.lattice = make_lattice(p.specimen, p.micro, p.density);
  Statics statics{p.lattice, scene, cache, p.statics_from_cache,
                  fmt::format("{} tolerance {:a} micro {:a} {:a} {:a}", key_of(request_of(scene)),
                              scene.specimen.contact_tolerance, p.micro.young_modulus, p.micro.poisson_ratio,
                              p.micro.radius_ratio)};
  const std::vector<char> present(p.lattice.beam.size(), 1);
  const std::vector<Vector6> unit = statics.unit(present, "");
  if (is_scaled(scene)) {
    p.micro.young_modulus *= continuum_strip_modulus(scene) / strip_modulus(p.lattice, unit, 1.0);
    p.lattice = make_lattice(p.specimen, p.micro, p.density);
  }
  p.strip_modulus = strip_modulus(p.lattice, unit, 1.0);
  std::vector<char> notched(present);
  std::string notch;
  if (scene.crack.start > 0.0) {
    for (const Crossing& c : crossings(p.path, p.lattice))
      if (c.position <= scene.crack.start) notched[c.beam] = 0;
    notch = notch_key(scene);
  }
  const std::optional<double> force = force_at_start(scene);
  p.pulled =
      force ? displacement_under(*force, statics, p.lattice, notched, notch) : displacement_at_start(scene);
  p.displacement = statics.at_rest(present, "", p.pulled);
  p.scale = scale_against(scene, p.lattice,
                          energy_per_length(p.lattice, kinematics, p.displacement) / p.lattice.box.thickness);
  if (!notch.empty()) p.displacement = statics.at_rest(notched, notch, p.pulled);
  p.grip_force = grip_force(p.lattice, notched, kinematics, p.displacement);
  p.static_energy = energy_of_all(p.lattice, kinematics, notched, p.displacement);
  if (scene.loading.method == LoadingMethod::ramp)
    p.displacement.assign(p.displacement.size(), Vector6::Zero());
  p.wall_prestress_s = seconds_since(start);
  tell(progress, "pre-stress", 1.0);
}

/// Where the preset says how the plate is loaded.
const char* load_key(const Scene& scene) {
  if (!scene.loading.curve.row.empty()) return "loading.curve";
  return scene.loading.force ? "loading.force" : "loading.displacement";
}

CrackPath path_of(const Scene& scene) {
  CrackPath path{{}, scene.crack.tips};
  for (const auto& [x, y] : path_points_m(scene)) path.point.emplace_back(x, y);
  return path;
}

/// A gauge that the crack would tear shows an opening, not a strain.
std::vector<Gauge> gauges_of(const Prepared& p) {
  const Scene::Output& output = p.preset.scene.output;
  const double radius = 0.5 * output.gauge_length * p.lattice.mean_radius;
  std::vector<Eigen::Vector2d> centre;
  for (const Eigen::Vector3d& c : p.lattice.centre) centre.emplace_back(c.head<2>());
  std::vector<Gauge> gauges;
  for (const auto& [x, y] : output.gauges) {
    const auto refuse = [&](const std::string& why) {
      return InputError({issue_at(p.preset, "output.gauges",
                                  fmt::format("at ({:g} mm, {:g} mm) {}", 1e3 * x, 1e3 * y, why))});
    };
    const double away = distance_to(p.path, {x, y});
    if (away < radius)
      throw refuse(
          fmt::format("the crack runs {:g} mm away, through a gauge of {:.4g} mm (output.gauge_length)",
                      1e-3 * std::round(1e6 * away), 2e3 * radius));
    auto plane = local_plane(centre, {x, y}, radius);
    if (!plane)
      throw refuse(fmt::format("a gauge of {:g} mm (output.gauge_length) has too few elements under it",
                               2e3 * radius));
    gauges.push_back({{x, y}, std::move(*plane)});
  }
  return gauges;
}

LanePlan plan_lane(const Prepared& p, const Scene& scene) {
  LanePlan lane;
  lane.scene = scene;
  if (scene.material.stiffness == StiffnessChoice::bulk)
    lane.units = units_of(bulk_micro_material.young_modulus / p.micro.young_modulus);
  lane.crack_end = crack_end(scene);
  const double length = scene.specimen.length;
  const auto window = window_over_length(scene);
  lane.window = {window[0] * length, window[1] * length};
  lane.scenario.law = release_law(scene, p.lattice);
  auto [history, lead] = lane_history(scene, lane.scenario.law.zone_length, p.rayleigh_speed, lane.units);
  lane.scenario.history = std::move(history);
  lane.lead = lead;
  lane.scenario.friction = scene.crack.friction;
  set_damping(lane.scenario, scene);
  return lane;
}

StepWish step_wish(const LanePlan& lane, double rayleigh_speed) {
  return {.zone_length = lane.scenario.law.zone_length,
          .speed = highest_velocity(lane.scene) * rayleigh_speed * lane.units.time,
          .alpha_at_surface = lane.scenario.alpha_at_surface,
          .alpha_elsewhere = lane.scenario.alpha_elsewhere};
}

std::vector<LanePlan> planned(const Prepared& p, const std::vector<Scene>& scenes) {
  if (crossings(p.path, p.lattice).empty())
    throw InputError({issue_at(p.preset, "crack.path", "crosses no beam of this lattice")});
  std::vector<LanePlan> lanes;
  for (const Scene& scene : scenes) {
    LanePlan lane = plan_lane(p, scene);
    const std::vector<DampedBeam> damped = damped_beams(p, {&lane, 1});
    lane.beams_damped = damped.size();
    lane.step = choose_step(p.preset, p.lattice, p.stable, damped, {step_wish(lane, p.rayleigh_speed)},
                            lane.units.time);
    lanes.push_back(std::move(lane));
  }
  return lanes;
}

}  // namespace

std::vector<DampedBeam> damped_beams(const Prepared& p, std::span<const LanePlan> lanes) {
  const auto any = [&](DampingRegion region) {
    return std::any_of(lanes.begin(), lanes.end(),
                       [&](const LanePlan& lane) { return lane.scene.damping.region == region; });
  };
  std::vector<DampedBeam> damped;
  const bool everywhere = any(DampingRegion::all);
  if (!everywhere && !any(DampingRegion::surface)) return damped;
  std::vector<int> crossing(p.lattice.beam.size(), -1);
  int next = 0;
  for (const Crossing& c : crossings(p.path, p.lattice)) crossing[c.beam] = next++;
  const double near = p.preset.scene.damping.surface_width * p.lattice.mean_radius;
  std::vector<char> at_surface(p.lattice.centre.size());
  for (std::size_t i = 0; i < at_surface.size(); ++i)
    at_surface[i] = distance_to(p.path, p.lattice.centre[i].head<2>()) <= near;
  for (int b = 0; b < static_cast<int>(p.lattice.beam.size()); ++b) {
    const bool surface = at_surface[p.lattice.ends[b][0]] || at_surface[p.lattice.ends[b][1]];
    if (surface || everywhere) damped.push_back(damped_beam(p.lattice, b, crossing[b], surface));
  }
  return damped;
}

ReleaseLaw release_law(const Scene& scene, const Lattice& lattice) {
  ReleaseLaw law{.technique = scene.crack.technique, .exponent = scene.crack.relaxation};
  if (law.technique == Technique::progressive)
    law.zone_length = scene.crack.damage_zone_ratio * lattice.mean_radius;
  return law;
}

void set_damping(LaneScenario& scenario, const Scene& scene) {
  const DampingRegion region = scene.damping.region;
  scenario.alpha_at_surface = region == DampingRegion::none ? 0.0 : scene.damping.alpha;
  scenario.alpha_elsewhere = region == DampingRegion::all ? scene.damping.alpha : 0.0;
}

double lattice_speed(const Prepared& p, const Speed& speed, const LaneUnits& units) {
  return speed_m_s(speed, p.rayleigh_speed) * units.time;
}

double damped_limit(const Prepared& p, std::vector<DampedBeam> damped, std::span<const LanePlan> lanes) {
  ViscousDamping damping(std::move(damped));
  for (const LanePlan& lane : lanes) {
    damping.alpha_at_surface = std::max(damping.alpha_at_surface, lane.scenario.alpha_at_surface);
    damping.alpha_elsewhere = std::max(damping.alpha_elsewhere, lane.scenario.alpha_elsewhere);
  }
  return damped_critical_step(p.lattice, damping, p.stable.critical);
}

void take_lanes(Prepared& p, std::vector<LanePlan> lanes) {
  p.lane = std::move(lanes);
  p.damped = damped_beams(p, p.lane);
  p.step = p.lane.front().step;
  for (const LanePlan& lane : p.lane) {
    p.step.dt = std::min(p.step.dt, lane.step.dt);
    p.step.critical_damped = std::min(p.step.critical_damped, lane.step.critical_damped);
  }
  for (LanePlan& lane : p.lane)
    lane.schedule = make_schedule(lane.scene, lane.scenario.history, p.step.dt, lane.crack_end, lane.window);
}

RateScale scale_of(const Prepared& prepared, const LanePlan& lane) {
  RateScale scale = prepared.scale;
  scale.g_i0 *= lane.units.energy;
  scale.g_i0_slope *= lane.units.energy;
  return scale;
}

double wave_speed_ratio(const Prepared& prepared, const LanePlan& lane) {
  return std::sqrt(prepared.strip_modulus * lane.units.energy / continuum_strip_modulus(lane.scene));
}

Prepared prepare(const Preset& preset, const std::vector<Scene>& lanes, Cache& cache,
                 const StageProgress& progress) {
  Prepared p;
  p.preset = preset;
  const Scene& scene = p.preset.scene;
  if (!can_crack(scene))
    throw InputError(
        {issue_at(p.preset, "specimen.shape",
                  "cannot be cracked: plates and blocks are; 'rift pack' fills the other shapes, "
                  "'rift calibrate' presses cylinders")});
  p.density = density(scene);
  p.rayleigh_speed = rayleigh_speed(scene);
  p.path = path_of(scene);
  build_specimen(p, cache, progress);
  try {
    build_prestress(p, cache, progress);
  } catch (const StaticsError& error) {
    throw InputError({issue_at(p.preset, load_key(scene), error.what())});
  }
  p.gauge = gauges_of(p);
  tell(progress, "critical step", 0.0);
  p.stable = stable_step(p.lattice);
  take_lanes(p, planned(p, lanes));
  for (int k = 0; k < static_cast<int>(p.lane.size()); ++k) check_steering(p, p.lane, k, 0);
  return p;
}

Prepared prepare(const Preset& preset, Cache& cache, const StageProgress& progress) {
  return prepare(preset, {preset.scene}, cache, progress);
}

}  // namespace rift

#include "engine/simulation/prepare.hpp"

#include "engine/base/clock.hpp"
#include "engine/base/interrupted.hpp"
#include "engine/lattice/lattice.hpp"
#include "engine/lattice/loads.hpp"
#include "engine/lattice/statics.hpp"
#include "engine/packing/packing.hpp"
#include "engine/scene/derived.hpp"
#include "engine/scene/layers_note.hpp"
#include "engine/simulation/steering.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <map>
#include <set>
#include <span>
#include <string>
#include <utility>

namespace rift::simulation {
namespace {

void build_specimen(Prepared& p, base::Cache& cache, const StageProgress& progress) {
  const scene::Scene& scene = p.preset.scene;
  const auto start = base::Clock::now();
  const packing::PackingRequest request = scene::request_of(scene);
  packing::Packing packing;
  try {
    packing = packing::cached_packing(request, cache, p.packing_from_cache, stage(progress, "packing"));
  } catch (const packing::PackingError& error) {
    throw SpecimenRefused(scene::packing_issue(p.preset, error));
  }
  try {
    const auto make = scene.loading.traction ? packing::make_free_specimen : packing::make_plate;
    p.specimen = make(packing, request.box, scene.specimen.contact_tolerance);
  } catch (const packing::PackingError& error) {
    throw SpecimenRefused(scene::issue_at(p.preset, "specimen.elements", error.what()));
  }
  p.wall_packing_s = base::seconds_since(start);
}

fracture::CrackPath path_of(const scene::Scene& scene) {
  fracture::CrackPath path{{}, scene.crack.tips, scene.crack.release_order};
  for (const auto& [x, y] : scene::path_points_m(scene)) path.point.emplace_back(x, y);
  return path;
}

/// A gauge that the crack would tear shows an opening, not a strain.
std::vector<lattice::Gauge> gauges_of(const Prepared& p) {
  const scene::Scene::Output& output = p.preset.scene.output;
  const double radius = 0.5 * output.gauge_length * p.lattice.mean_radius;
  std::vector<Eigen::Vector2d> centre;
  for (const Eigen::Vector3d& c : p.lattice.centre) centre.emplace_back(c.head<2>());
  std::vector<lattice::Gauge> gauges;
  for (const auto& [x, y] : output.gauges) {
    const auto refuse = [&](const std::string& why) {
      return scene::InputError({scene::issue_at(
          p.preset, "output.gauges", fmt::format("at ({:g} mm, {:g} mm) {}", 1e3 * x, 1e3 * y, why))});
    };
    const double away = fracture::distance_to(p.path, {x, y});
    if (away < radius)
      throw refuse(
          fmt::format("the crack runs {:g} mm away, through a gauge of {:.4g} mm (output.gauge_length)",
                      1e-3 * std::round(1e6 * away), 2e3 * radius));
    auto plane = lattice::local_plane(centre, {x, y}, radius);
    if (!plane)
      throw refuse(fmt::format("a gauge of {:g} mm (output.gauge_length) has too few elements under it",
                               2e3 * radius));
    gauges.push_back({{x, y}, std::move(*plane)});
  }
  return gauges;
}

LanePlan plan_lane(const Prepared& p, const scene::Scene& scene) {
  LanePlan lane;
  lane.scene = scene;
  if (scene.material.stiffness == scene::StiffnessChoice::bulk)
    lane.units = fracture::units_of(lattice::bulk_micro_material.young_modulus / p.micro.young_modulus);
  lane.crack_end = scene::crack_end(scene);
  const double length = scene.specimen.length;
  const auto window = scene::window_over_length(scene);
  lane.window = {window[0] * length, window[1] * length};
  if (scene::breaks_freely(scene)) {
    lane.scenario.material = breaking_material(p, scene, lane.units);
    lane.scenario.load = {scene.loading.traction.value_or(0.0) / lane.units.energy,
                          scene.loading.rise_time / lane.units.time};
    return lane;
  }
  lane.scenario.law = release_law(scene, p.lattice);
  auto [history, lead] = lane_history(scene, lane.scenario.law.zone_length, p.rayleigh_speed, lane.units);
  lane.scenario.history = std::move(history);
  lane.lead = lead;
  lane.scenario.friction = scene.crack.friction;
  set_damping(lane.scenario, scene);
  return lane;
}

StepRequest step_wish(const LanePlan& lane, double rayleigh_speed) {
  return {.zone_length = lane.scenario.law.zone_length,
          .speed = scene::highest_velocity(lane.scene) * rayleigh_speed * lane.units.time,
          .critical_damped = {}};
}

/// The limits of the step without damping, from the cache or computed and remembered.
lattice::StableStep cached_stable_step(const Prepared& p, base::Cache& cache,
                                       const base::ProgressCallback& told) {
  const std::string key = "critical step 1 of " + dynamics_key(p);
  if (const auto numbers = base::recall(cache, "step", key); numbers && numbers->size() == 2)
    return {.critical = (*numbers)[0], .element_bound = (*numbers)[1]};
  const lattice::StableStep stable = lattice::stable_step(p.lattice, told);
  base::remember(cache, "step", key, std::array{stable.critical, stable.element_bound});
  return stable;
}

/// What damping leaves of the critical step, computed once for all lanes that damp alike, and kept in the
/// cache.
class DampedLimits {
 public:
  DampedLimits(const Prepared& p, base::Cache& cache) : p_(p), cache_(cache) {}
  double of(const LanePlan& lane, std::vector<lattice::DampedBeam> damped,
            const base::ProgressCallback& told) {
    const std::string key = key_of(lane.scene);
    if (const auto known = limit_.find(key); known != limit_.end()) return known->second;
    if (const auto numbers = base::recall(cache_, "step", key); numbers && numbers->size() == 1)
      return limit_[key] = numbers->front();
    const double limit = damped_limit(p_, std::move(damped), {&lane, 1}, told);
    base::remember(cache_, "step", key, {&limit, 1});
    return limit_[key] = limit;
  }

 private:
  /// Names all that the limit depends on.
  std::string key_of(const scene::Scene& scene) const {
    const scene::Scene::Damping& damping = scene.damping;
    const std::string where = damping.region == scene::DampingRegion::all
                                  ? "all"
                                  : fmt::format("{:a} of path {}{}", p_.preset.scene.damping.surface_width,
                                                path_key(p_.preset.scene),
                                                p_.preset.scene.crack.tips == 2 ? " from the middle" : "");
    return fmt::format("damped critical step 1 of {} damping {:a} in {}", dynamics_key(p_), damping.alpha,
                       where);
  }

  const Prepared& p_;
  base::Cache& cache_;
  std::map<std::string, double> limit_;
};

std::vector<LanePlan> planned(const Prepared& p, const std::vector<scene::Scene>& scenes, base::Cache& cache,
                              const base::ProgressCallback& told) {
  if (fracture::crossings(p.path, p.lattice).empty())
    throw scene::InputError({scene::issue_at(p.preset, "crack.path", "crosses no beam of this lattice")});
  std::vector<LanePlan> lanes;
  DampedLimits limits(p, cache);
  const auto plan = [&](const scene::Scene& scene) {
    LanePlan lane = plan_lane(p, scene);
    StepRequest wish = step_wish(lane, p.rayleigh_speed);
    std::vector<lattice::DampedBeam> damped = damped_beams(p, {&lane, 1});
    lane.beams_damped = damped.size();
    if (!damped.empty()) wish.critical_damped = limits.of(lane, std::move(damped), told);
    lane.step = choose_step(p.preset, p.stable, wish, lane.units.time);
    return lane;
  };
  LanesRefused::Issues refused;
  for (std::size_t k = 0; k < scenes.size(); ++k) {
    try {
      lanes.push_back(plan(scenes[k]));
    } catch (const scene::InputError& error) {
      refused[k] = error.issues;
    }
  }
  if (!refused.empty()) throw LanesRefused(std::move(refused));
  return lanes;
}

/// The issues of all lanes, each once.
std::vector<scene::Issue> each_once(const LanesRefused::Issues& of) {
  std::vector<scene::Issue> all;
  std::set<std::string> texts;
  for (const auto& [lane, issues] : of)
    for (const scene::Issue& issue : issues)
      if (texts.insert(scene::to_text(issue)).second) all.push_back(issue);
  return all;
}

}  // namespace

std::string specimen_key(const scene::Scene& scene) {
  return fmt::format("{} contacts within {:a}{}", packing::key_of(scene::request_of(scene)),
                     scene.specimen.contact_tolerance, scene.loading.traction ? " free" : "");
}

LanesRefused::LanesRefused(Issues found) : InputError(each_once(found)), of(std::move(found)) {}

std::vector<lattice::DampedBeam> damped_beams(const Prepared& p, std::span<const LanePlan> lanes) {
  const auto any = [&](scene::DampingRegion region) {
    return std::any_of(lanes.begin(), lanes.end(),
                       [&](const LanePlan& lane) { return lane.scene.damping.region == region; });
  };
  std::vector<lattice::DampedBeam> damped;
  const bool everywhere = any(scene::DampingRegion::all);
  if (!everywhere && !any(scene::DampingRegion::surface)) return damped;
  std::vector<int> crossing(p.lattice.beam.size(), -1);
  int next = 0;
  for (const fracture::Crossing& c : fracture::crossings(p.path, p.lattice)) crossing[c.beam] = next++;
  const double near = p.preset.scene.damping.surface_width * p.lattice.mean_radius;
  std::vector<char> at_surface(p.lattice.centre.size());
  for (std::size_t i = 0; i < at_surface.size(); ++i)
    at_surface[i] = fracture::distance_to(p.path, p.lattice.centre[i].head<2>()) <= near;
  for (int b = 0; b < static_cast<int>(p.lattice.beam.size()); ++b) {
    const bool surface = at_surface[p.lattice.ends[b][0]] || at_surface[p.lattice.ends[b][1]];
    if (surface || everywhere) damped.push_back(lattice::damped_beam(p.lattice, b, crossing[b], surface));
  }
  return damped;
}

fracture::ReleaseLaw release_law(const scene::Scene& scene, const lattice::Lattice& lattice) {
  fracture::ReleaseLaw law{.technique = scene.crack.technique, .exponent = scene.crack.relaxation};
  if (law.technique == fracture::Technique::progressive)
    law.zone_length = scene.crack.damage_zone_ratio * lattice.mean_radius;
  return law;
}

void set_damping(fracture::LaneScenario& scenario, const scene::Scene& scene) {
  const scene::DampingRegion region = scene.damping.region;
  scenario.alpha_at_surface = region == scene::DampingRegion::none ? 0.0 : scene.damping.alpha;
  scenario.alpha_elsewhere = region == scene::DampingRegion::all ? scene.damping.alpha : 0.0;
}

fracture::CohesiveMaterial breaking_material(const Prepared& p, const scene::Scene& scene,
                                             const LaneUnits& units) {
  fracture::CohesiveMaterial material{.law = scene.breaking.law,
                                      .release_rate = scene.breaking.release_rate.value() / units.energy,
                                      .strength = 0.0,
                                      .young_modulus = scene.material.young_modulus / units.energy,
                                      .kappa = scene.breaking.kappa};
  if (material.law == fracture::FractureLaw::cohesive)
    material.strength = std::min(scene.breaking.strength.value() / units.energy,
                                 fracture::resolved_strength(p.lattice, material));
  return material;
}

double lattice_speed(const Prepared& p, const scene::Speed& speed, const LaneUnits& units) {
  return scene::speed_m_s(speed, p.rayleigh_speed) * units.time;
}

double damped_limit(const Prepared& p, std::vector<lattice::DampedBeam> damped,
                    std::span<const LanePlan> lanes, const base::ProgressCallback& told) {
  lattice::ViscousDamping damping(std::move(damped));
  for (const LanePlan& lane : lanes) {
    damping.alpha_at_surface = std::max(damping.alpha_at_surface, lane.scenario.alpha_at_surface);
    damping.alpha_elsewhere = std::max(damping.alpha_elsewhere, lane.scenario.alpha_elsewhere);
  }
  return lattice::damped_critical_step(p.lattice, damping, p.stable.critical, told);
}

void take_lanes(Prepared& p, std::vector<LanePlan> lanes) {
  p.lane = std::move(lanes);
  p.damped = damped_beams(p, p.lane);
  p.step = p.lane.front().step;
  for (const LanePlan& lane : p.lane) {
    p.step.dt = std::min(p.step.dt, lane.step.dt);
    p.step.critical_damped = std::min(p.step.critical_damped, lane.step.critical_damped);
  }
  refuse_out_of_range(p, step_numbers(p));
  for (LanePlan& lane : p.lane)
    lane.schedule =
        scene::breaks_freely(lane.scene)
            ? schedule_of_duration(lane.scene, p.step.dt * lane.units.time)
            : make_schedule(lane.scene, lane.scenario.history, p.step.dt, lane.crack_end, lane.window);
}

fracture::RateScale scale_of(const Prepared& prepared, const LanePlan& lane) {
  fracture::RateScale scale = prepared.scale;
  scale.g_i0 *= lane.units.energy;
  scale.g_i0_slope *= lane.units.energy;
  return scale;
}

double wave_speed_ratio(const Prepared& prepared, const LanePlan& lane) {
  return std::sqrt(prepared.strip_modulus * lane.units.energy / continuum_strip_modulus(lane.scene));
}

Prepared prepare(const scene::Preset& preset, const std::vector<scene::Scene>& lanes, base::Cache& cache,
                 const StageProgress& progress) {
  Prepared p;
  p.preset = preset;
  const scene::Scene& scene = p.preset.scene;
  if (!scene::can_crack(scene))
    throw scene::InputError({scene::issue_at(p.preset, "specimen.shape",
                                             "cannot be cracked: plates and blocks are; 'rift pack' fills "
                                             "the other shapes, 'rift calibrate' compresses cylinders")});
  p.density = scene::density(scene);
  p.rayleigh_speed = scene::rayleigh_speed(scene);
  p.path = path_of(scene);
  build_specimen(p, cache, progress);
  try {
    const auto start = base::Clock::now();
    build_prestress(p, cache, progress);
    p.wall_prestress_s = base::seconds_since(start);
    base::tell_or_stop(stage(progress, "pre-stress"), 1.0, "solving the pre-stress");
  } catch (const lattice::StaticsError& error) {
    throw scene::InputError({scene::issue_at(p.preset, load_key(scene), error.what())});
  }
  if (scene.loading.traction) {
    try {
      p.outside = lattice::opposite_tractions(p.lattice, 1);
    } catch (const packing::PackingError& error) {
      throw scene::InputError({scene::issue_at(p.preset, "loading.traction", error.what())});
    }
    std::fill(p.lattice.grip.begin(), p.lattice.grip.end(), packing::Grip::none);
    for (const packing::Boundary face : {packing::Boundary::left, packing::Boundary::right}) {
      if (!scene.loading.rollers) continue;
      const std::vector<int> at_face =
          packing::elements_at(p.lattice.box, face, p.lattice.centre, p.lattice.radius, packing::grip_depth);
      p.rollers.insert(p.rollers.end(), at_face.begin(), at_face.end());
    }
  }
  p.gauge = gauges_of(p);
  p.stable = cached_stable_step(p, cache, stage(progress, "critical step"));
  refuse_out_of_range(p, critical_step_numbers(p));
  take_lanes(p, planned(p, lanes, cache, stage(progress, "critical step with damping")));
  for (int k = 0; k < static_cast<int>(p.lane.size()); ++k) check_steering(p, p.lane, k, 0);
  return p;
}

Prepared prepare(const scene::Preset& preset, base::Cache& cache, const StageProgress& progress) {
  return prepare(preset, {preset.scene}, cache, progress);
}

}  // namespace rift::simulation

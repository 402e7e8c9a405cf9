#include "engine/simulation/summary.hpp"

#include "engine/ensemble/instruction_set.hpp"
#include "engine/scene/derived.hpp"
#include "engine/scene/rows_text.hpp"
#include "engine/simulation/steering.hpp"
#include "engine/theory/references.hpp"

#include <nlohmann/json.hpp>
#include <sys/resource.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace rift::simulation {
namespace {

using Json = nlohmann::ordered_json;

/// Written as null: JSON has no NaN.
constexpr double undefined = std::numeric_limits<double>::quiet_NaN();

double peak_memory_bytes() {
  rusage usage{};
  getrusage(RUSAGE_SELF, &usage);
  return 1024.0 * static_cast<double>(usage.ru_maxrss);
}

const char* name_of(fracture::Technique t) {
  return t == fracture::Technique::simple ? "simple" : "progressive";
}
const char* name_of(scene::DampingRegion r) {
  return r == scene::DampingRegion::none ? "none" : r == scene::DampingRegion::surface ? "surface" : "all";
}
const char* name_of(scene::StiffnessChoice s) {
  switch (s) {
    case scene::StiffnessChoice::in_situ:
      return "in-situ";
    case scene::StiffnessChoice::bulk:
      return "bulk";
    case scene::StiffnessChoice::calibrated:
      return "calibrated";
    case scene::StiffnessChoice::explicit_values:
      break;
  }
  return "explicit";
}

const char* name_of(scene::ReleaseRateReference r) {
  return r == scene::ReleaseRateReference::strip ? "strip" : "griffith";
}

void add_scenario(Json& j, const LanePlan& lane) {
  const scene::Scene& scene = lane.scene;
  const bool progressive = scene.crack.technique == fracture::Technique::progressive;
  j["crack_velocity_over_cr"] =
      scene::keeps_its_velocity(scene) ? Json(scene::highest_velocity(scene)) : Json(nullptr);
  j["crack_course"] = !scene.crack.history.empty()         ? "measured"
                      : !scene.crack.toughness.row.empty() ? "by itself"
                      : scene.crack.velocity.size() == 1   ? "constant"
                                                           : "piecewise";
  j["tips"] = scene.crack.tips;
  j["technique"] = name_of(scene.crack.technique);
  j["relaxation"] = progressive ? Json(scene.crack.relaxation) : Json(nullptr);
  j["relaxation_name"] = progressive ? Json(scene::relaxation_name(scene.crack.relaxation)) : Json(nullptr);
  j["damage_zone_ratio"] = progressive ? Json(scene.crack.damage_zone_ratio) : Json(nullptr);
  if (scene.crack.friction) j["friction"] = *scene.crack.friction;
  j["damping_alpha"] = scene.damping.alpha;
  j["damping_region"] = name_of(scene.damping.region);
  j["stiffness"] = name_of(scene.material.stiffness);
  j["plane"] = scene.material.plane == theory::Plane::stress ? "stress" : "strain";
  j["prestress_method"] = scene.loading.method == scene::LoadingMethod::ramp ? "ramp" : "static";
  j["kinematics"] = scene.solver.kinematics == lattice::Kinematics::linear ? "linear" : "corotational";
  j["precision"] = scene.solver.precision == ensemble::Precision::double_precision ? "double" : "single";
  j["beta"] = scene.solver.beta;
  j["seed"] = scene.specimen.seed;
}

void add_specimen(Json& j, const Prepared& p, const LanePlan& lane) {
  const scene::Scene& scene = p.preset.scene;
  j["elements"] = scene.specimen.elements;
  j["layers"] = scene.specimen.layers ? Json(*scene.specimen.layers) : Json(nullptr);
  j["beams"] = p.lattice.beam.size();
  j["beams_crossed"] = fracture::crossings(p.path, p.lattice).size();
  j["beams_damped"] = lane.beams_damped;
  j["rattlers"] = p.specimen.rattlers;
  j["coordination"] = p.specimen.packing.coordination;
  j["solid_fraction"] = p.specimen.packing.solid_fraction;
  j["mean_overlap"] = p.specimen.packing.mean_overlap;
  j["mean_radius_m"] = p.specimen.packing.mean_radius;
  j["length_m"] = p.lattice.box.length;
  j["height_m"] = p.lattice.box.height;
  j["thickness_m"] = p.lattice.box.thickness;
  j["young_modulus_pa"] = scene.material.young_modulus;
  j["poisson_ratio"] = scene.material.poisson_ratio;
  j["density_kg_m3"] = p.density;
  j["rayleigh_speed_m_s"] = p.rayleigh_speed;
  j["micro_young_modulus_pa"] = p.micro.young_modulus * lane.units.energy;
  j["micro_poisson_ratio"] = p.micro.poisson_ratio;
  j["micro_radius_ratio"] = p.micro.radius_ratio;
  j["strip_modulus_pa"] = p.strip_modulus * lane.units.energy;
}

void add_step(Json& j, const Prepared& p, const LanePlan& lane, const RunResult& r, const LaneResult& result,
              const BuildInfo& build) {
  const double dt = p.step.dt * lane.units.time;
  j["dt_s"] = dt;
  j["dt_critical_s"] = p.step.critical * lane.units.time;
  j["dt_critical_damped_s"] = lane.step.critical_damped * lane.units.time;
  j["dt_element_bound_s"] = p.step.element_bound * lane.units.time;
  j["dt_fraction"] = p.step.dt / p.step.critical;
  j["steps"] = result.steps;
  const double fastest = scene::highest_velocity(lane.scene) * p.rayleigh_speed;
  const double zone = lane.scenario.law.zone_length;
  j["steps_per_beam"] = zone > 0.0 ? Json(zone / (fastest * dt)) : Json(nullptr);
  j["threads"] = r.threads;
  j["simd"] = r.instructions;
  j["lanes"] = r.lanes;
  j["version"] = build.version;
}

void add_rates(Json& j, const Prepared& p, const LanePlan& lane, const Rates& rates) {
  const fracture::Plateau& plateau = rates.plateau;
  const auto rate = [&](double value) { return plateau.reached ? Json(value) : Json(nullptr); };
  const double ratio = plateau.mean.ratio_with_damping,
               v = scene::keeps_its_velocity(lane.scene) ? scene::highest_velocity(lane.scene) : undefined;
  const scene::Scene::Material& m = p.preset.scene.material;
  const auto reference = [&](theory::Factor (*of)(double, double, theory::Plane)) {
    return v > 0.0 && v <= 1.0 ? of(v, m.poisson_ratio, m.plane).g : undefined;
  };
  const double g_i0 = fracture::mean_g_i0(scale_of(p, lane), lane.window[0], lane.window[1]);
  j["g_i0_reference"] = name_of(lane.scene.output.g_i0_reference);
  j["g_i0_j_m2"] = g_i0;
  j["displacement_m"] = p.pulled;
  j["grip_force_n"] = p.grip_force * lane.units.energy;
  j["g_id_j_m2"] = rate(ratio * g_i0);
  j["ratio"] = rate(plateau.mean.ratio);
  j["ratio_release"] = rate(plateau.mean.ratio_release);
  j["ratio_with_damping"] = rate(ratio);
  j["ratio_translation_only"] = rate(plateau.mean.ratio_translation_only);
  j["ratio_scatter"] = rate(plateau.scatter);
  j["window_over_length"] = {lane.window[0] / p.scale.length, lane.window[1] / p.scale.length};
  j["echo_free_over_length"] = scene::echo_free_tip_m(lane.scene, wave_speed_ratio(p, lane)) / p.scale.length;
  j["broberg"] = reference(theory::broberg);
  j["freund"] = reference(theory::freund);
  j["strip"] = reference(theory::strip);
  j["error_broberg"] = rate(ratio - reference(theory::broberg));
  j["error_converged"] = nullptr;
}

void add_books(Json& j, const Prepared& p, const LanePlan& lane, const LaneResult& r) {
  const bool ramped = lane.schedule.ramp > 0;
  const results::Sample last = r.books.empty() ? results::Sample{} : r.books.back();
  j["energy_initial_j"] = r.books.empty() ? Json(nullptr) : Json(r.energy_at_crack_start);
  j["energy_elastic_j"] = last.elastic_j;
  j["energy_kinetic_translation_j"] = last.kinetic_translation_j;
  j["energy_kinetic_rotation_j"] = last.kinetic_rotation_j;
  j["energy_step_correction_j"] = last.step_correction_j;
  j["energy_fracture_j"] = last.fracture_j;
  j["energy_damping_j"] = last.damping_j;
  j["energy_numerical_damping_j"] = last.numerical_damping_j;
  j["energy_contact_j"] = last.contact_j;
  j["work_external_j"] = last.work_external_j;
  j["ledger_residual"] = r.worst_residual;
  j["ledger_closes"] =
      r.worst_residual <= ledger_limit(lane.scene.solver.kinematics, lane.scene.solver.precision);
  j["prestress_energy_over_static"] =
      ramped ? Json(r.energy_at_crack_start / (p.static_energy * lane.units.energy)) : Json(1.0);
  j["prestress_kinetic_fraction"] = ramped ? Json(r.prestress_kinetic) : Json(0.0);
  j["outcome"] = name_of(r.outcome);
  j["outcome_where"] = r.where.empty() ? Json(nullptr) : Json(r.where);
}

/// What the crack has left behind; empty where it did not come to its end.
void add_wake(Json& j, const fracture::Wake& wake) {
  j["wake_cell_m"] = wake.cell_m;
  j["wake_kinetic_j"] = wake.kinetic_j;
  j["wake_rotation_j"] = wake.cell_m.empty() ? Json(nullptr) : Json(wake.rotation_j);
  j["out_of_plane_m"] = wake.cell_m.empty() ? Json(nullptr) : Json(wake.out_of_plane_m);
}

void add_costs(Json& j, const Prepared& p, const RunResult& r, const LaneResult& lane, double wall_total_s) {
  const double marching = r.wall_prestress_s + r.wall_fracture_s;
  const auto rate = [&](std::size_t things) {
    return marching > 0.0 ? Json(static_cast<double>(r.lane_steps) * static_cast<double>(things) / marching)
                          : Json(nullptr);
  };
  j["wall_packing_s"] = p.wall_packing_s;
  j["wall_prestress_s"] = p.wall_prestress_s + r.wall_prestress_s;
  j["wall_fracture_s"] = lane.wall_s;
  j["wall_pass_s"] = r.wall_fracture_s;
  j["wall_total_s"] = wall_total_s;
  j["packing_from_cache"] = p.packing_from_cache;
  j["prestress_from_cache"] = p.statics_from_cache;
  j["element_steps_per_s"] = rate(p.lattice.centre.size());
  j["beam_steps_per_s"] = rate(p.lattice.beam.size());
  j["memory_peak_bytes"] = peak_memory_bytes();
}

/// Whether the scenario was changed while its tip was in its window: a mean over it means nothing then.
bool changed_in_window(const Prepared& prepared, const RunResult& result, int lane) {
  const LanePlan& plan = prepared.lane[lane];
  const std::vector<scene::Change>& changes = result.lane[lane].changes;
  const bool by_itself = !plan.scene.crack.toughness.row.empty();
  return std::any_of(changes.begin(), changes.end(), [&](const scene::Change& change) {
    if (by_itself && (change.axis == "crack_velocity" || change.axis == tip_stops)) return false;
    const auto steps = static_cast<double>(change.step - plan.schedule.crack_start());
    const double tip = history::tip_at(plan.scenario.history, steps * prepared.step.dt);
    return tip > plan.window[0] && tip < plan.window[1];
  });
}

Json changes_of(const LaneResult& lane) {
  Json changes = Json::array();
  for (const scene::Change& c : lane.changes)
    changes.push_back({{"step", c.step}, {"axis", c.axis}, {"value", c.value}});
  return changes;
}

/// How the preset wants to be shown, for whoever makes a film of the run.
Json film_of(const scene::Scene& scene) {
  const scene::Scene::Film& f = scene.film;
  return {{"title", f.title},         {"field", f.field}, {"colours", f.colours},
          {"camera", f.camera},       {"beams", f.beams}, {"magnification", f.magnification},
          {"close_up_m", f.close_up}, {"chart", f.chart}, {"boundaries", f.boundaries}};
}

/// The polyline of the crack's path [m].
Json path_of(const Prepared& prepared) {
  Json path = Json::array();
  for (const Eigen::Vector2d& p : prepared.path.point) path.push_back({p.x(), p.y()});
  return path;
}

Json scenarios_of(const Prepared& prepared) {
  Json scenarios = Json::array();
  for (const LanePlan& lane : prepared.lane) add_scenario(scenarios.emplace_back(), lane);
  return scenarios;
}

/// What each lane's release rate is measured against, for whoever looks at the run while it goes on.
Json rate_scales_of(const Prepared& prepared) {
  Json scales = Json::array();
  for (const LanePlan& lane : prepared.lane) {
    const fracture::RateScale scale = scale_of(prepared, lane);
    scales.push_back({{"g_i0_j_m2", scale.g_i0}, {"g_i0_slope_j_m3", scale.g_i0_slope}});
  }
  return scales;
}

/// Of the top grip, for those who draw it.
double largest_displacement(const Prepared& prepared) {
  const scene::Scene& scene = prepared.preset.scene;
  double largest = prepared.pulled;
  if (scene::grip_moves(scene))
    for (const auto& [time, displacement] : scene.loading.curve.row)
      if (time > scene::load_time(scene) && std::abs(displacement) > std::abs(largest))
        largest = displacement;
  return largest;
}

}  // namespace

Rates rates_of(const Prepared& prepared, const RunResult& result, int lane) {
  std::vector<results::Sample> rows;
  for (const results::Sample& row : result.lane[lane].books)
    if (row.phase == results::Phase::fracture) rows.push_back(row);
  if (rows.size() < 2) return {};
  const LanePlan& plan = prepared.lane[lane];
  const fracture::RateScale scale = scale_of(prepared, plan);
  Rates rates{fracture::plateau_of(rows, plan.window, scale), fracture::rate_curve(rows, scale)};
  if (changed_in_window(prepared, result, lane)) rates.plateau.reached = false;
  return rates;
}

Json header_of(const Prepared& prepared, const BuildInfo& build) {
  const scene::Scene& scene = prepared.preset.scene;
  const LanePlan& first = prepared.lane.front();
  std::int64_t steps = 0;
  for (const LanePlan& lane : prepared.lane) steps = std::max(steps, lane.schedule.total());
  return {{"preset_name", prepared.preset.name},
          {"preset", scene::preset_text(prepared.preset)},
          {"version", build.version},
          {"compiler", build.compiler},
          {"instruction_set", ensemble::name_of(ensemble::instruction_set())},
          {"seed", scene.specimen.seed},
          {"lanes", prepared.lane.size()},
          {"dt_s", prepared.step.dt * first.units.time},
          {"steps", steps},
          {"length_m", prepared.lattice.box.length},
          {"height_m", prepared.lattice.box.height},
          {"thickness_m", prepared.lattice.box.thickness},
          {"g_i0_j_m2", fracture::mean_g_i0(scale_of(prepared, first), first.window[0], first.window[1])},
          {"rate_scales", rate_scales_of(prepared)},
          {"rayleigh_speed_m_s", prepared.rayleigh_speed},
          {"tips", prepared.path.tips},
          {"path", path_of(prepared)},
          {"displacement_m", largest_displacement(prepared)},
          {"grip_moves", scene::grip_moves(scene)},
          {"mean_radius_m", prepared.lattice.mean_radius},
          {"density_kg_m3", prepared.density},
          {"solid_fraction", prepared.specimen.packing.solid_fraction},
          {"scenarios", scenarios_of(prepared)},
          {"film", film_of(scene)}};
}

Json lane_summary(const Prepared& prepared, const RunResult& result, int k, const Rates& rates,
                  const BuildInfo& build, double wall_total_s) {
  const LanePlan& lane = prepared.lane[k];
  Json scenario;
  add_scenario(scenario, lane);
  add_specimen(scenario, prepared, lane);
  add_step(scenario, prepared, lane, result, result.lane[k], build);
  add_rates(scenario, prepared, lane, rates);
  add_books(scenario, prepared, lane, result.lane[k]);
  const bool by_itself = !lane.scene.crack.toughness.row.empty();
  const double arrested = result.lane[k].arrested_m;
  if (by_itself) scenario["arrest_m"] = std::isfinite(arrested) ? Json(arrested) : Json(nullptr);
  if (!by_itself && !result.lane[k].changes.empty()) scenario["steering"] = changes_of(result.lane[k]);
  add_wake(scenario, result.lane[k].wake);
  add_costs(scenario, prepared, result, result.lane[k], wall_total_s);
  return scenario;
}

Json summary_of(const Prepared& prepared, const RunResult& result, const std::vector<Rates>& rates,
                const BuildInfo& build, double wall_total_s) {
  Json scenarios = Json::array();
  for (int k = 0; k < static_cast<int>(prepared.lane.size()); ++k)
    scenarios.push_back(lane_summary(prepared, result, k, rates[k], build, wall_total_s));
  return {{"preset", prepared.preset.name}, {"scenarios", scenarios}};
}

results::Geometry geometry_of(const Prepared& prepared) {
  const lattice::Lattice& lattice = prepared.lattice;
  results::Geometry g;
  for (const Eigen::Vector3d& c : lattice.centre)
    g.position.push_back({static_cast<float>(c.x()), static_cast<float>(c.y()), static_cast<float>(c.z())});
  for (double r : prepared.specimen.radius) g.radius.push_back(static_cast<float>(r));
  for (const auto& [i, j] : lattice.ends) g.beam.push_back({i, j});
  for (const fracture::Crossing& c : fracture::crossings(prepared.path, lattice))
    g.crossing.push_back(c.beam);
  std::sort(g.crossing.begin(), g.crossing.end());
  return g;
}

}  // namespace rift::simulation

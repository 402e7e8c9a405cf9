#include "engine/simulation/summary.hpp"

#include "engine/ensemble/instruction_set.hpp"
#include "engine/scene/derived.hpp"
#include "engine/scene/needs.hpp"
#include "engine/scene/parameters.hpp"
#include "engine/scene/rows_text.hpp"
#include "engine/simulation/steering.hpp"
#include "engine/theory/references.hpp"

#include <nlohmann/json.hpp>
#include <sys/resource.h>

#include <algorithm>
#include <cmath>
#include <numeric>

namespace rift::simulation {
namespace {

using Json = nlohmann::ordered_json;

constexpr double undefined = results::LaneSummary::undefined;

double peak_memory_bytes() {
  rusage usage{};
  getrusage(RUSAGE_SELF, &usage);
  return 1024.0 * static_cast<double>(usage.ru_maxrss);
}

/// A measured history's time less the run's; its first row is passed some time after the crack has started.
double history_clock(const Prepared& p, const LanePlan& lane) {
  if (lane.scene.crack.history.empty()) return undefined;
  const double start = static_cast<double>(lane.schedule.crack_start()) * p.step.dt * lane.units.time;
  return scene::load_time(lane.scene) - start - lane.lead;
}

void add_scenario(results::LaneSummary& s, const Prepared& p, const LanePlan& lane) {
  const scene::Scene& scene = lane.scene;
  if (scene::keeps_its_velocity(scene)) s.crack_velocity_over_cr = scene::highest_velocity(scene);
  s.crack_course = scene::breaks_freely(scene)          ? "free"
                   : !scene.crack.history.empty()       ? "measured"
                   : !scene.crack.toughness.row.empty() ? "by itself"
                   : scene.crack.velocity.size() == 1   ? "constant"
                                                        : "piecewise";
  s.history_clock_s = history_clock(p, lane);
  s.tips = scene.crack.tips;
  s.technique = scene::word_of("crack.technique", scene.crack.technique);
  if (scene::breaks_freely(scene)) {
    s.technique = scene::word_of("fracture.law", scene.breaking.law);
  } else if (scene.crack.technique == fracture::Technique::progressive) {
    s.relaxation = scene.crack.relaxation;
    s.relaxation_name = scene::relaxation_name(scene.crack.relaxation);
    s.damage_zone_ratio = scene.crack.damage_zone_ratio;
  }
  s.friction = scene.crack.friction.value_or(undefined);
  s.damping_alpha = scene.damping.alpha;
  s.damping_region = scene::word_of("damping.region", scene.damping.region);
  s.stiffness = scene::word_of("material.stiffness", scene.material.stiffness);
  s.plane = scene::word_of("material.plane", scene.material.plane);
  s.prestress_method = scene::word_of("loading.method", scene.loading.method);
  s.kinematics = scene::word_of("solver.kinematics", scene.solver.kinematics);
  s.precision = scene::word_of("solver.precision", scene.solver.precision);
  s.beta = scene.solver.beta;
  s.seed = static_cast<double>(scene.specimen.seed);
}

void add_specimen(results::LaneSummary& s, const Prepared& p, const LanePlan& lane) {
  const scene::Scene& scene = p.preset.scene;
  s.elements = scene.specimen.elements;
  s.layers = scene.specimen.layers.value_or(undefined);
  s.beams = static_cast<double>(p.lattice.beam.size());
  s.beams_crossed = static_cast<double>(fracture::crossings(p.path, p.lattice).size());
  s.beams_damped = static_cast<double>(lane.beams_damped);
  s.rattlers = p.specimen.rattlers;
  s.coordination = p.specimen.packing.coordination;
  s.solid_fraction = p.specimen.packing.solid_fraction;
  s.mean_overlap = p.specimen.packing.mean_overlap;
  s.mean_radius_m = p.specimen.packing.mean_radius;
  s.length_m = p.lattice.box.length;
  s.height_m = p.lattice.box.height;
  s.thickness_m = p.lattice.box.thickness;
  s.young_modulus_pa = scene.material.young_modulus;
  s.poisson_ratio = scene.material.poisson_ratio;
  s.density_kg_m3 = p.density;
  s.rayleigh_speed_m_s = p.rayleigh_speed;
  s.micro_young_modulus_pa = p.micro.young_modulus * lane.units.energy;
  s.micro_poisson_ratio = p.micro.poisson_ratio;
  s.micro_radius_ratio = p.micro.radius_ratio;
  s.strip_modulus_pa = p.strip_modulus * lane.units.energy;
}

void add_step(results::LaneSummary& s, const Prepared& p, const LanePlan& lane, const RunResult& r,
              const LaneResult& result, const BuildInfo& build) {
  const double dt = p.step.dt * lane.units.time;
  s.dt_s = dt;
  s.dt_critical_s = p.step.critical * lane.units.time;
  s.dt_critical_damped_s = lane.step.critical_damped * lane.units.time;
  s.dt_element_bound_s = p.step.element_bound * lane.units.time;
  s.dt_fraction = p.step.dt / p.step.critical;
  s.steps = static_cast<double>(result.steps);
  const double highest = scene::highest_velocity(lane.scene) * p.rayleigh_speed;
  const double zone = lane.scenario.law.zone_length;
  if (zone > 0.0) s.steps_per_beam = zone / (highest * dt);
  s.threads = r.threads;
  s.simd = r.instructions;
  s.lanes = r.lanes;
  s.version = build.version;
}

void add_rates(results::LaneSummary& s, const Prepared& p, const LanePlan& lane, const Rates& rates) {
  const double v = s.crack_velocity_over_cr;
  const scene::Scene::Material& m = p.preset.scene.material;
  const auto reference = [&](theory::Factor (*of)(double, double, theory::Plane)) {
    return v > 0.0 && v <= 1.0 ? of(v, m.poisson_ratio, m.plane).g : undefined;
  };
  s.g_i0_reference = scene::word_of("output.g_i0_reference", lane.scene.output.g_i0_reference);
  s.g_i0_j_m2 = fracture::mean_g_i0(scale_of(p, lane), lane.window[0], lane.window[1]);
  s.displacement_m = p.pulled;
  s.grip_force_n = p.grip_force * lane.units.energy;
  s.window_over_length = {lane.window[0] / p.scale.length, lane.window[1] / p.scale.length};
  s.echo_free_over_length = scene::echo_free_tip_m(lane.scene, wave_speed_ratio(p, lane)) / p.scale.length;
  s.broberg = reference(theory::broberg);
  s.freund = reference(theory::freund);
  s.strip = reference(theory::strip);
  if (const fracture::Plateau& plateau = rates.plateau; plateau.reached) {
    s.g_id_j_m2 = plateau.mean.ratio * s.g_i0_j_m2;
    s.ratio = plateau.mean.ratio;
    s.ratio_fracture = plateau.mean.ratio_fracture;
    s.ratio_paper = plateau.mean.ratio_paper;
    s.ratio_difference = plateau.mean.ratio_difference;
    s.ratio_scatter = plateau.scatter;
    s.ratio_trend = plateau.trend;
    s.error_broberg = s.ratio - s.broberg;
  }
}

void add_energy_balance(results::LaneSummary& s, const Prepared& p, const LanePlan& lane,
                        const LaneResult& r) {
  const bool ramped = lane.schedule.ramp > 0;
  const results::Sample last = r.samples.empty() ? results::Sample{} : r.samples.back();
  if (!r.samples.empty()) s.energy_initial_j = r.energy_at_crack_start;
  s.energy_elastic_j = last.elastic_j;
  s.energy_kinetic_translation_j = last.kinetic_translation_j;
  s.energy_kinetic_rotation_j = last.kinetic_rotation_j;
  s.energy_step_correction_j = last.step_correction_j;
  s.energy_fracture_j = last.fracture_j;
  s.energy_damping_j = last.damping_j;
  s.energy_numerical_damping_j = last.numerical_damping_j;
  s.energy_contact_j = last.contact_j;
  s.work_external_j = last.work_external_j;
  s.ledger_residual = r.worst_residual;
  s.ledger_limit = ledger_limit(lane.scene.solver.kinematics, lane.scene.solver.precision);
  s.ledger_closes = r.worst_residual <= s.ledger_limit;
  s.prestress_energy_over_static =
      ramped ? r.energy_at_crack_start / (p.static_energy * lane.units.energy) : 1.0;
  s.prestress_kinetic_fraction = ramped ? r.prestress_kinetic : 0.0;
  s.outcome = name_of(r.outcome);
  s.outcome_where = r.where;
  s.arrest_m = r.arrested_m;
  if (lane.scene.crack.toughness.row.empty())
    for (const scene::Change& c : r.changes) s.steering.push_back({c.step, c.axis, c.value});
}

/// What became of beams that break by themselves.
void add_broken(results::LaneSummary& s, const Prepared& p, const LanePlan& lane, const LaneResult& r) {
  const auto& material = lane.scenario.material;
  if (!material) return;
  s.release_rate_j_m2 = material->release_rate * lane.units.energy;
  s.kappa = material->kappa;
  if (material->law == fracture::FractureLaw::cohesive) {
    s.strength_pa = material->strength * lane.units.energy;
    s.strength_wished_pa = *lane.scene.breaking.strength;
  }
  s.beams_broken = r.broken.gone;
  s.beams_softened = r.broken.softened;
  if (r.broken.first_s >= 0.0) s.first_broken_s = r.broken.first_s;
  if (r.broken.leading_m < 0.0) return;
  s.crack_leading_m = r.broken.leading_m;
  const double advance = r.broken.leading_m - lane.scene.crack.start;
  if (advance > 0.0 && !r.samples.empty())
    s.fracture_energy_over_gc =
        r.samples.back().fracture_j / (s.release_rate_j_m2 * p.lattice.box.thickness * advance);
}

/// The motion that the crack has left behind; empty where it did not come to its end.
void add_wake(results::LaneSummary& s, const fracture::Wake& wake) {
  s.wake_cell_m = wake.cell_m;
  s.wake_kinetic_j = wake.kinetic_j;
  if (wake.cell_m.empty()) return;
  s.wake_rotation_j = wake.rotation_j;
  s.out_of_plane_m = wake.out_of_plane_m;
}

void add_costs(results::LaneSummary& s, const Prepared& p, const RunResult& r, const LaneResult& lane,
               double wall_total_s) {
  const double marching = r.wall_prestress_s + r.wall_fracture_s;
  const auto rate = [&](std::size_t things) {
    return marching > 0.0 ? static_cast<double>(r.lane_steps) * static_cast<double>(things) / marching
                          : undefined;
  };
  s.wall_packing_s = p.wall_packing_s;
  s.wall_prestress_s = p.wall_prestress_s + r.wall_prestress_s;
  s.wall_fracture_s = lane.wall_s;
  s.wall_pass_s = r.wall_fracture_s;
  s.wall_total_s = wall_total_s;
  s.packing_from_cache = p.packing_from_cache;
  s.prestress_from_cache = p.statics_from_cache;
  s.element_steps_per_s = rate(p.lattice.centre.size());
  s.beam_steps_per_s = rate(p.lattice.beam.size());
  s.memory_peak_bytes = peak_memory_bytes();
}

/// True where the scenario was changed while its tip was in its window: a mean over it means nothing then.
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

/// The look that the preset asks for, for whoever makes a film of the run.
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
  for (const LanePlan& lane : prepared.lane) {
    results::LaneSummary scenario;
    add_scenario(scenario, prepared, lane);
    scenarios.push_back(results::to_json(scenario, results::scenario_columns()));
  }
  return scenarios;
}

/// The scale of each lane's release rate, for whoever looks at the run while it goes on.
Json rate_scales_of(const Prepared& prepared) {
  Json scales = Json::array();
  for (const LanePlan& lane : prepared.lane) {
    const fracture::RateScale scale = scale_of(prepared, lane);
    scales.push_back({{"g_i0_j_m2", scale.g_i0}, {"g_i0_slope_j_m3", scale.g_i0_slope}});
  }
  return scales;
}

/// Largest displacement of the top grip, for those who draw it.
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
  for (const results::Sample& row : result.lane[lane].samples)
    if (row.phase == results::Phase::fracture) rows.push_back(row);
  const LanePlan& plan = prepared.lane[lane];
  if (rows.size() < 2 || scene::breaks_freely(plan.scene)) return {};
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
          {"tips", scene::breaks_freely(scene) ? 0 : prepared.path.tips},  // none to be drawn on the path
          {"path", path_of(prepared)},
          {"displacement_m", largest_displacement(prepared)},
          {"grip_moves", scene::grip_moves(scene)},
          {"mean_radius_m", prepared.lattice.mean_radius},
          {"density_kg_m3", prepared.density},
          {"young_modulus_pa", scene.material.young_modulus},
          {"solid_fraction", prepared.specimen.packing.solid_fraction},
          {"scenarios", scenarios_of(prepared)},
          {"film", film_of(scene)}};
}

results::LaneSummary lane_summary(const Prepared& prepared, const RunResult& result, int k,
                                  const Rates& rates, const BuildInfo& build, double wall_total_s) {
  const LanePlan& lane = prepared.lane[k];
  results::LaneSummary summary;
  add_scenario(summary, prepared, lane);
  add_specimen(summary, prepared, lane);
  add_step(summary, prepared, lane, result, result.lane[k], build);
  add_rates(summary, prepared, lane, rates);
  add_energy_balance(summary, prepared, lane, result.lane[k]);
  add_broken(summary, prepared, lane, result.lane[k]);
  add_wake(summary, result.lane[k].wake);
  add_costs(summary, prepared, result, result.lane[k], wall_total_s);
  summary.left_out = scene::left_out(lane.scene);
  return summary;
}

Json summary_of(const Prepared& prepared, const RunResult& result, const std::vector<Rates>& rates,
                const BuildInfo& build, double wall_total_s) {
  Json scenarios = Json::array();
  for (int k = 0; k < static_cast<int>(prepared.lane.size()); ++k)
    scenarios.push_back(results::to_json(lane_summary(prepared, result, k, rates[k], build, wall_total_s)));
  return {{"preset", prepared.preset.name}, {"scenarios", scenarios}};
}

results::Geometry geometry_of(const Prepared& prepared) {
  const lattice::Lattice& lattice = prepared.lattice;
  results::Geometry g;
  for (const Eigen::Vector3d& c : lattice.centre)
    g.position.push_back({static_cast<float>(c.x()), static_cast<float>(c.y()), static_cast<float>(c.z())});
  for (double r : prepared.specimen.radius) g.radius.push_back(static_cast<float>(r));
  for (const auto& [i, j] : lattice.ends) g.beam.push_back({i, j});
  if (scene::breaks_freely(prepared.preset.scene)) {
    g.crossing.resize(lattice.beam.size());
    std::iota(g.crossing.begin(), g.crossing.end(), 0);
    return g;
  }
  for (const fracture::Crossing& c : fracture::crossings(prepared.path, lattice))
    g.crossing.push_back(c.beam);
  std::sort(g.crossing.begin(), g.crossing.end());
  return g;
}

results::Mechanics mechanics_of(const Prepared& prepared) {
  const lattice::Lattice& lattice = prepared.lattice;
  const double modulus = prepared.lane.front().units.energy;  // the beams' of the lane over the lattice's
  results::Mechanics m;
  for (const Eigen::Vector3d& c : lattice.centre) m.centre.push_back({c.x(), c.y(), c.z()});
  m.radius = lattice.radius, m.mass = lattice.mass, m.inertia = lattice.inertia;
  for (const packing::Grip grip : lattice.grip) m.grip.push_back(static_cast<std::uint8_t>(grip));
  for (const lattice::Beam& beam : lattice.beam) {
    m.axial.push_back(modulus * beam.axial);
    m.bending.push_back(modulus * beam.bending);
    m.twist.push_back(modulus * beam.twist);
  }
  std::vector<fracture::Crossing> crossings = fracture::crossings(prepared.path, lattice);
  std::sort(crossings.begin(), crossings.end(),
            [](const auto& a, const auto& b) { return a.beam < b.beam; });
  for (const fracture::Crossing& c : crossings) m.crossing_position.push_back(c.position);
  return m;
}

}  // namespace rift::simulation

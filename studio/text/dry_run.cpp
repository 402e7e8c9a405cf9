#include "studio/text/dry_run.hpp"

#include "engine/base/process_limits.hpp"
#include "engine/base/text.hpp"
#include "engine/scene/derived.hpp"
#include "engine/scene/needs.hpp"
#include "engine/scene/parameters.hpp"
#include "engine/simulation/march.hpp"
#include "engine/simulation/summary.hpp"
#include "engine/study/resources.hpp"
#include "engine/theory/wave_speeds.hpp"
#include "studio/text/progress.hpp"

#include <fmt/format.h>
#include <sys/resource.h>

#include <algorithm>
#include <cmath>

namespace rift::studio {

using Json = nlohmann::ordered_json;

namespace {

/// Seconds per step on this machine, now: the run itself, for a moment.
double measured_seconds_per_step(const simulation::Prepared& p, int threads) {
  constexpr double enough_s = 0.3;
  double seconds = 0.0;
  std::int64_t steps = 0;
  simulation::Observer observer;
  observer.go_on = [&](const simulation::Progress& progress) {
    seconds = progress.seconds, steps = progress.step;
    return seconds < enough_s;
  };
  const simulation::RunResult result = simulation::march(p, observer, {.threads = threads});
  if (result.outcome == simulation::Outcome::stopped) return seconds / static_cast<double>(steps);
  return (result.wall_prestress_s + result.wall_fracture_s) / static_cast<double>(result.lane_steps);
}

double disk_bytes(const simulation::Prepared& p) {
  std::vector<study::Moments> moments;
  for (const simulation::LanePlan& lane : p.lane)
    moments.push_back({.frames = static_cast<double>(lane.schedule.frames.size()),
                       .samples = static_cast<double>(lane.schedule.samples.size())});
  return study::disk_bytes_of_run(p.preset.scene,
                                  {.elements = static_cast<double>(p.lattice.centre.size()),
                                   .beams = static_cast<double>(p.lattice.beam.size())},
                                  moments);
}

/// What this process has taken at most so far: the scene has marched in it for a moment.
double peak_memory_bytes() {
  rusage usage{};
  getrusage(RUSAGE_SELF, &usage);
  return 1024.0 * static_cast<double>(usage.ru_maxrss);
}

std::int64_t steps_of_all(const simulation::Prepared& p) {
  std::int64_t steps = 0;
  for (const simulation::LanePlan& lane : p.lane) steps += lane.schedule.total();
  return steps;
}

Json derived(const simulation::Prepared& p, double seconds_per_step) {
  const scene::Scene& scene = p.preset.scene;
  const scene::Scene::Material& m = scene.material;
  const theory::WaveSpeeds speeds = theory::wave_speeds(m.young_modulus, m.poisson_ratio, p.density, m.plane);
  const simulation::LanePlan& lane = p.lane.front();  // of several the first stands for all but the steps
  const double fastest = scene::highest_velocity(lane.scene) * p.rayleigh_speed;
  double zone = 0.0;
  for (const simulation::LanePlan& one : p.lane) zone = std::max(zone, one.scenario.law.zone_length);
  const double dt = p.step.dt * lane.units.time;
  const double fracture_s = static_cast<double>(lane.schedule.fracture) * dt;
  Json j;
  j["elements"] = scene.specimen.elements;
  j["beams"] = p.lattice.beam.size();
  j["beams_crossed"] = fracture::crossings(p.path, p.lattice).size();
  j["beams_damped"] = p.damped.size();
  j["rattlers"] = p.specimen.rattlers;
  j["mean_radius_m"] = p.lattice.mean_radius;
  j["thickness_m"] = p.lattice.box.thickness;
  j["density_kg_m3"] = p.density;
  j["dilatational_speed_m_s"] = speeds.dilatational;
  j["shear_speed_m_s"] = speeds.shear;
  j["rayleigh_speed_m_s"] = p.rayleigh_speed;
  j["micro_young_modulus_pa"] = p.micro.young_modulus * lane.units.energy;
  j["tips"] = scene.crack.tips;
  j["g_i0_j_m2"] = fracture::mean_g_i0(simulation::scale_of(p, lane), lane.window[0], lane.window[1]);
  j["g_i0_reference"] = scene::word_of("output.g_i0_reference", scene.output.g_i0_reference);
  j["displacement_m"] = p.pulled;
  j["grip_force_n"] = p.grip_force * lane.units.energy;
  j["strain"] = p.pulled / p.lattice.box.height;
  j["energy_stored_j"] = p.static_energy * lane.units.energy;
  j["crack_speed_m_s"] = fastest;
  j["crack_end_m"] = lane.crack_end;
  j["window_m"] = lane.window;
  j["echo_free_m"] = scene::echo_free_tip_m(lane.scene, simulation::wave_speed_ratio(p, lane));
  j["damage_zone_m"] = zone;
  if (const auto& material = lane.scenario.material) {
    j["release_rate_j_m2"] = material->release_rate * lane.units.energy;
    j["kappa"] = material->kappa;
    if (lane.scene.breaking.strength) {
      j["strength_pa"] = material->strength * lane.units.energy;
      j["strength_wished_pa"] = *lane.scene.breaking.strength;
    }
  }
  if (scene.loading.traction) j["traction_pa"] = *scene.loading.traction;
  j["dt_s"] = dt;
  j["dt_critical_s"] = p.step.critical * lane.units.time;
  j["dt_critical_damped_s"] = p.step.critical_damped * lane.units.time;
  j["dt_element_bound_s"] = p.step.element_bound * lane.units.time;
  j["dt_fraction"] = p.step.dt / p.step.critical;
  j["lanes"] = p.lane.size();
  j["steps"] = steps_of_all(p);
  j["steps_per_beam"] = zone > 0.0 ? Json(zone / (fastest * dt)) : Json(nullptr);
  j["fracture_time_s"] = fracture_s;
  j["wall_estimate_s"] = seconds_per_step * static_cast<double>(steps_of_all(p));
  j["disk_estimate_bytes"] = disk_bytes(p);
  j["memory_estimate_bytes"] = peak_memory_bytes();
  j["memory_available_bytes"] = base::available_memory_bytes();
  std::vector<scene::Scene> lanes;
  for (const simulation::LanePlan& one : p.lane) lanes.push_back(one.scene);
  j["left_out"] = scene::left_out_by_lanes(lanes);
  return j;
}

/// Where the ratio is read, and up to where the plate is as good as infinite.
std::string window_text(const Json& j) {
  const auto mm = [](const Json& metres) { return 1e3 * metres.get<double>(); };
  const double at = mm(j.at("echo_free_m"));
  const std::string echo =
      std::isnan(at)   ? "the first boundary reflection is not predicted for this crack"
      : std::isinf(at) ? "no boundary reflection reaches the tip"
                       : fmt::format("the first boundary reflection reaches the tip at {:.4g} mm", at);
  return fmt::format("measuring window {:.4g} to {:.4g} mm; {}", mm(j.at("window_m")[0]),
                     mm(j.at("window_m")[1]), echo);
}

/// What the specimen shows of itself, beside the material's.
std::string own_text(const Json& j) {
  const Json& own = j.at("own");
  if (own.is_null())
    return "not measured: 'rift check --measure' pulls the plate once, and the cache keeps it";
  const auto number = [&](const char* key) { return own.at(key).get<double>(); };
  const double nominal = j.at("rayleigh_speed_m_s").get<double>(), rayleigh = number("rayleigh_speed_m_s");
  return fmt::format(
      "E {:.3f} GPa, ν {:.3f}, {:.4g} mm between the grips, Rayleigh {:.0f} m/s, {:.3f} of the nominal "
      "c_R that velocities are over",
      1e-9 * number("young_modulus_pa"), number("poisson_ratio"), 1e3 * number("between_grips_m"), rayleigh,
      rayleigh / nominal);
}

/// The load, and what breaks the beams.
using Rows = std::vector<std::pair<std::string, std::string>>;
void add_load(Rows& rows, const Json& j) {
  const auto number = [&](const char* key) { return j.at(key).get<double>(); };
  if (j.contains("traction_pa")) {
    rows.emplace_back("load",
                      fmt::format("opposite tractions of {:.4g} MPa on top and bottom, from the start on",
                                  1e-6 * number("traction_pa")));
    return;
  }
  rows.emplace_back(
      "load",
      fmt::format("top grip displaced by {:.4g} mm, {:.3g} % of the height; grip force {:.4g} kN",
                  1e3 * number("displacement_m"), 100 * number("strain"), 1e-3 * number("grip_force_n")));
  rows.emplace_back(
      "pre-stress",
      fmt::format(
          "{:.4g} J stored, G_I0 = {:.5g} kJ/m² {}", number("energy_stored_j"), 1e-3 * number("g_i0_j_m2"),
          j.at("g_i0_reference") == "griffith" ? "(griffith, mean over the window)" : "of the strip"));
}

void add_crack(Rows& rows, const Json& j) {
  const auto number = [&](const char* key) { return j.at(key).get<double>(); };
  if (!j.contains("release_rate_j_m2")) {
    rows.emplace_back("crack", fmt::format("{}{:.0f} m/s to {:.4g} mm in {:.4g} ms, damage zone {:.4g} mm",
                                           number("tips") == 2 ? "two tips, half length at " : "",
                                           number("crack_speed_m_s"), 1e3 * number("crack_end_m"),
                                           1e3 * number("fracture_time_s"), 1e3 * number("damage_zone_m")));
    rows.emplace_back("", window_text(j));
    return;
  }
  rows.emplace_back(
      "crack", fmt::format("beams break by themselves for {:.4g} µs, G_c = {:.5g} J/m², kappa {:g}",
                           1e6 * number("fracture_time_s"), number("release_rate_j_m2"), number("kappa")));
  if (!j.contains("strength_pa")) return;
  const double strength = number("strength_pa"), wished = number("strength_wished_pa");
  rows.emplace_back(
      "strength",
      fmt::format("{:.4g} MPa{}", 1e-6 * strength,
                  strength < wished
                      ? fmt::format(", lowered from {:.4g} MPa, for which this lattice would need "
                                    "elements of {:.3g} times the size",
                                    1e-6 * wished, strength * strength / (wished * wished))
                      : ""));
}

}  // namespace

Json dry_run(const simulation::Prepared& prepared, int threads) {
  return derived(prepared, measured_seconds_per_step(prepared, threads));
}

std::vector<std::pair<std::string, std::string>> dry_run_rows(const Json& j) {
  std::vector<std::pair<std::string, std::string>> rows;
  const auto number = [&](const char* key) { return j.at(key).get<double>(); };
  const auto row = [&](const char* label, const std::string& text) { rows.emplace_back(label, text); };
  row("lattice", fmt::format("{} elements, {} beams ({} crossed, {} damped), {}",
                             base::json_text(j.at("elements")), base::json_text(j.at("beams")),
                             base::json_text(j.at("beams_crossed")), base::json_text(j.at("beams_damped")),
                             base::counted(j.at("rattlers").get<std::int64_t>(), "rattler")));
  row("", fmt::format("mean radius {:.4f} mm, thickness {:.4g} mm", 1e3 * number("mean_radius_m"),
                      1e3 * number("thickness_m")));
  row("material", fmt::format("density {:.1f} kg/m³, beam modulus {:.1f} GPa", number("density_kg_m3"),
                              1e-9 * number("micro_young_modulus_pa")));
  row("waves",
      fmt::format("dilatational {:.0f}, shear {:.0f}, Rayleigh {:.0f} m/s", number("dilatational_speed_m_s"),
                  number("shear_speed_m_s"), number("rayleigh_speed_m_s")));
  if (j.contains("own")) row("plate's own", own_text(j));
  add_load(rows, j);
  add_crack(rows, j);
  row("step", fmt::format("{:.3e} s, {:.3g} of the critical step {:.3e} s (guaranteed stable: {:.3e} s)",
                          number("dt_s"), number("dt_fraction"), number("dt_critical_s"),
                          number("dt_element_bound_s")));
  if (number("dt_critical_damped_s") < number("dt_critical_s"))
    row("", fmt::format("with damping the critical step is {:.4e} s", number("dt_critical_damped_s")));
  if (j.contains("step_error")) row("", j.at("step_error").get<std::string>());
  row("steps", fmt::format("{}{}", base::json_text(j.at("steps")),
                           j.at("steps_per_beam").is_null()
                               ? std::string()
                               : fmt::format(", {:.1f} per beam release", number("steps_per_beam"))));
  row("cost",
      fmt::format(
          "about {} after packing and pre-stress, {:.0f} of {:.0f} MB of memory, at most {:.0f} MB on disk",
          duration_text(number("wall_estimate_s")), 1e-6 * number("memory_estimate_bytes"),
          1e-6 * number("memory_available_bytes"), 1e-6 * number("disk_estimate_bytes")));
  const char* label = "left out";
  for (const auto& line : j.at("left_out")) row(label, line.get<std::string>()), label = "";
  return rows;
}

}  // namespace rift::studio

#pragma once

#include <nlohmann/json.hpp>

#include <array>
#include <cstdint>
#include <limits>
#include <span>
#include <string>
#include <variant>
#include <vector>

namespace rift::results {

/// A change that somebody made while the lane marched.
struct SteeringChange {
  std::int64_t step = 0;
  std::string axis, value;
};

/// The summary of one lane, as summary.json has it: each member under its own name [docs/results-format.md].
/// A number that is NaN and a text that is empty are null; so read as well what an older file lacks.
struct LaneSummary {
  static constexpr double undefined = std::numeric_limits<double>::quiet_NaN();

  // The scenario: known before the first step.
  double crack_velocity_over_cr = undefined;
  std::string crack_course;            // "constant", "piecewise", "measured" or "by itself"
  double history_clock_s = undefined;  // of a measured history: its time less the run's
  double tips = undefined;
  std::string technique;
  double relaxation = undefined;
  std::string relaxation_name;
  double damage_zone_ratio = undefined;
  double friction = undefined;
  double damping_alpha = undefined;
  std::string damping_region, stiffness, plane, prestress_method, kinematics, precision;
  double beta = undefined;
  double seed = undefined;

  // The specimen and its lattice.
  double elements = undefined, layers = undefined, beams = undefined, beams_crossed = undefined;
  double beams_damped = undefined, rattlers = undefined;
  double coordination = undefined, solid_fraction = undefined, mean_overlap = undefined;
  double mean_radius_m = undefined, length_m = undefined, height_m = undefined, thickness_m = undefined;
  double young_modulus_pa = undefined, poisson_ratio = undefined, density_kg_m3 = undefined;
  double rayleigh_speed_m_s = undefined;
  double micro_young_modulus_pa = undefined, micro_poisson_ratio = undefined, micro_radius_ratio = undefined;
  double strip_modulus_pa = undefined;

  // The step, and what marched.
  double dt_s = undefined, dt_critical_s = undefined, dt_critical_damped_s = undefined;
  double dt_element_bound_s = undefined, dt_fraction = undefined;
  double steps = undefined, steps_per_beam = undefined, threads = undefined;
  std::string simd;
  double lanes = undefined;
  std::string version;

  // The release rate, over the window.
  std::string g_i0_reference;
  double g_i0_j_m2 = undefined, displacement_m = undefined, grip_force_n = undefined, g_id_j_m2 = undefined;
  double ratio = undefined, ratio_fracture = undefined, ratio_paper = undefined;
  double ratio_difference = undefined, ratio_scatter = undefined, ratio_trend = undefined;
  std::array<double, 2> window_over_length{undefined, undefined};
  double echo_free_over_length = undefined;
  double broberg = undefined, freund = undefined, strip = undefined;
  double error_broberg = undefined, error_converged = undefined;

  // Beams that break by themselves.
  double release_rate_j_m2 = undefined, strength_pa = undefined, strength_wished_pa = undefined;
  double kappa = undefined, beams_broken = undefined, beams_softened = undefined;
  double first_broken_s = undefined, crack_leading_m = undefined;
  double fracture_energy_over_gc = undefined;  // of the leading position's advance

  // The energy balance at the end.
  double energy_initial_j = undefined, energy_elastic_j = undefined, energy_kinetic_translation_j = undefined;
  double energy_kinetic_rotation_j = undefined, energy_step_correction_j = undefined;
  double energy_fracture_j = undefined, energy_damping_j = undefined, energy_numerical_damping_j = undefined;
  double energy_contact_j = undefined, work_external_j = undefined, ledger_residual = undefined;
  double ledger_limit = undefined;  // of the balance error, by kinematics and precision
  bool ledger_closes = false;
  double prestress_energy_over_static = undefined, prestress_kinetic_fraction = undefined;
  std::string outcome, outcome_where;
  double arrest_m = undefined;  // of a crack that runs by itself
  std::vector<SteeringChange> steering;
  std::vector<double> wake_cell_m, wake_kinetic_j;
  double wake_rotation_j = undefined, out_of_plane_m = undefined;

  // What it cost.
  double wall_packing_s = undefined, wall_prestress_s = undefined, wall_fracture_s = undefined;
  double wall_pass_s = undefined, wall_total_s = undefined;
  double cost_s = undefined;  // of a study's scenario: by its kernel at full lanes, not by who marched beside
  bool packing_from_cache = false, prestress_from_cache = false;
  double element_steps_per_s = undefined, beam_steps_per_s = undefined, memory_peak_bytes = undefined;
  std::vector<std::string> left_out;  // what the scenario does not need, by name: "damping", "corotation"
};

/// A number that is a whole one in JSON.
struct WholeNumber {
  double LaneSummary::*member;
  bool operator==(const WholeNumber&) const = default;
};

/// A column of the summary: its name and the member that it stands for, whose type says how it is written and
/// read back.
struct SummaryColumn {
  const char* name;
  std::variant<double LaneSummary::*, WholeNumber, std::string LaneSummary::*, bool LaneSummary::*,
               std::array<double, 2> LaneSummary::*, std::vector<double> LaneSummary::*,
               std::vector<std::string> LaneSummary::*, std::vector<SteeringChange> LaneSummary::*>
      member;
  bool (*is_there)(const LaneSummary&) = nullptr;  // which lanes have the column; null: all of them
};

/// THE table of the summary's columns in the order in which they are written; and those of the scenario
/// alone, the first of them, which a journal's header gives of each lane.
[[nodiscard]] std::span<const SummaryColumn> summary_columns();
[[nodiscard]] std::span<const SummaryColumn> scenario_columns();

/// The summary as summary.json, a study's results and its table have it; `columns` of it.
[[nodiscard]] nlohmann::ordered_json to_json(const LaneSummary& summary,
                                             std::span<const SummaryColumn> columns = summary_columns());

/// Reads a summary, or a header's scenario, back. What is missing or of another type is undefined.
[[nodiscard]] LaneSummary lane_summary_of(const nlohmann::ordered_json& object);

/// The same of each entry of a list; none where it is no list.
[[nodiscard]] std::vector<LaneSummary> lane_summaries_of(const nlohmann::ordered_json& list);

/// A title for each lane from its scenario: what tells the lanes apart stands first, where a narrow screen
/// cuts it last, then what of technique and velocity they have in common.
[[nodiscard]] std::vector<std::string> lane_titles(const std::vector<LaneSummary>& scenarios);

}  // namespace rift::results

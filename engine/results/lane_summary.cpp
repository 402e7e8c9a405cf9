#include "engine/results/lane_summary.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace rift::results {
namespace {

using Json = nlohmann::ordered_json;
using L = LaneSummary;

constexpr std::array summary_table{
    SummaryColumn{"crack_velocity_over_cr", &L::crack_velocity_over_cr},
    SummaryColumn{"crack_course", &L::crack_course},
    SummaryColumn{"tips", WholeNumber{&L::tips}},
    SummaryColumn{"technique", &L::technique},
    SummaryColumn{"relaxation", &L::relaxation},
    SummaryColumn{"relaxation_name", &L::relaxation_name},
    SummaryColumn{"damage_zone_ratio", &L::damage_zone_ratio},
    SummaryColumn{"friction", &L::friction, [](const L& s) { return !std::isnan(s.friction); }},
    SummaryColumn{"damping_alpha", &L::damping_alpha},
    SummaryColumn{"damping_region", &L::damping_region},
    SummaryColumn{"stiffness", &L::stiffness},
    SummaryColumn{"plane", &L::plane},
    SummaryColumn{"prestress_method", &L::prestress_method},
    SummaryColumn{"kinematics", &L::kinematics},
    SummaryColumn{"precision", &L::precision},
    SummaryColumn{"beta", &L::beta},
    SummaryColumn{"seed", WholeNumber{&L::seed}},
    // what follows is not known before the run
    SummaryColumn{"elements", WholeNumber{&L::elements}},
    SummaryColumn{"layers", &L::layers},
    SummaryColumn{"beams", WholeNumber{&L::beams}},
    SummaryColumn{"beams_crossed", WholeNumber{&L::beams_crossed}},
    SummaryColumn{"beams_damped", WholeNumber{&L::beams_damped}},
    SummaryColumn{"rattlers", WholeNumber{&L::rattlers}},
    SummaryColumn{"coordination", &L::coordination},
    SummaryColumn{"solid_fraction", &L::solid_fraction},
    SummaryColumn{"mean_overlap", &L::mean_overlap},
    SummaryColumn{"mean_radius_m", &L::mean_radius_m},
    SummaryColumn{"length_m", &L::length_m},
    SummaryColumn{"height_m", &L::height_m},
    SummaryColumn{"thickness_m", &L::thickness_m},
    SummaryColumn{"young_modulus_pa", &L::young_modulus_pa},
    SummaryColumn{"poisson_ratio", &L::poisson_ratio},
    SummaryColumn{"density_kg_m3", &L::density_kg_m3},
    SummaryColumn{"rayleigh_speed_m_s", &L::rayleigh_speed_m_s},
    SummaryColumn{"micro_young_modulus_pa", &L::micro_young_modulus_pa},
    SummaryColumn{"micro_poisson_ratio", &L::micro_poisson_ratio},
    SummaryColumn{"micro_radius_ratio", &L::micro_radius_ratio},
    SummaryColumn{"strip_modulus_pa", &L::strip_modulus_pa},
    SummaryColumn{"dt_s", &L::dt_s},
    SummaryColumn{"dt_critical_s", &L::dt_critical_s},
    SummaryColumn{"dt_critical_damped_s", &L::dt_critical_damped_s},
    SummaryColumn{"dt_element_bound_s", &L::dt_element_bound_s},
    SummaryColumn{"dt_fraction", &L::dt_fraction},
    SummaryColumn{"steps", WholeNumber{&L::steps}},
    SummaryColumn{"steps_per_beam", &L::steps_per_beam},
    SummaryColumn{"threads", WholeNumber{&L::threads}},
    SummaryColumn{"simd", &L::simd},
    SummaryColumn{"lanes", WholeNumber{&L::lanes}},
    SummaryColumn{"version", &L::version},
    SummaryColumn{"g_i0_reference", &L::g_i0_reference},
    SummaryColumn{"g_i0_j_m2", &L::g_i0_j_m2},
    SummaryColumn{"displacement_m", &L::displacement_m},
    SummaryColumn{"grip_force_n", &L::grip_force_n},
    SummaryColumn{"g_id_j_m2", &L::g_id_j_m2},
    SummaryColumn{"ratio", &L::ratio},
    SummaryColumn{"ratio_release", &L::ratio_release},
    SummaryColumn{"ratio_with_damping", &L::ratio_with_damping},
    SummaryColumn{"ratio_translation_only", &L::ratio_translation_only},
    SummaryColumn{"ratio_scatter", &L::ratio_scatter},
    SummaryColumn{"window_over_length", &L::window_over_length},
    SummaryColumn{"echo_free_over_length", &L::echo_free_over_length},
    SummaryColumn{"broberg", &L::broberg},
    SummaryColumn{"freund", &L::freund},
    SummaryColumn{"strip", &L::strip},
    SummaryColumn{"error_broberg", &L::error_broberg},
    SummaryColumn{"error_converged", &L::error_converged},
    SummaryColumn{"energy_initial_j", &L::energy_initial_j},
    SummaryColumn{"energy_elastic_j", &L::energy_elastic_j},
    SummaryColumn{"energy_kinetic_translation_j", &L::energy_kinetic_translation_j},
    SummaryColumn{"energy_kinetic_rotation_j", &L::energy_kinetic_rotation_j},
    SummaryColumn{"energy_step_correction_j", &L::energy_step_correction_j},
    SummaryColumn{"energy_fracture_j", &L::energy_fracture_j},
    SummaryColumn{"energy_damping_j", &L::energy_damping_j},
    SummaryColumn{"energy_numerical_damping_j", &L::energy_numerical_damping_j},
    SummaryColumn{"energy_contact_j", &L::energy_contact_j},
    SummaryColumn{"work_external_j", &L::work_external_j},
    SummaryColumn{"ledger_residual", &L::ledger_residual},
    SummaryColumn{"ledger_closes", &L::ledger_closes},
    SummaryColumn{"prestress_energy_over_static", &L::prestress_energy_over_static},
    SummaryColumn{"prestress_kinetic_fraction", &L::prestress_kinetic_fraction},
    SummaryColumn{"outcome", &L::outcome},
    SummaryColumn{"outcome_where", &L::outcome_where},
    SummaryColumn{"arrest_m", &L::arrest_m, [](const L& s) { return s.crack_course == "by itself"; }},
    SummaryColumn{"steering", &L::steering, [](const L& s) { return !s.steering.empty(); }},
    SummaryColumn{"wake_cell_m", &L::wake_cell_m},
    SummaryColumn{"wake_kinetic_j", &L::wake_kinetic_j},
    SummaryColumn{"wake_rotation_j", &L::wake_rotation_j},
    SummaryColumn{"out_of_plane_m", &L::out_of_plane_m},
    SummaryColumn{"wall_packing_s", &L::wall_packing_s},
    SummaryColumn{"wall_prestress_s", &L::wall_prestress_s},
    SummaryColumn{"wall_fracture_s", &L::wall_fracture_s},
    SummaryColumn{"wall_pass_s", &L::wall_pass_s},
    SummaryColumn{"wall_total_s", &L::wall_total_s},
    SummaryColumn{"packing_from_cache", &L::packing_from_cache},
    SummaryColumn{"prestress_from_cache", &L::prestress_from_cache},
    SummaryColumn{"element_steps_per_s", &L::element_steps_per_s},
    SummaryColumn{"beam_steps_per_s", &L::beam_steps_per_s},
    SummaryColumn{"memory_peak_bytes", &L::memory_peak_bytes},
};

constexpr std::size_t of_scenario = 17;
static_assert(std::string_view(summary_table[of_scenario - 1].name) == "seed");

Json json_number(double value) { return std::isfinite(value) ? Json(value) : Json(nullptr); }

/// One way of writing per type of member.
struct Write {
  const LaneSummary& s;

  Json operator()(double L::*x) const { return json_number(s.*x); }
  Json operator()(WholeNumber n) const {
    return std::isfinite(s.*n.member) ? Json(std::llround(s.*n.member)) : Json(nullptr);
  }
  Json operator()(std::string L::*text) const { return (s.*text).empty() ? Json(nullptr) : Json(s.*text); }
  Json operator()(bool L::*truth) const { return s.*truth; }
  Json operator()(std::array<double, 2> L::*pair) const {
    return Json::array({json_number((s.*pair)[0]), json_number((s.*pair)[1])});
  }
  Json operator()(std::vector<double> L::*numbers) const {
    Json list = Json::array();
    for (const double x : s.*numbers) list.push_back(json_number(x));
    return list;
  }
  Json operator()(std::vector<SteeringChange> L::*changes) const {
    Json list = Json::array();
    for (const SteeringChange& c : s.*changes)
      list.push_back({{"step", c.step}, {"axis", c.axis}, {"value", c.value}});
    return list;
  }
};

double number_of(const Json& value) { return value.is_number() ? value.get<double>() : L::undefined; }
std::string text_of(const Json& value) {
  return value.is_string() ? value.get<std::string>() : std::string();
}

/// And one of reading it back.
struct Read {
  LaneSummary& s;
  const Json& value;

  void operator()(double L::*x) const { s.*x = number_of(value); }
  void operator()(WholeNumber n) const { s.*n.member = number_of(value); }
  void operator()(std::string L::*text) const { s.*text = text_of(value); }
  void operator()(bool L::*truth) const { s.*truth = value.is_boolean() && value.get<bool>(); }
  void operator()(std::array<double, 2> L::*pair) const {
    if (value.is_array() && value.size() == 2) s.*pair = {number_of(value[0]), number_of(value[1])};
  }
  void operator()(std::vector<double> L::*numbers) const {
    if (value.is_array())
      for (const Json& x : value) (s.*numbers).push_back(number_of(x));
  }
  void operator()(std::vector<SteeringChange> L::*changes) const {
    if (!value.is_array()) return;
    for (const Json& c : value)
      if (c.is_object() && c.contains("step") && c["step"].is_number_integer())
        (s.*changes)
            .push_back({c["step"].get<std::int64_t>(), text_of(c.value("axis", Json(nullptr))),
                        text_of(c.value("value", Json(nullptr)))});
  }
};

}  // namespace

std::span<const SummaryColumn> summary_columns() { return summary_table; }
std::span<const SummaryColumn> scenario_columns() { return summary_columns().first(of_scenario); }

Json to_json(const LaneSummary& summary, std::span<const SummaryColumn> some) {
  Json json = Json::object();
  for (const SummaryColumn& column : some)
    if (!column.is_there || column.is_there(summary))
      json[column.name] = std::visit(Write{summary}, column.member);
  return json;
}

LaneSummary lane_summary_of(const Json& object) {
  LaneSummary summary;
  if (!object.is_object()) return summary;
  for (const SummaryColumn& column : summary_table)
    if (const auto found = object.find(column.name); found != object.end())
      std::visit(Read{summary, *found}, column.member);
  return summary;
}

std::vector<LaneSummary> lane_summaries_of(const Json& list) {
  std::vector<LaneSummary> summaries;
  if (list.is_array())
    for (const Json& object : list) summaries.push_back(lane_summary_of(object));
  return summaries;
}

namespace {

std::string technique(const LaneSummary& s) { return s.technique.empty() ? "" : s.technique + " release"; }

std::string velocity(const LaneSummary& s) {
  return std::isnan(s.crack_velocity_over_cr) ? "" : fmt::format("{:.3g} c_r", s.crack_velocity_over_cr);
}

std::string damping(const LaneSummary& s) {
  if (!(std::abs(s.damping_alpha) > 0.0)) return "undamped";
  return fmt::format("alpha = {:g} {}", s.damping_alpha,
                     s.damping_region == "all" ? "everywhere" : "along the crack");
}

using Member = decltype(SummaryColumn::member);

/// A number or a text as a title shows it.
std::string plain(const LaneSummary& s, const Member& member) {
  const Json value = std::visit(Write{s}, member);
  return value.is_number() ? fmt::format("{:g}", value.get<double>()) : text_of(value);
}

/// A property that a title names only where it differs between the lanes.
struct Distinction {
  const char* label;
  Member member;
};
const Distinction distinctions[] = {
    {"", &L::relaxation_name},       {"r_l = ", &L::damage_zone_ratio}, {"friction ", &L::friction},
    {"", &L::damping_alpha},         {"stiffness ", &L::stiffness},     {"plane ", &L::plane},
    {"kinematics ", &L::kinematics}, {"precision ", &L::precision},     {"beta ", &L::beta},
    {"seed ", WholeNumber{&L::seed}}};

std::string text_of(const LaneSummary& s, const Distinction& distinction) {
  if (distinction.member == Member(&L::damping_alpha)) return damping(s);
  const std::string value = plain(s, distinction.member);
  return value.empty() ? value : distinction.label + value;
}

bool differs(const std::vector<LaneSummary>& scenarios, const Member& member) {
  return std::any_of(scenarios.begin(), scenarios.end(), [&](const LaneSummary& s) {
    return plain(s, member) != plain(scenarios.front(), member);
  });
}

}  // namespace

std::vector<std::string> lane_titles(const std::vector<LaneSummary>& scenarios) {
  std::vector<std::string> titles;
  for (const LaneSummary& s : scenarios) {
    std::vector<std::string> apart, common;
    (differs(scenarios, &L::technique) ? apart : common).push_back(technique(s));
    (differs(scenarios, &L::crack_velocity_over_cr) ? apart : common).push_back(velocity(s));
    for (const Distinction& d : distinctions)
      if (differs(scenarios, d.member)) apart.push_back(text_of(s, d));
    apart.insert(apart.end(), common.begin(), common.end());
    std::erase(apart, "");
    titles.push_back(fmt::format("{}", fmt::join(apart, ", ")));
  }
  return titles;
}

}  // namespace rift::results

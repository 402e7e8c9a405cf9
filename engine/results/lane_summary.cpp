#include "engine/results/lane_summary.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace rift::results {
namespace {

using Json = nlohmann::ordered_json;
using L = LaneSummary;

/// Whether its beams break by themselves.
bool is_free(const L& s) { return s.crack_course == "free"; }

// A column has the name of its member.
#define COLUMN(member) (SummaryColumn{#member, &L::member})
#define COLUMN_IF(member, is_there) (SummaryColumn{#member, &L::member, [](const L& s) { return is_there; }})
#define WHOLE(member) (SummaryColumn{#member, WholeNumber{&L::member}})
#define WHOLE_IF(member, is_there) \
  (SummaryColumn{#member, WholeNumber{&L::member}, [](const L& s) { return is_there; }})
constexpr std::array summary_table{
    COLUMN(crack_velocity_over_cr), COLUMN(crack_course),
    COLUMN_IF(history_clock_s, !std::isnan(s.history_clock_s)), WHOLE(tips), COLUMN(technique),
    COLUMN(relaxation), COLUMN(relaxation_name), COLUMN(damage_zone_ratio),
    COLUMN_IF(friction, !std::isnan(s.friction)), COLUMN(damping_alpha), COLUMN(damping_region),
    COLUMN(stiffness), COLUMN(plane), COLUMN(prestress_method), COLUMN(kinematics), COLUMN(precision),
    COLUMN(beta), WHOLE(seed),
    // what follows is not known before the run
    WHOLE(elements), COLUMN(layers), WHOLE(beams), WHOLE(beams_crossed), WHOLE(beams_damped), WHOLE(rattlers),
    COLUMN(coordination), COLUMN(solid_fraction), COLUMN(mean_overlap), COLUMN(mean_radius_m),
    COLUMN(length_m), COLUMN(height_m), COLUMN(thickness_m), COLUMN(young_modulus_pa), COLUMN(poisson_ratio),
    COLUMN(density_kg_m3), COLUMN(rayleigh_speed_m_s), COLUMN(micro_young_modulus_pa),
    COLUMN(micro_poisson_ratio), COLUMN(micro_radius_ratio), COLUMN(strip_modulus_pa), COLUMN(dt_s),
    COLUMN(dt_critical_s), COLUMN(dt_critical_damped_s), COLUMN(dt_element_bound_s), COLUMN(dt_fraction),
    WHOLE(steps), COLUMN(steps_per_beam), WHOLE(threads), COLUMN(simd), WHOLE(lanes), COLUMN(version),
    COLUMN(g_i0_reference), COLUMN(g_i0_j_m2), COLUMN(displacement_m), COLUMN(grip_force_n),
    COLUMN(g_id_j_m2), COLUMN(ratio), COLUMN(ratio_fracture), COLUMN(ratio_paper), COLUMN(ratio_difference),
    COLUMN(ratio_scatter), COLUMN(ratio_trend), COLUMN(window_over_length), COLUMN(echo_free_over_length),
    COLUMN(broberg), COLUMN(freund), COLUMN(strip), COLUMN(error_broberg), COLUMN(error_converged),
    COLUMN(energy_initial_j), COLUMN(energy_elastic_j), COLUMN(energy_kinetic_translation_j),
    COLUMN(energy_kinetic_rotation_j), COLUMN(energy_step_correction_j), COLUMN(energy_fracture_j),
    COLUMN(energy_damping_j), COLUMN(energy_numerical_damping_j), COLUMN(energy_contact_j),
    COLUMN(work_external_j), COLUMN(ledger_residual), COLUMN(ledger_limit), COLUMN(ledger_closes),
    COLUMN(prestress_energy_over_static), COLUMN(prestress_kinetic_fraction), COLUMN(outcome),
    COLUMN(outcome_where), COLUMN_IF(arrest_m, s.crack_course == "by itself"),
    COLUMN_IF(release_rate_j_m2, is_free(s)), COLUMN_IF(strength_pa, is_free(s)),
    COLUMN_IF(strength_wished_pa, is_free(s)), COLUMN_IF(kappa, is_free(s)),
    WHOLE_IF(beams_broken, is_free(s)), WHOLE_IF(beams_softened, is_free(s)),
    COLUMN_IF(first_broken_s, is_free(s)), COLUMN_IF(crack_leading_m, is_free(s)),
    COLUMN_IF(fracture_energy_over_gc, is_free(s)), COLUMN_IF(steering, !s.steering.empty()),
    COLUMN(wake_cell_m), COLUMN(wake_kinetic_j), COLUMN(wake_rotation_j), COLUMN(out_of_plane_m),
    COLUMN(wall_packing_s), COLUMN(wall_prestress_s), COLUMN(wall_fracture_s), COLUMN(wall_pass_s),
    COLUMN(left_out), COLUMN(wall_total_s), COLUMN(cost_s), COLUMN(packing_from_cache),
    COLUMN(prestress_from_cache), COLUMN(element_steps_per_s), COLUMN(beam_steps_per_s),
    COLUMN(memory_peak_bytes)};
#undef COLUMN
#undef COLUMN_IF
#undef WHOLE
#undef WHOLE_IF

constexpr std::size_t of_scenario = 18;
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
  Json operator()(std::vector<std::string> L::*texts) const {
    Json list = Json::array();
    for (const std::string& text : s.*texts) list.push_back(text);
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
  void operator()(std::vector<std::string> L::*texts) const {
    if (value.is_array())
      for (const Json& text : value) (s.*texts).push_back(text_of(text));
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

namespace {

/// Before version 0.2 of the program `ratio` was the balance without damping, and other names were used.
void rename_ratios_of_version_1(LaneSummary& s, const Json& object) {
  const auto number = [&](const char* name) { return number_of(object.value(name, Json(nullptr))); };
  const double balance = number("ratio"), with_damping = number("ratio_with_damping");
  s.ratio = with_damping;
  s.ratio_fracture = number("ratio_release");
  s.ratio_paper = number("ratio_translation_only") + (with_damping - balance);
  s.ratio_difference = balance - s.ratio_fracture;
}

}  // namespace

LaneSummary lane_summary_of(const Json& object) {
  LaneSummary summary;
  if (!object.is_object()) return summary;
  for (const SummaryColumn& column : summary_table)
    if (const auto found = object.find(column.name); found != object.end())
      std::visit(Read{summary, *found}, column.member);
  if (object.contains("ratio_with_damping")) rename_ratios_of_version_1(summary, object);
  return summary;
}

std::vector<LaneSummary> lane_summaries_of(const Json& list) {
  std::vector<LaneSummary> summaries;
  if (list.is_array())
    for (const Json& object : list) summaries.push_back(lane_summary_of(object));
  return summaries;
}

namespace {

std::string technique(const LaneSummary& s) {
  if (s.technique.empty()) return "";
  return s.technique + (is_free(s) ? " beams" : " release");
}

std::string velocity(const LaneSummary& s) {
  if (!std::isnan(s.crack_velocity_over_cr)) return fmt::format("{:.3g} c_R", s.crack_velocity_over_cr);
  if (s.crack_course == "measured") return "measured history";
  if (s.crack_course == "free") return "free crack";
  return s.crack_course == "by itself" ? "predicted velocity" : "";
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

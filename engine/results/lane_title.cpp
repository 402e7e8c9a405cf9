#include "engine/results/lane_title.hpp"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <algorithm>

namespace rift::results {
namespace {

using Scenario = nlohmann::ordered_json;

bool has(const Scenario& scenario, const char* name) {
  return scenario.contains(name) && !scenario[name].is_null();
}

std::string technique(const Scenario& s) {
  return has(s, "technique") ? s["technique"].get<std::string>() + " release" : "";
}

std::string velocity(const Scenario& s) {
  return has(s, "crack_velocity_over_cr")
             ? fmt::format("{:.3g} c_r", s["crack_velocity_over_cr"].get<double>())
             : "";
}

std::string damping(const Scenario& s) {
  const double alpha = s.value("damping_alpha", 0.0);
  if (alpha == 0) return "undamped";
  const std::string region = s.value("damping_region", "");
  return fmt::format("alpha = {:g} {}", alpha, region == "all" ? "everywhere" : "along the crack");
}

std::string plain(const Scenario& s, const char* name) {
  if (!has(s, name)) return "";
  return s[name].is_string() ? s[name].get<std::string>() : fmt::format("{:g}", s[name].get<double>());
}

/// What is said of a scenario only where it differs from another's.
std::string distinction(const Scenario& s, const std::string& name) {
  if (name == "damping_alpha") return damping(s);
  const std::string value = plain(s, name.c_str());
  if (value.empty() || name == "relaxation_name") return value;
  return (name == "damage_zone_ratio" ? "r_l = " : name + " ") + value;
}

constexpr const char* distinctions[] = {
    "relaxation_name", "damage_zone_ratio", "friction",  "damping_alpha", "stiffness",
    "plane",           "kinematics",        "precision", "beta",          "seed"};

bool differs(const std::vector<Scenario>& scenarios, const char* name) {
  return std::any_of(scenarios.begin(), scenarios.end(),
                     [&](const Scenario& s) { return plain(s, name) != plain(scenarios.front(), name); });
}

}  // namespace

std::vector<std::string> lane_titles(const std::vector<Scenario>& scenarios) {
  std::vector<std::string> titles;
  for (const Scenario& s : scenarios) {
    std::vector<std::string> apart, common;
    (differs(scenarios, "technique") ? apart : common).push_back(technique(s));
    (differs(scenarios, "crack_velocity_over_cr") ? apart : common).push_back(velocity(s));
    for (const char* name : distinctions)
      if (differs(scenarios, name)) apart.push_back(distinction(s, name));
    apart.insert(apart.end(), common.begin(), common.end());
    std::erase(apart, "");
    titles.push_back(fmt::format("{}", fmt::join(apart, ", ")));
  }
  return titles;
}

}  // namespace rift::results

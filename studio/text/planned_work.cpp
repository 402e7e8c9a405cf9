#include "studio/text/planned_work.hpp"

#include "engine/base/process_limits.hpp"
#include "engine/scene/issue.hpp"
#include "engine/scene/needs.hpp"
#include "engine/scene/scenarios.hpp"
#include "engine/study/plan.hpp"
#include "studio/text/progress.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <set>

namespace rift::studio {

using Json = nlohmann::ordered_json;

namespace {

/// The axes of the grid whose values differ between the combinations that are one scenario.
std::vector<std::string> axes_that_differ(const scene::Preset& preset, const scene::StudyRow& row) {
  std::vector<std::string> names;
  for (std::size_t axis = 0; axis < preset.grid.size(); ++axis)
    if (std::any_of(row.combinations.begin(), row.combinations.end(),
                    [&](const auto& values) { return values[axis] != row.combinations.front()[axis]; }))
      names.push_back(preset.grid[axis].name);
  return names;
}

/// "technique = "simple"", each reason once.
std::string reason_of(const std::vector<std::string>& axes) {
  std::vector<std::string> reasons;
  for (const std::string& name : axes) {
    std::string reason(scene::settled_by(*scene::find_axis(name)));
    if (std::find(reasons.begin(), reasons.end(), reason) == reasons.end())
      reasons.push_back(std::move(reason));
  }
  return scene::listed(reasons, "or");
}

std::size_t combinations_of(const scene::Preset& preset) {
  std::size_t count = 0;
  for (const scene::StudyRow& row : preset.study) count += std::max<std::size_t>(1, row.combinations.size());
  return count;
}

struct StepRange {
  double least = std::numeric_limits<double>::infinity(), most = 0, all = 0;
};

StepRange steps_of(const std::vector<scene::Scene>& scenes) {
  StepRange range;
  for (const scene::Scene& scene : scenes) {
    const auto steps = static_cast<double>(study::estimated_steps(scene).steps);
    range.least = std::min(range.least, steps);
    range.most = std::max(range.most, steps);
    range.all += steps;
  }
  return range;
}

}  // namespace

Json merged_combinations(const scene::Preset& preset) {
  std::map<std::pair<std::vector<std::string>, std::size_t>, Json> groups;
  for (const scene::StudyRow& row : preset.study) {
    if (row.combinations.size() < 2) continue;
    Json axes = Json::object();
    for (const auto& [name, text] : row.axes) axes[name] = text;
    Json& into = groups[{axes_that_differ(preset, row), row.combinations.size()}];
    into.push_back(std::move(axes));
  }
  Json list = Json::array();
  for (auto& [group, into] : groups)
    list.push_back({{"axes", group.first},
                    {"where", reason_of(group.first)},
                    {"combinations", group.second},
                    {"into", std::move(into)}});
  return list;
}

Json planned_json(const PlannedWork& work, const scene::Preset& preset) {
  Json j{{"command", work.command},
         {"counted", work.counted},
         {"count", work.count},
         {"missing", work.missing},
         {"specimens", work.specimens}};
  if (!preset.grid.empty()) {
    j["combinations"] = combinations_of(preset);
    j["merged"] = merged_combinations(preset);
  }
  Json parts = Json::array();
  for (const PlannedPart& part : work.parts)
    parts.push_back({{"name", part.name},
                     {"count", part.count},
                     {"counted", part.counted.empty() ? work.counted : part.counted},
                     {"wall_estimate_s", part.seconds}});
  j["parts"] = std::move(parts);
  if (!work.scenes.empty()) {
    const StepRange steps = steps_of(work.scenes);
    std::set<int> elements;
    for (const scene::Scene& scene : work.scenes) elements.insert(scene.specimen.elements);
    j["elements"] = elements;
    const auto expected = [&](double count) { return std::round(work.steps_factor * count); };
    j["steps_least"] = expected(steps.least), j["steps_most"] = expected(steps.most),
    j["steps"] = expected(steps.all);
    j["left_out"] = scene::left_out_by_scenarios(work.scenes);
  }
  j["wall_estimate_s"] = work.seconds;
  j["disk_estimate_bytes"] = work.disk_bytes;
  j["memory_estimate_bytes"] = work.memory_bytes;
  j["memory_available_bytes"] = base::available_memory_bytes();
  j["to_start"] = work.to_start.empty() ? Json(nullptr) : Json(work.to_start);
  return j;
}

namespace {

using Rows = std::vector<std::pair<std::string, std::string>>;

constexpr std::size_t most_merged_shown = 12;

void add_merged(Rows& rows, const Json& merged) {
  for (const Json& group : merged) {
    const auto axes = group.at("axes").get<std::vector<std::string>>();
    const Json& into = group.at("into");
    rows.emplace_back(
        &group == &merged.front() ? "merged" : "",
        fmt::format("{} {} not count where {}: {} combinations each are {} scenario{}",
                    scene::listed(axes, "and"), axes.size() == 1 ? "does" : "do",
                    group.at("where").get<std::string>(), group.at("combinations").get<std::size_t>(),
                    into.size(), into.size() == 1 ? "" : "s"));
    for (std::size_t k = 0; k < std::min(into.size(), most_merged_shown); ++k) {
      std::vector<std::string> words;
      for (const auto& [name, text] : into[k].items())
        if (text != "-") words.push_back(fmt::format("{} {}", name, text.get<std::string>()));
      rows.emplace_back("", fmt::format("  {}", fmt::join(words, ", ")));
    }
    if (into.size() > most_merged_shown)
      rows.emplace_back("",
                        fmt::format("  and {} more: --json names them all", into.size() - most_merged_shown));
  }
}

void add_scenarios(Rows& rows, const Json& j) {
  const auto counted = j.at("counted").get<std::string>();
  const int count = j.at("count").get<int>(), missing = j.at("missing").get<int>();
  std::string text = fmt::format("{} {}", count, counted);
  if (j.contains("combinations") && j.at("combinations").get<int>() != count)
    text += fmt::format(" of {} combinations", j.at("combinations").get<int>());
  if (const int specimens = j.at("specimens").get<int>(); specimens > 0)
    text += fmt::format(", {} specimen{}", specimens, specimens == 1 ? "" : "s");
  if (missing < count) text += fmt::format("; {} of them are computed already", count - missing);
  rows.emplace_back("computes", text);
  if (j.contains("merged")) add_merged(rows, j.at("merged"));
  const char* label = "parts";
  for (const Json& part : j.at("parts")) {
    const auto of_part = part.at("counted").get<std::string>();
    rows.emplace_back(
        label, fmt::format("{:<24}{:>5}{}   about {}", part.at("name").get<std::string>(),
                           part.at("count").get<int>(), of_part == counted ? std::string() : " " + of_part,
                           duration_text(part.at("wall_estimate_s").get<double>())));
    label = "";
  }
}

}  // namespace

Rows planned_rows(const Json& j) {
  Rows rows{{"command", j.at("command").get<std::string>()}};
  add_scenarios(rows, j);
  const auto number = [&](const char* key) { return j.at(key).get<double>(); };
  if (j.contains("steps")) {
    rows.emplace_back("lattice",
                      fmt::format("{} elements", fmt::join(j.at("elements").get<std::vector<int>>(), ", ")));
    rows.emplace_back("steps",
                      number("steps_least") == number("steps_most")
                          ? fmt::format("about {:.0f} each", number("steps_most"))
                          : fmt::format("about {:.0f} to {:.0f} each, {:.0f} in all", number("steps_least"),
                                        number("steps_most"), number("steps")));
  }
  const double disk = number("disk_estimate_bytes");
  rows.emplace_back(
      "cost", fmt::format("about {} from nothing, about {:.0f} of {:.0f} MB of memory{}",
                          duration_text(number("wall_estimate_s")), 1e-6 * number("memory_estimate_bytes"),
                          1e-6 * number("memory_available_bytes"),
                          disk > 0 ? fmt::format(", {:.0f} MB on disk", 1e-6 * disk)
                                   : std::string(", the cache on disk")));
  if (!j.at("to_start").is_null())
    rows.emplace_back("", "it starts with " + j.at("to_start").get<std::string>());
  const char* label = "left out";
  if (j.contains("left_out"))
    for (const Json& line : j.at("left_out")) rows.emplace_back(label, line.get<std::string>()), label = "";
  return rows;
}

}  // namespace rift::studio

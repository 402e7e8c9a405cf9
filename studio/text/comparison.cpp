#include "studio/text/comparison.hpp"

#include "engine/base/files.hpp"
#include "engine/base/world_error.hpp"
#include "engine/results/archive.hpp"
#include "engine/results/json_input.hpp"
#include "engine/results/run_folder.hpp"
#include "engine/study/store.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace rift::studio {
namespace fs = std::filesystem;
namespace {

using results::LaneSummary;
using Json = nlohmann::ordered_json;

constexpr ComparedQuantity quantities[] = {
    {"G_ID / G_I0", &LaneSummary::ratio, "{:.4f}"},
    {"± along the window", &LaneSummary::ratio_scatter, "{:.4f}"},
    {"of released beams", &LaneSummary::ratio_fracture, "{:.4f}"},
    {"Broberg's factor", &LaneSummary::broberg, "{:.4f}"},
    {"difference to Broberg", &LaneSummary::error_broberg, "{:+.4f}"},
    {"velocity [c_R]", &LaneSummary::crack_velocity_over_cr, "{:.3g}"},
    {"damage zone r_l [R]", &LaneSummary::damage_zone_ratio, "{:.3g}"},
    {"relaxation exponent", &LaneSummary::relaxation, "{:.3g}"},
    {"damping α", &LaneSummary::damping_alpha, "{:.3g}"},
    {"elements", &LaneSummary::elements, "{:.0f}"},
    {"fracture energy [J]", &LaneSummary::energy_fracture_j, "{:.4g}"},
    {"damping energy [J]", &LaneSummary::energy_damping_j, "{:.4g}"},
    {"elastic energy [J]", &LaneSummary::energy_elastic_j, "{:.4g}"},
    {"balance error", &LaneSummary::ledger_residual, "{:.0e}"},
    {"steps", &LaneSummary::steps, "{:.0f}"},
    {"crack took [s]", &LaneSummary::wall_fracture_s, "{:.2f}"},
};

std::string name_of(const fs::path& folder) {
  return folder.filename().empty() ? folder.parent_path().filename().string() : folder.filename().string();
}

void add_run(std::vector<ComparedScenario>& scenarios, const fs::path& folder) {
  // An experiment keeps its measured crack as a run.
  const bool experiment =
      !fs::exists(folder / results::journal_name) && fs::exists(folder / "run" / results::journal_name);
  const fs::path run = experiment ? folder / "run" : folder;
  const fs::path file = run / results::summary_name;
  if (!fs::exists(file))
    throw base::WorldError("compare", run,
                           fs::exists(run / results::journal_name)
                               ? "the run has not ended: 'rift resume' continues it"
                               : "it holds no run and no study");
  const std::vector<LaneSummary> lanes =
      results::lane_summaries_of(results::read_json(base::read_whole_file(file), file).at("scenarios"));
  const std::vector<std::string> titles = results::lane_titles(lanes);
  for (std::size_t k = 0; k < lanes.size(); ++k)
    scenarios.push_back({.title = fmt::format("{}: {}", name_of(folder), titles[k]),
                         .folder = run,
                         .lane = static_cast<int>(k),
                         .summary = lanes[k],
                         .series = run / "series.csv",
                         .series_lane = static_cast<int>(k)});
}

void add_study(std::vector<ComparedScenario>& scenarios, const fs::path& folder) {
  const study::StoredStudy stored = study::read_study(folder);
  for (std::size_t k = 0; k < stored.rows.size(); ++k) {
    if (!stored.rows[k]) continue;
    std::vector<std::string> values;
    for (const auto& [name, text] : stored.preset.study[k].axes)
      if (text != "-") values.push_back(fmt::format("{} {}", name, text));
    fs::path series = stored.files[k];
    scenarios.push_back({.title = fmt::format("{}: {}", name_of(folder), fmt::join(values, ", ")),
                         .folder = folder,
                         .lane = static_cast<int>(k),
                         .summary = *stored.rows[k],
                         .series = series.replace_extension(".csv")});
  }
}

/// Where the damage zones differ each title names its own.
void name_zones(std::vector<ComparedScenario>& scenarios) {
  const auto zone = [](const ComparedScenario& scenario) {
    const double r_l = scenario.summary.damage_zone_ratio;
    return std::isfinite(r_l) ? fmt::format("r_l = {:g}", r_l) : std::string();
  };
  const bool one = std::all_of(scenarios.begin(), scenarios.end(), [&](const ComparedScenario& scenario) {
    return zone(scenario) == zone(scenarios.front());
  });
  for (ComparedScenario& scenario : scenarios) {
    const bool named = scenario.title.find("r_l = ") != std::string::npos ||
                       scenario.title.find("damage_zone_ratio ") != std::string::npos;
    if (!one && !named && !zone(scenario).empty()) scenario.title += ", " + zone(scenario);
  }
}

}  // namespace

std::span<const ComparedQuantity> compared_quantities() { return quantities; }

std::vector<ComparedScenario> compared_scenarios(const std::vector<fs::path>& folders) {
  std::vector<ComparedScenario> scenarios;
  for (const fs::path& folder : folders)
    if (fs::exists(folder / study::study_name))
      add_study(scenarios, folder);
    else
      add_run(scenarios, folder);
  name_zones(scenarios);
  return scenarios;
}

std::string comparison_text(const std::vector<ComparedScenario>& scenarios, std::size_t width, bool color) {
  constexpr std::size_t names = 21, number = 10;
  std::string text;
  for (std::size_t k = 0; k < scenarios.size(); ++k)
    text += label_line(std::to_string(k + 1), heading(scenarios[k].title, color), 5);
  const std::size_t in_block = std::max<std::size_t>(1, (width - names) / (number + 2));
  for (std::size_t from = 0; from < scenarios.size(); from += in_block) {
    const std::size_t to = std::min(scenarios.size(), from + in_block);
    Table table{{""}, {}};
    for (std::size_t k = from; k < to; ++k) table.head.push_back(std::to_string(k + 1));
    for (const ComparedQuantity& quantity : quantities) {
      std::vector<std::string>& row = table.rows.emplace_back(std::vector<std::string>{quantity.name});
      for (std::size_t k = from; k < to; ++k)
        row.push_back(number_cell(scenarios[k].summary.*quantity.number, quantity.format));
    }
    text += "\n" + plain_table(table, color);
  }
  return text;
}

std::vector<Json> comparison_rows(const std::vector<ComparedScenario>& scenarios) {
  std::vector<Json> rows;
  for (std::size_t k = 0; k < scenarios.size(); ++k) {
    Json& row = rows.emplace_back(Json{{"scenario", k + 1},
                                       {"folder", scenarios[k].folder.string()},
                                       {"lane", scenarios[k].lane},
                                       {"title", scenarios[k].title}});
    row.update(results::to_json(scenarios[k].summary));
  }
  return rows;
}

}  // namespace rift::studio

#include "studio/reports/study_report.hpp"

#include "engine/base/csv.hpp"
#include "engine/base/numbers.hpp"
#include "engine/base/text.hpp"
#include "engine/base/world_error.hpp"
#include "engine/scene/needs.hpp"
#include "engine/scene/scenarios.hpp"
#include "engine/study/plan.hpp"
#include "engine/study/store.hpp"
#include "studio/reports/report.hpp"
#include "studio/reports/study_charts.hpp"
#include "studio/reports/work_precision.hpp"
#include "studio/text/progress.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace rift::studio {
namespace fs = std::filesystem;
namespace {

using Json = nlohmann::ordered_json;

constexpr const char* ratio_along_window = "G_ID/G_I0 ± along the window";
constexpr const char* to_broberg = "difference to Broberg";

void add_axes(std::vector<std::string>& cells, const study::AxisTexts& axes) {
  for (const auto& [name, text] : axes) cells.push_back(text);
}

std::vector<std::string> head_of(const study::AxisTexts& axes) {
  std::vector<std::string> head;
  for (const auto& [name, text] : axes) head.push_back(name);
  return head;
}

/// A field of a csv: what is no number is empty, axes and lists are one text.
std::string field_of(const Json& value) {
  if (value.is_null() || (value.is_number_float() && !std::isfinite(value.get<double>()))) return {};
  if (value.is_string()) return base::csv_field(value.get<std::string>());
  std::string text;
  if (value.is_object())
    for (const auto& [name, of_axis] : value.items())
      text += fmt::format("{}{} = {}", text.empty() ? "" : "; ", name, of_axis.get<std::string>());
  else if (value.is_array())
    for (const Json& part : value)
      text +=
          (text.empty() ? "" : " ") + (part.is_string() ? part.get<std::string>() : base::json_text(part));
  else
    text = base::json_text(value);
  return base::csv_field(text);
}

}  // namespace

Table scenario_table(const study::StudyRows& rows) {
  Table table;
  const bool converged = std::any_of(
      rows.begin(), rows.end(), [](const auto& row) { return row && std::isfinite(row->error_converged); });
  for (const auto& row : rows) {
    if (!row) continue;
    if (table.head.empty()) {
      table.head = head_of(row->axes);
      for (const char* name : {ratio_along_window, "Broberg", to_broberg}) table.head.emplace_back(name);
      if (converged) table.head.emplace_back("error");
      for (const char* name : {"run time [s]", "outcome"}) table.head.emplace_back(name);
    }
    std::vector<std::string> cells;
    add_axes(cells, row->axes);
    cells.push_back(scatter_cell(row->ratio, row->ratio_scatter));
    cells.push_back(number_cell(row->broberg, "{:.3f}"));
    cells.push_back(number_cell(row->error_broberg, "{:+.3f}"));
    if (converged) cells.push_back(number_cell(row->error_converged, "{:+.4f}"));
    cells.push_back(number_cell(run_time(*row), "{:.3g}"));
    cells.push_back(row->outcome);
    table.rows.push_back(std::move(cells));
  }
  return table;
}

Table seed_table(const study::StudyRows& rows) {
  Table table;
  const std::vector<RowFamily> found = families(rows, {"seed"});
  if (std::none_of(found.begin(), found.end(), [](const RowFamily& f) { return f.rows.size() > 1; }))
    return table;
  table.head = head_of(found.front().axes);
  for (const char* name :
       {"specimens", "G_ID/G_I0 ± between specimens", "Broberg", to_broberg, "run time [s]"})
    table.head.emplace_back(name);
  for (const RowFamily& family : found) {
    const MeanScatter ratio = mean_over(family.rows, &study::SummaryRow::ratio);
    std::vector<double> times;
    for (const study::SummaryRow& row : family.rows) times.push_back(run_time(row));
    std::vector<std::string> cells;
    add_axes(cells, family.axes);
    cells.push_back(std::to_string(ratio.count));
    cells.push_back(scatter_cell(ratio.mean, ratio.scatter));
    cells.push_back(number_cell(mean_over(family.rows, &study::SummaryRow::broberg).mean, "{:.3f}"));
    cells.push_back(number_cell(mean_over(family.rows, &study::SummaryRow::error_broberg).mean, "{:+.3f}"));
    cells.push_back(number_cell(base::mean_of(times), "{:.3g}"));
    table.rows.push_back(std::move(cells));
  }
  return table;
}

Table not_made_table(const study::StudyResult& result, const scene::Preset& preset) {
  Table table;
  for (const Json& one : study::to_json(result.not_made, preset)) {
    std::vector<std::string>& cells = table.rows.emplace_back();
    table.head.clear();
    for (const auto& [name, texts] : one.at("axes").items()) {
      table.head.push_back(name);
      cells.push_back(fmt::format("{}", fmt::join(texts.get<std::vector<std::string>>(), "; ")));
    }
    cells.push_back(std::to_string(one.at("rows").size()));
    cells.push_back(fmt::format("{}", fmt::join(one.at("why").get<std::vector<std::string>>(), "; ")));
    for (const char* name : {"scenarios", "why"}) table.head.emplace_back(name);
  }
  return table;
}

std::string left_out_text(const study::StudyRows& rows) {
  std::vector<std::string> parts;
  const auto there = std::count_if(rows.begin(), rows.end(), [](const auto& row) { return row.has_value(); });
  for (const scene::OptionalPart& part : scene::optional_parts()) {
    const auto without = std::count_if(rows.begin(), rows.end(), [&](const auto& row) {
      return row && std::find(row->left_out.begin(), row->left_out.end(), part.name) != row->left_out.end();
    });
    if (without == 0) continue;
    std::string& text = parts.emplace_back(part.name);
    std::replace(text.begin(), text.end(), '_', ' ');
    if (without < there) text += fmt::format(" ({} of {} scenarios)", without, there);
  }
  return fmt::format("{}", fmt::join(parts, ", "));
}

namespace {

/// The columns of all rows. One that not every row has, such as friction, stands where a row has it.
std::vector<std::string> columns_of(const std::vector<Json>& rows) {
  std::vector<std::string> names;
  for (const Json& row : rows) {
    auto place = names.begin();
    for (const auto& [name, value] : row.items()) {
      const auto known = std::find(names.begin(), names.end(), name);
      place = std::next(known == names.end() ? names.insert(place, name) : known);
    }
  }
  return names;
}

}  // namespace

std::string rows_csv(const std::vector<Json>& rows) {
  const std::vector<std::string> names = columns_of(rows);
  if (names.empty()) return {};
  std::string csv = fmt::format("{}\n", fmt::join(names, ","));
  for (const Json& row : rows) {
    std::string line;
    for (const std::string& name : names) line += "," + field_of(row.value(name, Json(nullptr)));
    csv += line.substr(1) + "\n";
  }
  return csv;
}

std::string study_csv(const Json& rows) {
  std::vector<Json> ordered;
  for (const Json& row : rows) {
    if (row.is_null()) continue;
    Json& to = ordered.emplace_back(Json{{"row", row.at("row")}, {"axes", row.at("axes")}});
    to.update(row);
  }
  return rows_csv(ordered);
}

namespace {

std::vector<fs::path> series_files(const scene::Preset& preset, const simulation::BuildInfo& build,
                                   const fs::path& folder) {
  std::vector<fs::path> files;
  for (const scene::Scene& scene : study::scenes_of_study(preset))
    files.push_back(
        study::result_file(folder, study::result_key(scene, build.version)).replace_extension(".csv"));
  return files;
}

std::string timings(const study::StudyResult& result) {
  double marching = 0.0;
  std::size_t there = 0;
  for (const auto& row : result.rows)
    if (row) marching += study::marching_time(*row), ++there;
  return fmt::format(
      "{} of {} scenarios; marching took {} in all; the last call took {} ({} computed, {} reused).", there,
      result.rows.size(), duration_text(marching), duration_text(result.wall_s), result.computed,
      result.found);
}

/// The axes' columns by their names in words, those without a second value left out: they are among the fixed
/// parameters.
Table in_words(const Table& table, const study::StudyRows& rows) {
  const std::vector<std::string> varied = varied_axes(rows);
  std::vector<std::size_t> kept;
  for (std::size_t k = 0; k < table.head.size(); ++k) {
    const bool axis = scene::find_axis(table.head[k]) != nullptr;
    if (!axis || std::find(varied.begin(), varied.end(), table.head[k]) != varied.end()) kept.push_back(k);
  }
  Table out{{}, {}};
  for (const std::size_t k : kept) out.head.push_back(axis_in_words(table.head[k]));
  for (const auto& row : table.rows) {
    std::vector<std::string>& cells = out.rows.emplace_back();
    for (const std::size_t k : kept) cells.push_back(row[k]);
  }
  return out;
}

/// What a study varies: "technique (2), v (3), specimen (seed) (2)".
std::string varied_text(const study::StudyRows& rows) {
  std::string text;
  for (const std::string& name : varied_axes(rows))
    text += fmt::format("{}{} ({} values)", text.empty() ? "" : ", ", axis_in_words(name),
                        values_of_axis(rows, name).size());
  return text.empty() ? "One scenario." : "Varied: " + text + ".";
}

}  // namespace

void write_study_report(const scene::Preset& preset, const StudyCall& call, const study::StudyResult& result,
                        const fs::path& folder) {
  const WorkPrecision work = work_precision(result.rows);
  std::vector<NamedChart> charts = velocity_charts(result.rows);
  for (NamedChart& chart : tip_charts(result.rows, series_files(preset, call.build, folder)))
    charts.push_back(std::move(chart));
  Report report{.title = "Release rates of the study " + preset_in_titles(preset.name),
                .made = {call.command, call.build, call.wall_s},
                .opening = {varied_text(result.rows), timings(result)},
                .scenes = study::scenes_of_study(preset)};
  report.sections.push_back(
      {work.converged ? "Error against run time" : "Difference to Broberg against run time",
       work_precision_charts(work), work_precision_text(work)});
  report.sections.push_back({"Schemes", work_precision_table(work)});
  report.sections.push_back({"Release rates", std::move(charts)});
  report.sections.push_back({"Scenarios", in_words(scenario_table(result.rows), result.rows)});
  Table not_made = not_made_table(result, preset);
  for (std::string& name : not_made.head) name = axis_in_words(name);
  report.sections.push_back({"Scenarios that could not be made", std::move(not_made)});
  write_report(report, folder);
}

}  // namespace rift::studio

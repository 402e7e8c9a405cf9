#include "studio/reports/accuracy_report.hpp"

#include "engine/claims/curve.hpp"
#include "studio/charts/label.hpp"
#include "studio/reports/report.hpp"
#include "studio/text/html.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace rift::studio {
namespace {

using Json = nlohmann::ordered_json;

/// "+0.0123" where four digits show it, "+1.2e-06" below.
std::string error_text(double error) {
  if (!std::isfinite(error)) return "-";
  if (error == 0.0) return "0";
  return std::abs(error) < 9.5e-4 ? fmt::format("{:+.1e}", error) : fmt::format("{:+.4f}", error);
}

std::string remark(const accuracy::Accuracy& accuracy, const accuracy::AccuracyLine& line, int position) {
  std::vector<std::string> remarks;
  if (line.factor == accuracy::Factor::elements && std::isfinite(line.error) && !line.resolved() &&
      line.uncertainty > 0.0)
    remarks.emplace_back("below the scatter");
  if (line.reference) remarks.emplace_back("reference");
  if (line.factor == accuracy::Factor::kinematics && !line.reference) remarks.emplace_back("another model");
  if (position == accuracy.recommended)
    remarks.emplace_back("recommended");
  else if (std::find(accuracy.front.begin(), accuracy.front.end(), position) != accuracy.front.end())
    remarks.emplace_back("efficient");
  return fmt::format("{}", fmt::join(remarks, ", "));
}

double lane_wall(const AccuracyReport& report) {
  double sum = 0.0;
  for (const study::SummaryRow& row : report.lanes) sum += row.wall_fracture_s;
  return sum / static_cast<double>(report.lanes.size());
}

std::string scatter_text(const accuracy::Accuracy& accuracy) {
  if (!std::isfinite(accuracy.specimen_scatter)) return {};
  return fmt::format("; specimens of the finest lattice scatter by {:.3f} (standard deviation)",
                     accuracy.specimen_scatter);
}

Json line_json(const accuracy::AccuracyLine& line) {
  return {{"knob", accuracy::name_of(line.factor)},
          {"variant", line.label},
          {"specimens", line.specimens},
          {"ratio", line.ratio},
          {"scatter", line.scatter},
          {"error", line.error},
          {"uncertainty", line.uncertainty},
          {"resolved", line.resolved()},
          {"error_converged", line.converged},
          {"error_converged_uncertainty", line.converged_uncertainty},
          {"error_broberg", line.error_broberg},
          {"wall_s", line.wall_s},
          {"cannot_be", line.cannot_be.empty() ? Json(nullptr) : Json(line.cannot_be)}};
}

}  // namespace

Table accuracy_table(const accuracy::Accuracy& accuracy) {
  Table table{.head = {"parameter", "variant", "ratio", "error", "std. uncertainty", "total error",
                       "diff. to Broberg", "wall [s]", ""},
              .rows = {}};
  accuracy::Factor last = accuracy::Factor::scene;
  for (std::size_t k = 0; k < accuracy.lines.size(); ++k) {
    const accuracy::AccuracyLine& line = accuracy.lines[k];
    const std::string factor = k > 0 && line.factor == last ? "" : accuracy::name_of(line.factor);
    last = line.factor;
    if (!line.cannot_be.empty()) {
      table.rows.push_back(
          {factor, line.label, "-", "-", "-", "-", "-", "-", "not computed: " + line.cannot_be});
      continue;
    }
    table.rows.push_back(
        {factor, line.label, number_cell(line.ratio, "{:.5f}"), error_text(line.error),
         line.factor == accuracy::Factor::elements ? number_cell(line.uncertainty, "{:.4f}") : "-",
         error_text(line.converged), number_cell(line.error_broberg, "{:+.3f}"),
         number_cell(line.wall_s, "{:.3f}"), remark(accuracy, line, static_cast<int>(k))});
  }
  return table;
}

std::string recommendation_text(const AccuracyReport& report) {
  const accuracy::Accuracy& a = report.accuracy;
  if (a.recommended < 0)
    return fmt::format("no variant is within the goal of {:g}; the most accurate one is {}", report.goal,
                       a.front.empty() ? std::string("not known") : a.lines[a.front.back()].label);
  const accuracy::AccuracyLine& line = a.lines[a.recommended];
  std::string text =
      fmt::format("{}: error {} in {:.2f} s", line.label, error_text(line.step_error), line.wall_s);
  if (!report.lanes.empty())
    text += fmt::format(", {} lanes side by side {:.3f} s each", report.lanes.size(), lane_wall(report));
  return text + fmt::format(" (goal {:g})", report.goal);
}

std::string lattice_text(const AccuracyReport& report) {
  const accuracy::Accuracy& a = report.accuracy;
  std::string text = "it is the finest one compared, so its own error is not known";
  if (std::isfinite(a.lattice_error)) {
    const bool resolved = std::abs(a.lattice_error) > 2.0 * a.lattice_uncertainty;
    text = fmt::format("error {} (standard uncertainty {:.4f}) compared with the finest lattice{}",
                       error_text(a.lattice_error), a.lattice_uncertainty,
                       resolved ? "" : ", below the scatter");
  }
  text += scatter_text(a);
  if (!std::isfinite(a.lattice_error)) return text;
  if (a.recommended_whole < 0) return text + "; including it, no variant is known to be within the goal";
  const accuracy::AccuracyLine& line = a.lines[a.recommended_whole];
  text += fmt::format("; including it, the cheapest variant within the goal is {}: {} in {:.2f} s",
                      line.label, error_text(line.converged), line.wall_s);
  return text + (line.reference ? ", the finest lattice"
                                : fmt::format(" (standard uncertainty {:.4f})", line.converged_uncertainty));
}

std::string accuracy_text(const AccuracyReport& report, bool color) {
  std::string text = plain_table(accuracy_table(report.accuracy), color) + "\n";
  text +=
      "error: difference to the reference of the parameter (below); total error: difference to the converged "
      "ratio, all parts together\nefficient: no other variant has both a smaller error and a shorter run "
      "time\n";
  for (const std::string& line : accuracy::reference_texts(report.accuracy)) text += "  " + line + "\n";
  for (const std::string& note : report.notes) text += "  note: " + note + "\n";
  text += "recommended on this lattice: " + recommendation_text(report) + "\n";
  return text + "error of the lattice: " + lattice_text(report) + "\n";
}

Json accuracy_rows(const AccuracyReport& report) {
  Json rows = Json::array();
  for (const accuracy::AccuracyLine& line : report.accuracy.lines)
    for (const int k : line.results) {
      const std::optional<study::SummaryRow>& computed = report.results[static_cast<std::size_t>(k)].row;
      if (!computed) continue;
      Json row = to_json(*computed);
      row["row"] = k;
      row["error_converged"] = line.converged;
      row["knob"] = accuracy::name_of(line.factor);
      row["variant"] = line.label;
      row["error_knob"] = line.error;
      row["uncertainty"] = line.uncertainty;
      row["wall_march_s"] = line.wall_s;
      rows.push_back(std::move(row));
    }
  return rows;
}

Json accuracy_json(const AccuracyReport& report) {
  Json lines = Json::array();
  for (const accuracy::AccuracyLine& line : report.accuracy.lines) lines.push_back(line_json(line));
  Json recommended = nullptr;
  if (report.accuracy.recommended >= 0) {
    recommended = line_json(report.accuracy.lines[report.accuracy.recommended]);
    recommended["lanes"] = report.lanes.size();
    recommended["wall_s_of_a_lane"] = report.lanes.empty() ? Json(nullptr) : Json(lane_wall(report));
  }
  return {{"preset", report.preset},
          {"version", report.build.version},
          {"goal", report.goal},
          {"notes", report.notes},
          {"compared", accuracy::reference_texts(report.accuracy)},
          {"specimen_scatter", report.accuracy.specimen_scatter},
          {"lines", lines},
          {"recommendation", recommendation_text(report)},
          {"lattice", lattice_text(report)},
          {"recommended", recommended},
          {"scenarios", accuracy_rows(report)}};
}

void write_accuracy_report(const AccuracyReport& report, const std::filesystem::path& folder) {
  std::string compared = html_paragraph(
      "\"error\" is the difference to the reference of the parameter alone; \"total error\" is the "
      "difference to the converged ratio, all parts together. The difference to Broberg's theory is no error "
      "of the computation and has a column of its own. An efficient variant is one for which no other has "
      "both a smaller error and a shorter run time. Wall times are those of the march alone, each variant "
      "computed separately: packing and static solve are cached.");
  for (const std::string& line : accuracy::reference_texts(report.accuracy)) compared += html_paragraph(line);
  for (const std::string& note : report.notes) compared += html_paragraph("Note: " + note);
  const std::string recommended = html_paragraph("On this lattice: " + recommendation_text(report)) +
                                  html_paragraph("Error of the lattice: " + lattice_text(report));
  std::vector<scene::Scene> scenes;
  for (const accuracy::CaseResult& result : report.results) scenes.push_back(result.setup.scene);
  write_report({.title = "Error against run time of " + preset_in_titles(report.preset),
                .made = {report.command, report.build, report.wall_s},
                .scenes = std::move(scenes),
                .sections = {{"Recommended", recommended},
                             {"Charts", accuracy_charts(report.results, report.accuracy, report.goal)},
                             {"Variants", accuracy_table(report.accuracy)},
                             {"What is compared with what", compared}}},
               folder);
}

namespace {

constexpr double smallest_drawn = 1e-7;  // errors below it are rounding, of no use in a chart

/// A series of a logarithmic chart, and how many of its points could not be drawn.
struct LogSeries {
  ChartSeries series;
  int left_out = 0;

  void add(double x, double error) {
    if (!std::isfinite(x) || !std::isfinite(error)) return;
    if (std::abs(error) < smallest_drawn)
      ++left_out;
    else
      series.add(x, std::abs(error));
  }
};

std::string left_out_text(int count) {
  if (count == 0) return {};
  return fmt::format(" Not drawn: {} with an error below {:g}, among them the references.", count,
                     smallest_drawn);
}

const char* series_label(accuracy::Factor factor) {
  switch (factor) {
    case accuracy::Factor::scene:
      return "the scene unchanged";
    case accuracy::Factor::time_step:
      return "time step, double";
    case accuracy::Factor::precision:
      return "time step, single";
    case accuracy::Factor::together:
      return "single, few samples";
    case accuracy::Factor::prestress:
      return "ramp instead of statics";
    case accuracy::Factor::samples:
      return "number of samples";
    default:
      return "elements, to the finest";
  }
}

/// The efficient variants, joined and named; and the recommended one.
std::vector<ChartSeries> front_of(const accuracy::Accuracy& accuracy) {
  ChartSeries front{.label = "efficient front", .style = ChartSeries::Style::line, .colour = -1},
      best{.style = ChartSeries::Style::points, .colour = -1};
  for (const int k : accuracy.front) {
    const accuracy::AccuracyLine& line = accuracy.lines[static_cast<std::size_t>(k)];
    const double error = std::abs(line.step_error);
    if (!(error >= smallest_drawn) || !(line.wall_s > 0.0)) continue;
    front.add(line.wall_s, error);
    front.text.push_back(k == accuracy.recommended ? "recommended" : line.label);
    if (k != accuracy.recommended) continue;
    best.label = "recommended: " + escape_label(line.label);
    best.add(line.wall_s, error);
  }
  return {std::move(front), std::move(best)};
}

NamedChart work_precision(const accuracy::Accuracy& accuracy, double goal) {
  Chart chart{.title = "Error of the release rate against run time",
              .x_label = "run time of the march [s]",
              .y_label = "|error of G_{ID} / G_{I0}| [-]",
              .log_x = true,
              .log_y = true};
  int left_out = 0;
  double from = INFINITY, to = 0.0;
  constexpr accuracy::Factor factors[] = {accuracy::Factor::time_step, accuracy::Factor::precision,
                                          accuracy::Factor::together,  accuracy::Factor::elements,
                                          accuracy::Factor::samples,   accuracy::Factor::prestress,
                                          accuracy::Factor::scene};
  for (const accuracy::Factor factor : factors) {
    LogSeries points{{.label = series_label(factor),
                      .style = ChartSeries::Style::points,
                      .colour = static_cast<int>(chart.series.size())}};
    for (const accuracy::AccuracyLine& line : accuracy.lines)
      if (line.factor == factor && line.cannot_be.empty() && line.wall_s > 0.0)
        points.add(line.wall_s, factor == accuracy::Factor::elements ? line.error : line.step_error);
    left_out += points.left_out;
    if (points.series.x.empty()) continue;
    from = std::min(from, *std::min_element(points.series.x.begin(), points.series.x.end()));
    to = std::max(to, *std::max_element(points.series.x.begin(), points.series.x.end()));
    chart.series.push_back(std::move(points.series));
  }
  if (!chart.series.empty()) {
    for (ChartSeries& series : front_of(accuracy))
      if (!series.x.empty()) chart.series.push_back(std::move(series));
    chart.series.push_back(level(fmt::format("goal {:g}", goal), goal, from, to));
    if (accuracy.specimen_scatter > smallest_drawn)
      chart.series.push_back(level("scatter between specimens", accuracy.specimen_scatter, from, to));
  }
  return {
      "work_precision",
      "Error and the time that the march takes, each variant computed by itself: down and to the left is "
      "better, and on the front no other variant on this lattice is both faster and more accurate. Errors "
      "are against the converged step on the scene's own specimen, those of elements against the finest "
      "lattice, means over the specimens; an error of elements below their scatter is not resolved." +
          left_out_text(left_out),
      std::move(chart)};
}

/// C h^p through the second finest step that is drawn, over all of them.
ChartSeries order_line(const ChartSeries& steps, double order, const std::string& label) {
  ChartSeries series{.label = label, .colour = -1};
  const std::size_t at = std::min<std::size_t>(1, steps.x.size() - 1);
  for (const double x : {steps.x.front(), steps.x.back()})
    series.add(x, steps.y[at] * std::pow(x / steps.x[at], order));
  return series;
}

NamedChart error_step(const accuracy::Accuracy& accuracy) {
  Chart chart{.title = "Error of the time step on one specimen",
              .x_label = "time step over the critical one [-]",
              .y_label = "|error of G_{ID}/G_{I0}| against the converged step [-]",
              .log_x = true,
              .log_y = true};
  int left_out = 0;
  for (const bool in_double : {true, false}) {
    LogSeries points{{.label = in_double ? "double" : "single",
                      .style = in_double ? ChartSeries::Style::line_points : ChartSeries::Style::points,
                      .colour = in_double ? 0 : 1}};
    for (const accuracy::AccuracyLine& line : accuracy.lines)
      if (line.factor == (in_double ? accuracy::Factor::time_step : accuracy::Factor::precision) &&
          line.cannot_be.empty())
        points.add(line.value, line.step_error);
    left_out += points.left_out;
    if (!points.series.x.empty()) chart.series.push_back(std::move(points.series));
  }
  std::string caption =
      "Error of the release-rate ratio against the time step, in fractions of the critical step.";
  for (const accuracy::FactorReference& r : accuracy.reference) {
    if (r.factor != accuracy::Factor::time_step || chart.series.empty()) continue;
    const accuracy::Convergence& c = r.convergence;
    caption += " In double precision: " + c.text + ".";
    ChartSeries& in_double = chart.series.front();
    if (c.clean) in_double.label = fmt::format("double, observed order {:.2f}", c.order);
    chart.series.push_back(c.clean ? order_line(in_double, c.order, fmt::format("order {:.2f}", c.order))
                                   : order_line(in_double, 2.0, "order 2, for comparison"));
  }
  return {"error_step", caption + left_out_text(left_out), std::move(chart)};
}

NamedChart ratio_elements(const std::vector<accuracy::CaseResult>& results,
                          const accuracy::Accuracy& accuracy) {
  Chart chart{.title = "Release rate against the number of elements",
              .x_label = "elements",
              .y_label = "G_{ID} / G_{I0} [-]",
              .log_x = true};
  ChartSeries mean{.label = "mean of the specimens", .style = ChartSeries::Style::line_points},
      each{.label = "each specimen", .style = ChartSeries::Style::points, .colour = 1};
  for (const accuracy::AccuracyLine& line : accuracy.lines) {
    if (line.factor != accuracy::Factor::elements || !std::isfinite(line.ratio)) continue;
    mean.add(line.value, line.ratio, line.scatter);
    for (const int k : line.results)
      if (const auto& row = results[static_cast<std::size_t>(k)].row) each.add(line.value, row->ratio);
  }
  if (mean.x.size() >= 2) {
    const double broberg = results.front().row.value_or(study::SummaryRow{}).broberg;
    const double first = mean.x.front(), last = mean.x.back();
    chart.series = {std::move(mean), std::move(each)};
    if (std::isfinite(broberg)) chart.series.push_back(level("Broberg", broberg, first, last));
  }
  return {"ratio_elements",
          "Ratio against the number of elements, mean of the specimens; bars: standard deviation between "
          "specimens, each a random packing.",
          std::move(chart)};
}

}  // namespace

std::vector<NamedChart> accuracy_charts(const std::vector<accuracy::CaseResult>& results,
                                        const accuracy::Accuracy& accuracy, double goal) {
  return those_with_points(
      {work_precision(accuracy, goal), error_step(accuracy), ratio_elements(results, accuracy)});
}

}  // namespace rift::studio

#include "studio/reports/work_precision.hpp"

#include "engine/base/numbers.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

namespace rift::studio {
namespace {

constexpr std::array of_accuracy{"elements", "dt_fraction", "precision", "samples"};
constexpr std::array of_problem{"crack_velocity", "path", "length", "layers", "plane"};
constexpr double smallest_error = 1e-7;  // below it is rounding, which a logarithmic chart has no place for
constexpr std::size_t most_panels = 9;

template <std::size_t n>
bool is_one_of(const std::array<const char*, n>& names, const std::string& name) {
  return std::find(names.begin(), names.end(), name) != names.end();
}

/// How accurate a value of an axis of accuracy is; larger is better.
double rank_of(const std::string& name, const std::string& value) {
  if (name == "precision") return value == "double" ? 1.0 : 0.0;
  return name == "dt_fraction" ? -number_of_value(value) : number_of_value(value);
}

/// Whether `a` is at least as accurate as `b` in every axis of accuracy, and better in one.
bool is_better(const study::AxisTexts& a, const study::AxisTexts& b) {
  bool better = false;
  for (const char* name : of_accuracy) {
    const double first = rank_of(name, value_of_axis(a, name)),
                 second = rank_of(name, value_of_axis(b, name));
    if (first < second) return false;
    better = better || first > second;
  }
  return better;
}

/// The row that is better than all the others, or null.
const study::SummaryRow* best_of(const std::vector<study::SummaryRow>& rows) {
  const study::SummaryRow* best = &rows.front();
  for (const study::SummaryRow& row : rows)
    if (is_better(row.axes, best->axes)) best = &row;
  const bool best_of_all = std::all_of(rows.begin(), rows.end(), [&](const study::SummaryRow& row) {
    return &row == best || is_better(best->axes, row.axes);
  });
  return best_of_all ? best : nullptr;
}

/// The place of axes in a list, which grows where they are new.
int place_in(std::vector<study::AxisTexts>& list, const study::AxisTexts& axes) {
  const auto found = std::find(list.begin(), list.end(), axes);
  if (found != list.end()) return static_cast<int>(found - list.begin());
  list.push_back(axes);
  return static_cast<int>(list.size()) - 1;
}

/// The axes of the problem, or all others; of both those that the study varies.
study::AxisTexts part_of_axes(study::AxisTexts axes, const std::vector<std::string>& varied, bool problem) {
  std::erase_if(axes, [&](const auto& axis) {
    return is_one_of(of_problem, axis.first) != problem ||
           std::find(varied.begin(), varied.end(), axis.first) == varied.end();
  });
  return axes;
}

double error_of(const study::SummaryRow& row, bool converged) {
  return converged ? row.error_converged : row.error_broberg;
}

/// Marks the points of one problem without a faster and nearer one; a reference has no error to compare.
void mark_front(std::vector<WorkPoint>& points, int problem) {
  std::vector<WorkPoint*> order;
  for (WorkPoint& p : points)
    if (p.problem == problem && !p.reference && std::isfinite(p.error) && std::isfinite(p.run_time_s))
      order.push_back(&p);
  std::stable_sort(order.begin(), order.end(),
                   [](const WorkPoint* a, const WorkPoint* b) { return a->run_time_s < b->run_time_s; });
  double best = std::numeric_limits<double>::infinity();
  for (WorkPoint* p : order)
    if (std::abs(p->error) < best) p->efficient = true, best = std::abs(p->error);
}

}  // namespace

double run_time(const study::SummaryRow& row) { return row.cost_s; }

study::StudyRows with_converged_errors(study::StudyRows rows) {
  for (const RowFamily& family : families(rows, {of_accuracy.begin(), of_accuracy.end()})) {
    const study::SummaryRow* reference = best_of(family.rows);
    if (!reference) continue;
    for (const study::SummaryRow& row : family.rows) {
      double& error = rows[static_cast<std::size_t>(row.row)]->error_converged;
      if (row.row != reference->row && !std::isfinite(error)) error = row.ratio - reference->ratio;
    }
  }
  return rows;
}

WorkPrecision work_precision(const study::StudyRows& rows) {
  WorkPrecision work;
  work.converged = std::any_of(rows.begin(), rows.end(),
                               [](const auto& row) { return row && std::isfinite(row->error_converged); });
  const std::vector<std::string> varied = varied_axes(rows);
  for (const RowFamily& family : families(rows, {"seed"})) {
    std::vector<double> errors, times;
    for (const study::SummaryRow& row : family.rows) {
      times.push_back(run_time(row));
      if (const double error = error_of(row, work.converged); std::isfinite(error)) errors.push_back(error);
    }
    const bool reference = work.converged && errors.empty();
    const double ratio = mean_over(family.rows, &study::SummaryRow::ratio).mean;
    if (!std::isfinite(ratio)) continue;
    work.points.push_back({.scheme = place_in(work.schemes, part_of_axes(family.axes, varied, false)),
                           .problem = place_in(work.problems, part_of_axes(family.axes, varied, true)),
                           .run_time_s = base::mean_of(times),
                           .ratio = ratio,
                           .error = base::mean_of(errors),
                           .scatter = base::deviation_of(errors),
                           .specimens = static_cast<int>(family.rows.size()),
                           .reference = reference});
  }
  for (std::size_t problem = 0; problem < work.problems.size(); ++problem)
    mark_front(work.points, static_cast<int>(problem));
  return work;
}

namespace {

const char* error_in_words(const WorkPrecision& work) {
  return work.converged ? "error against the converged reference" : "difference to Broberg";
}

bool can_be_drawn(const WorkPoint& p) {
  return std::isfinite(p.error) && std::abs(p.error) >= smallest_error && p.run_time_s > 0.0;
}

/// A series for each scheme, and the front through the efficient ones.
ChartPanel panel_of(const WorkPrecision& work, int problem) {
  ChartPanel panel{.title = axes_label(work.problems[static_cast<std::size_t>(problem)])};
  std::vector<const WorkPoint*> front;
  for (const WorkPoint& p : work.points) {
    if (p.problem != problem || !can_be_drawn(p)) continue;
    if (p.efficient) front.push_back(&p);
    ChartSeries series{.label = fmt::format("{}: {}", p.scheme + 1,
                                            axes_label(work.schemes[static_cast<std::size_t>(p.scheme)])),
                       .style = ChartSeries::Style::points,
                       .colour = p.scheme,
                       .text = {std::to_string(p.scheme + 1)}};
    series.x.push_back(p.run_time_s), series.y.push_back(std::abs(p.error));
    panel.series.push_back(std::move(series));
  }
  if (panel.series.empty()) return panel;
  std::sort(front.begin(), front.end(),
            [](const WorkPoint* a, const WorkPoint* b) { return a->run_time_s < b->run_time_s; });
  panel.series.push_back(
      series_of("efficient front", ChartSeries::Style::line, -1, front, [](const WorkPoint* p) {
        return ChartPoint{p->run_time_s, std::abs(p->error)};
      }));
  return panel;
}

std::string caption_of(const WorkPrecision& work) {
  const auto left_out = std::count_if(work.points.begin(), work.points.end(),
                                      [](const WorkPoint& p) { return !p.reference && !can_be_drawn(p); });
  std::string text = fmt::format(
      "{} against run time, both logarithmic, means over the specimens; down and to the left is better. The "
      "numbers are those of the table of schemes. On the efficient front no other scheme of the panel is "
      "both "
      "faster and nearer.",
      work.converged ? "Error against the converged reference"
                     : "Difference to Broberg (no numerical error)");
  if (left_out > 0)
    text += fmt::format(" {} without an error of at least {:g} cannot be drawn.", left_out, smallest_error);
  return text;
}

}  // namespace

std::vector<NamedChart> work_precision_charts(const WorkPrecision& work) {
  std::vector<ChartPanel> panels;
  for (std::size_t problem = 0; problem < work.problems.size(); ++problem)
    if (ChartPanel panel = panel_of(work, static_cast<int>(problem)); !panel.series.empty())
      panels.push_back(std::move(panel));
  const std::string title =
      work.converged ? "Error against run time" : "Difference to Broberg against run time";
  const std::string x_label = "run time of the scheme [s]";
  const std::string y_label =
      work.converged ? "|error of G_{ID} / G_{I0}| [-]" : "|G_{ID} / G_{I0} - Broberg| [-]";
  const auto name = [](std::size_t k) {
    return k == 0 ? std::string("work_precision") : fmt::format("work_precision_{}", k + 1);
  };
  std::vector<NamedChart> charts;
  if (panels.size() == 1)
    charts.push_back({name(0), caption_of(work),
                      Chart{.title = title,
                            .x_label = x_label,
                            .y_label = y_label,
                            .log_x = true,
                            .log_y = true,
                            .series = std::move(panels.front().series)}});
  else
    for (std::size_t from = 0; from < panels.size(); from += most_panels) {
      const auto first = panels.begin() + static_cast<std::ptrdiff_t>(from);
      const auto last =
          panels.begin() + static_cast<std::ptrdiff_t>(std::min(panels.size(), from + most_panels));
      charts.push_back({name(charts.size()), caption_of(work),
                        ChartGrid{.title = title,
                                  .x_label = x_label,
                                  .y_label = y_label,
                                  .log_x = true,
                                  .log_y = true,
                                  .panels = {first, last}}});
    }
  return charts;
}

Table work_precision_table(const WorkPrecision& work) {
  Table table;
  if (work.points.empty()) return table;
  table.head = {"no."};
  for (const auto& [name, text] : work.schemes.front()) table.head.push_back(axis_in_words(name));
  for (const auto& [name, text] : work.problems.front()) table.head.push_back(axis_in_words(name));
  for (const char* name :
       {"specimens", "G_ID/G_I0", error_in_words(work), "± between specimens", "run time [s]", ""})
    table.head.emplace_back(name);
  for (const WorkPoint& p : work.points) {
    std::vector<std::string> cells{std::to_string(p.scheme + 1)};
    for (const auto& [name, text] : work.schemes[static_cast<std::size_t>(p.scheme)]) cells.push_back(text);
    for (const auto& [name, text] : work.problems[static_cast<std::size_t>(p.problem)]) cells.push_back(text);
    cells.push_back(std::to_string(p.specimens));
    cells.push_back(number_cell(p.ratio, "{:.4f}"));
    cells.push_back(number_cell(p.error, "{:+.4f}"));
    cells.push_back(number_cell(p.scatter, "{:.4f}"));
    cells.push_back(number_cell(p.run_time_s, "{:.3g}"));
    cells.emplace_back(p.reference ? "reference" : p.efficient ? "efficient" : "");
    table.rows.push_back(std::move(cells));
  }
  return table;
}

std::string work_precision_text(const WorkPrecision& work) {
  if (work.converged)
    return "The error is the distance to the converged reference: the otherwise same scenario with the most "
           "elements, the smallest step, double precision and the most samples that this study holds.";
  return "This study holds no converged reference, so that no numerical error is known: an axis of accuracy "
         "gives one, such as dt_fraction = [0.05, 0.5] or elements = [5000, 20000]; 'rift accuracy' does it "
         "for "
         "one scenario. The difference to Broberg's theory is shown instead, which is no error: his body is "
         "infinite.";
}

}  // namespace rift::studio

#include "studio/report/accuracy_report.hpp"

#include "engine/base/files.hpp"
#include "engine/base/world_error.hpp"
#include "engine/study/curve.hpp"
#include "studio/report/accuracy_charts.hpp"
#include "studio/report/html.hpp"
#include "studio/report/progress.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <optional>

namespace rift::studio {
namespace {

using Json = nlohmann::ordered_json;

std::string fixed(double value, const char* format) {
  return std::isfinite(value) ? fmt::format(fmt::runtime(format), value) : "-";
}

/// "+0.0123" where four digits show it, "+1.2e-06" below.
std::string error_text(double error) {
  if (!std::isfinite(error)) return "-";
  if (error == 0.0) return "0";
  return std::abs(error) < 9.5e-4 ? fmt::format("{:+.1e}", error) : fmt::format("{:+.4f}", error);
}

std::string remark(const study::Accuracy& accuracy, const study::AccuracyLine& line, int position) {
  std::vector<std::string> remarks;
  if (line.knob == study::Knob::elements && std::isfinite(line.error) && !line.resolved() &&
      line.uncertainty > 0.0)
    remarks.emplace_back("below the scatter");
  if (line.reference) remarks.emplace_back("reference");
  if (line.knob == study::Knob::kinematics && !line.reference) remarks.emplace_back("another model");
  if (position == accuracy.recommended)
    remarks.emplace_back("recommended");
  else if (std::find(accuracy.front.begin(), accuracy.front.end(), position) != accuracy.front.end())
    remarks.emplace_back("on the front");
  std::string text;
  for (const std::string& r : remarks) text += (text.empty() ? "" : ", ") + r;
  return text;
}

double lane_wall(const AccuracyReport& report) {
  double sum = 0.0;
  for (const study::SummaryRow& row : report.lanes) sum += study::number_in(row, "wall_fracture_s");
  return sum / static_cast<double>(report.lanes.size());
}

std::string scatter_text(const study::Accuracy& accuracy) {
  if (!std::isfinite(accuracy.specimen_scatter)) return {};
  return fmt::format("; specimens of the finest lattice scatter by {:.3f} (standard deviation)",
                     accuracy.specimen_scatter);
}

Json line_json(const study::AccuracyLine& line) {
  const auto number = [](double v) { return std::isfinite(v) ? Json(v) : Json(nullptr); };
  return {{"knob", study::name_of(line.knob)},
          {"variant", line.label},
          {"specimens", line.specimens},
          {"ratio", number(line.ratio)},
          {"scatter", number(line.scatter)},
          {"error", number(line.error)},
          {"uncertainty", number(line.uncertainty)},
          {"resolved", line.resolved()},
          {"error_converged", number(line.converged)},
          {"error_converged_uncertainty", number(line.converged_uncertainty)},
          {"error_broberg", number(line.error_broberg)},
          {"wall_s", number(line.wall_s)},
          {"cannot_be", line.cannot_be.empty() ? Json(nullptr) : Json(line.cannot_be)}};
}

}  // namespace

Table accuracy_table(const study::Accuracy& accuracy) {
  Table table{.head = {"knob", "variant", "ratio", "error", "±", "converged", "to Broberg", "wall [s]", ""},
              .rows = {}};
  study::Knob last = study::Knob::scene;
  for (std::size_t k = 0; k < accuracy.lines.size(); ++k) {
    const study::AccuracyLine& line = accuracy.lines[k];
    const std::string knob = k > 0 && line.knob == last ? "" : study::name_of(line.knob);
    last = line.knob;
    if (!line.cannot_be.empty()) {
      table.rows.push_back({knob, line.label, "-", "-", "-", "-", "-", "-", "cannot be: " + line.cannot_be});
      continue;
    }
    table.rows.push_back({knob, line.label, fixed(line.ratio, "{:.5f}"), error_text(line.error),
                          line.knob == study::Knob::elements ? fixed(line.uncertainty, "{:.4f}") : "-",
                          error_text(line.converged), fixed(line.error_broberg, "{:+.3f}"),
                          fixed(line.wall_s, "{:.3f}"), remark(accuracy, line, static_cast<int>(k))});
  }
  return table;
}

std::string recommendation_text(const AccuracyReport& report) {
  const study::Accuracy& a = report.accuracy;
  if (a.recommended < 0)
    return fmt::format("no variant is within the goal of {:g}; the most accurate one is {}", report.goal,
                       a.front.empty() ? std::string("not known") : a.lines[a.front.back()].label);
  const study::AccuracyLine& line = a.lines[a.recommended];
  std::string text =
      fmt::format("{}: error {} in {:.2f} s", line.label, error_text(line.step_error), line.wall_s);
  if (!report.lanes.empty())
    text += fmt::format(", {} lanes side by side {:.3f} s each", report.lanes.size(), lane_wall(report));
  return text + fmt::format(" (goal {:g})", report.goal);
}

std::string lattice_text(const AccuracyReport& report) {
  const study::Accuracy& a = report.accuracy;
  std::string text = "the finest one that was tried, so that its own error is not known";
  if (std::isfinite(a.lattice_error)) {
    const bool resolved = std::abs(a.lattice_error) > 2.0 * a.lattice_uncertainty;
    text = fmt::format("error {} ± {:.4f} against the finest one{}", error_text(a.lattice_error),
                       a.lattice_uncertainty, resolved ? "" : ", below the scatter");
  }
  text += scatter_text(a);
  if (!std::isfinite(a.lattice_error)) return text;
  if (a.recommended_whole < 0) return text + "; no variant is known to keep to the goal with it";
  const study::AccuracyLine& line = a.lines[a.recommended_whole];
  text += fmt::format("; with it, the cheapest within the goal is {}: {} in {:.2f} s", line.label,
                      error_text(line.converged), line.wall_s);
  return text +
         (line.reference ? ", the finest itself" : fmt::format(" (± {:.4f})", line.converged_uncertainty));
}

std::string accuracy_text(const AccuracyReport& report, bool color) {
  std::string text = plain_table(accuracy_table(report.accuracy), color) + "\n";
  text +=
      "error: against what the knob is compared with; converged: against the converged reference, all parts "
      "together\n";
  for (const std::string& line : study::reference_texts(report.accuracy)) text += "  " + line + "\n";
  for (const std::string& note : report.notes) text += "  note: " + note + "\n";
  text += "recommended on this lattice: " + recommendation_text(report) + "\n";
  return text + "the lattice itself: " + lattice_text(report) + "\n";
}

std::vector<study::SummaryRow> accuracy_rows(const AccuracyReport& report) {
  const auto number = [](double v) { return std::isfinite(v) ? Json(v) : Json(nullptr); };
  std::vector<study::SummaryRow> rows;
  for (const study::AccuracyLine& line : report.accuracy.lines)
    for (const int k : line.tried) {
      study::SummaryRow row = report.tried[static_cast<std::size_t>(k)].row;
      if (!row.is_object()) continue;
      row["row"] = k;
      row["error_converged"] = number(line.converged);
      row["knob"] = study::name_of(line.knob);
      row["variant"] = line.label;
      row["error_knob"] = number(line.error);
      row["uncertainty"] = number(line.uncertainty);
      row["wall_march_s"] = number(line.wall_s);
      rows.push_back(std::move(row));
    }
  return rows;
}

Json accuracy_json(const AccuracyReport& report) {
  Json lines = Json::array();
  for (const study::AccuracyLine& line : report.accuracy.lines) lines.push_back(line_json(line));
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
          {"compared", study::reference_texts(report.accuracy)},
          {"specimen_scatter", std::isfinite(report.accuracy.specimen_scatter)
                                   ? Json(report.accuracy.specimen_scatter)
                                   : Json(nullptr)},
          {"lines", lines},
          {"recommendation", recommendation_text(report)},
          {"lattice", lattice_text(report)},
          {"recommended", recommended},
          {"scenarios", accuracy_rows(report)}};
}

void write_accuracy_report(const AccuracyReport& report, const std::filesystem::path& folder) {
  std::string figures;
  std::optional<base::WorldError> failure;
  for (const NamedChart& named : accuracy_charts(report.tried, report.accuracy, report.goal)) {
    try {
      figures += html_figure(draw_chart(named.chart, folder / "charts", named.name).svg_text, named.caption);
    } catch (const base::WorldError& error) {
      failure = error;
      figures += html_paragraph(fmt::format("{}: {}", named.name, error.what()));
    }
  }
  std::string compared = html_paragraph(
      "\"error\" is against what the knob is compared with, and nothing else; \"converged\" is against the "
      "converged "
      "reference, all parts together; the distance to Broberg's theory is no error of the computation and is "
      "kept "
      "apart. Wall times are those of the march alone, each variant by itself: packing and static solve are "
      "cached.");
  for (const std::string& line : study::reference_texts(report.accuracy)) compared += html_paragraph(line);
  for (const std::string& note : report.notes) compared += html_paragraph("Note: " + note);
  std::string body =
      html_paragraph(fmt::format("Made by `{}`, rift {} ({}), in {}.", report.command, report.build.version,
                                 report.build.compiler, duration_text(report.wall_s)));
  body += html_section("Recommended", html_paragraph("On this lattice: " + recommendation_text(report)) +
                                          html_paragraph("The lattice itself: " + lattice_text(report)));
  body += html_section("Charts", figures);
  body += html_section("Variants", html_table(accuracy_table(report.accuracy)));
  body += html_section("What is compared with what", compared);
  base::write_whole_file(folder / "report.html", html_page("Error against run time: " + report.preset, body));
  if (failure) throw base::WorldError(*failure);
}

}  // namespace rift::studio

#include "studio/reports/validation_report.hpp"

#include "engine/base/text.hpp"
#include "engine/scene/derived.hpp"
#include "engine/theory/wave_loaded_crack.hpp"
#include "studio/reports/report.hpp"
#include "studio/reports/study_report.hpp"
#include "studio/text/html.hpp"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <set>

namespace rift::studio {
namespace {

using Json = nlohmann::ordered_json;
using validation::FreeCrack;

constexpr const char* words_of_verdicts =
    "The rules were fixed before any run and are judged on packings that were not used to find the law's "
    "constant κ. "
    "\"Not judged\": the rule asks for mean radii of at most 0.5 mm. ± is the standard deviation of one "
    "realisation.";

/// "22000 elements, R = 0.49 mm, σ_t = 3.3 MPa, κ = 0.71, 8 realisations".
std::string size_text(const ValidatedSize& size) {
  const FreeCrack& first = size.cracks.front();
  return fmt::format("{} elements, R = {:.2f} mm, σ_t = {:.2f} MPa (what they resolve), κ = {:g}, {}",
                     size.elements, 1e3 * first.mean_radius, 1e-6 * first.strength, first.kappa,
                     base::counted(static_cast<int>(size.cracks.size()), "realisation"));
}

Table findings_table(const ValidatedSize& size) {
  Table table{{"rule", "verdict", "measured"}, {}};
  for (const validation::Finding& finding : size.findings)
    table.rows.push_back({finding.rule, name_of(finding.verdict), finding.measured});
  return table;
}

/// A chart of which each realisation is a line.
template <class RowsOf>
void add_lines(Chart& chart, const std::string& label, const std::vector<FreeCrack>& cracks, int colour,
               const RowsOf& rows_of) {
  for (const FreeCrack& crack : cracks) {
    ChartSeries line{.label = label, .colour = colour};
    for (const auto& [t, y] : rows_of(crack)) line.add(1e6 * t, y);
    line.name =
        fmt::format("seed {}{}", crack.realisation.seed, crack.realisation.mirrored ? ", mirrored" : "");
    chart.series.push_back(std::move(line));
  }
}

ChartSeries exact_line(const ValidatedSize& size) {
  double young = 0.0, poisson = 0.0;
  for (const FreeCrack& crack : size.cracks)
    young += crack.young_modulus / static_cast<double>(size.cracks.size()),
        poisson += crack.poisson_ratio / static_cast<double>(size.cracks.size());
  const theory::WaveLoadedCrack theory =
      theory::wave_loaded_crack(young, poisson, scene::density(size.scene), size.scene.material.plane,
                                size.scene.breaking.release_rate.value(), size.scene.loading.traction.value(),
                                size.cracks.front().height);
  ChartSeries line{
      .label = "exact, the specimens' mean E and ν", .style = ChartSeries::Style::dashed, .colour = -1};
  for (std::size_t k = 0; k < theory.time.size() && theory.advance[k] <= 17e-3; ++k)
    line.add(1e6 * theory.time[k], 1e3 * theory.advance[k]);
  return line;
}

/// What a chart's file is called.
std::string chart_name(const ValidatedProblem& problem, const ValidatedSize& size, const char* what) {
  return fmt::format("{}_{}_{}", problem.problem->name, size.elements, what);
}

void add_wave_loaded(std::vector<NamedChart>& charts, const ValidatedProblem& problem,
                     const ValidatedSize& size) {
  const double notch = size.cracks.front().notch;
  Chart tip{.title = fmt::format("Advance of the tip, {} elements", size.elements),
            .x_label = "time since the tractions [µs]",
            .y_label = "advance [mm]",
            .x_range = {10.0, 33.0},
            .y_range = {0.0, 18.0}};
  add_lines(tip, "realisations", size.cracks, 0, [&](const FreeCrack& crack) {
    auto rows = tip_history(crack);
    for (auto& row : rows) row[1] = 1e3 * (row[1] - notch);
    return rows;
  });
  Chart energy = tip;
  energy.title = fmt::format("Energy lost by the beams over G_c B, {} elements", size.elements);
  energy.y_label = "W / (G_c B) [mm]";
  energy.series.clear();
  add_lines(energy, "realisations", size.cracks, 0, [&](const FreeCrack& crack) {
    auto rows = crack.fracture;
    for (auto& row : rows) row[1] *= 1e3 / (size.scene.breaking.release_rate.value() * crack.thickness);
    return rows;
  });
  for (Chart* chart : {&tip, &energy}) chart->series.push_back(exact_line(size));
  charts.push_back(
      {chart_name(problem, size, "tip"),
       "The tip, the foremost gone beam with two others within two mean radii, against the exact history.",
       std::move(tip)});
  charts.push_back({chart_name(problem, size, "energy"),
                    "The energy that all beams have lost, as the advance of a crack that takes G_c per area.",
                    std::move(energy)});
}

NamedChart errors_over_sizes(const ValidatedProblem& problem) {
  Chart chart{.title = "Error of the tip's time since the waves met",
              .x_label = "advance [mm]",
              .y_label = "(t - t_0) / (exact) - 1 [%]"};
  for (std::size_t k = 0; k < problem.sizes.size(); ++k) {
    const ValidatedSize& size = problem.sizes[k];
    ChartSeries series{.label = fmt::format("R = {:.2f} mm", 1e3 * size.cracks.front().mean_radius),
                       .style = ChartSeries::Style::line_points,
                       .colour = static_cast<int>(k)};
    const auto errors = time_errors(size.scene, size.cracks, validation::advances, false);
    for (std::size_t a = 0; a < errors.size(); ++a)
      if (const validation::Spread error = validation::spread_of(errors[a]); error.count > 0)
        series.add(1e3 * validation::advances[a], 1e2 * error.mean, 1e2 * error.error());
    chart.series.push_back(std::move(series));
  }
  chart.series.push_back(level("exact", 0.0, 3.0, 15.0));
  return {problem.problem->name + "_errors", "Mean over the realisations; bars: standard error of the mean.",
          std::move(chart)};
}

void add_branching(std::vector<NamedChart>& charts, const ValidatedProblem& problem,
                   const ValidatedSize& size) {
  ChartGrid grid{.title = fmt::format("Beams gone, {} elements", size.elements),
                 .x_label = "x [mm]",
                 .y_label = "y [mm]",
                 .x_range = {0.0, 1e3 * size.cracks.front().length},
                 .y_range = {0.0, 1e3 * size.cracks.front().height}};
  for (const FreeCrack& crack : size.cracks) {
    ChartSeries beams{.label = "beams gone", .style = ChartSeries::Style::points, .colour = 0},
        notch{.label = "notch", .colour = 1};
    for (const validation::GoneBeam& beam : crack.gone) beams.add(1e3 * beam.at.x(), 1e3 * beam.at.y());
    notch.add(0.0, 5e2 * crack.height), notch.add(1e3 * crack.notch, 5e2 * crack.height);
    grid.panels.push_back(
        {fmt::format("seed {}", crack.realisation.seed), {std::move(beams), std::move(notch)}});
  }
  charts.push_back({chart_name(problem, size, "paths"), "Where beams are gone in the end, each packing.",
                    std::move(grid)});
  Chart tip{.title = fmt::format("Position of the foremost tip, {} elements", size.elements),
            .x_label = "time since the tractions [µs]",
            .y_label = "x [mm]"};
  for (std::size_t k = 0; k < size.cracks.size(); ++k) {
    ChartSeries line{.label = fmt::format("seed {}", size.cracks[k].realisation.seed),
                     .colour = static_cast<int>(k)};
    for (const auto& [t, x] : tip_history(size.cracks[k])) line.add(1e6 * t, 1e3 * x);
    tip.series.push_back(std::move(line));
  }
  charts.push_back(
      {chart_name(problem, size, "tip"), "Position of the foremost tip against time.", std::move(tip)});
}

std::vector<NamedChart> charts_of(const ValidatedProblem& problem) {
  const bool exact = problem.problem->kind == validation::Problem::Kind::wave_loaded;
  std::vector<NamedChart> charts;
  for (const ValidatedSize& size : problem.sizes)
    (exact ? add_wave_loaded : add_branching)(charts, problem, size);
  if (exact) charts.push_back(errors_over_sizes(problem));
  return those_with_points(std::move(charts));
}

}  // namespace

std::string validation_text(const ValidationReport& report, bool color) {
  std::string text;
  for (const ValidatedProblem& problem : report.problems) {
    text += heading(problem.problem->name + ": " + problem.problem->title, color) + "\n";
    for (const ValidatedSize& size : problem.sizes) {
      text += "  " + size_text(size) + "\n";
      for (const validation::Finding& finding : size.findings)
        text += fmt::format("    {:<14}{}\n{:18}{}\n", name_of(finding.verdict), finding.rule, "",
                            finding.measured);
    }
    text += "\n";
  }
  return text + words_of_verdicts + "\n";
}

Json validation_json(const ValidationReport& report) {
  Json problems = Json::array();
  for (const ValidatedProblem& problem : report.problems)
    for (const ValidatedSize& size : problem.sizes) {
      Json findings = Json::array(), cracks = Json::array();
      for (const validation::Finding& finding : size.findings)
        findings.push_back(
            {{"rule", finding.rule}, {"verdict", name_of(finding.verdict)}, {"measured", finding.measured}});
      for (const FreeCrack& crack : size.cracks)
        cracks.push_back(
            {{"seed", crack.realisation.seed},
             {"mirrored", crack.realisation.mirrored},
             {"beams_broken", crack.gone.size()},
             {"first_broken_s", crack.gone.empty() ? Json(nullptr) : Json(crack.gone.front().time)},
             {"energy_fracture_j", crack.fracture.back()[1]},
             {"young_modulus_pa", crack.young_modulus},
             {"poisson_ratio", crack.poisson_ratio},
             {"ledger_residual", crack.balance_error}});
      problems.push_back({{"problem", problem.problem->name},
                          {"elements", size.elements},
                          {"mean_radius_m", size.cracks.front().mean_radius},
                          {"strength_pa", size.cracks.front().strength},
                          {"kappa", size.cracks.front().kappa},
                          {"findings", findings},
                          {"realisations", cracks}});
    }
  return {{"command", report.command},
          {"version", report.build.version},
          {"wall_s", report.wall_s},
          {"problems", problems}};
}

void write_validation_report(const ValidationReport& report, const std::filesystem::path& folder) {
  std::vector<ReportSection> sections;
  std::vector<scene::Scene> scenes;
  std::vector<Json> rows;
  for (const ValidatedProblem& problem : report.problems) {
    const validation::Problem& p = *problem.problem;
    sections.push_back({p.title, html_paragraph(p.statement) + html_paragraph("Source: " + p.source + ".")});
    for (const ValidatedSize& size : problem.sizes) {
      sections.push_back(
          {fmt::format("{}: {} elements", p.name, size.elements), findings_table(size), size_text(size)});
      scenes.push_back(size.scene);
      for (const validation::Finding& finding : size.findings)
        rows.push_back({{"problem", p.name},
                        {"elements", size.elements},
                        {"rule", finding.rule},
                        {"verdict", name_of(finding.verdict)},
                        {"measured", finding.measured}});
    }
    sections.push_back({p.name + ": charts", charts_of(problem)});
  }
  write_report({.title = "Free cracks against an exact solution and published benchmarks",
                .made = {report.command, report.build, report.wall_s},
                .opening = {words_of_verdicts},
                .scenes = std::move(scenes),
                .files = {{"summary.json", base::json_text(validation_json(report), 2) + "\n"},
                          {"table.csv", rows_csv(rows)}},
                .sections = std::move(sections)},
               folder);
}

}  // namespace rift::studio

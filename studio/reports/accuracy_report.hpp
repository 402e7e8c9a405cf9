#pragma once

#include "engine/accuracy/judgement.hpp"
#include "engine/simulation/record.hpp"
#include "studio/charts/chart.hpp"
#include "studio/text/table.hpp"

#include <nlohmann/json.hpp>

#include <filesystem>
#include <string>
#include <vector>

namespace rift::studio {

/// All that `rift accuracy` reports.
struct AccuracyReport {
  std::string preset, command;
  simulation::BuildInfo build;
  std::vector<std::string> notes;
  std::vector<accuracy::CaseResult> results;
  accuracy::Accuracy accuracy;
  double goal = 0.01;
  std::vector<study::SummaryRow>
      lanes;  // of the recommended variant, side by side; empty where there is none
  double wall_s = 0;
};

/// A line per variant: both errors and the wall time side by side.
Table accuracy_table(const accuracy::Accuracy& accuracy);

/// "0.6 of critical, single, 25 samples: error 0.0012 in 0.14 s; ...", or that nothing reaches the goal.
std::string recommendation_text(const AccuracyReport& report);

/// What the scene's number of elements adds to that, as far as the scatter of specimens lets it be known.
std::string lattice_text(const AccuracyReport& report);

/// Table, what each factor is compared with, and the recommendation.
std::string accuracy_text(const AccuracyReport& report, bool color);

/// The rows of table.csv: those that were computed, with knob, variant, error of the knob, its
/// uncertainty and error_converged, of the mean over a line's specimens.
nlohmann::ordered_json accuracy_rows(const AccuracyReport& report);

/// The same for programs: lines, what they are compared with, recommendation, scenarios.
nlohmann::ordered_json accuracy_json(const AccuracyReport& report);

/// Writes charts/ and report.html. Throws WorldError where a chart cannot be drawn; the report is then
/// written without it.
void write_accuracy_report(const AccuracyReport& report, const std::filesystem::path& folder);

/// Charts of an accuracy study, those that have something to show:
///   work_precision    error over wall time, a series a factor (on the scene's own specimen; elements against
///   the
///                     finest), the goal, the scatter of specimens, what is recommended
///   error_step        error of the step over the step, double and single, with the observed order
///   ratio_elements    ratio over elements, mean and scatter of the specimens, beside Broberg's
/// Logarithmic axes have no place for an error of 0: such points are left out, which the caption says.
std::vector<NamedChart> accuracy_charts(const std::vector<accuracy::CaseResult>& results,
                                        const accuracy::Accuracy& accuracy, double goal);

}  // namespace rift::studio

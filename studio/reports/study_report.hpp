#pragma once

#include "engine/study/runner.hpp"
#include "studio/charts/chart.hpp"
#include "studio/text/table.hpp"

#include <filesystem>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace rift::studio {

// The results of a study as tables. Rows that are not computed yet are left out of all of them.

/// Rows that differ at most in the axes left out, and what they have in common.
struct RowFamily {
  study::AxisTexts axes;
  std::vector<study::SummaryRow> rows;
};

/// Rows by the axes other than `without`, families and rows in the order of the study.
std::vector<RowFamily> families(const study::StudyRows& rows, const std::vector<std::string>& without);

/// Mean of a number of the rows and its standard deviation (n - 1), NaN of fewer than two; what is undefined
/// does not count.
struct MeanScatter {
  double mean, scatter;
  int count;
};
MeanScatter mean_of(const std::vector<study::SummaryRow>& rows, double study::SummaryRow::*number);

/// One row per scenario: its axes, the ratio, Broberg's, the distance between them, the wall time.
Table scenario_table(const study::StudyRows& rows);

/// The same over the seeds; no rows where no two scenarios differ by seed only.
Table seed_table(const study::StudyRows& rows);

/// Rows of JSON as a csv with the columns of all of them: axes and lists are one text, what is undefined or
/// missing is empty.
std::string rows_csv(const std::vector<nlohmann::ordered_json>& rows);

/// table.csv of a list of rows: one per scenario, the names of summary.json; what is undefined is empty.
std::string study_csv(const nlohmann::ordered_json& rows);

/// What sets a scenario or a family apart, as a label of a chart: "progressive, linear, r_l = 1, seed 2".
std::string axes_label(const study::AxisTexts& axes);

/// Ratio against crack velocity beside Broberg, Freund and the strip, mean over seeds with their scatter as
/// bars; none where the study does not vary the velocity. At most 12 series a chart.
std::vector<NamedChart> velocity_charts(const study::StudyRows& rows);

/// Ratio against tip position of each scenario, from the series under runs/. At most 12 series a chart.
/// @param series  by row of the study
std::vector<NamedChart> tip_charts(const study::StudyRows& rows,
                                   const std::vector<std::filesystem::path>& series);

/// Writes charts/ and report.html into the folder of a study, from what is computed of it. Throws WorldError
/// where a chart cannot be drawn; the report is then written without it.
void write_study_report(const scene::Preset& preset, const simulation::BuildInfo& build,
                        const study::StudyResult& result, const std::filesystem::path& folder);

}  // namespace rift::studio

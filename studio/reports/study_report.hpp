#pragma once

#include "engine/study/runner.hpp"
#include "studio/text/table.hpp"

#include <filesystem>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace rift::studio {

// The results of a study as tables. Rows that are not computed yet are left out of all of them.

/// One row per scenario: its axes, the ratio, Broberg's, the difference between them, the error where a
/// converged reference is known, the run time of its scheme.
Table scenario_table(const study::StudyRows& rows);

/// The same over the seeds; no rows where no two scenarios differ by seed only.
Table seed_table(const study::StudyRows& rows);

/// The scenarios that could not be made, a row for each reason: the values of their axes, how many they are,
/// why; no rows where all could.
Table not_made_table(const study::StudyResult& result, const scene::Preset& preset);

/// What the computed scenarios leave out, in a line: "damping (24 of 30 scenarios), ramp, gauges"; a part
/// that all of them leave out has no count.
std::string left_out_text(const study::StudyRows& rows);

/// Rows of JSON as a csv with the columns of all of them: axes and lists are one text, what is undefined or
/// missing is empty.
std::string rows_csv(const std::vector<nlohmann::ordered_json>& rows);

/// table.csv of a list of rows: one per scenario, the names of summary.json; what is undefined is empty.
std::string study_csv(const nlohmann::ordered_json& rows);

/// By what a study was computed.
struct StudyCall {
  std::string command;
  simulation::BuildInfo build;
  double wall_s = 0;
};

/// Writes charts/ and report.html into the folder of a study, from what is computed of it. Throws WorldError
/// where a chart cannot be drawn; the report is then written without it.
void write_study_report(const scene::Preset& preset, const StudyCall& call, const study::StudyResult& result,
                        const std::filesystem::path& folder);

}  // namespace rift::studio

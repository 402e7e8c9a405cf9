#pragma once

#include "engine/study/runner.hpp"
#include "studio/text/table.hpp"

#include <string>
#include <vector>

namespace rift::studio {

// The results of a study as tables. Rows that are null, not computed yet, are left out of all of them.

/// Rows that differ at most in the axes left out, and what they have in common: {"technique": "simple", ...}.
struct RowFamily {
  nlohmann::ordered_json axes;
  std::vector<study::SummaryRow> rows;
};

/// Rows by the axes other than `without`, families and rows in the order of the study.
std::vector<RowFamily> families(const std::vector<study::SummaryRow>& rows,
                                const std::vector<std::string>& without);

/// Mean of the numbers under a name and their standard deviation (n - 1), NaN of fewer than two; nulls do not
/// count.
struct MeanScatter {
  double mean, scatter;
  int count;
};
MeanScatter mean_of(const std::vector<study::SummaryRow>& rows, const std::string& name);

/// One row per scenario: its axes, the ratio, Broberg's, the distance between them, the wall time.
Table scenario_table(const std::vector<study::SummaryRow>& rows);

/// The same over the seeds; no rows where no two scenarios differ by seed only.
Table seed_table(const std::vector<study::SummaryRow>& rows);

/// table.csv: one row per scenario, the names of summary.json; what is undefined is empty.
std::string study_csv(const std::vector<study::SummaryRow>& rows);

}  // namespace rift::studio

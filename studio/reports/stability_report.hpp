#pragma once

#include "engine/simulation/record.hpp"
#include "engine/stability/suite.hpp"
#include "studio/charts/chart.hpp"
#include "studio/text/table.hpp"

#include <nlohmann/json_fwd.hpp>

#include <filesystem>
#include <optional>
#include <vector>

namespace rift::studio {

/// What `rift stability` tells.
struct StabilityReport {
  std::vector<stability::StabilityRow> rows;
  std::optional<stability::GrowthCurve> growth;  // with a report only
  simulation::BuildInfo build;
  double wall_s = 0;
};

/// A line per case: expected, seen in both precisions, how far the books are open, growth, what was said.
Table stability_table(const std::vector<stability::StabilityRow>& rows);

/// A line per claim: what physics expects of it, and what was seen in both precisions.
Table claims_table(const std::vector<stability::StabilityRow>& rows);

/// Both tables, and how many cases are as expected.
std::string stability_text(const StabilityReport& report, bool color);

nlohmann::ordered_json stability_json(const StabilityReport& report);

/// report.html, table.csv, claims.csv, summary.json and charts/. Throws WorldError.
void write_stability_report(const StabilityReport& report, const std::filesystem::path& folder);

/// Growth of the highest mode around the critical step; residuals of the books, case by case.
std::vector<NamedChart> stability_charts(const StabilityReport& report);

}  // namespace rift::studio

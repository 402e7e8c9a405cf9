#pragma once

#include "engine/simulation/record.hpp"
#include "engine/stability/suite.hpp"

#include <nlohmann/json_fwd.hpp>

#include <filesystem>
#include <optional>
#include <vector>

namespace rift::studio {

/// What `rift stability` reports.
struct StabilityReport {
  std::vector<stability::StabilityRow> rows;
  std::optional<stability::GrowthCurve> growth;  // with a report only
  simulation::BuildInfo build;
  double wall_s = 0;
  std::string command = "rift stability";
};

/// Both tables, and how many cases are as expected.
std::string stability_text(const StabilityReport& report, bool color);

nlohmann::ordered_json stability_json(const StabilityReport& report);

/// report.html, table.csv, claims.csv, summary.json and charts/. Throws WorldError.
void write_stability_report(const StabilityReport& report, const std::filesystem::path& folder);

}  // namespace rift::studio

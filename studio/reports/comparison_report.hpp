#pragma once

#include "engine/simulation/record.hpp"
#include "studio/text/comparison.hpp"

#include <filesystem>
#include <string>
#include <vector>

namespace rift::studio {

/// Scenarios of any runs and studies beside each other.
struct Comparison {
  std::string command;  // that made it
  simulation::BuildInfo build;
  std::vector<ComparedScenario> scenarios;
};

/// Writes table.csv, summary.json, charts and report.html. Throws WorldError where a chart cannot be drawn;
/// the rest is then written all the same.
void write_comparison_report(const Comparison& comparison, const std::filesystem::path& folder);

}  // namespace rift::studio

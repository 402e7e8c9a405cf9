#pragma once

#include "engine/simulation/record.hpp"
#include "engine/validation/problems.hpp"

#include <nlohmann/json_fwd.hpp>

#include <filesystem>
#include <string>
#include <vector>

namespace rift::studio {

/// A problem computed with elements of one size.
struct ValidatedSize {
  int elements = 0;
  scene::Scene scene;
  std::vector<validation::FreeCrack> cracks;
  std::vector<validation::Finding> findings;
};

struct ValidatedProblem {
  const validation::Problem* problem = nullptr;
  std::vector<ValidatedSize> sizes;
};

/// What `rift validate` reports.
struct ValidationReport {
  std::vector<ValidatedProblem> problems;
  simulation::BuildInfo build;
  double wall_s = 0;
  std::string command = "rift validate";
};

/// The findings of each problem, for a terminal.
std::string validation_text(const ValidationReport& report, bool color);

nlohmann::ordered_json validation_json(const ValidationReport& report);

/// report.html, table.csv, summary.json and charts/. Throws WorldError.
void write_validation_report(const ValidationReport& report, const std::filesystem::path& folder);

}  // namespace rift::studio

#pragma once

#include "engine/claims/claims.hpp"
#include "engine/simulation/record.hpp"
#include "studio/charts/chart.hpp"

#include <nlohmann/json.hpp>

#include <string>
#include <vector>

namespace rift::studio {

/// A chart of the report, and what it shows of whom.
struct Figure {
  DrawnChart chart;
  std::string caption;
};

/// A picture of the report, beside its charts.
struct Picture {
  std::filesystem::path png;
  std::string caption;
};

/// A claim with its verdicts; those of a picture mean nothing.
struct JudgedClaim {
  const claims::Claim* claim = nullptr;
  claims::Judgement bulk, in_situ;
  int scenarios = 0;
  double wall_s = 0;  // computing time of its scenarios, shared ones counted for each claim
  std::vector<Figure> figures;
  std::vector<Picture> pictures;
  std::string not_drawn;  // of a claim that is a picture: why there is none
};

/// All that the report tells.
struct Reproduction {
  simulation::BuildInfo build;
  std::string command;  // "rift reproduce all --quick"
  int elements = 20000;
  int scenarios = 0, computed = 0, found = 0;
  double wall_s = 0;
  std::vector<JudgedClaim> claims;
};

/// One self-contained page: the verdicts in one table, then a section per claim with its charts as inline
/// SVG.
std::string reproduction_html(const Reproduction& reproduction);

/// The same as Markdown, charts linked as they lie below the report's folder (charts/NAME.svg).
std::string reproduction_markdown(const Reproduction& reproduction);

/// The same without charts, for a terminal.
std::string reproduction_text(const Reproduction& reproduction, bool color);

/// The same for programs: version, elements, times, and the claims with verdict and measured of each
/// stiffness.
nlohmann::ordered_json reproduction_json(const Reproduction& reproduction);

}  // namespace rift::studio

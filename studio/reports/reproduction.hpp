#pragma once

#include "engine/claims/claims.hpp"
#include "engine/simulation/record.hpp"
#include "studio/charts/chart.hpp"
#include "studio/text/table.hpp"

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

/// All that the report holds.
struct Reproduction {
  simulation::BuildInfo build;
  std::string command;  // "rift reproduce all --quick"
  int elements = 20000;
  int scenarios = 0, computed = 0, found = 0;
  double wall_s = 0;
  std::vector<JudgedClaim> claims;
  std::vector<scene::Scene> scenes;  // that were computed: what they share stands below the claims
};

/// ": simple and progressive release, linear relaxation, r_l = 1 and 4, α = 0": the schemes of the rows, as
/// captions tell them.
std::string scheme_text(const std::vector<study::SummaryRow>& rows);

/// A claim's charts for one stiffness, none where there is nothing to draw: ratio against velocity with error
/// bars over the specimens and Broberg's, Freund's and the strip's curves, ratio against tip position of the
/// first specimen, energies against time.
/// @param stiffness  "bulk" or "in-situ", in titles and file names
std::vector<NamedChart> claim_charts(const claims::Claim& claim, const claims::Evidence& evidence,
                                     const std::string& stiffness);

/// The ratio of progressive and simple release against the velocity over the specimen's own Rayleigh speed;
/// none where there are no results.
/// @param nominal_over_own  c_r of the material over the measured c_R
std::vector<NamedChart> charts_over_own_speed(const claims::Evidence& evidence, const std::string& stiffness,
                                              double nominal_over_own);

/// The charts and maps of a finding beyond the paper; none where there is nothing to draw.
std::vector<NamedChart> beyond_charts(const claims::Claim& claim, const claims::Evidence& evidence);

/// What the words of claims mean, and where that comes from.
Table margins_table();

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

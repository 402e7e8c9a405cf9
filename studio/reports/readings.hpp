#pragma once

#include "engine/claims/readings.hpp"
#include "engine/simulation/matching_coordination.hpp"
#include "engine/simulation/record.hpp"

#include <nlohmann/json.hpp>

#include <string>
#include <vector>

namespace rift::studio {

/// One reading: the verdicts of the claims, in their order, and the ratios of two schemes.
struct ReadingRow {
  claims::Reading reading;
  std::vector<claims::Judgement> judgement;
  std::vector<double> progressive, simple;  // at ReadingsReport::shown, means over the specimens
};

/// The energy balances of the scenarios of one technique and kinematics: how many exceed their limit, the
/// largest error, and the smallest of their limits.
struct BalanceRow {
  std::string technique, kinematics;
  int scenarios = 0, open = 0;
  double worst = 0, limit = 0;
};

/// All readings x all claims that they can decide.
struct ReadingsReport {
  simulation::BuildInfo build;
  std::string command;
  int elements = 0, scenarios = 0, computed = 0, found = 0;
  double wall_s = 0;
  simulation::MatchedCoordination matched;
  std::vector<const claims::Claim*> claims;
  std::vector<ReadingRow> rows;
  std::vector<BalanceRow> balances;

  static constexpr double shown[] = {0.05, 0.2, 0.5, 0.8, 1.0};  // [c_r]

  const ReadingRow& row_of(const claims::Reading& reading) const;
};

/// Judges the claims under every reading, and sees which energy balances close.
/// @param[in] evidence  with all rows of the study, and their series
void judge_readings(ReadingsReport& report, const claims::Evidence& evidence);

std::string readings_markdown(const ReadingsReport& report);
std::string readings_html(const ReadingsReport& report);
std::string readings_text(const ReadingsReport& report, bool color);
nlohmann::ordered_json readings_json(const ReadingsReport& report);

}  // namespace rift::studio

#include "studio/reports/readings.hpp"

#include <gtest/gtest.h>

namespace rift::studio {
namespace {

claims::SummaryRow row_of(const std::string& technique, const std::string& kinematics, double error) {
  claims::SummaryRow row;
  row.technique = technique, row.kinematics = kinematics, row.stiffness = "in-situ";
  row.coordination = 6.0, row.length_m = 0.2, row.thickness_m = 4e-3, row.g_i0_j_m2 = 1e4;
  row.ledger_residual = error, row.ledger_limit = 1e-3, row.ledger_closes = error <= row.ledger_limit;
  return row;
}

TEST(ReadingsReport, SaysWhichEnergyBalancesDoNotClose) {
  ReadingsReport report;
  claims::Evidence evidence;
  evidence.series = [](const claims::SummaryRow&) { return claims::SeriesTable{}; };
  evidence.rows = {row_of("simple", "corotational", 3e-3), row_of("progressive", "corotational", 2e-5),
                   row_of("simple", "corotational", 4e-4)};
  judge_readings(report, evidence);
  const std::string page = readings_markdown(report);
  EXPECT_NE(page.find("| simple | corotational | 2 | 1 | 3.0e-03 | 1e-03 |"), std::string::npos) << page;
  EXPECT_NE(page.find("| progressive | corotational | 1 | 0 | 2.0e-05 | 1e-03 |"), std::string::npos) << page;
  const auto json = readings_json(report)["energy_balances"];
  ASSERT_EQ(json.size(), 2U);
  EXPECT_EQ(json[0]["beyond_limit"], 1);
}

}  // namespace
}  // namespace rift::studio

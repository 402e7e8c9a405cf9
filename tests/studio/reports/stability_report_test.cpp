#include "studio/reports/stability_report.hpp"

#include "studio/reports/study_report.hpp"
#include "tests/studio/run_rift.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace rift::studio {
namespace {

TEST(StabilityReport, QuotesATextWithACommaInItsTables) {
  StabilityReport report;
  stability::StabilityRow row;
  row.family = "time step", row.name = "1.2 c_R, beyond any limit";
  row.in_double.residual = row.in_single.residual = 1e-12;
  row.in_double.said = "it said \"no\"";
  row.in_double.claims = {{.what = "ratio, with damping", .low = 0.5, .high = 1.5, .seen = 1.0}};
  report.rows = {row};
  const TemporaryFolder folder;
  write_stability_report(report, folder.path());
  const std::string table = read_text(folder.path() / "table.csv");
  EXPECT_TRUE(contains(table, "time step,\"1.2 c_R, beyond any limit\","));
  EXPECT_TRUE(contains(table, ",\"it said \"\"no\"\"\"\n"));
  EXPECT_TRUE(
      contains(read_text(folder.path() / "claims.csv"),
               "time step,\"1.2 c_R, beyond any limit\",double,\"ratio, with damping\",0.5,1.5,1,1\n"));
}

TEST(RowsCsv, QuotesTextsAndLeavesOutWhatIsUndefined) {
  const nlohmann::ordered_json row{{"series", "scan, twisted"},
                                   {"value", std::nan("")},
                                   {"none", nullptr},
                                   {"list", {1, 2}},
                                   {"ratio", 0.5}};
  EXPECT_EQ(rows_csv({row}), "series,value,none,list,ratio\n\"scan, twisted\",,,1 2,0.5\n");
}

}  // namespace
}  // namespace rift::studio

#include "studio/reports/study_report.hpp"

#include <gtest/gtest.h>

#include <algorithm>

namespace rift::studio {
namespace {

using Json = nlohmann::ordered_json;

TEST(RowsCsv, HasAColumnThatOnlySomeRowsHave) {
  EXPECT_EQ(rows_csv({Json{{"row", 0}, {"beta", 1.0}}, Json{{"row", 1}, {"friction", 0.3}, {"beta", 0.5}}}),
            "row,friction,beta\n0,,1.0\n1,0.3,0.5\n");
  EXPECT_EQ(rows_csv({}), "");
}

TEST(StudyCsv, PutsRowAndAxesFirstAndLeavesOutWhatIsNotComputed) {
  study::SummaryRow row;
  row.axes = {{"seed", "2"}, {"technique", "simple"}}, row.row = 3, row.seed = 2;
  const std::string csv = study_csv(to_json(study::StudyRows{std::nullopt, row}));
  EXPECT_TRUE(csv.starts_with("row,axes,crack_velocity_over_cr,")) << csv;
  EXPECT_NE(csv.find("\n3,seed = 2; technique = simple,"), std::string::npos) << csv;
  EXPECT_EQ(std::count(csv.begin(), csv.end(), '\n'), 2);
}

}  // namespace
}  // namespace rift::studio

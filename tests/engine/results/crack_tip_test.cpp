#include "engine/results/records.hpp"

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

namespace rift::results {
namespace {

using Header = nlohmann::ordered_json;
using Point = std::array<double, 2>;

TEST(CrackTip, OneTipIsAtItsArcLengthAlongTheBentPath) {
  const Header header{{"path", {{0, 0}, {3, 0}, {3, 4}}}, {"tips", 1}};
  EXPECT_EQ(tips_at(header, 2), (std::vector<Point>{{2, 0}}));
  EXPECT_EQ(tips_at(header, 5), (std::vector<Point>{{3, 2}}));
}

TEST(CrackTip, BeforeAndBeyondThePathItGoesStraightOn) {
  const Header header{{"path", {{0, 1}, {2, 1}}}};
  EXPECT_EQ(tips_at(header, -0.5), (std::vector<Point>{{-0.5, 1}}));
  EXPECT_EQ(tips_at(header, 2.5), (std::vector<Point>{{2.5, 1}}));
}

TEST(CrackTip, TwoTipsRunFromTheMiddleBothWays) {
  const Header header{{"path", {{0, 1}, {4, 1}}}, {"tips", 2}};
  EXPECT_EQ(tips_at(header, 1.5), (std::vector<Point>{{0.5, 1}, {3.5, 1}}));
}

}  // namespace
}  // namespace rift::results

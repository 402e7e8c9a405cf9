#include "engine/scene/issue.hpp"

#include <gtest/gtest.h>

namespace rift::scene {
namespace {

TEST(IssueText, NamesFileLineKeyAndValue) {
  EXPECT_EQ(to_text({"presets/x.toml", 14, "crack.velocity", "must lie in (0, 2] c_r", "\"5 c_r\""}),
            "presets/x.toml:14: crack.velocity = \"5 c_r\": must lie in (0, 2] c_r");
}

TEST(IssueText, LeavesOutWhatThereIsNot) {
  EXPECT_EQ(to_text({"x.toml", 0, "", "no such file"}), "x.toml: no such file");
  EXPECT_EQ(to_text({"x.toml", 3, "crack.path", "crosses no beam"}), "x.toml:3: crack.path: crosses no beam");
}

TEST(IssueText, GivesTheColumnOfASyntaxError) {
  EXPECT_EQ(to_text({"x.toml", 3, "", "what is this", "", 7}), "x.toml:3:7: what is this");
}

TEST(IssueText, WritesAnOverrideAsItWasTyped) {
  EXPECT_EQ(to_text({"--set", 0, "solver.beta", "must lie in (0, 1]", "5"}),
            "--set solver.beta=5: must lie in (0, 1]");
  EXPECT_EQ(to_text({"--set", 0, "solver.beta", "expected key=value"}),
            "--set solver.beta: expected key=value");
}

TEST(IssueText, WithoutItsPlaceNamesKeyAndValue) {
  EXPECT_EQ(without_place({"x.toml", 3, "crack.tips", "must be 1 or 2", "3"}),
            "crack.tips = 3: must be 1 or 2");
  EXPECT_EQ(without_place({"x.toml", 3, "crack.tips", "is needed"}), "crack.tips: is needed");
  EXPECT_EQ(without_place({"x.toml", 3, "", "is empty"}), "is empty");
}

TEST(NearestName, DoesNotCountCaseUnderscoresAndDashes) {
  const std::vector<std::string> names{"damage_zone_ratio", "damping_alpha", "resamples"};
  EXPECT_EQ(nearest_name("DamageZone-Ratio", names), "damage_zone_ratio");
  EXPECT_EQ(nearest_name("damping-alfa", names), "damping_alpha");
}

TEST(NearestName, IsTheShortestThatBeginsSoWhereNoneIsNear) {
  const std::vector<std::string> names{"damage_zone_ratio", "damage_zone", "velocity"};
  EXPECT_EQ(nearest_name("damagezo", names), "damage_zone");
  EXPECT_EQ(nearest_name("velo", names), "") << "too few letters";
  EXPECT_EQ(nearest_name("nothing", names), "");
}

TEST(InputErrorText, HasOneLinePerIssue) {
  const InputError error({{"x.toml", 1, "", "one"}, {"x.toml", 2, "", "two"}});
  EXPECT_STREQ(error.what(), "x.toml:1: one\nx.toml:2: two");
  EXPECT_EQ(error.issues.size(), 2u);
}

}  // namespace
}  // namespace rift::scene

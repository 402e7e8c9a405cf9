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

TEST(InputErrorText, HasOneLinePerIssue) {
  const InputError error({{"x.toml", 1, "", "one"}, {"x.toml", 2, "", "two"}});
  EXPECT_STREQ(error.what(), "x.toml:1: one\nx.toml:2: two");
  EXPECT_EQ(error.issues.size(), 2u);
}

}  // namespace
}  // namespace rift::scene

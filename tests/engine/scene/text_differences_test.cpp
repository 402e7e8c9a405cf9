#include "engine/scene/text_differences.hpp"

#include <gtest/gtest.h>

namespace rift::scene {
namespace {

using Texts = std::vector<std::string>;

TEST(TextDifferences, NameKeysWithTheirTablesAndBothValues) {
  const std::string before =
      "[specimen]\n# Seed\nseed = 1\nelements = 3000\n[crack]\nend = 0.06\nresamples 2\n";
  EXPECT_EQ(text_differences(before, before), Texts{});
  EXPECT_EQ(
      text_differences(before, "[specimen]\nseed = 7\nelements = 3000\n[crack]\nfriction = 0\nresamples 3\n"),
      (Texts{"crack.end was 0.06, is now not given", "crack.friction was not given, is now 0",
             "resamples was 2, is now 3", "specimen.seed was 1, is now 7"}));
}

TEST(TextDifferences, OfLongValuesSayThatThereIsOne) {
  const std::string rows = "history = [[0, 0.01], [1e-6, 0.0101], [4e-6, 0.0102], [5e-6, ";
  EXPECT_EQ(text_differences("[crack]\n" + rows + "0.2]]\n", "[crack]\n" + rows + "0.3]]\n"),
            Texts{"crack.history differs"});
}

TEST(TextDifferences, AtTheEndOfAMessageAreFourAtMost) {
  EXPECT_EQ(differences_text("a 1\nb 1\n", "a 1\nb 2\n"), ": b was 1, is now 2");
  EXPECT_EQ(differences_text("a 1\nb 1\nc 1\nd 1\ne 1\nf 1\n", "a 2\nb 2\nc 2\nd 2\ne 2\nf 2\n"),
            ": a was 1, is now 2; b was 1, is now 2; c was 1, is now 2; d was 1, is now 2; and 2 more");
  EXPECT_EQ(differences_text("a 1\n", "a 1\n"), "");
}

}  // namespace
}  // namespace rift::scene

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

}  // namespace
}  // namespace rift::scene

#include "engine/scene/issue.hpp"

#include <gtest/gtest.h>

#include <string>
#include <vector>

namespace rift::scene {
namespace {

TEST(Printable, EscapesControlCharacters) { EXPECT_EQ(printable("a\x1b[2J\nb\x7f"), "a\\x1b[2J\\x0ab\\x7f"); }

TEST(Printable, CutsLongTextBetweenLetters) {
  EXPECT_EQ(printable("abcdef", 4), "abcd...");
  EXPECT_EQ(printable("abcµd", 4), "abc...");  // the letter has two bytes
  EXPECT_EQ(printable("abcd", 4), "abcd");
}

TEST(Listed, JoinsWithCommasAndALastWord) {
  EXPECT_EQ(listed(std::vector<std::string>{"a"}), "a");
  EXPECT_EQ(listed(std::vector<std::string>{"a", "b"}), "a or b");
  EXPECT_EQ(listed(std::vector<std::string>{"a", "b", "c"}, "and"), "a, b and c");
}

TEST(NearestName, FindsTyposAndSwappedLetters) {
  const std::vector<std::string> names{"damage_zone_ratio", "height", "length"};
  EXPECT_EQ(nearest_name("damge_zone_ratio", names), "damage_zone_ratio");
  EXPECT_EQ(nearest_name("hieght", names), "height");
  EXPECT_EQ(nearest_name("lenght", std::vector<std::string>{"lenses", "length"}), "length");
}

TEST(NearestName, IsSilentAboutStrangers) {
  const std::vector<std::string> names{"alpha", "beta", "dt"};
  EXPECT_EQ(nearest_name("history", names), "");
  EXPECT_EQ(nearest_name("ab", names), "");
  EXPECT_EQ(nearest_name(std::string(1000, 'a'), names), "");
}

TEST(Trimmed, TakesBlanksOffBothEnds) {
  EXPECT_EQ(trimmed(" \ta b\r\n"), "a b");
  EXPECT_EQ(trimmed("  "), "");
}

}  // namespace
}  // namespace rift::scene

#include "studio/graphics/symbol_cells.hpp"

#include <gtest/gtest.h>

#include <algorithm>

namespace rift::studio {
namespace {

std::string codes_from(std::string_view before, std::string_view after) {
  SymbolChanges changes;
  changes.add(4, 1, cells_of(before), cells_of(after));
  return changes.codes();
}

TEST(SymbolCells, ColoursGoWithTheLetters) {
  const auto cells = cells_of("\033[0m\033[38;2;255;0;0;48;5;17ma\033[7mb\033[0;31;104mc\033[39md\033[0m▀");
  ASSERT_EQ(cells.size(), 5U);
  EXPECT_EQ(cells[0], (SymbolCell{"a", "38;2;255;0;0", "48;5;17", false}));
  EXPECT_EQ(cells[1], (SymbolCell{"b", "38;2;255;0;0", "48;5;17", true}));
  EXPECT_EQ(cells[2], (SymbolCell{"c", "31", "104", false}));
  EXPECT_EQ(cells[3], (SymbolCell{"d", "", "104", false}));
  EXPECT_EQ(cells[4], (SymbolCell{"▀", "", "", false}));
}

TEST(SymbolCells, WhatIsNotSeenIsNoDifference) {
  EXPECT_EQ(cells_of("\033[31;44m "), cells_of("\033[32;44m "));
  EXPECT_EQ(cells_of("\033[0;38;5;3m█")[0], (SymbolCell{" ", "", "38;5;3", false}));
}

TEST(SymbolCells, CoarseColoursAreInStepsAndEqualOnesAreABlank) {
  auto cells = cells_of("\033[38;2;10;100;255;48;2;20;96;250mx\033[38;2;17;96;252m▀\033[31;44mz");
  std::for_each(cells.begin(), cells.end(), make_coarse);
  EXPECT_EQ(cells[0].letter, " ") << "of one colour";
  EXPECT_EQ(cells[0].background, "48;2;16;96;255");
  EXPECT_EQ(cells[1], cells[0]);
  EXPECT_EQ(cells[2], (SymbolCell{"z", "31", "44", false}));
}

TEST(SymbolChanges, AHalfBlockIsTheOtherHalfWhereThatSaysFewerColours) {
  EXPECT_EQ(codes_from("", "\033[31;44m▀\033[34;41m▄\033[34;45m▌"),
            "\033[2;5H\033[0;31;44m▀▀\033[35m▐\033[0m");
}

TEST(SymbolChanges, PassOverCellsThatStayAndSayColoursOnce) {
  EXPECT_EQ(codes_from("abcde", "abcde"), "");
  EXPECT_EQ(codes_from("abcde", "abXde"), "\033[2;7H\033[0mX\033[0m");
  EXPECT_EQ(codes_from("abcde", "Xbcde"), "\033[2;5H\033[0mX\033[0m");
  EXPECT_EQ(codes_from("abcdefghij", "Xbcdefghij\033[31mK"), "\033[2;5H\033[0mX\033[9C\033[31mK\033[0m");
  EXPECT_EQ(codes_from("", "\033[31;44mab\033[32mc\033[49md"),
            "\033[2;5H\033[0;31;44mab\033[32mc\033[0;32md\033[0m");
}

}  // namespace
}  // namespace rift::studio

#include "studio/text/table.hpp"

#include <gtest/gtest.h>

#include <string>
#include <vector>

namespace rift::studio {
namespace {

TEST(Wrapped, BreaksAtBlanksAndCountsLetters) {
  using Lines = std::vector<std::string>;
  EXPECT_EQ(wrapped("one two three", 7), (Lines{"one two", "three"}));
  EXPECT_EQ(wrapped("  one  two ", 80), (Lines{"one two"}));
  EXPECT_EQ(wrapped("äöü äöü", 7), (Lines{"äöü äöü"}));
  EXPECT_EQ(wrapped("unbreakable a", 4), (Lines{"unbreakable", "a"}));
  EXPECT_TRUE(wrapped("", 10).empty());
}

TEST(PlainTable, PutsItsLastColumnIntoLines) {
  const Table table{{"name", "shows"}, {{"a", "a plate of many more words than fit"}, {"b", ""}}};
  EXPECT_EQ(plain_table(table, false, 30),
            "name  shows\n"
            "a     a plate of many more\n"
            "      words than fit\n"
            "b\n");
  EXPECT_EQ(plain_table(table, false, 0), plain_table(table, false)) << "no terminal";
}

}  // namespace
}  // namespace rift::studio

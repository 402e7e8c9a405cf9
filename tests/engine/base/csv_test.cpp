#include "engine/base/csv.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace rift::base {
namespace {

TEST(CsvField, IsQuotedWhereAReaderWouldSplitIt) {
  EXPECT_EQ(csv_field("plain text; 0.5"), "plain text; 0.5");
  EXPECT_EQ(csv_field("a, b"), "\"a, b\"");
  EXPECT_EQ(csv_field("say \"no\""), "\"say \"\"no\"\"\"");
  EXPECT_EQ(csv_field("two\nlines"), "\"two\nlines\"");
  EXPECT_EQ(csv_field(""), "");
}

TEST(CsvField, OfANumberReadsBackAndIsEmptyWhereThereIsNone) {
  EXPECT_EQ(csv_field(1.0 / 3.0), "0.3333333333333333");
  EXPECT_EQ(csv_field(0.1F), csv_field(static_cast<double>(0.1F)));
  EXPECT_EQ(csv_field(std::nan("")), "");
  EXPECT_EQ(csv_field(INFINITY), "");
  EXPECT_EQ(csv_field(-7), "-7");
}

TEST(CsvRow, JoinsTextsAndNumbers) {
  EXPECT_EQ(csv_row("run, 1", 2, 0.5, std::nan(""), std::string("last")), "\"run, 1\",2,0.5,,last\n");
}

}  // namespace
}  // namespace rift::base

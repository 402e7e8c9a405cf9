#include "engine/base/text.hpp"

#include <gtest/gtest.h>

namespace rift::base {
namespace {

TEST(Escaped, LeavesUtf8AsItIs) {
  for (const char* text : {"", "run 1", "α = 0, 3 µm, ±", "日本語", "\U0001F600"})
    EXPECT_EQ(escaped(text), text);
}

TEST(Escaped, ShowsControlCharactersAsNumbers) {
  EXPECT_EQ(escaped("a\x1b[2J\nb\x7f"), "a\\x1b[2J\\x0ab\\x7f");
  EXPECT_EQ(escaped("\u009b2J"), "\\xc2\\x9b2J");  // another beginning of an escape sequence
  EXPECT_EQ(escaped("a\u00a0b"), "a\u00a0b");      // the first letter behind them
}

TEST(Escaped, ShowsBytesThatAreNoUtf8AsNumbers) {
  EXPECT_EQ(escaped("r\xe9sultats"), "r\\xe9sultats");
  EXPECT_EQ(escaped("cut \xc3"), "cut \\xc3");
  EXPECT_EQ(escaped("\xc0\xaf"), "\\xc0\\xaf");                    // overlong
  EXPECT_EQ(escaped("\xe0\x80\xaf"), "\\xe0\\x80\\xaf");           // overlong
  EXPECT_EQ(escaped("\xed\xa0\x80"), "\\xed\\xa0\\x80");           // half of a pair of UTF-16
  EXPECT_EQ(escaped("\xf4\x90\x80\x80"), "\\xf4\\x90\\x80\\x80");  // beyond the last letter
}

TEST(Escaped, KeepsWhatItIsToldTo) { EXPECT_EQ(escaped("a\tb\nc\x1b", "\n\t"), "a\tb\nc\\x1b"); }

TEST(Counted, PutsTheNounInTheSingularForOneOnly) {
  EXPECT_EQ(counted(0, "rattler"), "0 rattlers");
  EXPECT_EQ(counted(1, "rattler"), "1 rattler");
  EXPECT_EQ(counted(2, "rattler"), "2 rattlers");
  EXPECT_EQ(counted(1, "history", "histories"), "1 history");
  EXPECT_EQ(counted(3, "history", "histories"), "3 histories");
}

TEST(Escaped, TwiceIsOnce) {
  const std::string once = escaped("r\xe9s\x1b[31m");
  EXPECT_EQ(escaped(once), once);
}

TEST(Letters, AreTakenApartAndPutTogetherAgain) {
  const std::string text = "a\u00b5\u65e5\U0001F600";
  EXPECT_EQ(letters_of(text), U"a\u00b5\u65e5\U0001F600");
  EXPECT_EQ(count_letters(text), 4U);
  std::string again;
  for (const char32_t letter : letters_of(text)) append_letter(again, letter);
  EXPECT_EQ(again, text);
}

TEST(WithoutQuotes, TakesAPairOfThemOff) {
  EXPECT_EQ(without_quotes("\"simple\""), "simple");
  EXPECT_EQ(without_quotes("0.5"), "0.5");
  EXPECT_EQ(without_quotes("\""), "\"");
}

}  // namespace
}  // namespace rift::base

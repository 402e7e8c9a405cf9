#include "studio/graphics/answers.hpp"

#include <gtest/gtest.h>

namespace rift::studio {
namespace {

/// Of kitty's protocol, of xterm as a VT340, of a window in pixels.
const std::string kitty = "\033_Gi=31;OK\033\\\033[6;20;10t\033[?62;c";
const std::string vt340 = "\033[?2;0;1000;800S\033[4;480;800t\033[6;13;6t\033[?63;1;2;4;6;9;15;22c";

TerminalAnswers read(const std::string& bytes, std::size_t piece = 1 << 20) {
  TerminalAnswers answers(80, 24);
  for (std::size_t from = 0; from < bytes.size(); from += piece) answers.take(bytes.substr(from, piece));
  return answers;
}

TEST(TerminalAnswers, KittyAndItsCells) {
  const TerminalAnswers answers = read(kitty);
  EXPECT_TRUE(answers.complete());
  EXPECT_TRUE(answers.capabilities().kitty);
  EXPECT_FALSE(answers.capabilities().sixel);
  EXPECT_EQ(answers.capabilities().cell_width, 10);
  EXPECT_EQ(answers.capabilities().cell_height, 20);
  EXPECT_EQ(answers.typed(), "");
}

TEST(TerminalAnswers, SixelItsLargestPictureAndTheCellRatherThanTheWindow) {
  const TerminalAnswers answers = read(vt340);
  EXPECT_TRUE(answers.capabilities().sixel);
  EXPECT_FALSE(answers.capabilities().kitty);
  EXPECT_EQ(answers.capabilities().most_width, 1000);
  EXPECT_EQ(answers.capabilities().most_height, 800);
  EXPECT_EQ(answers.capabilities().cell_width, 6);
}

TEST(TerminalAnswers, AWindowGivesTheCellWhereNothingElseDoes) {
  const TerminalAnswers answers = read("\033[4;480;800t\033[?1;2c");
  EXPECT_EQ(answers.capabilities().cell_width, 10);
  EXPECT_EQ(answers.capabilities().cell_height, 20);
  EXPECT_FALSE(answers.capabilities().sixel);
}

TEST(TerminalAnswers, AreTheSameInPiecesOfAnySize) {
  for (const std::string& bytes : {kitty, vt340})
    for (std::size_t piece = 1; piece <= bytes.size(); ++piece) {
      const TerminalAnswers whole = read(bytes), parts = read(bytes, piece);
      EXPECT_TRUE(parts.complete()) << piece;
      EXPECT_EQ(parts.capabilities().kitty, whole.capabilities().kitty) << piece;
      EXPECT_EQ(parts.capabilities().sixel, whole.capabilities().sixel) << piece;
      EXPECT_EQ(parts.capabilities().cell_height, whole.capabilities().cell_height) << piece;
      EXPECT_EQ(parts.typed(), "") << piece;
    }
}

TEST(TerminalAnswers, KeysTypedMeanwhileAreKept) {
  const TerminalAnswers answers = read("q\033[A\033_Gi=31;OK\033\\xy\033OB\033[?62;4c", 3);
  EXPECT_EQ(answers.typed(), "q\033[Axy\033OB");
  EXPECT_TRUE(answers.capabilities().kitty);
  EXPECT_TRUE(answers.capabilities().sixel);
  EXPECT_EQ(read("q\033").typed(), "q\033");
  EXPECT_EQ(read("q\033[?62").typed(), "q") << "half an answer is no keys";
}

TEST(TerminalAnswers, ARefusalAndJunkAreNoPictures) {
  EXPECT_FALSE(read("\033_Gi=31;ENOTSUPPORTED\033\\\033[?62c").capabilities().kitty);
  EXPECT_FALSE(read("\033[?2;3;0S\033[?62;c").capabilities().most_width > 0);
  EXPECT_EQ(read("\033[6;0;-7t\033[6;99999999999;1t").capabilities().cell_width, 0);
  EXPECT_EQ(read("\033[6;300;10t").capabilities().cell_width, 0) << "no letter is so high";
  EXPECT_EQ(read("\033[4;10;800t").capabilities().cell_width, 0) << "24 rows of no pixel each";
  EXPECT_FALSE(read("\033[").complete());
  EXPECT_FALSE(read("\033_G never ends").capabilities().answers);
  EXPECT_FALSE(read("").capabilities().answers);
  EXPECT_FALSE(read("\033[?64").complete());
}

TEST(TerminalAnswers, TheLengthOfASequence) {
  EXPECT_EQ(length_of_sequence("\033[0n"), 4);
  EXPECT_EQ(length_of_sequence("\033[?62;4crest"), 8);
  EXPECT_EQ(length_of_sequence("\033_Gi=1;OK\033\\"), 11);
  EXPECT_EQ(length_of_sequence("\033]52;c\a"), 7);
  EXPECT_EQ(length_of_sequence("\033OAx"), 3);
  EXPECT_EQ(length_of_sequence("\033"), 0);
  EXPECT_EQ(length_of_sequence("\033[1;"), 0);
  EXPECT_EQ(length_of_sequence("\033x"), -1);
  EXPECT_EQ(length_of_sequence("x"), -1);
}

}  // namespace
}  // namespace rift::studio

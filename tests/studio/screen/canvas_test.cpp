#include "studio/screen/canvas.hpp"

#include <gtest/gtest.h>

namespace rift::studio {
namespace {

TEST(Canvas, ALetterIsACell) {
  Canvas canvas(8, 2);
  EXPECT_EQ(canvas.text(1, 0, "α=1 µs", {Ink::good}), 6);
  EXPECT_EQ(canvas.at(1, 0).glyph, U'α');
  EXPECT_EQ(canvas.at(5, 0).glyph, U'µ');
  EXPECT_EQ(canvas.at(1, 0).style.ink, Ink::good);
  EXPECT_EQ(canvas.row(0), " α=1 µs");
  EXPECT_EQ(canvas.row(1), "");
}

TEST(Canvas, WhatLiesOutsideIsNotDrawn) {
  Canvas canvas(4, 1);
  canvas.text(-2, 0, "abcdefgh");
  canvas.put(1, 5, U'x');
  EXPECT_EQ(canvas.row(0), "cdef");
  EXPECT_EQ(canvas.text(0, 0, "wide", {}, 2), 2);
  EXPECT_EQ(canvas.row(0), "wief");
}

TEST(Canvas, BytesThatAreNoUtf8BecomeQuestionMarks) {
  EXPECT_EQ(letters_of("a\xff\xc3"), U"a??");
  EXPECT_EQ(letters_of("●"), U"●");
}

}  // namespace
}  // namespace rift::studio

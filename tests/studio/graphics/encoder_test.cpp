#include "studio/graphics/encoder.hpp"

#include <gtest/gtest.h>

#include <algorithm>

namespace rift::studio {
namespace {

/// Red on the left, blue on the right.
std::vector<std::uint8_t> two_halves(int width, int height) {
  std::vector<std::uint8_t> rgb;
  for (int y = 0; y < height; ++y)
    for (int x = 0; x < width; ++x) {
      const bool left = 2 * x < width;
      rgb.insert(rgb.end(),
                 {static_cast<std::uint8_t>(left ? 255 : 0), 0, static_cast<std::uint8_t>(left ? 0 : 255)});
    }
  return rgb;
}

constexpr Area area{2, 1, 8, 4};

std::string shown(Graphics graphics, Colours colours = Colours::all, bool unicode = true) {
  if (!PictureEncoder::there()) return "";
  const auto rgb = two_halves(80, 80);
  TerminalKind kind;
  kind.colours = colours;
  kind.unicode = unicode;
  PictureEncoder encoder(graphics, kind, 10, 20);
  return encoder.show({area, 80, 80, rgb, 1});
}

int count(const std::string& text, const std::string& part) {
  int n = 0;
  for (std::size_t at = text.find(part); at != std::string::npos; at = text.find(part, at + 1)) ++n;
  return n;
}

class Encoder : public testing::Test {
 protected:
  void SetUp() override {
    if (!PictureEncoder::there()) GTEST_SKIP() << "built without libchafa";
  }
};

TEST_F(Encoder, SixelBeginsInItsCellAndLeavesTheCursorWhereItWas) {
  const std::string bytes = shown(Graphics::sixel);
  EXPECT_TRUE(bytes.starts_with("\0337\033[2;3H\033P"));
  EXPECT_TRUE(bytes.ends_with("\033\\\0338"));
  EXPECT_NE(bytes.find("#"), std::string::npos);
}

TEST_F(Encoder, KittyHasTheRectangleANumberAndNoAnswers) {
  const std::string bytes = shown(Graphics::kitty);
  EXPECT_NE(bytes.find("\033_Ga=T,i=2,p=1,q=2,C=1,f=32,s=80,v=80,c=8,r=4,m=1\033\\"), std::string::npos)
      << bytes.substr(0, 100);
  EXPECT_NE(bytes.find("\033_Gm=0\033\\"), std::string::npos);
  EXPECT_NE(bytes.find("\033_Ga=d,d=I,i=1,q=2\033\\"), std::string::npos) << "the one before goes";
}

TEST_F(Encoder, KittyEnlargesAPictureOfFewerPixels) {
  const auto rgb = two_halves(40, 40);
  PictureEncoder encoder(Graphics::kitty, {}, 10, 20);
  const std::string bytes = encoder.show({area, 40, 40, rgb, 1});
  EXPECT_NE(bytes.find("s=40,v=40,c=8,r=4"), std::string::npos) << bytes.substr(0, 100);
}

TEST_F(Encoder, APictureOfAnyWidthKeepsItsRows) {
  const auto rgb = two_halves(70, 80);
  TerminalKind kind;
  kind.colours = Colours::all;
  PictureEncoder encoder(Graphics::symbols, kind, 10, 20);
  const std::string bytes = encoder.show({area, 70, 80, rgb, 1});
  const auto row = [&](int y) { return bytes.substr(bytes.find(at_cell(2, y)) + at_cell(2, y).size(), 30); };
  for (int y = 3; y <= 4; ++y) EXPECT_EQ(row(y), row(2)) << y;
}

TEST_F(Encoder, ItermHasTheRectangle) {
  const std::string bytes = shown(Graphics::iterm);
  EXPECT_NE(bytes.find("\033]1337;File=inline=1;width=8;height=4;preserveAspectRatio=0:"), std::string::npos);
}

TEST_F(Encoder, SymbolsAreARowForEachRowInTheTerminalsColours) {
  const std::string bytes = shown(Graphics::symbols);
  for (int row = 2; row <= 5; ++row) EXPECT_EQ(count(bytes, at_cell(2, row - 1)), 1) << row;
  EXPECT_NE(bytes.find("255;0;0"), std::string::npos);
  EXPECT_NE(bytes.find("0;0;255"), std::string::npos);
  EXPECT_EQ(count(shown(Graphics::symbols, Colours::many), ";2;255"), 0) << "no 24-bit colours";
  EXPECT_NE(shown(Graphics::symbols, Colours::many).find(";5;"), std::string::npos);
  EXPECT_EQ(count(shown(Graphics::symbols, Colours::eight), ";5;"), 0);
  const std::string mono = shown(Graphics::symbols, Colours::two, false);
  EXPECT_TRUE(
      std::all_of(mono.begin(), mono.end(), [](char c) { return static_cast<unsigned char>(c) < 128; }));
  EXPECT_EQ(count(mono, "38;"), 0);
}

TEST_F(Encoder, OfSymbolsOnlyChangedRowsAreSent) {
  TerminalKind kind;
  kind.colours = Colours::all;
  PictureEncoder encoder(Graphics::symbols, kind, 10, 20);
  auto rgb = two_halves(80, 80);
  EXPECT_NE(encoder.show({area, 80, 80, rgb, 1}), "");
  EXPECT_EQ(encoder.show({area, 80, 80, rgb, 2}), "");
  std::fill(rgb.begin(), rgb.begin() + 3 * 80 * 20, std::uint8_t{90});  // the first row of cells
  const std::string changed = encoder.show({area, 80, 80, rgb, 3});
  EXPECT_EQ(count(changed, at_cell(2, 1)), 1);
  EXPECT_EQ(count(changed, at_cell(2, 2)), 0);
  (void)encoder.clear(area);
  EXPECT_EQ(count(encoder.show({area, 80, 80, rgb, 4}), at_cell(2, 2)), 1) << "all again after a clearing";
}

TEST_F(Encoder, ClearingBlanksTheRectangleAndNothingElse) {
  PictureEncoder sixel(Graphics::sixel, {}, 10, 20), kitty(Graphics::kitty, {}, 10, 20);
  const std::string bytes = sixel.clear(area);
  for (int row = 1; row < 5; ++row) EXPECT_EQ(count(bytes, at_cell(2, row) + "        "), 1) << row;
  EXPECT_EQ(count(bytes, "H"), 4);
  EXPECT_EQ(count(kitty.clear(area), "\033_Ga=d,d=I,"), 2);
  EXPECT_EQ(sixel.restore(), "\033\\") << "ends a picture that was cut off";
}

}  // namespace
}  // namespace rift::studio

#include "studio/screen/live.hpp"

#include "studio/screen/curves.hpp"
#include "studio/screen/plate.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace rift::studio {
namespace {

std::string text_of(const Canvas& canvas) {
  std::string text;
  for (int y = 0; y < canvas.height(); ++y) text += canvas.row(y) + "\n";
  return text;
}

/// 20 x 8 elements of 1 mm, the upper half lifted by 1 mm left of the middle.
results::Geometry blocks() {
  results::Geometry g;
  for (int y = 0; y < 8; ++y)
    for (int x = 0; x < 20; ++x) {
      g.position.push_back(
          {1e-3F * (static_cast<float>(x) + 0.5F), 1e-3F * (static_cast<float>(y) + 0.5F), 0});
      g.radius.push_back(0.5e-3F);
    }
  return g;
}

Live run_of(int lanes) {
  Live live;
  live.name = "plate";
  live.state = "running";
  live.done = 0.5;
  live.step = 500;
  live.steps = 1000;
  live.length = 0.02;
  live.height = 0.008;
  for (int k = 0; k < lanes; ++k) {
    LiveLane& lane = live.lanes.emplace_back();
    lane.title = k == 0 ? "simple release" : "progressive release";
    for (int n = 0; n < 50; ++n) {
      results::Sample s;
      s.time_s = 1e-6 * n;
      s.tip_m = 2e-4 * n;
      s.elastic_j = 10 - 0.1 * n;
      s.fracture_j = 0.1 * n;
      lane.samples.push_back(s);
      lane.rates.push_back({.tip_m = s.tip_m, .ratio = 0.75});
    }
  }
  return live;
}

TEST(LiveTable, LeavesColumnsOutForWhatTellsLanesApart) {
  Live live = run_of(3);
  live.lanes[0].title = "progressive release, r_l = 1, 0.5 c_R";
  live.lanes[1].title = "progressive release, r_l = 4, 0.5 c_R";
  live.lanes[2].title = "simple release, 0.5 c_R";
  for (const int width : {80, 120}) {
    Canvas canvas(width, 24);
    draw_live(canvas, live, {}, Glyphs::unicode);
    const std::string text = text_of(canvas);
    EXPECT_NE(text.find("1 progressive release, r_l = 1"), std::string::npos) << text;
    EXPECT_NE(text.find("2 progressive release, r_l = 4"), std::string::npos) << text;
    EXPECT_NE(text.find("tip mm"), std::string::npos) << text;
  }
}

TEST(LiveLayout, AllPartsHaveRoomOnAnOrdinaryTerminal) {
  for (const auto& [width, height] : {std::pair{80, 24}, {120, 40}, {200, 60}}) {
    const LiveLayout l = live_layout(width, height, 2, true);
    for (const Area& part :
         {l.head, l.plate, l.plate_beside, l.budget, l.energies, l.rates, l.table, l.message, l.foot})
      EXPECT_FALSE(part.empty()) << width << "x" << height;
  }
}

TEST(Plate, APoreOfThePackingIsFilledAndTheCrackIsNot) {
  results::Geometry g;  // 20 x 8 elements without one, and without the middle of two rows
  for (int y = 0; y < 8; ++y)
    for (int x = 0; x < 20; ++x) {
      const bool pore = x == 15 && y == 6, crack = x < 8 && y == 4;
      if (pore || crack) continue;
      g.position.push_back(
          {1e-3F * (static_cast<float>(x) + 0.5F), 1e-3F * (static_cast<float>(y) + 0.5F), 0});
      g.radius.push_back(0.3e-3F);
    }
  Canvas canvas(20, 4);
  draw_plate(canvas, {0, 0, 20, 4}, g, {}, {0.02, 0.008, 0, {}}, Glyphs::unicode);
  EXPECT_NE(canvas.at(15, 0).style.lower, no_shade);
  EXPECT_EQ(canvas.at(4, 1).style.lower, no_shade);
  EXPECT_NE(canvas.at(12, 1).style.lower, no_shade);
}

TEST(LiveScreen, TellsStateBudgetAndLanes) {
  Canvas canvas(120, 40);
  draw_live(canvas, run_of(2), {.shown = 1, .foot = "q leave"}, Glyphs::unicode);
  const std::string text = text_of(canvas);
  for (const char* part :
       {"plate  running  step 500 of 1000", " 50 %", "elastic", "5.1 J", "fracture", "4.9 J", "balance",
        "1 simple release", "2 progressive release", "0.750", "q leave"})
    EXPECT_NE(text.find(part), std::string::npos) << part << " in\n" << text;
}

TEST(LiveScreen, TwoPlatesStandBesideEachOther) {
  Live live = run_of(2);
  const results::Geometry g = blocks();
  live.geometry = &g;
  Canvas canvas(120, 40);
  draw_live(canvas, live, {.shown = 0, .beside = 1, .foot = ""}, Glyphs::unicode);
  const LiveLayout layout = live_layout(120, 40, 2, true);
  const std::string titles = canvas.row(layout.plate.y);
  EXPECT_NE(titles.find("1 simple release"), std::string::npos);
  EXPECT_GT(titles.find("2 progressive release"), titles.find("1 simple release"));
  for (const Area& plate : {layout.plate, layout.plate_beside}) {
    int coloured = 0;
    for (int y = plate.y; y < plate.y + plate.height; ++y)
      for (int x = plate.x; x < plate.x + plate.width; ++x)
        if (canvas.at(x, y).style.ink == Ink::shades) ++coloured;
    EXPECT_GT(coloured, plate.width);
  }
}

TEST(LiveScreen, TheColoursAreOfTheVelocityWhereItIsWanted) {
  Live live = run_of(1);
  const results::Geometry g = blocks();
  live.geometry = &g;
  live.fastest = 10;
  live.lanes[0].displacement.assign(g.position.size(), {0, 0, 0});
  live.lanes[0].velocity.assign(g.position.size(), {0, 10, 0});
  const LiveLayout layout = live_layout(100, 30, 1, false);
  const auto middle = [&](bool velocity) {
    Canvas canvas(100, 30);
    draw_live(canvas, live, {.velocity = velocity, .foot = ""}, Glyphs::unicode);
    return canvas.at(layout.plate.x + layout.plate.width / 2, layout.plate.y + layout.plate.height / 2)
        .style.upper;
  };
  EXPECT_EQ(middle(true), shade_steps - 1);
  EXPECT_EQ(middle(false), shade_steps / 2);  // nothing was pulled: no scale, the middle
}

TEST(LiveScreen, BooksThatDoNotCloseTurnRed) {
  Live live = run_of(1);
  live.lanes[0].samples.back().residual = 1e-3;
  Canvas canvas(100, 30);
  draw_live(canvas, live, {}, Glyphs::unicode);
  const Area budget = live_layout(100, 30, 1, false).budget;
  EXPECT_EQ(canvas.at(budget.x, budget.y + 5).style.ink, Ink::bad);
  EXPECT_NE(canvas.row(budget.y + 5).find("ABOVE 1e-10"), std::string::npos);
}

TEST(LiveScreen, ATerminalTooSmallSaysHowLargeItShouldBe) {
  Canvas canvas(40, 10);
  draw_live(canvas, run_of(1), {}, Glyphs::unicode);
  EXPECT_EQ(canvas.row(4), "40x10 is too small: 60x16 needed");
  Canvas least(1, 1);
  draw_live(least, run_of(1), {}, Glyphs::unicode);
}

TEST(LiveScreen, InAsciiThereIsNothingElse) {
  Canvas canvas(100, 30);
  const results::Geometry g = blocks();
  Live live = run_of(2);
  live.geometry = &g;
  draw_live(canvas, live, {.beside = 1, .foot = "q leave"}, Glyphs::ascii);
  for (int y = 0; y < 30; ++y)
    for (int x = 0; x < 100; ++x) EXPECT_LT(canvas.at(x, y).glyph, 128U) << x << "," << y;
}

TEST(Curves, AStraightLineIsADiagonalOfDots) {
  Canvas canvas(15, 6);  // 7 for labels; title and foot: 8 x 4 cells of dots
  const Curve line{{{0, 0}, {1, 1}}, {Ink::elastic}};
  draw_curves(canvas, {0, 0, 15, 6}, {{0, 1}, {0, 1}, "x", "y"}, {&line, 1}, Glyphs::unicode);
  for (int k = 0; k < 4; ++k) {
    EXPECT_EQ(canvas.at(7 + 2 * k, 4 - k).style.ink, Ink::elastic) << k;
    EXPECT_GE(canvas.at(7 + 2 * k, 4 - k).glyph, U'\u2801');
  }
  EXPECT_EQ(canvas.at(7, 1).glyph, U' ');
  EXPECT_EQ(canvas.at(14, 4).glyph, U' ');
}

TEST(Curves, WhatIsNoNumberLeavesAGap) {
  Canvas canvas(15, 6);
  const Curve line{{{0, 0}, {0.5, std::nan("")}, {1, 1}}, {Ink::elastic}};
  draw_curves(canvas, {0, 0, 15, 6}, {{0, 1}, {0, 1}, "", ""}, {&line, 1}, Glyphs::unicode);
  EXPECT_EQ(canvas.at(10, 3).glyph, U' ');
}

TEST(Plate, TheCrackIsOpenAndColoursFollowTheDisplacement) {
  const results::Geometry g = blocks();
  std::vector<std::array<float, 3>> moved(g.position.size(), {0, 0, 0});
  for (std::size_t i = 0; i < moved.size(); ++i)
    if (g.position[i][1] > 4e-3F) moved[i][1] = 2e-3F;
  const std::vector<std::array<double, 2>> tips{{0.02, 0.004}};
  Canvas canvas(20, 5);  // a half of a cell is 1 mm high
  draw_plate(canvas, {0, 0, 20, 5}, g, moved, {0.02, 0.008, 2e-3, tips}, Glyphs::unicode);
  EXPECT_EQ(canvas.at(3, 0).style.upper, shade_steps - 1) << "pulled";
  EXPECT_EQ(canvas.at(3, 4).style.lower, 0) << "at rest";
  EXPECT_EQ(canvas.at(3, 2).style.upper, no_shade) << "open, but for what lies above and below";
}

}  // namespace
}  // namespace rift::studio

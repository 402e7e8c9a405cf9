#include "studio/screen/live.hpp"

#include "studio/screen/curves.hpp"
#include "studio/screen/plate.hpp"

#include <gtest/gtest.h>

namespace rift::studio {
namespace {

bool overlap(const Area& a, const Area& b) {
  return !a.empty() && !b.empty() && a.x < b.x + b.width && b.x < a.x + a.width && a.y < b.y + b.height &&
         b.y < a.y + a.height;
}

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
      lane.books.push_back(s);
      lane.rates.push_back({.tip_m = s.tip_m, .ratio = 0.75});
    }
  }
  return live;
}

TEST(LiveLayout, NothingOverlapsAndNothingLeavesTheScreenAtAnySize) {
  for (int width = 1; width <= 300; width += width < 130 ? 1 : 7)
    for (int height = 1; height <= 100; ++height)
      for (const int lanes : {1, 2, 8}) {
        const LiveLayout l = live_layout(width, height, lanes);
        const Area all[] = {l.head, l.plate, l.budget, l.energies, l.rates, l.table, l.foot};
        for (int a = 0; a < 7; ++a) {
          if (all[a].empty()) continue;
          ASSERT_TRUE(all[a].x >= 0 && all[a].y >= 0 && all[a].x + all[a].width <= width &&
                      all[a].y + all[a].height <= height)
              << width << "x" << height << ", " << lanes << " lanes, part " << a;
          for (int b = a + 1; b < 7; ++b)
            ASSERT_FALSE(overlap(all[a], all[b]))
                << width << "x" << height << ", " << lanes << " lanes, " << a << " and " << b;
        }
      }
}

TEST(LiveLayout, AllPartsHaveRoomOnAnOrdinaryTerminal) {
  for (const auto& [width, height] : {std::pair{80, 24}, {120, 40}, {200, 60}}) {
    const LiveLayout l = live_layout(width, height, 2);
    for (const Area& part : {l.head, l.plate, l.budget, l.energies, l.rates, l.table, l.foot})
      EXPECT_FALSE(part.empty()) << width << "x" << height;
  }
}

TEST(LiveScreen, TellsStateBudgetAndLanes) {
  Canvas canvas(120, 40);
  draw_live(canvas, run_of(2), 1, "q leave", Glyphs::unicode);
  const std::string text = text_of(canvas);
  for (const char* part :
       {"plate  running  step 500 of 1000", " 50 %", "elastic", "5.1 J", "fracture", "4.9 J", "residual",
        "1 simple release", "2 progressive release", "0.750", "q leave"})
    EXPECT_NE(text.find(part), std::string::npos) << part << " in\n" << text;
}

TEST(LiveScreen, BooksThatDoNotCloseTurnRed) {
  Live live = run_of(1);
  live.lanes[0].books.back().residual = 1e-3;
  Canvas canvas(100, 30);
  draw_live(canvas, live, 0, "", Glyphs::unicode);
  const Area budget = live_layout(100, 30, 1).budget;
  EXPECT_EQ(canvas.at(budget.x, budget.y + 5).style.ink, Ink::bad);
  EXPECT_NE(canvas.row(budget.y + 5).find("BEYOND"), std::string::npos);
}

TEST(LiveScreen, ATerminalTooSmallSaysHowLargeItShouldBe) {
  Canvas canvas(40, 10);
  draw_live(canvas, run_of(1), 0, "", Glyphs::unicode);
  EXPECT_EQ(canvas.row(5), "40x10 is too small: 60x16 needed");
  Canvas least(1, 1);
  draw_live(least, run_of(1), 0, "", Glyphs::unicode);
}

TEST(LiveScreen, InAsciiThereIsNothingElse) {
  Canvas canvas(100, 30);
  const results::Geometry g = blocks();
  Live live = run_of(2);
  live.geometry = &g;
  draw_live(canvas, live, 0, "q leave", Glyphs::ascii);
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

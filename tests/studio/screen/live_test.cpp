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
    const LiveLayout l = live_layout(width, height, 2, true, 2.5);
    for (const Area& part : {l.head, l.plate, l.plate_beside, l.colours, l.balance, l.energies, l.rates,
                             l.table, l.message, l.foot})
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
       {"plate  running  step 500 of 1000", " 50 %", "elastic", "5.1 J", "fracture", "4.9 J",
        "balance error 0e+00, limit 1e-09", "1 simple release", "2 progressive release", "0.750", "q leave"})
    EXPECT_NE(text.find(part), std::string::npos) << part << " in\n" << text;
}

TEST(LiveScreen, SaysNoStepsBeforeTheirNumberIsKnown) {
  Live live = run_of(1);
  live.state = "packing 24 %";
  live.step = live.steps = 0;
  Canvas canvas(80, 24);
  draw_live(canvas, live, {}, Glyphs::unicode);
  EXPECT_NE(canvas.row(0).find("plate  packing 24 %"), std::string::npos) << canvas.row(0);
  EXPECT_EQ(canvas.row(0).find("step"), std::string::npos) << canvas.row(0);
}

TEST(LiveScreen, TimeLeftIsShownWholeWhereThereIsLittleRoom) {
  Live live = run_of(1);
  live.name = "lesson_node-release";
  live.step = 3326, live.steps = 16041, live.steps_per_s = 62.6, live.seconds_left = 203;
  const auto head = [&](int width) {
    Canvas canvas(width, 24);
    draw_live(canvas, live, {}, Glyphs::unicode);
    return canvas.row(0);
  };
  EXPECT_NE(head(100).find("62.6 steps/s   3 min 23 s left"), std::string::npos) << head(100);
  EXPECT_NE(head(76).find("step 3326 of 16041   3 min 23 s left"), std::string::npos) << head(76);
}

TEST(LiveScreen, TwoPlatesStandBesideEachOther) {
  Live live = run_of(2);
  const results::Geometry g = blocks();
  live.geometry = &g;
  Canvas canvas(120, 40);
  draw_live(canvas, live, {.shown = 0, .beside = 1, .foot = ""}, Glyphs::unicode);
  const LiveLayout layout = live_layout(120, 40, 2, true, 2.5);
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
  const LiveLayout layout = live_layout(100, 30, 1, false, 2.5);
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
  const Area balance = live_layout(100, 30, 1, false, 2.5).balance;
  EXPECT_EQ(canvas.at(balance.x, balance.y + 5).style.ink, Ink::bad);
  EXPECT_NE(canvas.row(balance.y + 5).find("ABOVE 1e-09"), std::string::npos);
  EXPECT_NE(canvas.row(0).find("balance error 1e-03"), std::string::npos);  // where no bars have room too
}

/// A lane that runs from 2 to 12 mm and takes `ratio` of G_I0 = 1000 J/m2 all along.
LiveLane steady_lane(double ratio) {
  LiveLane lane;
  lane.title = "steady";
  lane.scale = {.thickness = 1e-3, .g_i0 = 1000, .length = 0.02};
  lane.window = {0.004, 0.008};
  lane.broberg = 0.52, lane.freund = 0.525, lane.strip = 1;
  for (int n = 0; n <= 100; ++n) {
    results::Sample s;
    s.time_s = 1e-6 * n;
    s.tip_m = 2e-3 + 1e-4 * n;
    s.fracture_j = ratio * 1e-3 * 1000 * (s.tip_m - 2e-3);
    s.elastic_j = 10 - s.fracture_j;
    lane.samples.push_back(s);
  }
  return lane;
}

TEST(LiveScreen, OneLaneShowsItsRatioWhileItRunsAndAtItsEnd) {
  Live live = run_of(0);
  live.lanes.push_back(steady_lane(0.75));
  LiveLane& lane = live.lanes[0];
  const auto screen = [&](int width = 80) {
    Canvas canvas(width, 24);
    draw_live(canvas, live, {}, Glyphs::unicode);
    return text_of(canvas);
  };
  const std::vector<results::Sample> all = lane.samples;
  lane.samples.resize(10);  // to 2.9 mm
  EXPECT_NE(screen().find("G_ID/G_I0   -"), std::string::npos) << screen();
  lane.samples.assign(all.begin(), all.begin() + 41);  // to 6 mm, half of the window
  EXPECT_NE(screen().find("0.750 so far"), std::string::npos) << screen();
  lane.samples = all;
  EXPECT_NE(screen().find("0.750 ± 0.000"), std::string::npos) << screen();
  lane.ended = LiveLane::Ratio{0.731, 0.02};  // the summary's own
  for (const char* part :
       {"0.731 ± 0.020", "4 to 8 mm", "Broberg     0.520", "Freund      0.525", "strip       1.000"})
    EXPECT_NE(screen().find(part), std::string::npos) << part << " in\n" << screen();
  lane.ended = LiveLane::Ratio{std::nan(""), std::nan("")};
  EXPECT_NE(screen().find("none: steered in the window"), std::string::npos) << screen();
  lane.samples.resize(10);
  EXPECT_NE(screen().find("none: window not passed"), std::string::npos) << screen();
}

TEST(LiveScreen, SaysWhatItsColoursAndCurvesMean) {
  Live live = run_of(0);
  live.lanes.push_back(steady_lane(0.75));
  const results::Geometry g = blocks();
  live.geometry = &g;
  live.pulled = 2e-3, live.fastest = 12.5;
  live.lanes[0].velocity.assign(g.position.size(), {0, 1, 0});
  for (const bool velocity : {false, true}) {
    Canvas canvas(80, 24);
    draw_live(canvas, live, {.velocity = velocity, .foot = ""}, Glyphs::unicode);
    const std::string text = text_of(canvas);
    EXPECT_NE(
        text.find(velocity ? "vertical velocity [m/s]  -12.5 ▀▀▀" : "vertical displacement [mm]  0 ▀▀▀"),
        std::string::npos)
        << text;
    EXPECT_NE(text.find("shape ×1"), std::string::npos);
    EXPECT_NE(text.find("energy [J]  elastic fracture"), std::string::npos) << text;
    EXPECT_NE(text.find("G_ID/G_I0  Broberg Freund strip"), std::string::npos) << text;
  }
}

TEST(Curves, TheLegendIsCutAlikeWhereThereIsLittleRoom) {
  const std::vector<Curve> curves{{{{0, 0}, {1, 1}}, {Ink::elastic}, "elastic"},
                                  {{{0, 1}, {1, 0}}, {Ink::kinetic}, "kinetic"}};
  Canvas wide(30, 6), narrow(15, 6);
  draw_curves(wide, {0, 0, 30, 6}, {{0, 1}, {0, 1}, "x", "y"}, curves, Glyphs::unicode);
  draw_curves(narrow, {0, 0, 15, 6}, {{0, 1}, {0, 1}, "x", "y"}, curves, Glyphs::unicode);
  EXPECT_EQ(wide.row(0), "y  elastic kinetic");
  EXPECT_EQ(narrow.row(0), "y  elast kinet");
  EXPECT_EQ(wide.at(3, 0).style.ink, Ink::elastic);
  EXPECT_EQ(wide.at(11, 0).style.ink, Ink::kinetic);
}

TEST(Curves, AMarkTellsACurveWithoutColours) {
  const std::vector<Curve> curves{{{{0, 0}, {1, 1}}, {}, "", U'a', Marks::each},
                                  {{{0, 1}, {1, 0}}, {}, "", U'b', Marks::last}};
  Canvas canvas(15, 6);
  draw_curves(canvas, {0, 0, 15, 6}, {{0, 1}, {0, 1}, "x", "y"}, curves, Glyphs::unicode);
  EXPECT_EQ(canvas.at(7, 4).glyph, U'a');
  EXPECT_EQ(canvas.at(14, 1).glyph, U'a');
  EXPECT_EQ(canvas.at(14, 4).glyph, U'b');
  EXPECT_NE(canvas.at(7, 1).glyph, U'b');
}

TEST(Curves, LogarithmicAxesSayTheNumbersThemselves) {
  Canvas canvas(30, 6);
  draw_curves(canvas, {0, 0, 30, 6}, {{-1, 2}, {-3, 0}, "x", "y", true}, {}, Glyphs::unicode);
  EXPECT_NE(canvas.row(4).find("0.001"), std::string::npos);
  EXPECT_NE(canvas.row(5).find("0.1"), std::string::npos);
  EXPECT_NE(canvas.row(5).find("100"), std::string::npos);
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

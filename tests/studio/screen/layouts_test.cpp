#include "studio/screen/layouts.hpp"

#include "studio/screen/canvas.hpp"
#include "studio/screen/live.hpp"
#include "tests/expectations.hpp"

#include <gtest/gtest.h>

#include <functional>
#include <vector>

namespace rift::studio {
namespace {

bool overlap(const Area& a, const Area& b) {
  return !a.empty() && !b.empty() && a.x < b.x + b.width && b.x < a.x + a.width && a.y < b.y + b.height &&
         b.y < a.y + a.height;
}

std::vector<Area> parts_of(const LiveLayout& l) {
  return {l.head,  l.plate,    l.plate_beside, l.colours, l.balance, l.result,
          l.table, l.energies, l.rates,        l.message, l.foot};
}

using Layout = std::function<std::vector<Area>(int width, int height)>;

const std::vector<std::pair<const char*, Layout>>& layouts() {
  static const std::vector<std::pair<const char*, Layout>> all{
      {"home",
       [](int w, int h) {
         const HomeLayout l = home_layout(w, h);
         return std::vector{l.head, l.search, l.list, l.detail, l.foot};
       }},
      {"home with preview",
       [](int w, int h) {
         const HomeLayout l = home_layout(w, h, true);
         return std::vector{l.head, l.search, l.list, l.preview, l.detail, l.foot};
       }},
      {"form",
       [](int w, int h) {
         const FormLayout l = form_layout(w, h);
         return std::vector{l.head, l.search, l.rows, l.derived, l.detail, l.foot};
       }},
      {"compare 2",
       [](int w, int h) {
         const CompareLayout l = compare_layout(w, h, 2);
         return std::vector{l.head, l.titles, l.table, l.rates, l.foot};
       }},
      {"compare 8",
       [](int w, int h) {
         const CompareLayout l = compare_layout(w, h, 8);
         return std::vector{l.head, l.titles, l.table, l.rates, l.foot};
       }},
      {"compare 3 with plates",
       [](int w, int h) {
         const CompareLayout l = compare_layout(w, h, 3, true);
         return std::vector{l.head, l.titles, l.table, l.plates, l.rates, l.foot};
       }},
      {"study",
       [](int w, int h) {
         const StudyLayout l = study_layout(w, h);
         return std::vector{l.head, l.chosen, l.grid, l.velocities, l.errors, l.foot};
       }},
      {"live 1",
       [](int w, int h) {
         const LiveLayout l = live_layout(w, h, 1, false, 5);
         return parts_of(l);
       }},
      {"live 2 beside",
       [](int w, int h) {
         const LiveLayout l = live_layout(w, h, 2, true, 5);
         return parts_of(l);
       }},
      {"live 8", [](int w, int h) {
         const LiveLayout l = live_layout(w, h, 8, false, 5);
         return parts_of(l);
       }}};
  return all;
}

TEST(Layouts, NothingOverlapsAndNothingLeavesTheScreenAtAnySize) {
  for (const auto& [name, layout] : not_empty(layouts())) {
    int placed = 0;
    for (int width = 1; width <= 300; ++width)
      for (int height = 1; height <= 100; ++height) {
        const std::vector<Area> parts = layout(width, height);
        for (std::size_t a = 0; a < parts.size(); ++a) {
          if (parts[a].empty()) continue;
          ++placed;
          ASSERT_TRUE(parts[a].x >= 0 && parts[a].y >= 0 && parts[a].x + parts[a].width <= width &&
                      parts[a].y + parts[a].height <= height)
              << name << " " << width << "x" << height << ", part " << a;
          for (std::size_t b = a + 1; b < parts.size(); ++b)
            ASSERT_FALSE(overlap(parts[a], parts[b]))
                << name << " " << width << "x" << height << ", " << a << " and " << b;
        }
      }
    EXPECT_GT(placed, 0) << name;
  }
}

TEST(Layouts, ThePlateIsThereBeforeAnythingElse) {
  for (const int lanes : {1, 2, 3, 8})
    for (int width = least_width; width <= 200; ++width)
      for (int height = least_height; height <= 60; ++height) {
        const LiveLayout l = live_layout(width, height, lanes, lanes > 1, 5);
        ASSERT_GE(l.plate.height, lanes > 1 ? 5 : 4) << lanes << " lanes, " << width << "x" << height;
        ASSERT_FALSE(l.colours.empty());
        ASSERT_GT((lanes > 1 ? l.table : l.result).height, 2)
            << lanes << " lanes, " << width << "x" << height;
      }
}

TEST(Layouts, EveryPartHasRoomOnTheTerminalsThatAreCommon) {
  for (const auto& [width, height] : {std::pair{80, 24}, {120, 40}, {200, 60}}) {
    const HomeLayout home = home_layout(width, height);
    EXPECT_GT(home.list.height, 10);
    const FormLayout form = form_layout(width, height);
    EXPECT_GT(form.rows.height, 8);
    EXPECT_GT(form.derived.height, 4);
    EXPECT_FALSE(study_layout(width, height).errors.empty());
    EXPECT_FALSE(compare_layout(width, height, 2).rates.empty());
    EXPECT_GE(home_layout(width, height, true).preview.height, 8);
    EXPECT_GE(compare_layout(width, height, 2, true).plates.height, 16);
  }
}

TEST(Box, AParagraphBreaksAtBlanksAndKeepsItsNewlines) {
  Canvas canvas(12, 5);
  EXPECT_EQ(draw_paragraph(canvas, {1, 0, 10, 5}, "one two three\nfour"), 3);
  EXPECT_EQ(canvas.row(0), " one two");
  EXPECT_EQ(canvas.row(1), " three");
  EXPECT_EQ(canvas.row(2), " four");
  Canvas narrow(4, 3);
  EXPECT_EQ(draw_paragraph(narrow, {0, 0, 4, 3}, "abcdefgh"), 2);
  EXPECT_EQ(narrow.row(1), "efgh");
}

TEST(Box, StandsInTheMiddleAndNeverLeavesTheScreen) {
  Canvas canvas(20, 7);
  const Area inside = draw_box(canvas, 6, 1, "t", Glyphs::ascii);
  EXPECT_EQ(inside.x, 7);
  EXPECT_EQ(inside.y, 3);
  EXPECT_EQ(canvas.row(2), "      +- t --+");
  EXPECT_EQ(canvas.row(3), "      |      |");
  for (int w = 1; w < 12; ++w)
    for (int h = 1; h < 8; ++h) {
      Canvas small(w, h);
      const Area area = draw_box(small, 30, 10, "title", Glyphs::unicode);
      EXPECT_TRUE(area.empty() || (area.x + area.width < w && area.y + area.height < h));
    }
}

}  // namespace
}  // namespace rift::studio

#include "studio/view/view_layout.hpp"

#include "tests/expectations.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace rift::studio {
namespace {

TEST(ViewLayout, PartsAreApartAndOnTheScreenAtEverySize) {
  for (int width = 1; width <= 220; width += 3)
    for (int height = 1; height <= 70; ++height)
      for (const int most : {0, 1000}) {
        const PictureRoom room{
            .pictures = true, .cell_width = 10, .cell_height = 20, .most_width = most, .most_height = most};
        const ViewLayout layout = view_layout(width, height, room);
        if (width < least_width || height < least_height) {
          EXPECT_TRUE(layout.picture.empty());
          continue;
        }
        int next = 0;
        for (const Area& area :
             not_empty(std::vector{layout.picture, layout.numbers, layout.message, layout.foot})) {
          EXPECT_FALSE(area.empty());
          EXPECT_GE(area.y, next);
          EXPECT_LE(area.x + area.width, width);
          next = area.y + area.height;
        }
        EXPECT_LE(next, height);
        if (most == 0) continue;
        EXPECT_LE(layout.picture.width * 10, most);
        EXPECT_LE(layout.picture.height * 20, most);
      }
}

TEST(ViewLayout, ThePartForTheLargestPictureIsInTheMiddle) {
  const PictureRoom room{
      .pictures = true, .cell_width = 10, .cell_height = 20, .most_width = 800, .most_height = 200};
  const Area area = limited({5, 3, 100, 30}, room);
  EXPECT_TRUE(same(area, {15, 3, 80, 10}));
  EXPECT_TRUE(same(limited({5, 3, 70, 9}, room), {5, 3, 70, 9}));
}

TEST(ViewLayout, PixelsAreThoseOfTheCellsEvenAndNeverTooFew) {
  const PictureRoom room{.pictures = true, .cell_width = 9, .cell_height = 17};
  EXPECT_EQ(pixels_for({0, 0, 100, 30}, room, 1), (std::array{900, 510}));
  EXPECT_EQ(pixels_for({0, 0, 101, 31}, room, 1), (std::array{910, 528}));
  EXPECT_EQ(pixels_for({0, 0, 100, 30}, room, 0.5), (std::array{450, 256}));
  const auto least = pixels_for({0, 0, 60, 12}, room, 0.1);
  EXPECT_GE(least[0], 320);
  EXPECT_GE(least[1], 180);
  const PictureRoom large{.pictures = true, .cell_width = 100, .cell_height = 200};
  EXPECT_EQ(pixels_for({0, 0, 200, 60}, large, 1), (std::array{8192, 4916})) << "as large as can be drawn";
}

TEST(ViewLayout, WhileItMovesAPictureHasAsManyPixelsAsCanBeDrawnAndSent) {
  const Area area{0, 0, 100, 30};
  PictureRoom room{.pictures = true, .cell_width = 10, .cell_height = 20};
  EXPECT_EQ(share_while_moving(area, room, 0.05, 0.1), 1);
  EXPECT_DOUBLE_EQ(share_while_moving(area, room, 0.4, 0.1), 0.5) << "a quarter of the pixels";
  room.bytes_per_pixel = 0.5;  // 300 kB a picture
  room.bytes_per_s = 1e6;
  EXPECT_NEAR(share_while_moving(area, room, 0.05, 0.1), std::sqrt(1.0 / 3), 1e-12);
  room.bytes_per_s = 1e4;
  EXPECT_EQ(share_while_moving(area, room, 0.05, 0.1), 0.25) << "something is seen on any line";
}

}  // namespace
}  // namespace rift::studio

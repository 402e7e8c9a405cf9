#include "viz/layout.hpp"

#include <gtest/gtest.h>

namespace rift::viz {
namespace {

constexpr Extent paper_plate{.length = 0.2, .height = 0.042, .middle = 0.02};

Job job_of(int panes, int width, int height, Chart chart = Chart::growing, bool large = false) {
  Job job;
  job.panes.resize(panes);
  job.width = width;
  job.height = height;
  job.look.chart = chart;
  job.look.large_text = large;
  return job;
}

/// Beyond the rounding of boxes that touch.
bool overlap(const Box& a, const Box& b) {
  constexpr double tiny = 1e-6;
  return a.x0 + tiny < b.x1 && b.x0 + tiny < a.x1 && a.y0 + tiny < b.y1 && b.y0 + tiny < a.y1;
}

std::vector<Box> boxes_of(const Layout& layout) {
  std::vector<Box> all{layout.title, layout.colour_bar, layout.scale_bar, layout.beam_bar};
  for (const PaneLayout& pane : layout.panes) all.insert(all.end(), {pane.title, pane.moment, pane.picture});
  all.insert(all.end(), layout.chart.begin(), layout.chart.end());
  if (!layout.chart.empty()) all.push_back(layout.key);
  if (layout.ratio.width() > 0) all.push_back(layout.ratio);
  return all;
}

TEST(Layout, NothingOverlapsAndNothingLeavesTheFrame) {
  for (int panes = 1; panes <= 4; ++panes)
    for (const auto& [width, height] :
         {std::pair{1280, 720}, {1920, 1080}, {640, 360}, {720, 720}, {1080, 1920}})
      for (const Chart chart : {Chart::none, Chart::growing, Chart::whole})
        for (const bool large : {true, false})
          for (const Camera camera : {Camera::plate, Camera::tip, Camera::side}) {
            Job job = job_of(panes, width, height, chart, large);
            job.look.camera = camera;
            const std::vector<Box> boxes = boxes_of(layout_of(job, paper_plate));
            ASSERT_FALSE(boxes.empty());
            for (std::size_t a = 0; a < boxes.size(); ++a) {
              EXPECT_GT(boxes[a].width(), 0)
                  << panes << " panes, " << width << "x" << height << ", box " << a;
              EXPECT_GT(boxes[a].height(), 0)
                  << panes << " panes, " << width << "x" << height << ", box " << a;
              EXPECT_TRUE(boxes[a].x0 >= 0 && boxes[a].y0 >= 0 && boxes[a].x1 <= width &&
                          boxes[a].y1 <= height);
              ASSERT_FALSE(boxes.empty());
              for (std::size_t b = a + 1; b < boxes.size(); ++b)
                EXPECT_FALSE(overlap(boxes[a], boxes[b]))
                    << panes << " panes, " << width << "x" << height << ", boxes " << a << " and " << b;
            }
          }
}

TEST(Layout, OnePlateFillsFourFifthsOfTheWidth) {
  for (const auto& [width, height] : {std::pair{1280, 720}, {1920, 1080}}) {
    const Job job = job_of(1, width, height);
    const Box picture = layout_of(job, paper_plate).panes.front().picture;
    const Window shown = window_of(job.look, picture, paper_plate, {0, 0});
    EXPECT_GE(paper_plate.length / shown.width * picture.width(), 0.8 * width);
  }
}

TEST(Layout, ThePlateKeepsItsProportions) {
  const Job job = job_of(3, 1280, 720);
  const Box picture = layout_of(job, paper_plate).panes.front().picture;
  const Window shown = window_of(job.look, picture, paper_plate, {0, 0});
  EXPECT_NEAR(shown.width / picture.width(), shown.height / picture.height(), 1e-12);
  EXPECT_GE(shown.height, paper_plate.height);
}

TEST(Layout, ACloseUpHasTheTipInItsMiddle) {
  Job job = job_of(1, 1280, 720);
  job.look.camera = Camera::tip;
  const Box picture = layout_of(job, paper_plate).panes.front().picture;
  const std::array<double, 2> tip{0.031, 0.021};
  const auto pixel = to_pixels(axes_of(job.look), window_of(job.look, picture, paper_plate, tip), picture,
                               {tip[0], tip[1], 0});
  EXPECT_NEAR(pixel[0], 0.5 * (picture.x0 + picture.x1), 1e-9);
  EXPECT_NEAR(pixel[1], 0.5 * (picture.y0 + picture.y1), 1e-9);
}

TEST(Layout, TheSideCameraForeshortensThePlate) {
  Look look;
  const Box picture{0, 0, 100, 100};
  const Window shown{.x = 0.1, .y = 0.02, .width = 0.2, .height = 0.2};
  const double front = to_pixels(axes_of(look), shown, picture, {0.1, 0.04, 0})[1] - 50;
  look.camera = Camera::side;
  EXPECT_NEAR(to_pixels(axes_of(look), shown, picture, {0.1, 0.04, 0})[1] - 50, front * std::cos(side_tilt),
              1e-9);
}

TEST(Layout, TheFreeCameraIsTheSideCameraAtItsAngle) {
  Look side, free;
  side.camera = Camera::side;
  free.camera = Camera::free;
  free.view.tilt = side_tilt;
  const Axes a = axes_of(side), b = axes_of(free);
  for (int axis = 0; axis < 3; ++axis) {
    EXPECT_DOUBLE_EQ(a.right[axis], b.right[axis]);
    EXPECT_DOUBLE_EQ(a.up[axis], b.up[axis]);
    EXPECT_DOUBLE_EQ(a.out[axis], b.out[axis]);
  }
}

TEST(Layout, TheDirectionsOfACameraAreUnitVectorsAtRightAngles) {
  Look look;
  look.camera = Camera::free;
  look.view.turn = 0.7, look.view.tilt = -0.4;
  const Axes axes = axes_of(look);
  const auto product = [](const auto& a, const auto& b) { return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]; };
  EXPECT_NEAR(product(axes.right, axes.right), 1, 1e-15);
  EXPECT_NEAR(product(axes.up, axes.up), 1, 1e-15);
  EXPECT_NEAR(product(axes.right, axes.up), 0, 1e-15);
  EXPECT_NEAR(axes.right[1] * axes.up[2] - axes.right[2] * axes.up[1], axes.out[0], 1e-15);
  EXPECT_NEAR(axes.right[0] * axes.up[1] - axes.right[1] * axes.up[0], axes.out[2], 1e-15);
}

TEST(Layout, WithoutTextsThePlatesHaveTheirRoom) {
  Job job = job_of(1, 640, 360, Chart::none);
  const Box with = layout_of(job, paper_plate).panes.front().picture;
  job.look.texts = false;
  const Box without = layout_of(job, paper_plate).panes.front().picture;
  EXPECT_DOUBLE_EQ(without.height(), 360);
  EXPECT_LT(with.height(), 300);
}

}  // namespace
}  // namespace rift::viz

#include "studio/charts/point_texts.hpp"

#include "studio/charts/text_width.hpp"
#include "tests/expectations.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace rift::studio {
namespace {

const TextSpace space{
    .area = {84, 504, 82, 402}, .x = {0.01, 1}, .y = {1e-4, 1}, .log_x = true, .log_y = true};

/// Schemes whose times and errors hardly differ, as those of one damping have.
std::vector<ChartSeries> crowd(int schemes) {
  std::vector<ChartSeries> series;
  for (int k = 0; k < schemes; ++k) {
    ChartSeries& one = series.emplace_back();
    one.style = ChartSeries::Style::points, one.colour = k;
    one.add(0.1 * (1 + 0.02 * (k % 3)), 0.01 * std::pow(1.08, k));
    one.text = {std::to_string(k + 1)};
  }
  return series;
}

std::array<double, 2> place_in(const TextSpace& s, double x, double y) {
  return {s.area.left + std::log(x / s.x.min) / std::log(s.x.max / s.x.min) * s.area.width(),
          s.area.bottom + std::log(y / s.y.min) / std::log(s.y.max / s.y.min) * s.area.height()};
}

TEST(PointTexts, CoverNoOtherTextAndNoPoint) {
  for (const int schemes : {2, 8, 27}) {
    const std::vector<PointText> texts = placed_texts(crowd(schemes), space);
    ASSERT_EQ(texts.size(), static_cast<std::size_t>(schemes));
    for (const PointText& a : texts)
      for (const PointText& b : texts) {
        const auto at_a = place_in(space, a.x, a.y), at_b = place_in(space, b.x, b.y);
        const double across = std::abs(at_a[0] + a.dx - at_b[0]), along = std::abs(at_a[1] + a.dy - at_b[1]);
        EXPECT_TRUE(across > 0.5 * text_px(a.text, point_text_px) || along > 0.5 * point_text_px)
            << a.text << " covers the point of " << b.text;
        if (&a == &b) continue;
        const double half = 0.5 * (text_px(a.text, point_text_px) + text_px(b.text, point_text_px));
        EXPECT_TRUE(std::abs(at_a[0] + a.dx - at_b[0] - b.dx) >= half ||
                    std::abs(at_a[1] + a.dy - at_b[1] - b.dy) >= point_text_px)
            << a.text << " covers " << b.text;
      }
  }
}

TEST(PointTexts, StandWithinTheAxes) {
  std::vector<ChartSeries> series = crowd(1);
  series[0].x = {0.99}, series[0].y = {0.99}, series[0].text = {"recommended"};
  const PointText text = placed_texts(series, space).at(0);
  const auto at = place_in(space, text.x, text.y);
  EXPECT_LE(at[0] + text.dx + 0.5 * text_px(text.text, point_text_px), space.area.right);
  EXPECT_LE(at[1] + text.dy + 0.5 * point_text_px, space.area.top);
}

TEST(PointTexts, ALineLeadsToATextThatIsAwayFromItsPoint) {
  const std::vector<PointText> alone = placed_texts(crowd(1), space), many = placed_texts(crowd(27), space);
  EXPECT_FALSE(alone.at(0).is_led);
  EXPECT_FALSE(text_lines(alone, space, chart_height).find("set arrow") != std::string::npos);
  EXPECT_TRUE(text_lines(many, space, chart_height).find("set arrow") != std::string::npos);
}

}  // namespace
}  // namespace rift::studio

#pragma once

#include "studio/charts/chart.hpp"
#include "studio/charts/chart_layout.hpp"

#include <string>
#include <vector>

namespace rift::studio {

/// A text beside its point, from which its middle lies (dx, dy) away [px].
struct PointText {
  std::string text, colour;
  double x = 0, y = 0;  // of the point, in the axes' units
  double dx = 0, dy = 0;
  bool is_led = false;  // a thin line leads to it, as it is not next to its point
};

/// The axes within which texts stand, and the ends that these show.
struct TextSpace {
  PlotArea area;
  Span x, y;
  bool log_x = false, log_y = false;
};

/// Where the texts of all series stand: within the axes, where they cover no other text, and as few points
/// and lines as can be. Cost O(texts² + texts · points).
std::vector<PointText> placed_texts(const std::vector<ChartSeries>& series, const TextSpace& space);

/// The script's lines that draw them, in a picture of this height.
std::string text_lines(const std::vector<PointText>& texts, const TextSpace& space, int height);

constexpr double point_text_px = 12;  // font of these texts

}  // namespace rift::studio

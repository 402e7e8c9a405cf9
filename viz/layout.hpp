#pragma once

#include "viz/job.hpp"

#include <array>
#include <vector>

/// Where everything stands in a frame: pure arithmetic, so that a test can ask whether anything overlaps.
namespace rift::viz {

/// Pixels from the lower left corner.
struct Box {
  double x0 = 0, y0 = 0, x1 = 0, y1 = 0;
  [[nodiscard]] double width() const { return x1 - x0; }
  [[nodiscard]] double height() const { return y1 - y0; }
};

/// What a camera shows, in the plane of the picture [m]: the plate's x-y plane, which the side camera sees
/// foreshortened about the plate's middle.
struct Window {
  double x = 0, y = 0;           // its middle
  double width = 0, height = 0;  // of the picture's box
};

struct PaneLayout {
  Box title, moment;  // above the picture: what it is, and when; beside one another where there is room
  Box picture;
};

struct Layout {
  int text_px = 0;  // height of the small text
  Box title;
  std::vector<PaneLayout> panes;
  Box colour_bar;          // with its numbers and its title
  Box beam_bar;            // the same of beams whose colours are not the field's
  Box scale_bar;           // on the left of the colour bar
  Box key;                 // of the charts' lines, above them
  std::vector<Box> chart;  // of each pane; none where the look has no chart
};

/// The plate as it is drawn, loaded [m].
struct Extent {
  double length = 0, height = 0;
  double middle = 0;  // y of half its height
};

/// The side camera looks from below the plate's front, this much out of its normal.
constexpr double side_tilt = 1.15;  // rad

/// Where a point of the plate's front is in a picture's box, in pixels.
[[nodiscard]] std::array<double, 2> to_pixels(const Look& look, const Window& shown, const Box& picture,
                                              const Extent& plate, const std::array<double, 2>& point);

/// The layout of a frame: the columns of panes are chosen so that the plates are as large as can be.
[[nodiscard]] Layout layout_of(const Job& job, const Extent& plate);

/// What is shown in a picture's box. @param tip  x and y of the crack's tip [m]
[[nodiscard]] Window window_of(const Look& look, const Box& picture, const Extent& plate,
                               const std::array<double, 2>& tip);

}  // namespace rift::viz

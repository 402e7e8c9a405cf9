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

[[nodiscard]] bool holds(const Box& box, const std::array<double, 2>& point);

/// What a camera shows [m].
struct Window {
  double x = 0, y = 0;           // the point of the plate's plane in its middle
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
  std::vector<Box> chart;  // the energy budget of each pane; none where the look has no chart
  Box ratio;               // G_ID/G_I0 of all panes; none but beside whole charts
};

/// The plate as it is drawn, loaded [m].
struct Extent {
  double length = 0, height = 0;
  double middle = 0;  // y of half its height
};

/// The side camera looks from below the plate's front, this much out of its normal.
constexpr double side_tilt = 1.15;  // rad

/// The directions of a camera, as unit vectors: what is right and up in the picture, and out of it.
struct Axes {
  std::array<double, 3> right, up, out;
};
[[nodiscard]] Axes axes_of(const Look& look);

/// Whether the plate's front hides what lies behind it.
[[nodiscard]] bool seen_from_front(const Look& look);

/// Where a point is in a picture's box, in pixels: the projection along `out`.
[[nodiscard]] std::array<double, 2> to_pixels(const Axes& axes, const Window& shown, const Box& picture,
                                              const std::array<double, 3>& point);

/// The layout of a frame: the columns of panes are chosen so that the plates are as large as can be.
[[nodiscard]] Layout layout_of(const Job& job, const Extent& plate);

/// What is shown in a picture's box. @param tip  x and y of the crack's tip [m]
[[nodiscard]] Window window_of(const Look& look, const Box& picture, const Extent& plate,
                               const std::array<double, 2>& tip);

}  // namespace rift::viz

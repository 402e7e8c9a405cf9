#pragma once

#include "studio/screen/canvas.hpp"
#include "studio/screen/screen_picture.hpp"

#include <array>

namespace rift::studio {

/// Where the parts of the viewer are.
struct ViewLayout {
  Area picture, numbers, message, foot;
};

[[nodiscard]] bool same(const Area& a, const Area& b);

/// The part of an area that the largest picture of the terminal fills: at its top, in the middle.
[[nodiscard]] Area limited(const Area& area, const PictureRoom& room);

/// Pure arithmetic for any size; empty where the terminal is too small.
/// @param room  whose largest picture limits the picture's area
[[nodiscard]] ViewLayout view_layout(int width, int height, const PictureRoom& room);

/// The pixels of a picture for an area, even numbers as films need them, and no more than can be drawn.
/// @param share  of the pixels along each side, in (0, 1]
[[nodiscard]] std::array<int, 2> pixels_for(const Area& area, const PictureRoom& room, double share);

/// The share of pixels along each side with which a picture takes no longer than `wished_s`, to be drawn and
/// to be sent. @param drawn_s  that a picture of all pixels took to be drawn, 0 where not known
[[nodiscard]] double share_while_moving(const Area& area, const PictureRoom& room, double drawn_s,
                                        double wished_s);

}  // namespace rift::studio

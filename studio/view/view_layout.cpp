#include "studio/view/view_layout.hpp"

#include <algorithm>
#include <cmath>

namespace rift::studio {
namespace {

// As `rift render --size` has it.
constexpr int least_width_px = 320, least_height_px = 180, drawable_px = 8192;

int limited_cells(int cells, int cell_px, int most_px) {
  return most_px > 0 ? std::min(cells, most_px / cell_px) : cells;
}

int even(double pixels) { return 2 * static_cast<int>(std::lround(0.5 * pixels)); }

}  // namespace

bool same(const Area& a, const Area& b) {
  return a.x == b.x && a.y == b.y && a.width == b.width && a.height == b.height;
}

Area limited(const Area& area, const PictureRoom& room) {
  const int columns = limited_cells(area.width, room.cell_width, room.most_width);
  const int rows = limited_cells(area.height, room.cell_height, room.most_height);
  return {area.x + (area.width - columns) / 2, area.y, columns, rows};
}

ViewLayout view_layout(int width, int height, const PictureRoom& room) {
  if (width < least_width || height < least_height) return {};
  // What is known of an element has some 220 letters.
  const int message = width < 112 ? 3 : 2;
  const int numbers_at = height - message - 2;
  return {limited({0, 0, width, numbers_at}, room),
          {1, numbers_at, width - 2, 1},
          {1, numbers_at + 1, width - 2, message},
          {1, height - 1, width - 2, 1}};
}

std::array<int, 2> pixels_for(const Area& area, const PictureRoom& room, double share) {
  const double width = share * area.width * room.cell_width, height = share * area.height * room.cell_height;
  const double larger = std::max({1.0, least_width_px / width, least_height_px / height});
  const double scale = std::min({larger, drawable_px / width, drawable_px / height});
  return {even(scale * width), even(scale * height)};
}

double share_while_moving(const Area& area, const PictureRoom& room, double drawn_s, double wished_s) {
  const double pixels = static_cast<double>(area.width) * room.cell_width * area.height * room.cell_height;
  const double sent_s = room.bytes_per_s > 0 ? pixels * room.bytes_per_pixel / room.bytes_per_s : 0;
  const double longest_s = std::max(drawn_s, sent_s);
  constexpr double least_share = 0.25;
  return longest_s > wished_s ? std::max(least_share, std::sqrt(wished_s / longest_s)) : 1.0;
}

}  // namespace rift::studio

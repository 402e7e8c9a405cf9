#include "studio/screen/live.hpp"

#include <algorithm>

namespace rift::studio {

// From above: two lines of head, the plate or two of them, bars beside the table, two plots side by side, a
// line of what happened, a line of keys. On a low screen the plate goes first.
LiveLayout live_layout(int width, int height, int lanes, bool two) {
  LiveLayout layout;
  if (width <= 0 || height <= 0) return layout;
  layout.head = {0, 0, width, std::min(2, height)};
  layout.foot = {0, height - 1, width, height >= 3 ? 1 : 0};
  if (width < least_width || height < least_height) return layout;
  layout.message = {0, height - 2, width, 1};
  int top = layout.head.height, left = height - layout.head.height - 2;
  constexpr int least_plots = 6;
  const int bars = 6, rows = lanes > 1 ? std::min(lanes + 1, 9) : 0, middle = std::max(bars, rows);
  const int plate = std::min({left - middle - least_plots - 1, (two ? width / 2 : width) / 8 + 1, 26});
  if (plate >= 3) {
    layout.plate = {0, top, two ? width / 2 - 1 : width, plate};
    if (two) layout.plate_beside = {width / 2 + 1, top, width - width / 2 - 1, plate};
    top += plate + 1;
    left -= plate + 1;
  }
  const int half = lanes > 1 ? width / 2 : width;
  layout.budget = {0, top, half - (lanes > 1 ? 1 : 0), std::min(bars, left)};
  if (lanes > 1) layout.table = {half, top, width - half, std::min(rows, left)};
  top += middle;
  left -= middle;
  if (left < 5) return layout;
  layout.energies = {0, top, width / 2 - 1, left};
  layout.rates = {width / 2, top, width - width / 2, left};
  return layout;
}

}  // namespace rift::studio

#include "studio/screen/layouts.hpp"

#include <algorithm>

namespace rift::studio {
namespace {

bool too_small(int width, int height) { return width < least_width || height < least_height; }

constexpr int detail_lines = 3;

}  // namespace

HomeLayout home_layout(int width, int height, bool preview) {
  if (too_small(width, height)) return {};
  const int rows = height - 2 - detail_lines - 1;
  HomeLayout layout{{1, 0, width - 2, 1},
                    {1, 1, width - 2, 1},
                    {1, 2, width - 2, rows},
                    {},
                    {1, 2 + rows, width - 2, detail_lines},
                    {1, height - 1, width - 2, 1}};
  if (preview && width >= 100) {
    const int beside = width / 2;
    layout.list.width = width - beside - 2;
    layout.preview = {width - beside + 1, 2, beside - 2, rows};
  } else if (preview) {
    layout.list.height = rows / 2;
    layout.preview = {1, 2 + layout.list.height, width - 2, rows - layout.list.height};
  }
  return layout;
}

// What follows from the parameters stands beside them where there is room, else below them.
FormLayout form_layout(int width, int height) {
  if (too_small(width, height)) return {};
  const int middle = height - 2 - detail_lines - 1;
  FormLayout layout{{1, 0, width - 2, 1},
                    {1, 1, width - 2, 1},
                    {1, 2, width - 2, middle},
                    {},
                    {1, height - 1 - detail_lines, width - 2, detail_lines},
                    {1, height - 1, width - 2, 1}};
  if (width >= 100) {
    const int beside = std::max(44, width * 45 / 100);
    layout.rows.width = width - beside - 2;
    layout.derived = {width - beside + 1, 2, beside - 2, middle};
  } else {
    const int below = std::min(8, height / 4);
    layout.rows.height = middle - below;
    layout.derived = {1, 2 + layout.rows.height, width - 2, below};
  }
  return layout;
}

CompareLayout compare_layout(int width, int height, int columns, bool plates) {
  if (too_small(width, height)) return {};
  const int titles = std::min(columns, std::max(0, height - 8));
  const int top = titles + 2, left = height - top - 1;
  const int table = std::min({19 + 10 * columns, width >= 110 ? width / 2 : width - 2, width - 2});
  CompareLayout layout{{1, 0, width - 2, 1},
                       {1, 1, width - 2, titles},
                       {1, top, table, left},
                       {},
                       {},
                       {1, height - 1, width - 2, 1}};
  if (plates) {
    constexpr int rates = 10;
    const bool beside = width - table >= 70;
    if (!beside) layout.table = {};
    const int x = beside ? table + 2 : 1, wide = width - x - 1, above = left >= 3 * rates ? left - rates : left;
    layout.plates = {x, top, wide, above};
    if (above < left) layout.rates = {x, top + above, wide, rates};
    return layout;
  }
  if (width - table >= 42) {
    layout.rates = {table + 2, top, width - table - 3, left};
  } else if (left >= 13) {
    layout.table.height = left / 2;
    layout.rates = {1, top + left / 2 + 1, width - 2, left - left / 2 - 1};
  }
  return layout;
}

StudyLayout study_layout(int width, int height) {
  if (too_small(width, height)) return {};
  const int left = height - 3, plots = std::max(7, left * 45 / 100);
  return {{1, 0, width - 2, 1},
          {1, 1, width - 2, 1},
          {1, 2, width - 2, left - plots},
          {1, 2 + left - plots, width / 2 - 2, plots},
          {width / 2 + 1, 2 + left - plots, width - width / 2 - 2, plots},
          {1, height - 1, width - 2, 1}};
}

}  // namespace rift::studio

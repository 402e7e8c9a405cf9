#pragma once

#include "studio/screen/canvas.hpp"

/// Where the parts of each screen are: pure arithmetic for any size. Parts lie inside the screen and apart
/// from each other; empty ones have no room.
namespace rift::studio {

struct HomeLayout {
  Area head, search, list, detail, foot;
};
[[nodiscard]] HomeLayout home_layout(int width, int height);

struct FormLayout {
  Area head, search, rows, derived, detail, foot;
};
[[nodiscard]] FormLayout form_layout(int width, int height);

struct CompareLayout {
  Area head, titles, table, rates, foot;
};
/// @param columns  scenarios beside each other
[[nodiscard]] CompareLayout compare_layout(int width, int height, int columns);

struct StudyLayout {
  Area head, chosen, grid, velocities, errors, foot;
};
[[nodiscard]] StudyLayout study_layout(int width, int height);

}  // namespace rift::studio

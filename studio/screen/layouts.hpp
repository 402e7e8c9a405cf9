#pragma once

#include "studio/screen/canvas.hpp"

/// Where the parts of each screen are: pure arithmetic for any size. Parts lie inside the screen and apart
/// from each other; empty ones have no room.
namespace rift::studio {

struct HomeLayout {
  Area head, search, list, preview, detail, foot;
};
/// @param preview  whether a plate is shown beside the list, or below it where the screen is narrow
[[nodiscard]] HomeLayout home_layout(int width, int height, bool preview = false);

struct FormLayout {
  Area head, search, rows, derived, detail, foot;
};
[[nodiscard]] FormLayout form_layout(int width, int height);

struct CompareLayout {
  Area head, titles, table, plates, rates, foot;
};
/// @param columns  scenarios beside each other;  @param plates  whether their plates are shown, for which the
/// numbers of the narrow screen give way
[[nodiscard]] CompareLayout compare_layout(int width, int height, int columns, bool plates = false);

struct StudyLayout {
  Area head, chosen, grid, velocities, errors, foot;
};
[[nodiscard]] StudyLayout study_layout(int width, int height);

}  // namespace rift::studio

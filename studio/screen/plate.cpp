#include "studio/screen/plate.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

namespace rift::studio {
namespace {

/// Means over the boxes of a grid, rows from the top.
class Grid {
 public:
  Grid(int across, int down)
      : width(across), height(down), sum_(static_cast<std::size_t>(across) * down), count_(sum_.size()) {}

  /// Adds a value to the box it lies in and to those whose middles its disc covers.
  void add(double column, double row, double radius_x, double radius_y, double value) {
    for (int y = static_cast<int>(std::floor(row - radius_y)); y <= static_cast<int>(row + radius_y); ++y)
      for (int x = static_cast<int>(std::floor(column - radius_x)); x <= static_cast<int>(column + radius_x);
           ++x) {
        if (x < 0 || y < 0 || x >= width || y >= height) continue;
        const bool in_it =
            x == static_cast<int>(std::floor(column)) && y == static_cast<int>(std::floor(row));
        const double from_x = (x + 0.5 - column) / radius_x, from_y = (y + 0.5 - row) / radius_y;
        if (!in_it && from_x * from_x + from_y * from_y > 1) continue;
        sum_[index(x, y)] += value;
        ++count_[index(x, y)];
      }
  }
  [[nodiscard]] bool empty(int x, int y) const { return count_[index(x, y)] == 0; }
  [[nodiscard]] double mean(int x, int y) const { return sum_[index(x, y)] / count_[index(x, y)]; }

  /// Gives a box that is empty between four that are not their mean: a pore of the packing, not the crack.
  void fill_pores() {
    const Grid before = *this;
    for (int y = 1; y + 1 < height; ++y)
      for (int x = 1; x + 1 < width; ++x) {
        if (!before.empty(x, y)) continue;
        const std::array<std::array<int, 2>, 4> around{{{x - 1, y}, {x + 1, y}, {x, y - 1}, {x, y + 1}}};
        if (std::any_of(around.begin(), around.end(),
                        [&](const auto& n) { return before.empty(n[0], n[1]); }))
          continue;
        for (const auto& [nx, ny] : around) sum_[index(x, y)] += before.mean(nx, ny), ++count_[index(x, y)];
      }
  }

  int width, height;

 private:
  [[nodiscard]] std::size_t index(int x, int y) const { return static_cast<std::size_t>(y) * width + x; }
  std::vector<double> sum_;
  std::vector<int> count_;
};

/// The part of the area that has the plate's proportions; a half of a cell is about square.
Area fitted(const Area& area, double aspect) {
  Area plate = area;
  plate.height = std::clamp(static_cast<int>(std::lround(area.width / aspect / 2)), 1, area.height);
  plate.width = std::clamp(static_cast<int>(std::lround(2 * plate.height * aspect)), 1, area.width);
  plate.x += (area.width - plate.width) / 2;
  plate.y += (area.height - plate.height) / 2;
  return plate;
}

std::int8_t shade_of(double value, double least, double most) {
  const double part = most > least ? std::clamp((value - least) / (most - least), 0.0, 1.0) : 0.5;
  return static_cast<std::int8_t>(std::lround(part * (shade_steps - 1)));
}

void draw_cell(Canvas& canvas, int x, int y, std::int8_t upper, std::int8_t lower, Glyphs glyphs) {
  if (upper == no_shade && lower == no_shade) return;
  if (glyphs == Glyphs::ascii) {
    constexpr std::u32string_view letters = U".,:;-=+*oxXO%@#";
    canvas.put(x, y, letters[std::max(upper, lower)], {});
    return;
  }
  const char32_t glyph = upper == no_shade ? U'▄' : U'▀';
  canvas.put(x, y, glyph, {.ink = Ink::shades, .upper = upper, .lower = lower});
}

}  // namespace

void draw_plate(Canvas& canvas, const Area& area, const results::Geometry& geometry,
                std::span<const std::array<float, 3>> displacement, const PlateLook& look, Glyphs glyphs) {
  if (area.empty()) return;
  const double height = look.height + look.pulled;
  const Area plate = fitted(area, look.length / height);
  Grid grid(plate.width, 2 * plate.height);
  const auto column = [&](double x) { return x / look.length * grid.width; };
  const auto row = [&](double y) { return (1 - y / height) * grid.height; };
  const bool by_velocity = look.velocity.size() == geometry.position.size();
  for (std::size_t i = 0; i < geometry.position.size(); ++i) {
    const double ux = displacement.empty() ? 0 : displacement[i][0],
                 uy = displacement.empty() ? 0 : displacement[i][1];
    const double r = geometry.radius[i];
    grid.add(column(geometry.position[i][0] + ux), row(geometry.position[i][1] + uy),
             r / look.length * grid.width, r / height * grid.height, by_velocity ? look.velocity[i][1] : uy);
  }
  grid.fill_pores();
  const double least = by_velocity ? -look.fastest : 0, most = by_velocity ? look.fastest : look.pulled;
  const auto shade = [&](int x, int y) {
    return grid.empty(x, y) ? no_shade : shade_of(grid.mean(x, y), least, most);
  };
  for (int y = 0; y < plate.height; ++y)
    for (int x = 0; x < plate.width; ++x)
      draw_cell(canvas, plate.x + x, plate.y + y, shade(x, 2 * y), shade(x, 2 * y + 1), glyphs);
  for (const auto& [x, y] : look.tips) {
    const int tip_x = static_cast<int>(column(x)), tip_y = static_cast<int>(row(y + 0.5 * look.pulled) / 2);
    if (tip_x >= 0 && tip_x < plate.width)
      canvas.put(plate.x + tip_x, plate.y + tip_y, glyphs == Glyphs::unicode ? U'●' : U'@',
                 {.ink = Ink::plain, .bold = true});
  }
}

void draw_scale(Canvas& canvas, int x, int y, Glyphs glyphs) {
  for (int step = 0; step < shade_steps; ++step)
    draw_cell(canvas, x + step, y, static_cast<std::int8_t>(step), static_cast<std::int8_t>(step), glyphs);
}

}  // namespace rift::studio

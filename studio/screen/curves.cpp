#include "studio/screen/curves.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <optional>

namespace rift::studio {
namespace {

/// The dots of a cell by column and row   [Unicode 15, braille patterns U+2800].
constexpr std::uint8_t dot_bit[2][4] = {{0x01, 0x02, 0x04, 0x40}, {0x08, 0x10, 0x20, 0x80}};

/// Dots over an area of cells.
class Dots {
 public:
  explicit Dots(const Area& area)
      : area_(area), bits_(static_cast<std::size_t>(area.width) * area.height), style_(bits_.size()) {}

  [[nodiscard]] int width() const { return 2 * area_.width; }
  [[nodiscard]] int height() const { return 4 * area_.height; }
  /// @param y  from the top
  void set(int x, int y, const Style& style) {
    if (x < 0 || y < 0 || x >= width() || y >= height()) return;
    const std::size_t cell = static_cast<std::size_t>(y / 4) * area_.width + x / 2;
    bits_[cell] |= dot_bit[x % 2][y % 4];
    style_[cell] = style;
  }
  void line(std::array<double, 2> a, std::array<double, 2> b, const Style& style) {
    const double steps = std::max({1.0, std::abs(b[0] - a[0]), std::abs(b[1] - a[1])});
    for (int k = 0; k <= static_cast<int>(steps); ++k)
      set(static_cast<int>(std::lround(a[0] + (b[0] - a[0]) * k / steps)),
          static_cast<int>(std::lround(a[1] + (b[1] - a[1]) * k / steps)), style);
  }
  void draw(Canvas& canvas, Glyphs glyphs) const {
    for (std::size_t k = 0; k < bits_.size(); ++k) {
      if (bits_[k] == 0) continue;
      const char32_t glyph = glyphs == Glyphs::unicode ? U'\u2800' + bits_[k] : U'*';
      canvas.put(area_.x + static_cast<int>(k) % area_.width, area_.y + static_cast<int>(k) / area_.width,
                 glyph, style_[k]);
    }
  }

 private:
  Area area_;
  std::vector<std::uint8_t> bits_;
  std::vector<Style> style_;
};

/// Where a point lies, in dots of an area of so many; nothing where it is no number or far outside, which is
/// not worth a line.
std::optional<std::array<double, 2>> place_of(const std::array<double, 2>& point, const Axes& axes, int width,
                                              int height) {
  const std::array at{(point[0] - axes.x[0]) / (axes.x[1] - axes.x[0]) * (width - 1),
                      (axes.y[1] - point[1]) / (axes.y[1] - axes.y[0]) * (height - 1)};
  const bool near =
      std::isfinite(at[0]) && std::isfinite(at[1]) && std::abs(at[0]) < 1e5 && std::abs(at[1]) < 1e5;
  return near ? std::optional(at) : std::nullopt;
}

void draw_line(Dots& dots, const Axes& axes, const Curve& curve) {
  if (!curve.line) return;
  for (std::size_t k = 0; k < curve.points.size(); ++k) {
    const auto here = place_of(curve.points[k], axes, dots.width(), dots.height()),
               before = place_of(curve.points[k == 0 ? 0 : k - 1], axes, dots.width(), dots.height());
    if (here && before) dots.line(*before, *here, curve.style);
  }
}

/// The curve's letter over its points, or over the last one that there is.
void draw_marks(Canvas& canvas, const Area& plot, const Axes& axes, const Curve& curve) {
  if (curve.marks == Marks::none) return;
  for (std::size_t k = curve.points.size(); k-- > 0;) {
    const auto at = place_of(curve.points[k], axes, 2 * plot.width, 4 * plot.height);
    const int x = at ? static_cast<int>(std::lround((*at)[0])) / 2 : -1,
              y = at ? static_cast<int>(std::lround((*at)[1])) / 4 : -1;
    if (x < 0 || y < 0 || x >= plot.width || y >= plot.height) continue;
    canvas.put(plot.x + x, plot.y + y, curve.mark, {curve.style.ink, true});
    if (curve.marks == Marks::last) return;
  }
}

/// The labels in their curves' colours, cut alike where there is no room for all of their letters.
void draw_legend(Canvas& canvas, int x, int y, int width, std::span<const Curve> curves) {
  std::size_t longest = 0, count = 0;
  for (const Curve& curve : curves)
    longest = std::max(longest, letters_of(curve.label).size()), count += curve.label.empty() ? 0 : 1;
  const auto taken = [&](std::size_t most) {
    std::size_t cells = count;
    for (const Curve& curve : curves) cells += std::min(most, letters_of(curve.label).size());
    return static_cast<int>(cells);
  };
  while (longest > 1 && taken(longest) > width) --longest;
  const int end = x + width;
  for (const Curve& curve : curves)
    if (!curve.label.empty() && x < end)
      x += 1 + canvas.text(x, y, curve.label, {curve.style.ink, true},
                           std::min(static_cast<int>(longest), end - x));
}

}  // namespace

void draw_curves(Canvas& canvas, const Area& area, const Axes& axes, std::span<const Curve> curves,
                 Glyphs glyphs) {
  constexpr int labels = 7;
  const Area plot{area.x + labels, area.y + 1, area.width - labels, area.height - 2};
  if (plot.width < 4 || plot.height < 2) return;
  const Style dim{Ink::dim};
  const auto number = [&](double value) {
    return fmt::format("{:.3g}", axes.logarithmic ? std::pow(10.0, value) : value);
  };
  const int titled = canvas.text(area.x, area.y, axes.y_title, dim, area.width) + 2;
  draw_legend(canvas, area.x + titled, area.y, area.width - titled, curves);
  for (int y = 0; y < plot.height; ++y)
    canvas.put(plot.x - 1, plot.y + y, glyphs == Glyphs::unicode ? U'│' : U'|', dim);
  const auto label = [&](int y, double value) {
    const std::string text = number(value);
    canvas.text(plot.x - 1 - static_cast<int>(text.size()), y, text, dim, labels);
  };
  label(plot.y, axes.y[1]);
  label(plot.y + plot.height - 1, axes.y[0]);
  const int foot = plot.y + plot.height;
  const std::string end = number(axes.x[1]);
  canvas.text(plot.x, foot, number(axes.x[0]), dim, plot.width);
  canvas.text(plot.x + plot.width - static_cast<int>(end.size()), foot, end, dim, plot.width);
  const auto title = static_cast<int>(letters_of(axes.x_title).size());
  if (title + 12 < plot.width)
    canvas.text(plot.x + (plot.width - title) / 2, foot, axes.x_title, dim, plot.width);
  Dots dots(plot);
  for (const Curve& curve : curves) draw_line(dots, axes, curve);
  dots.draw(canvas, glyphs);
  for (const Curve& curve : curves) draw_marks(canvas, plot, axes, curve);
}

}  // namespace rift::studio

#include "studio/charts/point_texts.hpp"

#include "studio/charts/chart_script.hpp"
#include "studio/charts/label.hpp"
#include "studio/charts/text_width.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

namespace rift::studio {
namespace {

struct Rectangle {
  double left, right, bottom, top;
};

Rectangle around(double x, double y, double width, double height) {
  return {x - 0.5 * width, x + 0.5 * width, y - 0.5 * height, y + 0.5 * height};
}

bool overlap(const Rectangle& a, const Rectangle& b) {
  return a.left < b.right && b.left < a.right && a.bottom < b.top && b.bottom < a.top;
}

bool lies_within(const Rectangle& inner, const PlotArea& outer) {
  return inner.left >= outer.left && inner.right <= outer.right && inner.bottom >= outer.bottom &&
         inner.top <= outer.top;
}

/// What a text should not cover, and how bad it would be.
struct Obstacle {
  Rectangle place;
  double weight;
};

constexpr double of_text = 1000, of_leaving = 3000, of_point = 30, of_line = 1.5;  // weights
constexpr double of_distance = 0.15;                                               // [1/px]
constexpr double symbol_px = 10, line_px = 4, along_line_px = 6;
constexpr std::array distances{8.0, 16.0, 26.0, 38.0, 54.0, 74.0};  // of a text's edge from its point [px]
constexpr double far_px = 14;                                       // from there on a line leads to the text
constexpr int directions = 16;

/// Width and height that a text takes, with a little room around it [px].
std::array<double, 2> size_of(const std::string& text) {
  return {text_px(escape_label(text), point_text_px) + 4, point_text_px + 2};
}

double pixel(double value, const Span& span, bool log, double from, double to) {
  const auto at = [&](double v) { return log ? std::log(v) : v; };
  return from + (at(value) - at(span.min)) / (at(span.max) - at(span.min)) * (to - from);
}

std::array<double, 2> place_of(const TextSpace& s, double x, double y) {
  return {pixel(x, s.x, s.log_x, s.area.left, s.area.right),
          pixel(y, s.y, s.log_y, s.area.bottom, s.area.top)};
}

bool has_line(const ChartSeries& s) {
  return s.style == ChartSeries::Style::line || s.style == ChartSeries::Style::dashed ||
         s.style == ChartSeries::Style::line_points;
}

void add_line(std::vector<Obstacle>& obstacles, const std::array<double, 2>& a,
              const std::array<double, 2>& b) {
  const int parts = 1 + static_cast<int>(std::hypot(b[0] - a[0], b[1] - a[1]) / along_line_px);
  for (int k = 0; k <= parts; ++k) {
    const double at = static_cast<double>(k) / parts;
    obstacles.push_back(
        {around(std::lerp(a[0], b[0], at), std::lerp(a[1], b[1], at), line_px, line_px), of_line});
  }
}

/// Points that a logarithmic axis can show.
std::vector<std::size_t> shown_points(const ChartSeries& s, const TextSpace& space) {
  std::vector<std::size_t> points = drawable_points(s);
  std::erase_if(points, [&](std::size_t k) {
    return (space.log_x && s.x[k] <= 0.0) || (space.log_y && s.y[k] <= 0.0);
  });
  return points;
}

std::vector<Obstacle> drawn(const std::vector<ChartSeries>& series, const TextSpace& space) {
  std::vector<Obstacle> obstacles;
  for (const ChartSeries& s : series) {
    if (s.style == ChartSeries::Style::band) continue;
    const std::vector<std::size_t> points = shown_points(s, space);
    for (std::size_t n = 0; n < points.size(); ++n) {
      const auto at = place_of(space, s.x[points[n]], s.y[points[n]]);
      if (s.style == ChartSeries::Style::points || s.style == ChartSeries::Style::line_points)
        obstacles.push_back({around(at[0], at[1], symbol_px, symbol_px), of_point});
      if (has_line(s) && n > 0)
        add_line(obstacles, place_of(space, s.x[points[n - 1]], s.y[points[n - 1]]), at);
    }
  }
  return obstacles;
}

/// The best of the places around a point; it becomes an obstacle of the next text.
void place(PointText& text, const TextSpace& space, std::vector<Obstacle>& obstacles) {
  const auto at = place_of(space, text.x, text.y);
  const auto [width, height] = size_of(text.text);
  double least = INFINITY;
  Rectangle best{};
  for (const double distance : distances)
    for (int k = 0; k < directions; ++k) {
      const double angle = std::numbers::pi * (0.25 + 2.0 * k / directions);  // up and to the right first
      // Beside the point at full width, above and below it in the middle.
      const auto along = [&](double part, double size) {
        return part * distance + 0.5 * size * std::clamp(1.5 * part, -1.0, 1.0);
      };
      const double dx = along(std::cos(angle), width), dy = along(std::sin(angle), height);
      const Rectangle here = around(at[0] + dx, at[1] + dy, width, height);
      double cost = of_distance * distance + (lies_within(here, space.area) ? 0.0 : of_leaving);
      for (const Obstacle& obstacle : obstacles)
        if (overlap(here, obstacle.place)) cost += obstacle.weight;
      if (cost >= least) continue;
      least = cost, best = here;
      text.dx = dx, text.dy = dy, text.is_led = distance > far_px;
    }
  obstacles.push_back({best, of_text});
}

}  // namespace

std::vector<PointText> placed_texts(const std::vector<ChartSeries>& series, const TextSpace& space) {
  std::vector<PointText> texts;
  std::vector<Obstacle> obstacles = drawn(series, space);
  int references = 0;
  for (const ChartSeries& s : series) {
    const SeriesLook look = look_of(s, s.colour < 0 ? references++ : 0);
    if (s.text.empty()) continue;
    for (const std::size_t k : shown_points(s, space)) {
      texts.push_back({.text = s.text[k], .colour = look.colour, .x = s.x[k], .y = s.y[k]});
      place(texts.back(), space, obstacles);
    }
  }
  return texts;
}

std::string text_lines(const std::vector<PointText>& texts, const TextSpace& space, int height) {
  std::string out;
  for (const PointText& t : texts) {
    const auto at = place_of(space, t.x, t.y);
    const auto screen = [&](double dx, double dy) {
      return fmt::format("screen {:.4f}, screen {:.4f}", (at[0] + dx) / chart_width, (at[1] + dy) / height);
    };
    const auto edge = [](double middle, double size) {  // of the text, nearest to the point
      return std::clamp(0.0, middle - 0.5 * size, middle + 0.5 * size);
    };
    const auto [wide, high] = size_of(t.text);
    if (t.is_led)
      out += fmt::format("set arrow from {} to {} nohead lw 0.7 lc rgb '{}'\n", screen(0.0, 0.0),
                         screen(edge(t.dx, wide), edge(t.dy, high)), t.colour);
    out += fmt::format("set label {} at {} center font ',{:g}' tc rgb '{}' front\n",
                       script_string(escape_label(t.text)), screen(t.dx, t.dy), point_text_px, t.colour);
  }
  return out;
}

}  // namespace rift::studio

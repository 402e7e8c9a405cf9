#include "viz/draw/boundaries.hpp"

#include "engine/results/records.hpp"

#include <fmt/format.h>
#include <nlohmann/json.hpp>
#include <vtkActor2D.h>
#include <vtkRenderer.h>

#include <cmath>

namespace rift::viz {
namespace {

constexpr Colour grip{0.45, 0.48, 0.52}, pull{0.80, 0.25, 0.10};

/// A bar with the hatching of a fixed support, outside one edge of the plate.
void add_grip(Sheet& sheet, const Box& plate, double thick, bool top) {
  const double y0 = top ? plate.y1 : plate.y0 - thick;
  for (double x = plate.x0; x + thick <= plate.x1; x += 0.9 * thick)
    sheet.add_line({x, y0}, {x + thick, y0 + thick}, 1.5, grip);
  sheet.add(Box{plate.x0, y0, plate.x1, y0 + thick}, {0.88, 0.89, 0.91});
  const double edge = top ? plate.y1 : plate.y0;
  sheet.add_line({plate.x0, edge}, {plate.x1, edge}, 2.5, ink);
}

/// A measure with arrows at both ends.
void add_measure(Sheet& sheet, const std::array<double, 2>& a, const std::array<double, 2>& b) {
  const std::array<double, 2> middle{0.5 * (a[0] + b[0]), 0.5 * (a[1] + b[1])};
  sheet.add_arrow(middle, a, 1.6, ink);
  sheet.add_arrow(middle, b, 1.6, ink);
}

/// The crack's path, dashed, and an arrow along its first part.
void add_path(Sheet& sheet, const Box& plate, const nlohmann::ordered_json& header) {
  const double scale = plate.width() / header.at("length_m").get<double>();
  const auto path = results::path_of(header);
  const auto pixel = [&](const std::array<double, 2>& p) {
    return std::array{plate.x0 + scale * p[0], plate.y0 + scale * p[1]};
  };
  for (std::size_t k = 0; k + 1 < path.size(); ++k) {
    const auto a = pixel(path[k]), b = pixel(path[k + 1]);
    const double length = std::hypot(b[0] - a[0], b[1] - a[1]), ex = (b[0] - a[0]) / length,
                 ey = (b[1] - a[1]) / length;
    for (double s = 0; s + 9 <= length; s += 16)
      sheet.add_line({a[0] + s * ex, a[1] + s * ey}, {a[0] + (s + 9) * ex, a[1] + (s + 9) * ey}, 2, ink);
  }
}

}  // namespace

void add_boundaries(vtkRenderer& overlay, const Box& plate, int text_px,
                    const nlohmann::ordered_json& header) {
  const double t = text_px, middle = 0.5 * (plate.x0 + plate.x1);
  const auto millimetres = [&](const char* name) {
    return fmt::format("{:g} mm", header.at(name).get<double>() * 1e3);
  };
  Sheet sheet;
  add_grip(sheet, plate, 0.8 * t, true);
  add_grip(sheet, plate, 0.8 * t, false);
  constexpr int arrows = 9;
  for (int k = 0; k < arrows; ++k) {
    const double x = plate.x0 + plate.width() * (k + 0.5) / arrows;
    sheet.add_arrow({x, plate.y1 + 1.0 * t}, {x, plate.y1 + 3.0 * t}, 2.5, pull);
  }
  add_measure(sheet, {plate.x0, plate.y0 - 1.8 * t}, {plate.x1, plate.y0 - 1.8 * t});
  add_measure(sheet, {plate.x1 + 1.2 * t, plate.y0}, {plate.x1 + 1.2 * t, plate.y1});
  add_path(sheet, plate, header);
  overlay.AddActor2D(sheet.actor());
  const auto write = [&](double x, double y, Align align, const std::string& text) {
    overlay.AddActor2D(text_at(x, y, text_px, align, text));
  };
  const std::string pulled = millimetres("displacement_m");
  write(middle, plate.y1 + 3.2 * t, Align::centre,
        header.value("grip_moves", false) ? fmt::format("grip, moved along y up to {}", pulled)
                                          : fmt::format("grip, pulled by {} along y and then held", pulled));
  write(middle, plate.y0 - 3.3 * t, Align::centre,
        fmt::format("length {}, thickness {}; lower grip at rest", millimetres("length_m"),
                    millimetres("thickness_m")));
  write(plate.x1 + 1.7 * t, 0.5 * (plate.y0 + plate.y1) - 0.5 * t, Align::left, millimetres("height_m"));
  write(plate.x0 - 0.6 * t, 0.75 * plate.y1 + 0.25 * plate.y0 - 0.5 * t, Align::right, "free");
  write(plate.x0 - 0.6 * t, 0.5 * (plate.y0 + plate.y1) - 0.5 * t, Align::right, "crack");
}

}  // namespace rift::viz

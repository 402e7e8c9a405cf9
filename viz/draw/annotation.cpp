#include "viz/draw/annotation.hpp"

#include <fmt/format.h>
#include <vtkActor2D.h>
#include <vtkCellArray.h>
#include <vtkCellData.h>
#include <vtkPoints.h>
#include <vtkPolyData.h>
#include <vtkPolyDataMapper2D.h>
#include <vtkProperty2D.h>
#include <vtkRenderer.h>
#include <vtkSmartPointer.h>
#include <vtkTextProperty.h>
#include <vtkUnsignedCharArray.h>

#include <cmath>
#include <numbers>

namespace rift::viz {
namespace {

constexpr int corners = 32;

std::array<double, 2> on_circle(double radius, int corner) {
  const double angle = 2 * std::numbers::pi * corner / corners;
  return {radius * std::cos(angle), radius * std::sin(angle)};
}

/// 1, 2 or 5 times a power of ten, at most `most`.
double round_length(double most) {
  const double decade = std::pow(10.0, std::floor(std::log10(most)));
  for (const double factor : {5.0, 2.0})
    if (factor * decade <= most) return factor * decade;
  return decade;
}

}  // namespace

Sheet::Sheet() { colours_->SetNumberOfComponents(3); }

void Sheet::add(const std::vector<std::array<double, 2>>& corners, const Colour& colour) {
  cells_->InsertNextCell(static_cast<int>(corners.size()));
  for (const auto& [x, y] : corners) cells_->InsertCellPoint(points_->InsertNextPoint(x, y, 0));
  colours_->InsertNextTuple3(255 * colour[0], 255 * colour[1], 255 * colour[2]);
}

void Sheet::add(const Box& b, const Colour& colour) {
  add({{b.x0, b.y0}, {b.x1, b.y0}, {b.x1, b.y1}, {b.x0, b.y1}}, colour);
}

void Sheet::add_line(const std::array<double, 2>& a, const std::array<double, 2>& b, double width,
                     const Colour& colour) {
  const double length = std::hypot(b[0] - a[0], b[1] - a[1]);
  const double nx = -(b[1] - a[1]) / length * 0.5 * width, ny = (b[0] - a[0]) / length * 0.5 * width;
  add({{a[0] - nx, a[1] - ny}, {b[0] - nx, b[1] - ny}, {b[0] + nx, b[1] + ny}, {a[0] + nx, a[1] + ny}},
      colour);
}

void Sheet::add_arrow(const std::array<double, 2>& a, const std::array<double, 2>& b, double width,
                      const Colour& colour) {
  const double length = std::hypot(b[0] - a[0], b[1] - a[1]);
  const double ex = (b[0] - a[0]) / length, ey = (b[1] - a[1]) / length, head = 4 * width, half = 2 * width;
  const std::array<double, 2> neck{b[0] - head * ex, b[1] - head * ey};
  add_line(a, neck, width, colour);
  add({b, {neck[0] - half * ey, neck[1] + half * ex}, {neck[0] + half * ey, neck[1] - half * ex}}, colour);
}

vtkNew<vtkActor2D> Sheet::actor() {
  vtkNew<vtkPolyData> data;
  data->SetPoints(points_);
  data->SetPolys(cells_);
  data->GetCellData()->SetScalars(colours_);
  vtkNew<vtkPolyDataMapper2D> mapper;
  mapper->SetInputData(data);
  vtkNew<vtkActor2D> actor;
  actor->SetMapper(mapper);
  return actor;
}

vtkNew<vtkTextActor> text_at(double x, double y, int height_px, Align align, const std::string& text,
                             bool bold) {
  vtkNew<vtkTextActor> actor;
  actor->SetInput(text.c_str());
  actor->SetPosition(x, y);
  vtkTextProperty& property = *actor->GetTextProperty();
  property.SetFontFamilyToArial();
  property.SetFontSize(height_px);
  property.SetBold(bold);
  property.SetColor(ink[0], ink[1], ink[2]);
  property.SetVerticalJustificationToBottom();
  if (align == Align::centre) property.SetJustificationToCentered();
  if (align == Align::right) property.SetJustificationToRight();
  return actor;
}

void fit(vtkTextActor& actor, vtkRenderer& overlay, double width_px) {
  double size[2];
  for (int px = actor.GetTextProperty()->GetFontSize(); px > 6; --px) {
    actor.GetTextProperty()->SetFontSize(px);
    actor.GetSize(&overlay, size);
    if (size[0] <= width_px) return;
  }
}

void add_colour_bar(vtkRenderer& overlay, const Box& box, int text_px, const Field& field,
                    const ColourMap& map, const std::array<double, 2>& range) {
  const double bar_y0 = box.y0 + 1.35 * text_px, bar_y1 = bar_y0 + 0.8 * text_px;
  Sheet sheet;
  constexpr int steps = 256;
  for (int k = 0; k < steps; ++k)
    sheet.add({box.x0 + box.width() * k / steps, bar_y0, box.x0 + box.width() * (k + 1) / steps, bar_y1},
              colour_at(map, k / (steps - 1.0)));
  constexpr int ticks = 4;
  for (int k = 0; k <= ticks; ++k) {
    const double x = box.x0 + box.width() * k / ticks;
    sheet.add({x - 0.5, bar_y0 - 0.25 * text_px, x + 0.5, bar_y0}, ink);
    const double value = (range[0] + (range[1] - range[0]) * k / ticks) / field.unit_in_si;
    overlay.AddActor2D(
        text_at(x, box.y0 - 0.1 * text_px, text_px, Align::centre, fmt::format("{:.3g}", value)));
  }
  overlay.AddActor2D(sheet.actor());
  overlay.AddActor2D(text_at(
      0.5 * (box.x0 + box.x1), bar_y1 + 0.15 * text_px, text_px, Align::centre,
      field.unit == "1" ? std::string(field.title) : fmt::format("{} [{}]", field.title, field.unit)));
}

void add_scale_bar(vtkRenderer& overlay, const Box& box, int text_px, double metres_per_pixel) {
  const double length = round_length(0.9 * box.width() * metres_per_pixel),
               pixels = length / metres_per_pixel;
  const double y = box.y0 + 1.75 * text_px, tick = 0.25 * text_px;
  Sheet sheet;
  sheet.add(Box{box.x0, y - 1, box.x0 + pixels, y + 1}, ink);
  for (const double x : {box.x0, box.x0 + pixels}) sheet.add(Box{x - 1, y - tick, x + 1, y + tick}, ink);
  overlay.AddActor2D(sheet.actor());
  overlay.AddActor2D(text_at(box.x0 + 0.5 * pixels, box.y0 - 0.1 * text_px, text_px, Align::centre,
                             fmt::format("{:g} mm", length * 1e3)));
}

void add_key(vtkRenderer& overlay, const Box& box, int text_px, const std::vector<KeyEntry>& entries) {
  constexpr double line = 2.2, gap = 0.5, between = 2;  // in heights of the text
  std::vector<vtkSmartPointer<vtkTextActor>> names;
  double width = 0, size[2];
  for (const KeyEntry& entry : entries) {
    names.push_back(text_at(0, box.y0, text_px, Align::left, entry.name));
    overlay.AddActor2D(names.back());
    names.back()->GetSize(&overlay, size);
    width += size[0] + (line + gap + between) * text_px;
  }
  double x = 0.5 * (box.x0 + box.x1 - width + between * text_px);
  Sheet sheet;
  for (std::size_t k = 0; k < entries.size(); ++k) {
    const double y = box.y0 + 0.6 * text_px;
    const int dashes = entries[k].dashed ? 3 : 1;
    const double pitch = line * text_px / (dashes - (dashes > 1 ? 0.4 : 0.0));
    for (int dash = 0; dash < dashes; ++dash)
      sheet.add(Box{x + dash * pitch, y - 0.1 * text_px, x + dash * pitch + (dashes > 1 ? 0.6 : 1.0) * pitch,
                    y + 0.1 * text_px},
                entries[k].colour);
    names[k]->SetPosition(x + (line + gap) * text_px, box.y0);
    names[k]->GetSize(&overlay, size);
    x += size[0] + (line + gap + between) * text_px;
  }
  overlay.AddActor2D(sheet.actor());
}

vtkNew<vtkActor2D> dot(double diameter_px) {
  const double inner = 0.5 * diameter_px, outer = inner + 1.5;
  constexpr Colour dark{0.05, 0.05, 0.05}, rim{1, 1, 1};
  Sheet sheet;
  for (int k = 0; k < corners; ++k) {
    sheet.add({{0, 0}, on_circle(inner, k), on_circle(inner, k + 1)}, dark);
    sheet.add({on_circle(inner, k), on_circle(outer, k), on_circle(outer, k + 1), on_circle(inner, k + 1)},
              rim);
  }
  return sheet.actor();
}

}  // namespace rift::viz

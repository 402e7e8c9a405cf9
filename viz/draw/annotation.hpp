#pragma once

#include "viz/field.hpp"
#include "viz/layout.hpp"

#include <vtkCellArray.h>
#include <vtkNew.h>
#include <vtkPoints.h>
#include <vtkTextActor.h>
#include <vtkUnsignedCharArray.h>

#include <string>

class vtkActor2D;
class vtkLookupTable;
class vtkRenderer;

/// What stands on the frame in pixels: texts, the colour bar, a dot, a scale bar.
namespace rift::viz {

enum class Align : std::uint8_t { left, centre, right };

constexpr Colour ink{0.13, 0.15, 0.18};

/// Coloured polygons in pixels; what was added first lies on top.
class Sheet {
 public:
  Sheet();
  void add(const std::vector<std::array<double, 2>>& corners, const Colour& colour);
  void add(const Box& box, const Colour& colour);
  /// A straight line of a width.
  void add_line(const std::array<double, 2>& from, const std::array<double, 2>& to, double width,
                const Colour& colour);
  /// A line that ends in an arrow's head.
  void add_arrow(const std::array<double, 2>& from, const std::array<double, 2>& to, double width,
                 const Colour& colour);
  [[nodiscard]] vtkNew<vtkActor2D> actor();

 private:
  vtkNew<vtkPoints> points_;
  vtkNew<vtkCellArray> cells_;
  vtkNew<vtkUnsignedCharArray> colours_;
};

/// A line of text with its foot at (x, y) [px].
vtkNew<vtkTextActor> text_at(double x, double y, int height_px, Align align, const std::string& text,
                             bool bold = false);

/// Makes a text smaller until it is no wider than this. The overlay must be in its window.
void fit(vtkTextActor& actor, vtkRenderer& overlay, double width_px);

/// The colours of a field from one end of its range to the other, with its title, unit and numbers.
void add_colour_bar(vtkRenderer& overlay, const Box& box, int text_px, const Field& field,
                    const ColourMap& map, const std::array<double, 2>& range);

/// A length that is as long as it says.
void add_scale_bar(vtkRenderer& overlay, const Box& box, int text_px, double metres_per_pixel);

/// A name, and the colour of its line, which may be dashed.
struct KeyEntry {
  std::string name;
  Colour colour;
  bool dashed = false;
};

/// The key of a chart's lines, in one row in the middle of its box.
void add_key(vtkRenderer& overlay, const Box& box, int text_px, const std::vector<KeyEntry>& entries);

/// A dark dot with a light rim, as wide as a text is high. Move it by SetPosition (its middle, in pixels).
vtkNew<vtkActor2D> dot(double diameter_px);

}  // namespace rift::viz

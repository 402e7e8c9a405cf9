#pragma once

#include "viz/layout.hpp"

#include <vtkChartXY.h>
#include <vtkNew.h>
#include <vtkTable.h>

#include <array>
#include <span>

class vtkAxis;
class vtkRenderer;

/// What the charts under a picture share.
namespace rift::viz {

/// The axis from one number to another, in the texts of the frame.
void style(vtkAxis& axis, int text_px, const char* title, double least, double most);

/// Puts a chart into a renderer of its own, which has the whole box.
void put(vtkChartXY& chart, const Box& box, vtkRenderer& renderer);

/// A line of a chart that points are set for again and again.
class ChartLine {
 public:
  /// @param colour  of 255;  @param pen  of vtkPen
  ChartLine(vtkChartXY& chart, const std::array<unsigned char, 3>& colour, double width_px, int pen);

  /// None hides it.
  void show(std::span<const std::array<double, 2>> points);

 private:
  vtkNew<vtkTable> table_;
  vtkPlot* plot_;
};

/// A line across a chart at the moment that the picture shows.
class MomentLine {
 public:
  MomentLine(vtkChartXY& chart, int text_px);
  void show(double at, double most);

 private:
  ChartLine line_;
};

}  // namespace rift::viz

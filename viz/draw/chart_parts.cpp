#include "viz/draw/chart_parts.hpp"

#include "viz/draw/annotation.hpp"

#include <vtkAxis.h>
#include <vtkContextActor.h>
#include <vtkContextScene.h>
#include <vtkFloatArray.h>
#include <vtkPen.h>
#include <vtkPlot.h>
#include <vtkRenderer.h>
#include <vtkTextProperty.h>

namespace rift::viz {

void style(vtkAxis& axis, int text_px, const char* title, double least, double most) {
  axis.SetTitle(title);
  axis.SetRange(least, most);
  axis.SetBehavior(vtkAxis::FIXED);
  axis.SetGridVisible(false);
  for (vtkTextProperty* text : {axis.GetLabelProperties(), axis.GetTitleProperties()}) {
    text->SetFontSize(text_px);
    text->SetFontFamilyToArial();
    text->SetBold(false);
    text->SetColor(ink[0], ink[1], ink[2]);
  }
}

void put(vtkChartXY& chart, const Box& box, vtkRenderer& renderer) {
  chart.SetAutoSize(false);
  chart.SetSize(vtkRectf(0, 0, static_cast<float>(box.width()), static_cast<float>(box.height())));
  vtkNew<vtkContextActor> actor;
  actor->GetScene()->AddItem(&chart);
  renderer.AddActor(actor);
}

ChartLine::ChartLine(vtkChartXY& chart, const std::array<unsigned char, 3>& colour, double width_px,
                     int pen) {
  for (const char* name : {"x", "y"}) {
    vtkNew<vtkFloatArray> column;
    column->SetName(name);
    table_->AddColumn(column);
  }
  plot_ = chart.AddPlot(vtkChart::LINE);
  plot_->SetInputData(table_, 0, 1);
  plot_->SetColor(colour[0], colour[1], colour[2], 255);
  plot_->SetWidth(static_cast<float>(width_px));
  plot_->GetPen()->SetLineType(pen);
}

void ChartLine::show(std::span<const std::array<double, 2>> points) {
  // A line has two points: the first row stands twice.
  const std::size_t rows = points.empty() ? 0 : points.size() + 1;
  table_->SetNumberOfRows(static_cast<vtkIdType>(rows));
  for (std::size_t row = 0; row < rows; ++row)
    for (int column : {0, 1})
      table_->SetValue(static_cast<vtkIdType>(row), column, points[row == 0 ? 0 : row - 1][column]);
  plot_->SetVisible(rows > 0);
  table_->Modified();
}

MomentLine::MomentLine(vtkChartXY& chart, int text_px)
    : line_(chart, {33, 38, 46}, 0.12 * text_px, vtkPen::SOLID_LINE) {}

void MomentLine::show(double at, double most) {
  const std::array<std::array<double, 2>, 2> ends{{{at, 0}, {at, most}}};
  line_.show(ends);
}

}  // namespace rift::viz

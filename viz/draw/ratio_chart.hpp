#pragma once

#include "engine/results/schema.hpp"
#include "viz/draw/annotation.hpp"
#include "viz/draw/chart_parts.hpp"

#include <vtkChartXY.h>
#include <vtkNew.h>

#include <span>
#include <vector>

class vtkRenderer;

namespace rift::viz {

/// G_ID/G_I0 of all panes against the tip's position, with a line at the tip of the first pane.
class RatioChart {
 public:
  /// @param panes  whose lines it has;  @param length_m  of the axis of tip positions
  RatioChart(vtkRenderer& renderer, const Box& box, int text_px, std::size_t panes, double length_m);

  /// @param rates  of each pane; none where its run goes on
  void show(const std::vector<std::span<const results::RatePoint>>& rates, double tip_m);

 private:
  vtkNew<vtkChartXY> chart_;
  std::vector<ChartLine> line_;
  MomentLine moment_;
};

/// Names and colours of its lines; none for one pane, whose axis says enough.
[[nodiscard]] std::vector<KeyEntry> ratio_key(std::size_t panes);

}  // namespace rift::viz

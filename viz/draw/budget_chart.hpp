#pragma once

#include "engine/results/schema.hpp"
#include "viz/draw/annotation.hpp"

#include <vtkChartXY.h>
#include <vtkNew.h>
#include <vtkTable.h>

#include <span>
#include <vector>

class vtkRenderer;

namespace rift::viz {

/// The names and colours of the budget's lines. @param damping  whether anything is damped
[[nodiscard]] std::vector<KeyEntry> budget_key(bool damping);

/// The energy budget of a pane, growing with time: elastic, kinetic, fracture and, where there is any,
/// damping [J].
class BudgetChart {
 public:
  /// @param lasts_s  the whole axis of time;  @param most_j  of the axis of energy
  BudgetChart(vtkRenderer& renderer, const Box& box, int text_px, double lasts_s, double most_j,
              bool damping);

  /// @param start_s  when the crack started
  void show(std::span<const results::Sample> books, double start_s);

 private:
  std::size_t entries_;
  vtkNew<vtkTable> table_;
  vtkNew<vtkChartXY> chart_;
};

}  // namespace rift::viz

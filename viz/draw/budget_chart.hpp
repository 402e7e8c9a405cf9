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

/// The lines of a budget beside elastic, kinetic and fracture: those that there is something of.
struct BudgetLines {
  bool damping = false, contact = false;
};

/// Of all samples of a lane. Contact is a line of its own from a thousandth of the energy on: without
/// friction it is what faces that meet and part between two steps leave.
[[nodiscard]] BudgetLines budget_lines(std::span<const results::Sample> samples);

/// Names and colours.
[[nodiscard]] std::vector<KeyEntry> budget_key(const BudgetLines& lines);

/// The energy budget of a pane [J], growing with time.
class BudgetChart {
 public:
  /// @param lasts_s  the whole axis of time;  @param most_j  of the axis of energy
  BudgetChart(vtkRenderer& renderer, const Box& box, int text_px, double lasts_s, double most_j,
              const BudgetLines& lines);

  /// @param start_s  when the crack started
  void show(std::span<const results::Sample> samples, double start_s);

 private:
  std::vector<double results::Sample::*> energy_;  // of each line; kinetic: of translation and rotation
  vtkNew<vtkTable> table_;
  vtkNew<vtkChartXY> chart_;
};

}  // namespace rift::viz

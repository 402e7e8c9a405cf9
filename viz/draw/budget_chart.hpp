#pragma once

#include "engine/results/schema.hpp"
#include "viz/draw/annotation.hpp"
#include "viz/draw/chart_parts.hpp"

#include <vtkChartXY.h>
#include <vtkNew.h>
#include <vtkTable.h>

#include <optional>
#include <span>
#include <string>
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

/// The energy budget of a pane [J] against time.
class BudgetChart {
 public:
  /// @param since  what the axis of time begins with: "the crack's start"
  /// @param lasts_s  the whole axis of time;  @param with_moment  shows a line at the moment
  BudgetChart(vtkRenderer& renderer, const Box& box, int text_px, const std::string& since, double lasts_s,
              const BudgetLines& lines, bool with_moment);

  /// @param start_s  where the axis of time begins;  @param moment_s  since then;  @param most_j  of the axis
  /// of energy
  void show(std::span<const results::Sample> samples, double start_s, double moment_s, double most_j);

 private:
  std::vector<double results::Sample::*> energy_;  // of each line; kinetic: of translation and rotation
  vtkNew<vtkTable> table_;
  vtkNew<vtkChartXY> chart_;
  std::optional<MomentLine> moment_;
};

}  // namespace rift::viz

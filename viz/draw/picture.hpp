#pragma once

#include "viz/draw/budget_chart.hpp"
#include "viz/draw/pane_view.hpp"

#include <vtkGenericOpenGLRenderWindow.h>
#include <vtkLookupTable.h>
#include <vtkNew.h>

#include <cstdint>
#include <memory>
#include <span>
#include <vector>

namespace rift::viz {

/// A frame with all that stands in it, drawn again and again: one window, one mapper a pane; a moment only
/// swaps arrays. An OffscreenContext must be current.
class Picture {
 public:
  /// Throws std::runtime_error where VTK cannot use the context.
  explicit Picture(const Job& job);
  Picture(const Picture&) = delete;
  Picture& operator=(const Picture&) = delete;
  ~Picture();

  /// @param since_start_s  time since the crack's start [s]
  /// @param[out] rgb  width · height · 3 bytes, rows from the top
  void draw(double since_start_s, std::span<std::uint8_t> rgb);

 private:
  void add_panes();
  void add_charts();
  void read(std::span<std::uint8_t> rgb);

  Job job_;
  std::vector<std::unique_ptr<LaneReader>> reader_;
  Extent plate_;
  Layout layout_;
  vtkNew<vtkGenericOpenGLRenderWindow> window_;
  vtkNew<vtkRenderer> background_, overlay_;
  vtkNew<vtkUnsignedCharArray> pixels_;
  std::vector<std::unique_ptr<PaneView>> pane_;
  std::vector<std::unique_ptr<BudgetChart>> chart_;
};

}  // namespace rift::viz

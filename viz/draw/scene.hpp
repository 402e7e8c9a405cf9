#pragma once

#include "viz/draw/budget_chart.hpp"
#include "viz/draw/moment.hpp"
#include "viz/draw/pane_view.hpp"
#include "viz/draw/ratio_chart.hpp"

#include <vtkLookupTable.h>
#include <vtkNew.h>
#include <vtkRenderer.h>
#include <vtkSmartPointer.h>

#include <array>
#include <memory>
#include <vector>

class vtkRenderWindow;

namespace rift::viz {

using LaneReaders = std::vector<std::unique_ptr<LaneReader>>;

/// All that stands in the frame of a job. It goes out of the window with the object.
class Scene {
 public:
  /// @param job, readers  outlive it
  Scene(const Job& job, const LaneReaders& readers, vtkRenderWindow& window);
  ~Scene();
  Scene(const Scene&) = delete;
  Scene& operator=(const Scene&) = delete;

  /// The moments of all panes. @param range  of the colours
  void show(double since_start_s, const std::vector<Moment>& moments, const std::array<double, 2>& range);
  [[nodiscard]] const std::vector<std::unique_ptr<PaneView>>& panes() const { return pane_; }

 private:
  void add_panes();
  void add_title();
  void add_charts();
  void show_scales(const std::array<double, 2>& range);
  void show_charts(double since_start_s);
  vtkRenderer& chart_place(const Box& box);

  const Job& job_;
  const LaneReaders& reader_;
  vtkRenderWindow& window_;
  Extent plate_;
  Layout layout_;
  vtkNew<vtkRenderer> overlay_;
  vtkSmartPointer<vtkRenderer> scales_;
  std::array<double, 3> scaled_{};  // range, and the height of the window, that the scales show
  vtkSmartPointer<vtkLookupTable> colours_;
  std::vector<std::unique_ptr<PaneView>> pane_;
  std::vector<vtkSmartPointer<vtkRenderer>> chart_place_;
  std::vector<std::unique_ptr<BudgetChart>> chart_;
  std::unique_ptr<RatioChart> ratio_;
};

}  // namespace rift::viz

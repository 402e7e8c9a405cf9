#pragma once

#include "viz/draw/annotation.hpp"
#include "viz/draw/beam_lines.hpp"
#include "viz/draw/moment.hpp"
#include "viz/draw/spheres.hpp"
#include "viz/layout.hpp"
#include "viz/order.hpp"
#include "viz/pick.hpp"

#include <vtkActor2D.h>
#include <vtkNew.h>
#include <vtkRenderer.h>
#include <vtkSmartPointer.h>
#include <vtkTextActor.h>

#include <optional>
#include <vector>

class vtkLookupTable;
class vtkRenderWindow;

namespace rift::viz {

/// One lane in its place in the frame: elements, beams, the tip, its caption.
class PaneView {
 public:
  PaneView(const Job& job, const Layout& layout, std::size_t place_in_frame, const Extent& plate,
           LaneReader& reader, vtkLookupTable& colours, vtkRenderWindow& window, vtkRenderer& overlay);

  ~PaneView();
  PaneView(const PaneView&) = delete;
  PaneView& operator=(const PaneView&) = delete;

  void show(const Moment& moment);
  /// What was shown, and what stands at a pixel of it.
  [[nodiscard]] const PaneAnswer& answer() const { return answer_; }
  [[nodiscard]] Picked at(const std::array<double, 2>& pixel) const;

 private:
  void add_texts(const std::string& title, int text_px, vtkRenderer& overlay);
  [[nodiscard]] std::vector<std::array<double, 2>> carried_tips(const Moment& moment) const;
  void look_at(const Window& shown);
  [[nodiscard]] std::string caption(const Moment& moment) const;

  const Look& look_;
  PaneLayout place_;
  Extent plate_;
  LaneReader& reader_;
  vtkRenderWindow& window_;
  vtkNew<vtkRenderer> renderer_;
  std::vector<std::int32_t> shown_;  // elements
  PaneAnswer answer_;
  std::optional<Spheres> spheres_;
  std::optional<BeamLines> beams_;
  vtkSmartPointer<vtkTextActor> title_, moment_;
  std::vector<vtkSmartPointer<vtkActor2D>> dots_;
};

}  // namespace rift::viz

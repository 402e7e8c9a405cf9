#pragma once

#include "viz/draw/moment.hpp"
#include "viz/draw/scene.hpp"
#include "viz/order.hpp"

#include <vtkGenericOpenGLRenderWindow.h>
#include <vtkNew.h>
#include <vtkUnsignedCharArray.h>

#include <array>
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

  /// Another job of the same size in the same window. What both have in common stays: runs that were read,
  /// and all that stands in the frame where only the range or the numbers of the camera differ.
  void change(const Job& job);

  /// @param since_start_s  time since the crack's start [s]
  /// @param[out] rgb  width · height · 3 bytes, rows from the top
  void draw(double since_start_s, std::span<std::uint8_t> rgb);

  /// What the last frame shows.
  [[nodiscard]] Answer answer() const;
  /// What stands at a pixel of it, from the lower left corner.
  [[nodiscard]] Picked at(const std::array<double, 2>& pixel) const;

 private:
  void open(const std::vector<Pane>& panes);
  void build();
  void read(std::span<std::uint8_t> rgb);

  Job job_;
  std::vector<Pane> open_;
  std::vector<std::unique_ptr<LaneReader>> reader_;
  vtkNew<vtkGenericOpenGLRenderWindow> window_;
  vtkNew<vtkRenderer> background_;
  vtkNew<vtkUnsignedCharArray> pixels_;
  std::unique_ptr<Scene> scene_;
  std::array<double, 2> range_{};
};

}  // namespace rift::viz

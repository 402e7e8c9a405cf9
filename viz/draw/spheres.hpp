#pragma once

#include "viz/field.hpp"
#include "viz/job.hpp"
#include "viz/pores.hpp"

#include <vtkActor.h>
#include <vtkFloatArray.h>
#include <vtkNew.h>
#include <vtkPoints.h>
#include <vtkPolyData.h>

#include <span>
#include <vector>

class vtkLookupTable;

namespace rift::viz {

/// 256 colours of a map over a range.
[[nodiscard]] vtkNew<vtkLookupTable> lookup_table(const ColourMap& map, const std::array<double, 2>& range);

/// Balls as sphere impostors: a frame only swaps positions and values.
class Spheres {
 public:
  Spheres(std::vector<Ball> balls, vtkLookupTable& colours);

  /// @param displacement, value  of all elements;  @param magnification  of displacements
  void show(std::span<const std::array<float, 3>> displacement, std::span<const float> value,
            const std::array<float, 3>& magnification);
  [[nodiscard]] vtkActor& actor() { return *actor_; }

 private:
  std::vector<Ball> balls_;
  vtkNew<vtkPolyData> cloud_;
  vtkNew<vtkPoints> points_;
  vtkNew<vtkFloatArray> value_;
  vtkNew<vtkActor> actor_;
};

}  // namespace rift::viz

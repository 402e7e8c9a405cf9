#pragma once

#include "engine/results/schema.hpp"
#include "viz/job.hpp"

#include <vtkActor.h>
#include <vtkFloatArray.h>
#include <vtkNew.h>
#include <vtkPoints.h>
#include <vtkPolyData.h>

#include <span>
#include <vector>

class vtkLookupTable;

namespace rift::viz {

/// Beams as lines, coloured by their factor: softening ones stand out, broken ones are a faint trace.
class BeamLines {
 public:
  /// @param which  crossing or all;  @param pixels  width of a line
  BeamLines(const results::Geometry& geometry, Beams which, double pixels);

  /// @param factor  of each crossing beam; empty: all are whole
  void show(std::span<const std::array<float, 3>> displacement, std::span<const float> factor,
            const std::array<float, 3>& magnification);
  [[nodiscard]] vtkActor& actor() { return *actor_; }

 private:
  const results::Geometry& geometry_;
  std::vector<std::int32_t> beam_;      // that are drawn
  std::vector<std::int32_t> crossing_;  // of each, its place among the crossing beams, or -1
  vtkNew<vtkPolyData> lines_;
  vtkNew<vtkPoints> points_;
  vtkNew<vtkFloatArray> factor_;
  vtkNew<vtkActor> actor_;
};

}  // namespace rift::viz

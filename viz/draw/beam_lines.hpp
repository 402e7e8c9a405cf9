#pragma once

#include "engine/results/schema.hpp"
#include "viz/field.hpp"
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

/// Yellow to red: the colours of the stiffness that a beam has lost, where no field shows damage; and what
/// their bar says.
const ColourMap& softening();
const Field& beam_damage();

/// Beams as lines, coloured by their factor: softening ones stand out, broken ones are a faint trace.
class BeamLines {
 public:
  /// @param which  crossing or all
  /// @param lost  colours of the stiffness lost;  @param to_the_end  a broken beam has the last of them, not
  /// the pale one
  BeamLines(const results::Geometry& geometry, Beams which, const ColourMap& lost, bool to_the_end);

  /// Of the lines, in pixels.
  void set_width(double pixels);

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

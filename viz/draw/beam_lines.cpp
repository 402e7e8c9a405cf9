#include "viz/draw/beam_lines.hpp"

#include <vtkCellArray.h>
#include <vtkCellData.h>
#include <vtkLookupTable.h>
#include <vtkPolyDataMapper.h>
#include <vtkProperty.h>

#include <algorithm>

namespace rift::viz {
namespace {

/// Whole beams are slate, softening ones have the colour of what they have lost.
vtkNew<vtkLookupTable> factor_colours(const ColourMap& lost, bool to_the_end) {
  vtkNew<vtkLookupTable> table;
  constexpr int colours = 256;
  table->SetNumberOfTableValues(colours);
  for (int k = 1; k < colours - 1; ++k) {
    const Colour c = colour_at(lost, 1 - k / (colours - 1.0));
    table->SetTableValue(k, c[0], c[1], c[2], 1);
  }
  const Colour broken = to_the_end ? colour_at(lost, 1) : Colour{0.80, 0.82, 0.85};
  table->SetTableValue(0, broken[0], broken[1], broken[2], 1);
  table->SetTableValue(colours - 1, 0.24, 0.30, 0.38, 1);
  table->SetTableRange(0, 1);
  return table;
}

}  // namespace

const ColourMap& softening() {
  static const ColourMap map{"softening", Scale::sequential, "", {0xffc70d, 0xcc000d}};
  return map;
}

const Field& beam_damage() {
  static const Field field{"beams", "beams: stiffness lost", "1", 1, Scale::sequential, "damage"};
  return field;
}

BeamLines::BeamLines(const results::Geometry& geometry, Beams which, const ColourMap& lost, bool to_the_end)
    : geometry_(geometry) {
  std::vector<std::int32_t> place(geometry.beam.size(), -1);
  for (std::size_t k = 0; k < geometry.crossing.size(); ++k)
    place[geometry.crossing[k]] = static_cast<std::int32_t>(k);
  vtkNew<vtkCellArray> cells;
  for (std::int32_t b = 0; b < static_cast<std::int32_t>(geometry.beam.size()); ++b) {
    if (which == Beams::crossing && place[b] < 0) continue;
    const auto [i, j] = geometry.beam[b];
    cells->InsertNextCell({i, j});
    beam_.push_back(b);
    crossing_.push_back(place[b]);
  }
  points_->SetDataTypeToFloat();
  points_->SetNumberOfPoints(static_cast<vtkIdType>(geometry.position.size()));
  factor_->SetNumberOfValues(static_cast<vtkIdType>(beam_.size()));
  lines_->SetPoints(points_);
  lines_->SetLines(cells);
  lines_->GetCellData()->SetScalars(factor_);

  vtkNew<vtkPolyDataMapper> mapper;
  mapper->SetInputData(lines_);
  mapper->SetLookupTable(factor_colours(lost, to_the_end));
  mapper->UseLookupTableScalarRangeOn();
  actor_->SetMapper(mapper);
  actor_->GetProperty()->SetRenderLinesAsTubes(true);
}

void BeamLines::set_width(double pixels) { actor_->GetProperty()->SetLineWidth(static_cast<float>(pixels)); }

void BeamLines::show(std::span<const std::array<float, 3>> displacement, std::span<const float> factor,
                     const std::array<float, 3>& magnification) {
  auto* xyz = static_cast<float*>(points_->GetVoidPointer(0));
  for (std::size_t i = 0; i < geometry_.position.size(); ++i)
    for (int axis = 0; axis < 3; ++axis)
      xyz[3 * i + axis] = geometry_.position[i][axis] +
                          (displacement.empty() ? 0 : magnification[axis] * displacement[i][axis]);
  for (std::size_t k = 0; k < beam_.size(); ++k)
    factor_->SetValue(static_cast<vtkIdType>(k),
                      crossing_[k] < 0 || factor.empty() ? 1 : factor[crossing_[k]]);
  points_->Modified();
  factor_->Modified();
  lines_->Modified();
}

}  // namespace rift::viz

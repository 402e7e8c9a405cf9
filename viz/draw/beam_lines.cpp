#include "viz/draw/beam_lines.hpp"

#include <vtkCellArray.h>
#include <vtkCellData.h>
#include <vtkLookupTable.h>
#include <vtkPolyDataMapper.h>
#include <vtkProperty.h>

#include <algorithm>

namespace rift::viz {
namespace {

/// Whole beams are slate, softening ones run from yellow to red as they lose their stiffness, broken ones are
/// pale.
vtkNew<vtkLookupTable> factor_colours() {
  vtkNew<vtkLookupTable> table;
  constexpr int colours = 256;
  table->SetNumberOfTableValues(colours);
  for (int k = 1; k < colours - 1; ++k) {
    const double lost = 1 - k / (colours - 1.0);
    table->SetTableValue(k, 1.0 - 0.2 * lost, 0.78 * (1 - lost), 0.05, 1);
  }
  table->SetTableValue(0, 0.80, 0.82, 0.85, 1);
  table->SetTableValue(colours - 1, 0.24, 0.30, 0.38, 1);
  table->SetTableRange(0, 1);
  return table;
}

}  // namespace

BeamLines::BeamLines(const results::Geometry& geometry, Beams which, double pixels) : geometry_(geometry) {
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
  mapper->SetLookupTable(factor_colours());
  mapper->UseLookupTableScalarRangeOn();
  actor_->SetMapper(mapper);
  actor_->GetProperty()->SetLineWidth(static_cast<float>(pixels));
  actor_->GetProperty()->SetRenderLinesAsTubes(true);
}

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

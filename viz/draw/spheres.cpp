#include "viz/draw/spheres.hpp"

#include <vtkCellArray.h>
#include <vtkLookupTable.h>
#include <vtkOpenGLSphereMapper.h>
#include <vtkPointData.h>
#include <vtkProperty.h>

namespace rift::viz {

vtkNew<vtkLookupTable> lookup_table(const ColourMap& map, const std::array<double, 2>& range) {
  vtkNew<vtkLookupTable> table;
  constexpr int colours = 256;
  table->SetNumberOfTableValues(colours);
  for (int k = 0; k < colours; ++k) {
    const Colour c = colour_at(map, k / (colours - 1.0));
    table->SetTableValue(k, c[0], c[1], c[2], 1);
  }
  table->SetTableRange(range[0], range[1]);
  return table;
}

Spheres::Spheres(std::vector<Ball> balls, vtkLookupTable& colours) : balls_(std::move(balls)) {
  const auto n = static_cast<vtkIdType>(balls_.size());
  points_->SetDataTypeToFloat();
  points_->SetNumberOfPoints(n);
  value_->SetNumberOfValues(n);
  vtkNew<vtkFloatArray> radius;
  radius->SetName("radius");
  radius->SetNumberOfValues(n);
  for (vtkIdType k = 0; k < n; ++k) radius->SetValue(k, balls_[static_cast<std::size_t>(k)].radius);
  cloud_->SetPoints(points_);
  vtkNew<vtkCellArray> cells;  // not drawn, but VTK tells by them where a cloud is
  cells->InsertNextCell(static_cast<int>(n));
  for (vtkIdType k = 0; k < n; ++k) cells->InsertCellPoint(k);
  cloud_->SetVerts(cells);
  cloud_->GetPointData()->AddArray(radius);
  cloud_->GetPointData()->SetScalars(value_);

  vtkNew<vtkOpenGLSphereMapper> mapper;
  mapper->SetInputData(cloud_);
  mapper->SetScaleArray("radius");
  mapper->SetLookupTable(&colours);
  mapper->UseLookupTableScalarRangeOn();
  mapper->StaticOff();
  actor_->SetMapper(mapper);
  // A lamp at the camera: the middle of a sphere has its colour unshaded, its rim darkens.
  actor_->GetProperty()->SetAmbient(0.35);
  actor_->GetProperty()->SetDiffuse(0.65);
  actor_->GetProperty()->SetSpecular(0);
}

void Spheres::show(std::span<const std::array<float, 3>> displacement, std::span<const float> value,
                   const std::array<float, 3>& magnification) {
  auto* xyz = static_cast<float*>(points_->GetVoidPointer(0));
  for (std::size_t k = 0; k < balls_.size(); ++k) {
    const std::int32_t i = balls_[k].element;
    for (int axis = 0; axis < 3; ++axis)
      xyz[3 * k + axis] =
          balls_[k].place[axis] + (displacement.empty() ? 0 : magnification[axis] * displacement[i][axis]);
    value_->SetValue(static_cast<vtkIdType>(k), value.empty() ? 0 : value[i]);
  }
  points_->Modified();
  value_->Modified();
  cloud_->Modified();
}

}  // namespace rift::viz

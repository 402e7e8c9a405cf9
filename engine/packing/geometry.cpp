#include "engine/packing/geometry.hpp"

#include <cmath>

namespace rift::packing {
namespace {

/// The axes across which the wall is round, 1 or 0 each.
Eigen::Array3d round_axes(Shape shape) {
  if (shape == Shape::cylinder) return {1, 0, 1};
  if (shape == Shape::sphere) return {1, 1, 1};
  return {0, 0, 0};
}

bool has_flat_walls(Shape shape, int axis) {
  return shape != Shape::periodic && round_axes(shape)[axis] == 0.0;
}

/// From the middle of a round wall, across it.
Eigen::Vector3d outward(const Box& box, const Eigen::Vector3d& point) {
  return round_axes(box.shape) * (point - 0.5 * box.size()).array();
}

}  // namespace

Eigen::Vector3d minimum_image(const Box& box, const Eigen::Vector3d& a, const Eigen::Vector3d& b) {
  Eigen::Vector3d span = b - a;
  if (box.shape == Shape::periodic)
    span.array() -= box.size().array() * (span.array() / box.size().array()).round();
  return span;
}

bool contains(const Box& box, const Eigen::Vector3d& point) {
  return (point.array() >= 0.0).all() && (point.array() <= box.size().array()).all() &&
         outward(box, point).norm() <= 0.5 * box.length;
}

double depth_below(const Box& box, Boundary boundary, const Eigen::Vector3d& point) {
  const int axis = static_cast<int>(boundary) / 2;
  const bool at_zero = static_cast<int>(boundary) % 2 == 0;
  return at_zero ? point[axis] : box.size()[axis] - point[axis];
}

std::vector<int> elements_at(const Box& box, Boundary boundary, const std::vector<Eigen::Vector3d>& centre,
                             const std::vector<double>& radius, double depth) {
  std::vector<int> elements;
  for (std::size_t i = 0; i < centre.size(); ++i)
    if (depth_below(box, boundary, centre[i]) <= depth * radius[i]) elements.push_back(static_cast<int>(i));
  return elements;
}

Eigen::Vector3d push_of_others(const Box& box, const Eigen::Vector3d& centre, double radius) {
  Eigen::Vector3d push = Eigen::Vector3d::Zero();
  for (int c = 0; c < 3; ++c)
    if (has_flat_walls(box.shape, c)) push[c] = push_between(centre[c], box.size()[c], radius);
  const Eigen::Vector3d out = outward(box, centre);
  const double distance = out.norm(), overlap = distance + radius - 0.5 * box.length;
  if (distance > 0.0 && overlap > 0.0) push -= 2.0 * overlap / distance * out;
  return push;
}

Eigen::Matrix3d wall_stiffness(const Box& box, const Eigen::Vector3d& centre, double radius) {
  Eigen::Matrix3d k = Eigen::Matrix3d::Zero();
  for (int c = 0; c < 3; ++c)
    if (has_flat_walls(box.shape, c))
      k(c, c) = (centre[c] < radius ? 2.0 : 0.0) + (box.size()[c] - centre[c] < radius ? 2.0 : 0.0);
  const Eigen::Vector3d out = outward(box, centre);
  const double distance = out.norm(), overlap = distance + radius - 0.5 * box.length;
  if (distance > 0.0 && overlap > 0.0) {
    const Eigen::Vector3d n = out / distance;
    const Eigen::Matrix3d across = round_axes(box.shape).matrix().asDiagonal();
    k += 2.0 * (n * n.transpose() + overlap / distance * (across - n * n.transpose()));
  }
  return k;
}

}  // namespace rift::packing

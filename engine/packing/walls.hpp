#pragma once

#include <Eigen/Core>

#include <algorithm>
#include <cstdint>
#include <numbers>

namespace rift::packing {

/// Shapes of a specimen. Plates (one or a few elements thick) and blocks lie between six flat walls, a
/// cylinder between a round wall about the y axis and two flat ones, a sphere within its own; a periodic box
/// has no walls and repeats itself in all three directions.
enum class Shape : std::uint8_t { plate, block, cylinder, sphere, periodic };

/// The space of a specimen: a box [0, length] x [0, height] x [0, thickness], or what its walls leave of it
/// [m]. A cylinder stands upright, of diameter length = thickness; a sphere has all three equal.
struct Box {
  double length = 0, height = 0, thickness = 0;
  Shape shape = Shape::block;

  bool is_cuboid() const { return shape == Shape::plate || shape == Shape::block; }
  double volume() const {
    const double share = shape == Shape::cylinder ? std::numbers::pi / 4.0
                         : shape == Shape::sphere ? std::numbers::pi / 6.0
                                                  : 1.0;
    return share * length * height * thickness;
  }
  /// Area that a pull along this axis acts on; of a cylinder along its own, y.
  double section(int axis) const {
    const double share = shape == Shape::cylinder && axis == 1 ? std::numbers::pi / 4.0 : 1.0;
    return share * size().prod() / size()[axis];
  }
  Eigen::Vector3d size() const { return {length, height, thickness}; }
};

/// The vector from a to b [as them]; in a periodic box to the nearest image of b.
Eigen::Vector3d minimum_image(const Box& box, const Eigen::Vector3d& a, const Eigen::Vector3d& b);

/// Whether a point lies within the walls.
bool holds(const Box& box, const Eigen::Vector3d& point);

/// How the walls push a sphere that reaches beyond them, f = -dU/dx of U = sum overlap^2: as its mirror image
/// behind a wall would, at unit contact stiffness.
inline Eigen::Vector3d wall_push(const Box& box, const Eigen::Vector3d& centre, double radius);

/// -df/dx of that push, positive semidefinite.
Eigen::Matrix3d wall_stiffness(const Box& box, const Eigen::Vector3d& centre, double radius);

/// Between two flat walls, at 0 and at `edge`.
inline double push_between(double p, double edge, double radius) {
  return 2.0 * (std::max(0.0, radius - p) - std::max(0.0, radius - (edge - p)));
}

/// wall_push() where some wall is round, or none is there.
Eigen::Vector3d push_of_others(const Box& box, const Eigen::Vector3d& centre, double radius);

inline Eigen::Vector3d wall_push(const Box& box, const Eigen::Vector3d& centre, double radius) {
  if (!box.is_cuboid()) return push_of_others(box, centre, radius);
  return {push_between(centre.x(), box.length, radius), push_between(centre.y(), box.height, radius),
          push_between(centre.z(), box.thickness, radius)};
}

}  // namespace rift::packing

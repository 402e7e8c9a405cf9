#pragma once

#include <Eigen/Core>

#include <algorithm>
#include <array>
#include <cstdint>
#include <numbers>
#include <vector>

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
bool contains(const Box& box, const Eigen::Vector3d& point);

/// Parts of a specimen's surface, by the faces of its box; what a grip holds or a pull acts on is named so.
/// Those of an axis stand beside each other, the one at 0 first.
enum class Boundary : std::uint8_t { left, right, bottom, top, back, front };

/// The two boundaries that an axis leads through.
constexpr std::array<Boundary, 2> ends_of_axis(int axis) {
  return {static_cast<Boundary>(2 * axis), static_cast<Boundary>(2 * axis + 1)};
}

/// How deep a point lies below a boundary.
double depth_below(const Box& box, Boundary boundary, const Eigen::Vector3d& point);

/// Elements whose centre lies within `depth` of their radius below a boundary, ascending.
std::vector<int> elements_at(const Box& box, Boundary boundary, const std::vector<Eigen::Vector3d>& centre,
                             const std::vector<double>& radius, double depth);

/// How the walls push a sphere that reaches beyond them, f = -dU/dx of U = sum overlap^2: as its mirror image
/// behind a wall would, at unit contact stiffness.
inline Eigen::Vector3d wall_push(const Box& box, const Eigen::Vector3d& centre, double radius);

/// -df/dx of that push, positive semidefinite.
Eigen::Matrix3d wall_stiffness(const Box& box, const Eigen::Vector3d& centre, double radius);

/// Between two flat walls, at 0 and at `edge`.
inline double push_between(double p, double edge, double radius) {
  const double beyond_low = radius - p, beyond_high = radius - (edge - p);
  return 2.0 * ((beyond_low > 0.0 ? beyond_low : 0.0) - (beyond_high > 0.0 ? beyond_high : 0.0));
}

/// wall_push() where some wall is round, or none is there.
Eigen::Vector3d push_of_others(const Box& box, const Eigen::Vector3d& centre, double radius);

inline Eigen::Vector3d wall_push(const Box& box, const Eigen::Vector3d& centre, double radius) {
  if (!box.is_cuboid()) return push_of_others(box, centre, radius);
  return {push_between(centre.x(), box.length, radius), push_between(centre.y(), box.height, radius),
          push_between(centre.z(), box.thickness, radius)};
}

}  // namespace rift::packing

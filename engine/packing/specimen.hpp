#pragma once

#include "engine/packing/packing.hpp"

#include <array>
#include <cstdint>
#include <vector>

namespace rift::packing {

/// Which grip holds an element: each takes a boundary's elements within `grip_depth` of their radius; what
/// lies at both is the bottom's   [model.md §4].
enum class Grip : std::uint8_t { none, bottom, top };

constexpr Boundary boundary_of(Grip grip) { return grip == Grip::bottom ? Boundary::bottom : Boundary::top; }

inline constexpr double grip_depth = 1.3;

/// A specimen ready to become a lattice: elements in touch, the ones that carry no load taken out.
struct Specimen {
  Box box;
  std::vector<Eigen::Vector3d> centre;   // N [m]
  std::vector<double> radius;            // N [m]
  std::vector<Grip> grip;                // N
  std::vector<std::array<int, 2>> beam;  // B pairs i < j of elements in contact
  int rattlers = 0;                      // elements left out: no path of beams to a grip
  PackingStatistics packing;             // of all elements
};

/// Joins the elements in contact (distance <= tolerance x (r_i + r_j)), finds the grips and leaves out the
/// rattlers. Throws PackingError where a grip holds no element, or nothing joins the grips.
Specimen make_plate(const Packing& packing, const Box& box, double contact_tolerance);

/// The same of a specimen that nothing holds: what hangs together by the largest number of elements. Throws
/// PackingError where that does not reach from the bottom to the top (a periodic box has neither).
Specimen make_free_specimen(const Packing& packing, const Box& box, double contact_tolerance);

/// For each of n elements, whether a path of beams leads from it to an element with anchor[i] != 0.
std::vector<char> reached_from(const std::vector<char>& anchor, const std::vector<std::array<int, 2>>& beam);

}  // namespace rift::packing

#pragma once

#include "engine/packing/sphere_packing.hpp"

#include <array>

/// The arithmetic of many spheres or pairs of them, side by side: compiled for several instruction sets, of
/// which the processor's best is called. Nothing is contracted, so that all of them give the same bits.
namespace rift::packing {

/// Some pairs of spheres. What a loop reads or writes of each lies side by side.
struct PairGroup {
  static constexpr int room = 256;
  template <class Number>
  using Of = std::array<Number, room>;
  Of<double> x, y, z;       // from one centre to the other
  Of<double> reach;         // how near they must be
  Of<double> squared, gap;  // squared distance, and by how much it is above the squared reach
};

/// Finds `squared` and `gap` of the first `count` pairs.
void find_gaps(PairGroup& pairs, int count);

/// Contacts, with the pairs that they are of.
struct ContactGroup {
  PairGroup::Of<int> pair;
  PairGroup::Of<double> x, y, z;         // from one centre to the other; then the force on the other
  PairGroup::Of<double> reach, squared;  // r_i + r_j; squared distance
  PairGroup::Of<double> overlap;
};

/// Finds `overlap` and the forces, at unit contact stiffness, of the first `count` contacts.
void find_forces(ContactGroup& contacts, int count);

/// How flat walls push spheres: force[k] = wall_push() of sphere[k], k in [0, count), in a cuboid.
void find_flat_pushes(const Box& box, double scale, const SpherePacking::Sphere* sphere, int count,
                      SpherePacking::Vector* force);

}  // namespace rift::packing

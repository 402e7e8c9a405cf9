#pragma once

#include "engine/ensemble/part.hpp"
#include "engine/fracture/crack_path.hpp"
#include "engine/lattice/beam.hpp"
#include "engine/lattice/forces.hpp"

#include <cstddef>
#include <new>
#include <vector>

namespace rift::ensemble {

/// Memory that begins on a cache line, so that no register straddles two.
template <class T>
struct OnCacheLine {
  using value_type = T;
  OnCacheLine() = default;
  template <class U>
  OnCacheLine(const OnCacheLine<U>&) {}
  T* allocate(std::size_t n) { return static_cast<T*>(::operator new(n * sizeof(T), std::align_val_t(64))); }
  void deallocate(T* p, std::size_t) { ::operator delete(p, std::align_val_t(64)); }
  bool operator==(const OnCacheLine&) const { return true; }
};

template <class T>
using AlignedVector = std::vector<T, OnCacheLine<T>>;

/// What the rows of all parts are made from.
struct RowSource {
  const lattice::Lattice& lattice;
  lattice::Kinematics kinematics;
  const std::vector<lattice::Vector6>& base;  // N, the base state
  const std::vector<fracture::Crossing>& met;
  const std::vector<char>& notched;  // [crossing] absent from the base state on
  const std::vector<lattice::DampedBeam>& damped;
  const std::vector<Eigen::Vector2d>& normal;  // [crossing] of the faces, from i to j; empty without contact
};

/// First elements of `parts` ranges with about equally many beams, and N; all but the last multiples of
/// chunk_size, so that sums by chunks do not depend on them. Fewer parts where there are fewer chunks.
std::vector<int> cut_evenly(const lattice::Lattice& lattice, int parts);

/// The rows that one thread works on, and copies of elements of other parts that they refer to.
template <class Real>
struct PartRows {
  std::vector<int> ghost;  // elements, in the order of their rows
  int first_ghost_row = 0;
  std::vector<std::int32_t> halo_i, first, special;
  std::vector<SoundRow<LinearBeam<Real>>> linear;
  std::vector<SoundRow<CorotationalBeam<Real>>> corotational;
  AlignedVector<BeamGroup<Real, 7>> linear_group;
  AlignedVector<BeamGroup<Real, 10>> corotational_group;
  std::vector<CrossingRow<Real, LinearBeam<Real>>> linear_crossing;
  std::vector<CrossingRow<Real, CorotationalBeam<Real>>> corotational_crossing;
  std::vector<ContactRow<Real, LinearBeam<Real>>> linear_contact;
  std::vector<ContactRow<Real, CorotationalBeam<Real>>> corotational_contact;
  std::vector<DampedRow<Real>> damped;
  AlignedVector<Real> ring, extra, damping, damping_before, contact, contact_before;
  AlignedVector<double> account;
  PartView<Real> view{};  // of the vectors above; state and lanes' arrays are the ensemble's
};

/// @param[in] begin, end       the part's elements
/// @param[in] first_ghost_row  where its copies of others begin
/// @param[in] lanes            of the kernel
template <class Real>
PartRows<Real> rows_of_part(const RowSource& source, int begin, int end, int first_ghost_row, int lanes);

}  // namespace rift::ensemble

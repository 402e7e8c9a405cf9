#pragma once

#include "engine/lattice/static_system.hpp"

namespace rift::lattice {

/// A lattice that nothing holds, under loads that balance each other: a body, or a box that repeats itself.
/// What the loads leave open (the rigid motions of a body, the drift of a periodic box) is settled by a
/// spring that ties one element to where it was; under balanced loads the spring carries nothing. All
/// elements must hang together.
class FreeBody {
 public:
  /// Cost of one assembly; the lattice is not needed afterwards.
  explicit FreeBody(const Lattice& lattice);

  /// Motions at rest under forces and moments on the elements [N, N m]. Cost about 100 products with K;
  /// throws StaticsError, Interrupted. @param[in] tolerance  of the relative residual
  std::vector<Vector6> at_rest(const std::vector<Vector6>& load, double tolerance = 1e-10,
                               const base::FractionTold& told = {});

 private:
  StaticSystem system_;
  StaticSolver solver_;
};

}  // namespace rift::lattice

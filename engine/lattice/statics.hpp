#pragma once

#include "engine/base/interrupted.hpp"
#include "engine/lattice/lattice.hpp"

#include <memory>
#include <stdexcept>
#include <vector>

namespace rift::lattice {

/// A linear system of statics could not be solved to its tolerance.
struct StaticsError : std::runtime_error {
  using std::runtime_error::runtime_error;
};

/// A lattice that nothing holds, under loads that balance each other: a body, or a box that repeats itself.
/// What the loads leave open (the rigid motions of a body, the drift of a periodic box) is settled by a
/// spring that ties one element to where it was; under balanced loads the spring carries nothing. All
/// elements must hang together.
class FreeBody {
 public:
  /// The lattice is not needed afterwards. @param[in] threads  0 for one per core; the bits do not depend on
  /// it
  explicit FreeBody(const Lattice& lattice, int threads = 0);
  ~FreeBody();

  /// Motions at rest under forces and moments on the elements [N, N m]. Cost about 100 products with K;
  /// throws StaticsError, Interrupted. @param[in] tolerance  of the relative residual
  std::vector<Vector6> at_rest(const std::vector<Vector6>& load, double tolerance = 1e-10,
                               const base::ProgressCallback& told = {});

 private:
  struct Tied;
  std::unique_ptr<Tied> tied_;
};

/// How the top face is moved along y: by `middle` [m] in its middle, and by `tilt` of that more at its right
/// end and less at its left one, straight between; and by `shear` of it along x.
struct Pull {
  double middle = 0, tilt = 0, shear = 0;
  Pull(double displacement, double tilt_of_it = 0, double shear_of_it = 0)
      : middle(displacement), tilt(tilt_of_it), shear(shear_of_it) {}  // NOLINT: a plain pull is a number
  double at(double over_length) const { return middle * (1.0 + tilt * (2.0 * over_length - 1.0)); }
};

/// Displacements of all elements at rest, K q = 0 on the free ones   [model.md §4].
/// Bottom elements are clamped, top elements move without turning, unless the grips let both turn; elements
/// that no path of present beams joins to a grip stay where they are.
/// @param[in] present       B, 0 for a beam that a notch has cut
/// @return N displacements (u [m], theta [rad]); relative residual of the free forces 1e-13
/// Cost about 110 products with K (conjugate gradients, see RigidPatches) and 1.5 kB an element; throws
/// StaticsError, Interrupted. @param[in] threads  0 for one per core; the bits do not depend on it
std::vector<Vector6> stretched_at_rest(const Lattice& lattice, const std::vector<char>& present,
                                       const Pull& pull, const base::ProgressCallback& told = {},
                                       int threads = 0);

/// The same with corotational beams: Newton's method from the linear solution until the free forces are 1e-11
/// of the linear loads, or what rounding leaves of strains below 1e-4. Cost about five linear solutions;
/// throws StaticsError, Interrupted.
/// @return N displacements and rotation vectors
std::vector<Vector6> stretched_at_rest_corotational(const Lattice& lattice, const std::vector<char>& present,
                                                    const Pull& pull, const base::ProgressCallback& told = {},
                                                    int threads = 0);

}  // namespace rift::lattice

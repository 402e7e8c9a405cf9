#pragma once

#include "engine/base/interrupted.hpp"
#include "engine/lattice/lattice.hpp"

namespace rift::lattice {
class FreeBody;
}

namespace rift::calibration {

/// Forces on the centres of the elements at the two ends of a specimen along an axis, those whose centre lies
/// within grip_depth of their radius from its face: each end gets `force` in all, outwards, spread as evenly
/// as it can be with its resultant on the axis through the middle of the box, so that nothing turns.
/// @param[in] axis  0, 1, 2 for x, y, z;  @param[in] force  [N], negative presses
/// @return N forces and moments. Throws PackingError where an end holds fewer than three elements.
std::vector<lattice::Vector6> end_loads(const lattice::Lattice& lattice, int axis, double force);

/// What a pull along an axis shows.
struct Pulled {
  double young_modulus = 0;  // E [Pa]: force over the nominal section, over the ends' relative shortening
  double gauge_modulus = 0;  // the same from the strain of the middle half
  Eigen::Vector3d poisson_ratio{
      0, 0, 0};  // by direction, from the linear fit over the middle half; 0 along the axis
  std::vector<lattice::Vector6> motion;  // N [m, rad]
};

/// Gradient of the displacements, du_a/dx_b, by least squares over the elements whose coordinate along `axis`
/// lies in the middle half of the box.
Eigen::Matrix3d gradient_in_middle(const lattice::Lattice& lattice,
                                   const std::vector<lattice::Vector6>& motion, int axis);

/// Pulls (or presses) a free specimen statically: E and nu of the paper's appendix.
Pulled pull(const lattice::Lattice& lattice, lattice::FreeBody& body, int axis, double force,
            const base::ProgressCallback& told = {});

}  // namespace rift::calibration

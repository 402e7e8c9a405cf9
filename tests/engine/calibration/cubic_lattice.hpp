#pragma once

#include "engine/lattice/lattice.hpp"

namespace rift::calibration::cubic_lattice {

constexpr double edge = 2e-3, young = 1e9, section_radius = 0.3e-3;  // r_mu 0.3 of radii of half an edge

/// n[0] x n[1] x n[2] touching spheres in a cubic lattice; what repeats has beams through its faces.
inline lattice::Lattice lattice_of(std::array<int, 3> n, packing::Shape shape) {
  const packing::Box box{n[0] * edge, n[1] * edge, n[2] * edge, shape};
  packing::Packing packing;
  for (int x = 0; x < n[0]; ++x)
    for (int y = 0; y < n[1]; ++y)
      for (int z = 0; z < n[2]; ++z)
        packing.centre.emplace_back(edge * Eigen::Vector3d(x + 0.5, y + 0.5, z + 0.5)),
            packing.radius.push_back(0.5 * edge * (1.0 + 1e-9));
  return lattice::make_lattice(packing::make_free_specimen(packing, box, 1.0),
                               {.young_modulus = young, .poisson_ratio = 0.2, .radius_ratio = 0.3}, 1000.0);
}

}  // namespace rift::calibration::cubic_lattice

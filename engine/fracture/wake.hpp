#pragma once

#include "engine/lattice/lattice.hpp"

#include <vector>

namespace rift::fracture {

/// How the energy that a crack has left behind moves: by the size of what moves together, and out of plane.
struct Wake {
  std::vector<double> cell_m;  // sides of square cells, 4 mean radii and doubling, the last above the height
  std::vector<double> kinetic_j;  // one more: of motion within the smallest cells, of those within the next
                                  // ones of which they are a fourth, ..., and last of the largest as wholes
  double rotation_j = 0;          // kinetic energy of rotation
  double out_of_plane_m = 0;      // largest mean motion along z of an 8 mean radii wide cell
};

/// Translation of the elements of a stretch of the plate, taken apart by size: the energy which cells moving
/// as wholes have, E(l) = 1/2 sum |P_cell|^2 / M_cell, falls with their side l; the bands are its steps from
/// cell to cell (a Haar decomposition), none negative, and add up to all of it. Elements that move at random
/// are in the first band but for one part in the elements of a cell.
/// @param[in] stretch   from and to along x [m]; the cells are counted from the second
/// @param[in] velocity  [m/s], [rad/s] of each element
/// @param[in] moved     along z since the start of the run [m], of each element
Wake wake_of(const lattice::Lattice& lattice, const std::array<double, 2>& stretch,
             const std::vector<lattice::Vector6>& velocity, const std::vector<double>& moved);

}  // namespace rift::fracture

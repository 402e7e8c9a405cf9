#include "engine/fracture/wake.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <utility>

namespace rift::fracture {
namespace {

struct Lump {
  double mass = 0, moved = 0;
  Eigen::Vector3d momentum = Eigen::Vector3d::Zero();
};
using Cells = std::map<std::pair<long, long>, Lump>;

double energy_of(const Cells& cells) {
  double energy = 0.0;
  for (const auto& [place, lump] : cells) energy += 0.5 * lump.momentum.squaredNorm() / lump.mass;
  return energy;
}

Cells merged(const Cells& cells) {
  Cells larger;
  for (const auto& [place, lump] : cells) {
    Lump& into = larger[{place.first / 2, place.second / 2}];
    into.mass += lump.mass;
    into.momentum += lump.momentum;
  }
  return larger;
}

/// Largest mean motion along z, of cells that are at least half full.
double largest_motion(const Cells& cells) {
  double fullest = 0.0, largest = 0.0;
  for (const auto& [place, lump] : cells) fullest = std::max(fullest, lump.mass);
  for (const auto& [place, lump] : cells)
    if (lump.mass > 0.5 * fullest) largest = std::max(largest, std::abs(lump.moved / lump.mass));
  return largest;
}

}  // namespace

Wake wake_of(const lattice::Lattice& lattice, const std::array<double, 2>& stretch,
             const std::vector<lattice::Vector6>& velocity, const std::vector<double>& moved) {
  Wake wake;
  Cells cells, wide;
  double side = 4.0 * lattice.mean_radius, energy = 0.0;
  for (std::size_t i = 0; i < lattice.centre.size(); ++i) {
    const Eigen::Vector3d& centre = lattice.centre[i];
    if (centre.x() < stretch[0] || centre.x() > stretch[1]) continue;
    const auto place = [&](double width) {
      return std::pair(static_cast<long>((stretch[1] - centre.x()) / width),
                       static_cast<long>(centre.y() / width));
    };
    const lattice::Vector6& v = velocity[i];
    const Eigen::Vector3d momentum = lattice.mass[i] * v.head<3>();
    energy += 0.5 * momentum.dot(v.head<3>());
    wake.rotation_j += 0.5 * lattice.inertia[i] * v.tail<3>().squaredNorm();
    Lump& lump = cells[place(side)];
    lump.mass += lattice.mass[i];
    lump.momentum += momentum;
    Lump& broad = wide[place(2.0 * side)];
    broad.mass += lattice.mass[i];
    broad.moved += lattice.mass[i] * moved[i];
  }
  wake.out_of_plane_m = largest_motion(wide);
  for (;; side *= 2.0, cells = merged(cells)) {
    const double whole = energy_of(cells);
    wake.cell_m.push_back(side);
    wake.kinetic_j.push_back(energy - whole);
    energy = whole;
    if (side >= lattice.box.height) break;
  }
  wake.kinetic_j.push_back(energy);
  return wake;
}

}  // namespace rift::fracture

#include "engine/lattice/stiffness.hpp"

namespace rift {

double energy_per_length(const Lattice& lattice, const std::vector<Vector6>& q) {
  const double from = 0.25 * lattice.box.length, to = 0.75 * lattice.box.length;
  double energy = 0.0;
  for (std::size_t b = 0; b < lattice.beam.size(); ++b) {
    const auto& [i, j] = lattice.ends[b];
    const double middle = 0.5 * (lattice.centre[i].x() + lattice.centre[j].x());
    if (middle >= from && middle < to)
      energy += energy_of(lattice.beam[b], strain_of(lattice.beam[b], q[i], q[j]));
  }
  return energy / (to - from);
}

double strip_modulus(const Lattice& lattice, const std::vector<Vector6>& q, double displacement) {
  return 2.0 * energy_per_length(lattice, q) * lattice.box.height /
         (lattice.box.thickness * displacement * displacement);
}

}  // namespace rift

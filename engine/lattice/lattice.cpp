#include "engine/lattice/lattice.hpp"

namespace rift::lattice {
namespace {

void add_masses(Lattice& lattice, const packing::Specimen& specimen, double density) {
  double cubes = 0.0;
  for (double r : specimen.radius) cubes += r * r * r;
  for (double r : specimen.radius) {
    const double mass = density * specimen.box.volume() * (r * r * r / cubes);
    lattice.mass.push_back(mass);
    lattice.inertia.push_back(0.4 * mass * r * r);
  }
}

}  // namespace

Lattice make_lattice(const packing::Specimen& specimen, const MicroMaterial& micro, double density) {
  Lattice lattice{.centre = specimen.centre,
                  .radius = specimen.radius,
                  .grip = specimen.grip,
                  .mass = {},
                  .inertia = {},
                  .ends = specimen.beam,
                  .beam = {},
                  .mean_radius = specimen.packing.mean_radius,
                  .box = specimen.box};
  add_masses(lattice, specimen, density);
  lattice.beam.reserve(specimen.beam.size());
  for (const auto& [i, j] : specimen.beam) {
    const double section_radius = micro.radius_ratio * 0.5 * (specimen.radius[i] + specimen.radius[j]);
    lattice.beam.push_back(
        make_beam(packing::way_between(specimen.box, specimen.centre[i], specimen.centre[j]), section_radius,
                  micro.young_modulus, micro.poisson_ratio));
  }
  return lattice;
}

}  // namespace rift::lattice

#include "engine/lattice/lattice.hpp"

#include "engine/lattice/beam.hpp"

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
        make_beam(packing::minimum_image(specimen.box, specimen.centre[i], specimen.centre[j]),
                  section_radius, micro.young_modulus, micro.poisson_ratio));
  }
  return lattice;
}

double energy_of_beam(const Lattice& lattice, int beam, Kinematics kinematics,
                      const std::vector<Vector6>& q) {
  const auto& [i, j] = lattice.ends[beam];
  const Beam& b = lattice.beam[beam];
  const bool linear = kinematics == Kinematics::linear;
  return energy_of(b, linear ? strain_of(b, q[i], q[j]) : strain_of(b, pose_of(q[i]), pose_of(q[j])));
}

double elastic_energy(const Lattice& lattice, const std::vector<char>& present, Kinematics kinematics,
                      const std::vector<Vector6>& q) {
  double energy = 0.0;
  for (std::size_t b = 0; b < lattice.beam.size(); ++b)
    if (present[b]) energy += energy_of_beam(lattice, static_cast<int>(b), kinematics, q);
  return energy;
}

double grip_force(const Lattice& lattice, const std::vector<char>& present, Kinematics kinematics,
                  const std::vector<Vector6>& q) {
  const bool linear = kinematics == Kinematics::linear;
  double pull = 0.0;
  for (std::size_t b = 0; b < lattice.beam.size(); ++b) {
    const auto& [i, j] = lattice.ends[b];
    const bool i_on_top = lattice.grip[i] == packing::Grip::top,
               j_on_top = lattice.grip[j] == packing::Grip::top;
    if (!present[b] || i_on_top == j_on_top) continue;
    const Beam& beam = lattice.beam[b];
    const BeamLoads loads =
        linear ? loads_of(beam, q[i], q[j]) : loads_of(beam, pose_of(q[i]), pose_of(q[j]));
    pull += i_on_top ? -loads.force_i.y() : loads.force_i.y();
  }
  return pull;
}

double energy_per_length(const Lattice& lattice, Kinematics kinematics, const std::vector<Vector6>& q) {
  const double from = 0.25 * lattice.box.length, to = 0.75 * lattice.box.length;
  std::vector<char> measured(lattice.beam.size());
  for (std::size_t b = 0; b < measured.size(); ++b) {
    const auto& [i, j] = lattice.ends[b];
    const double middle = 0.5 * (lattice.centre[i].x() + lattice.centre[j].x());
    measured[b] = middle >= from && middle < to;
  }
  return elastic_energy(lattice, measured, kinematics, q) / (to - from);
}

double strip_modulus(const Lattice& lattice, const std::vector<Vector6>& q, double displacement) {
  return 2.0 * energy_per_length(lattice, Kinematics::linear, q) * lattice.box.height /
         (lattice.box.thickness * displacement * displacement);
}

}  // namespace rift::lattice

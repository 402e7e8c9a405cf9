#include "engine/lattice/stiffness.hpp"

#include "engine/mechanics/corotational.hpp"
#include "engine/scene/scene.hpp"

namespace rift::lattice {

double energy_of_beam(const Lattice& lattice, int beam, scene::Kinematics kinematics,
                      const std::vector<mechanics::Vector6>& q) {
  const auto& [i, j] = lattice.ends[beam];
  const mechanics::Beam& b = lattice.beam[beam];
  const bool linear = kinematics == scene::Kinematics::linear;
  return mechanics::energy_of(
      b, linear ? mechanics::strain_of(b, q[i], q[j])
                : mechanics::strain_of(b, mechanics::pose_of(q[i]), mechanics::pose_of(q[j])));
}

double grip_force(const Lattice& lattice, const std::vector<char>& present, scene::Kinematics kinematics,
                  const std::vector<mechanics::Vector6>& q) {
  const bool linear = kinematics == scene::Kinematics::linear;
  double pull = 0.0;
  for (std::size_t b = 0; b < lattice.beam.size(); ++b) {
    const auto& [i, j] = lattice.ends[b];
    const bool i_on_top = lattice.grip[i] == Grip::top, j_on_top = lattice.grip[j] == Grip::top;
    if (!present[b] || i_on_top == j_on_top) continue;
    const mechanics::Beam& beam = lattice.beam[b];
    const mechanics::BeamLoads loads =
        linear ? mechanics::loads_of(beam, q[i], q[j])
               : mechanics::loads_of(beam, mechanics::pose_of(q[i]), mechanics::pose_of(q[j]));
    pull += i_on_top ? -loads.force_i.y() : loads.force_i.y();
  }
  return pull;
}

double energy_per_length(const Lattice& lattice, scene::Kinematics kinematics,
                         const std::vector<mechanics::Vector6>& q) {
  const double from = 0.25 * lattice.box.length, to = 0.75 * lattice.box.length;
  double energy = 0.0;
  for (std::size_t b = 0; b < lattice.beam.size(); ++b) {
    const auto& [i, j] = lattice.ends[b];
    const double middle = 0.5 * (lattice.centre[i].x() + lattice.centre[j].x());
    if (middle >= from && middle < to) energy += energy_of_beam(lattice, static_cast<int>(b), kinematics, q);
  }
  return energy / (to - from);
}

double strip_modulus(const Lattice& lattice, const std::vector<mechanics::Vector6>& q, double displacement) {
  return 2.0 * energy_per_length(lattice, scene::Kinematics::linear, q) * lattice.box.height /
         (lattice.box.thickness * displacement * displacement);
}

}  // namespace rift::lattice

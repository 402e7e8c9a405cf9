#include "engine/lattice/forces.hpp"

#include <cmath>

namespace rift::lattice {

BeamRow row_of(const Lattice& lattice, int beam) {
  const Beam& b = lattice.beam[beam];
  return {.i = lattice.ends[beam][0],
          .j = lattice.ends[beam][1],
          .nx = b.axis.x(),
          .ny = b.axis.y(),
          .nz = b.axis.z(),
          .axial = b.axial,
          .bending = b.bending,
          .twist = b.twist,
          .per_length = 1.0 / b.length};
}

void add_beam_forces(std::span<const BeamRow> beams, const double* q, double* f) {
  for (const BeamRow& beam : beams) {
    const EndLoads loads = end_loads(beam, q + 6L * beam.i, q + 6L * beam.j);
    loads.add_to_i(f + 6L * beam.i);
    loads.add_to_j(f + 6L * beam.j);
  }
}

DampedBeam damped_beam(const Lattice& lattice, int beam, int crossing, bool at_surface) {
  const auto& [i, j] = lattice.ends[beam];
  const auto reduced = [](double a, double b) { return a * b / (a + b); };
  const double m = reduced(lattice.mass[i], lattice.mass[j]),
               I = reduced(lattice.inertia[i], lattice.inertia[j]);
  const Beam& b = lattice.beam[beam];
  return {.i = i,
          .j = j,
          .axis = b.axis,
          .axial = 2.0 * std::sqrt(b.axial * m),
          .twist = 2.0 * std::sqrt(b.twist * I),
          .bend = 2.0 * std::sqrt(0.5 * b.bending * I),
          .crossing = crossing,
          .at_surface = at_surface};
}

void add_damping_forces(ViscousDamping& damping, const double* rate, const double* factor, double dt,
                        double* f, double& work) {
  double* last = damping.last.data();
  for (const DampedBeam& b : damping.beam) {
    const double softened = b.crossing < 0 ? 1.0 : factor[b.crossing];
    const double alpha = softened * (b.at_surface ? damping.alpha_at_surface : damping.alpha_elsewhere);
    const Eigen::Map<const Vector6> rate_i(rate + 6L * b.i), rate_j(rate + 6L * b.j);
    const Eigen::Vector3d slide = rate_j.head<3>() - rate_i.head<3>(),
                          turn = rate_j.tail<3>() - rate_i.tail<3>();
    const double stretching = b.axis.dot(slide), twisting = b.axis.dot(turn);
    const double force = alpha * b.axial * stretching;
    const Eigen::Vector3d moment = alpha * (b.bend * turn + (b.twist - b.bend) * twisting * b.axis);
    Vector6 load;
    load << force * b.axis, moment;
    Eigen::Map<Vector6>(f + 6L * b.i) += load;
    Eigen::Map<Vector6>(f + 6L * b.j) -= load;
    Eigen::Map<Eigen::Vector3d> last_moment(last + 1);
    work += 0.5 * dt * ((last[0] + force) * stretching + (last_moment + moment).dot(turn));
    last[0] = force;
    last_moment = moment;
    last += 4;
  }
}

}  // namespace rift::lattice

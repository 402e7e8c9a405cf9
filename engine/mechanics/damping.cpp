#include "engine/mechanics/damping.hpp"

#include <cmath>

namespace rift {

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

template <int Lanes>
void add_damping_forces(ViscousDamping<Lanes>& damping, const double* rate, const double* factor, double dt,
                        double* f, std::array<double, Lanes>& work) {
  double* last = damping.last.data();
  for (const DampedBeam& b : damping.beam) {
    for (int lane = 0; lane < Lanes; ++lane) {
      const double softened = b.crossing < 0 ? 1.0 : factor[b.crossing * Lanes + lane];
      const double alpha =
          softened * (b.at_surface ? damping.alpha_at_surface : damping.alpha_elsewhere)[lane];
      const auto relative = [&](int c) {
        return rate[(6 * b.j + c) * Lanes + lane] - rate[(6 * b.i + c) * Lanes + lane];
      };
      const Eigen::Vector3d slide(relative(0), relative(1), relative(2)),
          turn(relative(3), relative(4), relative(5));
      const double stretching = b.axis.dot(slide), twisting = b.axis.dot(turn);
      const double force = alpha * b.axial * stretching;
      const Eigen::Vector3d moment = alpha * (b.bend * turn + (b.twist - b.bend) * twisting * b.axis);
      for (int c = 0; c < 3; ++c) {
        f[(6 * b.i + c) * Lanes + lane] += force * b.axis[c];
        f[(6 * b.j + c) * Lanes + lane] -= force * b.axis[c];
        f[(6 * b.i + 3 + c) * Lanes + lane] += moment[c];
        f[(6 * b.j + 3 + c) * Lanes + lane] -= moment[c];
      }
      const Eigen::Vector3d moment_before(last[Lanes + lane], last[2 * Lanes + lane], last[3 * Lanes + lane]);
      work[lane] += 0.5 * dt * ((last[lane] + force) * stretching + (moment_before + moment).dot(turn));
      last[lane] = force;
      for (int c = 0; c < 3; ++c) last[(1 + c) * Lanes + lane] = moment[c];
    }
    last += 4 * Lanes;
  }
}

template void add_damping_forces<1>(ViscousDamping<1>&, const double*, const double*, double, double*,
                                    std::array<double, 1>&);
template void add_damping_forces<4>(ViscousDamping<4>&, const double*, const double*, double, double*,
                                    std::array<double, 4>&);

}  // namespace rift

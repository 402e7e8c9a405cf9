#include "engine/lattice/forces.hpp"

#include <cmath>

namespace rift::lattice {
namespace {

/// What one beam does to its ends: force on i, moment on i, moment on j.
struct EndLoads {
  double fx, fy, fz, mix, miy, miz, mjx, mjy, mjz;
};

/// Symbols as in model.md §2: d = u_j - u_i, p = chord rotation psi = n x d / l, a, b = theta of i, j.
inline EndLoads end_loads(const BeamRow& beam, const double* qi, const double* qj) {
  const double nx = beam.nx, ny = beam.ny, nz = beam.nz;
  const double dx = qj[0] - qi[0], dy = qj[1] - qi[1], dz = qj[2] - qi[2];
  const double ax = qi[3], ay = qi[4], az = qi[5];
  const double bx = qj[3], by = qj[4], bz = qj[5];
  const double px = (ny * dz - nz * dy) * beam.per_length;
  const double py = (nz * dx - nx * dz) * beam.per_length;
  const double pz = (nx * dy - ny * dx) * beam.per_length;
  const double sx = ax + bx - 2.0 * px, sy = ay + by - 2.0 * py, sz = az + bz - 2.0 * pz;

  const double pull = beam.axial * (nx * dx + ny * dy + nz * dz);
  const double shear = 3.0 * beam.bending * beam.per_length;
  const double na = nx * ax + ny * ay + nz * az, nb = nx * bx + ny * by + nz * bz;
  const double torsion = beam.twist * (nb - na);
  const double along_i =
      beam.bending * (2.0 * na + nb) + torsion;  // w n.(s + alpha_i) + k_t n.(theta_j - theta_i)
  const double along_j = beam.bending * (na + 2.0 * nb) - torsion;
  const double w = beam.bending;
  return {pull * nx - shear * (sy * nz - sz * ny), pull * ny - shear * (sz * nx - sx * nz),
          pull * nz - shear * (sx * ny - sy * nx), along_i * nx - w * (sx + ax - px),
          along_i * ny - w * (sy + ay - py),       along_i * nz - w * (sz + az - pz),
          along_j * nx - w * (sx + bx - px),       along_j * ny - w * (sy + by - py),
          along_j * nz - w * (sz + bz - pz)};
}

}  // namespace

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
    double *fi = f + 6L * beam.i, *fj = f + 6L * beam.j;
    const EndLoads e = end_loads(beam, q + 6L * beam.i, q + 6L * beam.j);
    fi[0] += e.fx, fi[1] += e.fy, fi[2] += e.fz, fi[3] += e.mix, fi[4] += e.miy, fi[5] += e.miz;
    fj[0] -= e.fx, fj[1] -= e.fy, fj[2] -= e.fz, fj[3] += e.mjx, fj[4] += e.mjy, fj[5] += e.mjz;
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

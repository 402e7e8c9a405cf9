#include "engine/mechanics/forces.hpp"

namespace rift {
namespace {

/// What one beam does to its ends in one lane: force on i, moment on i, moment on j.
struct EndLoads {
  double fx, fy, fz, mix, miy, miz, mjx, mjy, mjz;
};

/// Symbols as in physics.md §2: d = u_j - u_i, p = chord rotation psi = n x d / l, a, b = theta of i, j.
template <int Lanes>
inline EndLoads end_loads(const BeamRow& beam, const double* qi, const double* qj) {
  const auto at = [](const double* v, int component) { return v[component * Lanes]; };
  const double nx = beam.nx, ny = beam.ny, nz = beam.nz;
  const double dx = at(qj, 0) - at(qi, 0), dy = at(qj, 1) - at(qi, 1), dz = at(qj, 2) - at(qi, 2);
  const double ax = at(qi, 3), ay = at(qi, 4), az = at(qi, 5);
  const double bx = at(qj, 3), by = at(qj, 4), bz = at(qj, 5);
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

template <int Lanes>
inline void add(const EndLoads& e, double factor, double* fi, double* fj) {
  fi[0 * Lanes] += factor * e.fx, fj[0 * Lanes] -= factor * e.fx;
  fi[1 * Lanes] += factor * e.fy, fj[1 * Lanes] -= factor * e.fy;
  fi[2 * Lanes] += factor * e.fz, fj[2 * Lanes] -= factor * e.fz;
  fi[3 * Lanes] += factor * e.mix, fj[3 * Lanes] += factor * e.mjx;
  fi[4 * Lanes] += factor * e.miy, fj[4 * Lanes] += factor * e.mjy;
  fi[5 * Lanes] += factor * e.miz, fj[5 * Lanes] += factor * e.mjz;
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

template <int Lanes>
void add_beam_forces(std::span<const BeamRow> beams, const double* q, double* f) {
  for (const BeamRow& beam : beams) {
    const std::ptrdiff_t i = 6L * Lanes * beam.i, j = 6L * Lanes * beam.j;
    for (int lane = 0; lane < Lanes; ++lane)
      add<Lanes>(end_loads<Lanes>(beam, q + i + lane, q + j + lane), 1.0, f + i + lane, f + j + lane);
  }
}

template <int Lanes>
void add_beam_forces(std::span<const BeamRow> beams, const double* factor, const double* q, double* f) {
  for (const BeamRow& beam : beams) {
    const std::ptrdiff_t i = 6L * Lanes * beam.i, j = 6L * Lanes * beam.j;
    for (int lane = 0; lane < Lanes; ++lane)
      add<Lanes>(end_loads<Lanes>(beam, q + i + lane, q + j + lane), *factor++, f + i + lane, f + j + lane);
  }
}

template void add_beam_forces<1>(std::span<const BeamRow>, const double*, double*);
template void add_beam_forces<1>(std::span<const BeamRow>, const double*, const double*, double*);
template void add_beam_forces<4>(std::span<const BeamRow>, const double*, double*);
template void add_beam_forces<4>(std::span<const BeamRow>, const double*, const double*, double*);

}  // namespace rift

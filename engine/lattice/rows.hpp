#pragma once

#include "engine/lattice/lattice.hpp"

#include <algorithm>
#include <array>
#include <cstdint>
#include <vector>

/// Pairs of elements as plain rows, what each row does to its two ends, and rows shared out among threads.
namespace rift::lattice {

/// A beam in one cache line.
struct BeamRow {
  std::int32_t i, j;
  double nx, ny, nz;
  double axial;       // k_a [N/m]
  double bending;     // w [N m]
  double twist;       // k_t [N m]
  double per_length;  // 1 / l [1/m]
};
static_assert(sizeof(BeamRow) == 64);

BeamRow row_of(const Lattice& lattice, int beam);

/// A damped beam, with alpha and what the rates are multiplied by.
struct DampingRow {
  std::int32_t i, j;
  double nx, ny, nz;
  double axial;  // along the axis [N s/m]
  double twist;  // of a relative rotation about the axis, less `bend` [N m s]
  double bend;   // of any relative rotation [N m s]
};

/// A beam of any stiffness that depends on u_j - u_i, theta_i and theta_j: the lower triangle of the
/// symmetric 9 x 9 matrix over these, row by row.
struct StiffnessRow {
  std::int32_t i, j;
  std::array<double, 45> k;
};

/// What one row does to its ends: force on i (the one on j is its negative), moment on i, moment on j.
struct EndLoads {
  double fx, fy, fz, mix, miy, miz, mjx, mjy, mjz;

  void add_to_i(double* f) const {
    f[0] += fx, f[1] += fy, f[2] += fz, f[3] += mix, f[4] += miy, f[5] += miz;
  }
  void add_to_j(double* f) const {
    f[0] -= fx, f[1] -= fy, f[2] -= fz, f[3] += mjx, f[4] += mjy, f[5] += mjz;
  }
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

/// At rates: the force along the axis, and a moment that only the relative rotation makes.
inline EndLoads end_loads(const DampingRow& beam, const double* qi, const double* qj) {
  const double nx = beam.nx, ny = beam.ny, nz = beam.nz;
  const double tx = qj[3] - qi[3], ty = qj[4] - qi[4], tz = qj[5] - qi[5];
  const double pull = beam.axial * (nx * (qj[0] - qi[0]) + ny * (qj[1] - qi[1]) + nz * (qj[2] - qi[2]));
  const double twist = beam.twist * (nx * tx + ny * ty + nz * tz);
  const double mx = beam.bend * tx + twist * nx, my = beam.bend * ty + twist * ny,
               mz = beam.bend * tz + twist * nz;
  return {pull * nx, pull * ny, pull * nz, mx, my, mz, -mx, -my, -mz};
}

inline EndLoads end_loads(const StiffnessRow& row, const double* qi, const double* qj) {
  const std::array<double, 9> e{qj[0] - qi[0], qj[1] - qi[1], qj[2] - qi[2], qi[3], qi[4],
                                qi[5],         qj[3],         qj[4],         qj[5]};
  std::array<double, 9> l{};
  const double* k = row.k.data();
  for (int r = 0; r < 9; ++r) {
    for (int c = 0; c < r; ++c, ++k) l[r] += *k * e[c], l[c] += *k * e[r];
    l[r] += *k++ * e[r];
  }
  return {l[0], l[1], l[2], -l[3], -l[4], -l[5], -l[6], -l[7], -l[8]};
}

/// Elements [begin, end) and the rows that act on any of them, in the order of the rows: a row with one end
/// in each of two shares stands in both. So a share writes to its own elements only, and each element adds up
/// its rows in one order, whoever does it.
template <class Row>
struct Share {
  int begin = 0, end = 0;
  std::vector<Row> row;
  bool owns(int element) const { return element >= begin && element < end; }
};

/// @param[in] end  where each share ends, ascending; rows of elements beyond the last act on nothing there
template <class Row>
std::vector<Share<Row>> shared_out(const std::vector<int>& end, const std::vector<Row>& rows) {
  std::vector<Share<Row>> shares(end.size());
  for (std::size_t s = 0; s < end.size(); ++s) shares[s] = {s == 0 ? 0 : end[s - 1], end[s], {}};
  const auto share_of = [&](int element) {
    return static_cast<std::size_t>(std::upper_bound(end.begin(), end.end(), element) - end.begin());
  };
  const auto visit = [&](const Row& row, const auto& see) {
    const std::size_t a = share_of(row.i), b = share_of(row.j);
    if (a < shares.size()) see(a);
    if (b != a && b < shares.size()) see(b);
  };
  std::vector<std::size_t> count(shares.size(), 0);
  for (const Row& row : rows) visit(row, [&](std::size_t s) { ++count[s]; });
  for (std::size_t s = 0; s < shares.size(); ++s) shares[s].row.reserve(count[s]);
  for (const Row& row : rows) visit(row, [&](std::size_t s) { shares[s].row.push_back(row); });
  return shares;
}

/// Adds the loads of a share's rows to its elements.
/// @param[in]     x  [element][6];  @param[in,out] y  [element][6]
template <class Row>
void add_loads(const Share<Row>& share, const double* x, double* y) {
  for (const Row& row : share.row) {
    const EndLoads loads = end_loads(row, x + 6L * row.i, x + 6L * row.j);
    if (share.owns(row.i)) loads.add_to_i(y + 6L * row.i);
    if (share.owns(row.j)) loads.add_to_j(y + 6L * row.j);
  }
}

}  // namespace rift::lattice

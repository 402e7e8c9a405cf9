#include "engine/mechanics/statics.hpp"

#include "engine/mechanics/rigid_patches.hpp"

#include <Eigen/IterativeLinearSolvers>
#include <fmt/core.h>

namespace rift {
namespace {

using Matrix = RigidPatches::Matrix;

struct FreeSystem {
  std::vector<int> number;  // of each element among the free ones, -1 where held
  std::vector<Eigen::Vector3d> centre;
  Matrix k;
  Eigen::VectorXd load;
};

std::vector<int> number_the_free(const Lattice& lattice, const std::vector<char>& present) {
  std::vector<std::array<int, 2>> beams;
  for (std::size_t b = 0; b < present.size(); ++b)
    if (present[b]) beams.push_back(lattice.ends[b]);
  std::vector<char> held(lattice.grip.size());
  for (std::size_t i = 0; i < held.size(); ++i) held[i] = lattice.grip[i] != Grip::none;
  const std::vector<char> joined = reached_from(held, beams);
  std::vector<int> number(held.size(), -1);
  int count = 0;
  for (std::size_t i = 0; i < held.size(); ++i)
    if (!held[i] && joined[i]) number[i] = count++;
  return number;
}

/// Stiffness in the unknowns (u, R theta), which puts forces and moments on one scale.
FreeSystem assemble(const Lattice& lattice, const std::vector<char>& present, const Vector6& top_motion) {
  FreeSystem system{.number = number_the_free(lattice, present), .centre = {}, .k = {}, .load = {}};
  for (std::size_t i = 0; i < lattice.centre.size(); ++i)
    if (system.number[i] >= 0) system.centre.push_back(lattice.centre[i]);
  const long unknowns = 6 * static_cast<long>(system.centre.size());
  system.load = Eigen::VectorXd::Zero(unknowns);
  Eigen::Matrix<double, 12, 1> scale;
  scale << Eigen::Vector3d::Ones(), Eigen::Vector3d::Constant(1.0 / lattice.mean_radius),
      Eigen::Vector3d::Ones(), Eigen::Vector3d::Constant(1.0 / lattice.mean_radius);

  std::vector<Eigen::Triplet<double>> entries;
  entries.reserve(144 * lattice.beam.size());
  for (std::size_t b = 0; b < lattice.beam.size(); ++b) {
    if (!present[b]) continue;
    const Matrix12 k = scale.asDiagonal() * stiffness_of(lattice.beam[b]) * scale.asDiagonal();
    for (int end = 0; end < 2; ++end) {
      const int row = system.number[lattice.ends[b][end]];
      if (row < 0) continue;
      for (int other = 0; other < 2; ++other) {
        const int element = lattice.ends[b][other], column = system.number[element];
        const Eigen::Matrix<double, 6, 6> block = k.block<6, 6>(6 * end, 6 * other);
        if (column >= 0) {
          for (int r = 0; r < 6; ++r)
            for (int c = 0; c < 6; ++c) entries.emplace_back(6 * row + r, 6 * column + c, block(r, c));
        } else if (lattice.grip[element] == Grip::top) {
          system.load.segment<6>(6 * row) -= block * top_motion;
        }
      }
    }
  }
  system.k.resize(unknowns, unknowns);
  system.k.setFromTriplets(entries.begin(), entries.end());
  return system;
}

Eigen::VectorXd solve(const FreeSystem& system, double mean_radius) {
  constexpr double tolerance = 1e-12,
                   patch_edge = 6.0;  // edge in mean radii: the quickest of 4, 6, 8, 12 at 20,000
  Eigen::ConjugateGradient<Matrix, Eigen::Lower | Eigen::Upper, RigidPatches> solver;
  solver.setTolerance(tolerance);
  solver.preconditioner().place(system.centre, mean_radius, patch_edge * mean_radius);
  solver.compute(system.k);
  if (solver.info() != Eigen::Success) throw StaticsError("the lattice's stiffness is not positive definite");
  Eigen::VectorXd unknown = solver.solve(system.load);
  if (solver.info() != Eigen::Success || !unknown.allFinite())
    throw StaticsError(
        fmt::format("the pre-stress did not converge: relative residual {:.3g} after {} iterations "
                    "(limit {:.3g})",
                    solver.error(), solver.iterations(), tolerance));
  return unknown;
}

}  // namespace

std::vector<Vector6> stretched_at_rest(const Lattice& lattice, const std::vector<char>& present,
                                       double displacement) {
  Vector6 top_motion = Vector6::Zero();
  top_motion[1] = displacement;
  const FreeSystem system = assemble(lattice, present, top_motion);
  std::vector<Vector6> q(lattice.centre.size(), Vector6::Zero());
  for (std::size_t i = 0; i < q.size(); ++i)
    if (lattice.grip[i] == Grip::top) q[i] = top_motion;
  if (system.centre.empty()) return q;
  const Eigen::VectorXd unknown = solve(system, lattice.mean_radius);
  for (std::size_t i = 0; i < q.size(); ++i) {
    if (system.number[i] < 0) continue;
    q[i] = unknown.segment<6>(6 * system.number[i]);
    q[i].tail<3>() /= lattice.mean_radius;
  }
  return q;
}

}  // namespace rift

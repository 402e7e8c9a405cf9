#include "engine/mechanics/statics.hpp"

#include "engine/mechanics/corotational.hpp"
#include "engine/mechanics/rigid_patches.hpp"

#include <Eigen/IterativeLinearSolvers>
#include <fmt/core.h>

#include <functional>

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

using StiffnessOf = std::function<Matrix12(int beam)>;

/// Stiffness in the unknowns (u, R theta), which puts forces and moments on one scale; no loads yet.
FreeSystem assemble(const Lattice& lattice, const std::vector<char>& present, const StiffnessOf& stiffness) {
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
    const Matrix12 k = scale.asDiagonal() * stiffness(static_cast<int>(b)) * scale.asDiagonal();
    for (int end = 0; end < 2; ++end) {
      const int row = system.number[lattice.ends[b][end]];
      if (row < 0) continue;
      for (int other = 0; other < 2; ++other) {
        const int column = system.number[lattice.ends[b][other]];
        if (column < 0) continue;
        for (int r = 0; r < 6; ++r)
          for (int c = 0; c < 6; ++c)
            entries.emplace_back(6 * row + r, 6 * column + c, k(6 * end + r, 6 * other + c));
      }
    }
  }
  system.k.resize(unknowns, unknowns);
  system.k.setFromTriplets(entries.begin(), entries.end());
  return system;
}

/// The loads on the free elements, in the unknowns' scale.
void set_loads(FreeSystem& system, const Lattice& lattice, const std::vector<Vector6>& force) {
  for (std::size_t i = 0; i < force.size(); ++i) {
    if (system.number[i] < 0) continue;
    system.load.segment<6>(6 * system.number[i]) = force[i];
    system.load.segment<3>(6 * system.number[i] + 3) /= lattice.mean_radius;
  }
}

/// Force and moment on each element from the beams that are there.
template <class State, class LoadsOf>
std::vector<Vector6> forces_on(const Lattice& lattice, const std::vector<char>& present,
                               const std::vector<State>& state, const LoadsOf& loads) {
  std::vector<Vector6> force(state.size(), Vector6::Zero());
  for (std::size_t b = 0; b < lattice.beam.size(); ++b) {
    if (!present[b]) continue;
    const auto& [i, j] = lattice.ends[b];
    const BeamLoads l = loads(lattice.beam[b], state[i], state[j]);
    force[i].head<3>() += l.force_i, force[i].tail<3>() += l.moment_i;
    force[j].head<3>() -= l.force_i, force[j].tail<3>() += l.moment_j;
  }
  return force;
}

Eigen::VectorXd solve(const FreeSystem& system, double mean_radius, double tolerance) {
  constexpr double patch_edge = 6.0;  // edge in mean radii: the quickest of 4, 6, 8, 12 at 20,000
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

/// The top grip moved, all else where it was.
std::vector<Vector6> gripped(const Lattice& lattice, double displacement) {
  std::vector<Vector6> q(lattice.centre.size(), Vector6::Zero());
  for (std::size_t i = 0; i < q.size(); ++i)
    if (lattice.grip[i] == Grip::top) q[i][1] = displacement;
  return q;
}

/// The solution as motions of the free elements.
Vector6 motion_in(const Eigen::VectorXd& unknown, int number, double mean_radius) {
  Vector6 q = unknown.segment<6>(6 * number);
  q.tail<3>() /= mean_radius;
  return q;
}

}  // namespace

std::vector<Vector6> stretched_at_rest(const Lattice& lattice, const std::vector<char>& present,
                                       double displacement) {
  FreeSystem system = assemble(lattice, present, [&](int b) { return stiffness_of(lattice.beam[b]); });
  std::vector<Vector6> q = gripped(lattice, displacement);
  if (system.centre.empty()) return q;
  set_loads(system, lattice,
            forces_on(lattice, present, q, [](const Beam& beam, const Vector6& i, const Vector6& j) {
              return loads_of(beam, i, j);
            }));
  const Eigen::VectorXd unknown = solve(system, lattice.mean_radius, 1e-13);
  for (std::size_t i = 0; i < q.size(); ++i)
    if (system.number[i] >= 0) q[i] = motion_in(unknown, system.number[i], lattice.mean_radius);
  return q;
}

std::vector<Vector6> stretched_at_rest_corotational(const Lattice& lattice, const std::vector<char>& present,
                                                    double displacement) {
  constexpr double balanced = 1e-11, inner_tolerance = 1e-5;
  constexpr int most_rounds = 20;
  std::vector<Pose> pose;
  for (const Vector6& q : stretched_at_rest(lattice, present, displacement)) pose.push_back(pose_of(q));
  const auto load_of = [](const Beam& beam, const Pose& i, const Pose& j) { return loads_of(beam, i, j); };
  double scale = 0.0, unbalance = 0.0;
  for (int round = 0; round < most_rounds; ++round) {
    FreeSystem system = assemble(lattice, present, [&](int b) -> Matrix12 {
      const auto& [i, j] = lattice.ends[b];
      const Matrix12 k = tangent_of(lattice.beam[b], pose[i], pose[j]);
      return 0.5 * (k + k.transpose());  // what is not symmetric of one beam cancels at equilibrium
    });
    const std::vector<Vector6> force = forces_on(lattice, present, pose, load_of);
    set_loads(system, lattice, force);
    unbalance = system.load.norm();
    if (round == 0)
      for (std::size_t i = 0; i < force.size(); ++i)
        if (system.number[i] < 0) scale += force[i].head<3>().squaredNorm();
    if (unbalance <= balanced * std::sqrt(scale)) {
      std::vector<Vector6> q;
      for (const Pose& p : pose) q.push_back(motion_of(p));
      return q;
    }
    const Eigen::VectorXd unknown = solve(system, lattice.mean_radius, inner_tolerance);
    for (std::size_t i = 0; i < pose.size(); ++i) {
      if (system.number[i] < 0) continue;
      const Pose moved = pose_of(motion_in(unknown, system.number[i], lattice.mean_radius));
      pose[i].u += moved.u;
      pose[i].turn = (moved.turn * pose[i].turn).normalized();
    }
  }
  throw StaticsError(
      fmt::format("the corotational pre-stress did not converge in {} Newton steps: {:.3g} of the grips' "
                  "forces left, limit {:.3g}",
                  most_rounds, unbalance / std::sqrt(scale), balanced));
}

}  // namespace rift

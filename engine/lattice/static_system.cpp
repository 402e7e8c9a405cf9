#include "engine/lattice/static_system.hpp"

#include "engine/lattice/rigid_patches.hpp"

#include <Eigen/IterativeLinearSolvers>
#include <fmt/core.h>

#include <algorithm>
#include <cmath>

namespace rift::lattice {

StaticSystem assemble(const Lattice& lattice, std::vector<int> number, const std::vector<char>& present,
                      const StiffnessOf& stiffness) {
  StaticSystem system{.number = std::move(number), .centre = {}, .mean_radius = lattice.mean_radius, .k = {}};
  for (std::size_t i = 0; i < lattice.centre.size(); ++i)
    if (system.number[i] >= 0) system.centre.push_back(lattice.centre[i]);
  const long unknowns = 6 * static_cast<long>(system.centre.size());
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

Eigen::VectorXd loads_on(const StaticSystem& system, const std::vector<Vector6>& force) {
  Eigen::VectorXd load = Eigen::VectorXd::Zero(system.k.rows());
  for (std::size_t i = 0; i < force.size(); ++i) {
    if (system.number[i] < 0) continue;
    load.segment<6>(6 * system.number[i]) = force[i];
    load.segment<3>(6 * system.number[i] + 3) /= system.mean_radius;
  }
  return load;
}

std::vector<Vector6> motions_in(const StaticSystem& system, const Eigen::VectorXd& unknown) {
  std::vector<Vector6> q(system.number.size(), Vector6::Zero());
  for (std::size_t i = 0; i < q.size(); ++i) {
    if (system.number[i] < 0) continue;
    q[i] = unknown.segment<6>(6 * system.number[i]);
    q[i].tail<3>() /= system.mean_radius;
  }
  return q;
}

struct StaticSolver::ConjugateGradients
    : Eigen::ConjugateGradient<StaticSystem::Matrix, Eigen::Lower | Eigen::Upper, RigidPatches> {};

StaticSolver::StaticSolver(const StaticSystem& system)
    : system_(system), iteration_(std::make_unique<ConjugateGradients>()) {
  constexpr double patch_edge = 6.0;  // edge in mean radii: the quickest of 4, 6, 8, 12 at 20,000
  iteration_->preconditioner().place(system.centre, system.mean_radius, patch_edge * system.mean_radius);
  iteration_->compute(system.k);
  if (iteration_->info() != Eigen::Success)
    throw StaticsError("the lattice's stiffness is not positive definite");
}

StaticSolver::~StaticSolver() = default;

Eigen::VectorXd StaticSolver::solve(const Eigen::VectorXd& load, double tolerance,
                                    const base::FractionTold& told) {
  iteration_->setTolerance(tolerance);
  iteration_->preconditioner().seen = [&, at_first = load.norm(),
                                       done = 0.0](const Eigen::VectorXd& left) mutable {
    if (!told) return;
    const double digits = std::log(left.norm() / at_first) / std::log(tolerance);
    if (digits > done) done = std::min(digits, 1.0);  // not so for NaN
    base::tell_or_stop(told, done, "solving the statics");
  };
  Eigen::VectorXd unknown = iteration_->solve(load);
  if (iteration_->info() != Eigen::Success || !unknown.allFinite())
    throw StaticsError(fmt::format(
        "the statics did not converge: relative residual {:.3g} after {} iterations (limit {:.3g})",
        iteration_->error(), iteration_->iterations(), tolerance));
  return unknown;
}

}  // namespace rift::lattice

#include "engine/lattice/statics.hpp"

#include "engine/lattice/beam.hpp"

#include <Eigen/Dense>
#include <Eigen/IterativeLinearSolvers>
#include <Eigen/SparseCholesky>
#include <fmt/core.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <numeric>

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

/// Preconditioner for the beam lattice: one block per element for the short waves, and the rigid motions of
/// patches a few elements wide, solved directly, for the long ones (two-level additive Schwarz, Dryja and
/// Widlund 1987):
///   M^-1 = D^-1 + P (P^T K P)^-1 P^T
/// Fits Eigen::ConjugateGradient, which calls compute() with a matrix and solve() with each residual.
class RigidPatches {
 public:
  using Matrix = Eigen::SparseMatrix<double>;

  /// @param[in] centre  n element centres [m]; unknowns are (u, R theta) of each in turn
  /// @param[in] scale   R [m], what rotations were multiplied by
  /// @param[in] edge    of a patch [m]
  void place(const std::vector<Eigen::Vector3d>& centre, double scale, double edge);

  RigidPatches& analyzePattern(const Matrix&) { return *this; }
  RigidPatches& factorize(const Matrix& k);
  RigidPatches& compute(const Matrix& k) { return factorize(k); }
  Eigen::VectorXd solve(const Eigen::VectorXd& residual) const;
  Eigen::ComputationInfo info() const { return info_; }

  /// Sees each residual before it is solved for, once a round of the iteration; may throw to give up.
  std::function<void(const Eigen::VectorXd& residual)> seen;

 private:
  Matrix motions_;  // P: 6 n x 6 patches
  std::vector<Eigen::Matrix<double, 6, 6>> inverse_block_;
  Eigen::SimplicialLLT<Matrix> coarse_;
  Eigen::ComputationInfo info_ = Eigen::Success;
};

namespace {

using Triplets = std::vector<Eigen::Triplet<double>>;

/// One element's rows of P: u = U + Omega x d, R theta = R Omega, with Omega scaled by R as the unknowns are.
void add_rigid_motion(Triplets& entries, int element, int patch, const Eigen::Vector3d& d) {
  const int row = 6 * element, column = 6 * patch;
  for (int c = 0; c < 6; ++c) entries.emplace_back(row + c, column + c, 1.0);
  for (int c = 0; c < 3; ++c) {
    const int next = (c + 1) % 3, last = (c + 2) % 3;
    entries.emplace_back(row + c, column + 3 + next, d[last]);
    entries.emplace_back(row + c, column + 3 + last, -d[next]);
  }
}

}  // namespace

void RigidPatches::place(const std::vector<Eigen::Vector3d>& centre, double scale, double edge) {
  std::map<std::array<long, 3>, std::vector<int>> patches;
  for (std::size_t i = 0; i < centre.size(); ++i) {
    const auto cell = [&](int c) { return static_cast<long>(std::floor(centre[i][c] / edge)); };
    patches[{cell(0), cell(1), cell(2)}].push_back(static_cast<int>(i));
  }
  Triplets entries;
  int patch = 0;
  for (const auto& [cell, members] : patches) {
    Eigen::Vector3d middle = Eigen::Vector3d::Zero();
    for (int i : members) middle += centre[i] / static_cast<double>(members.size());
    for (int i : members) add_rigid_motion(entries, i, patch, (centre[i] - middle) / scale);
    ++patch;
  }
  motions_.resize(6 * static_cast<long>(centre.size()), 6 * patch);
  motions_.setFromTriplets(entries.begin(), entries.end());
}

RigidPatches& RigidPatches::factorize(const Matrix& k) {
  const long n = k.rows() / 6;
  inverse_block_.resize(n);
  for (long i = 0; i < n; ++i) {
    const Eigen::Matrix<double, 6, 6> block = k.block(6 * i, 6 * i, 6, 6);
    inverse_block_[i] = block.inverse();
  }
  const Matrix coarse = motions_.transpose() * k * motions_;
  coarse_.compute(coarse);
  info_ = coarse_.info();
  return *this;
}

Eigen::VectorXd RigidPatches::solve(const Eigen::VectorXd& residual) const {
  if (seen) seen(residual);
  const Eigen::VectorXd restricted = motions_.transpose() * residual;
  Eigen::VectorXd correction = motions_ * coarse_.solve(restricted);
  for (std::size_t i = 0; i < inverse_block_.size(); ++i) {
    const long at = 6 * static_cast<long>(i);
    correction.segment<6>(at) += inverse_block_[i] * residual.segment<6>(at);
  }
  return correction;
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
                                    const base::ProgressCallback& told) {
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

namespace {

StaticSystem tied(const Lattice& lattice) {
  std::vector<int> number(lattice.centre.size());
  std::iota(number.begin(), number.end(), 0);
  StaticSystem system = assemble(lattice, std::move(number), std::vector<char>(lattice.beam.size(), 1),
                                 [&](int b) { return stiffness_of(lattice.beam[b]); });
  const int unknowns =
      lattice.box.shape == packing::Shape::periodic ? 3 : 6;  // a lattice that repeats cannot turn
  for (int c = 0; c < unknowns; ++c) system.k.coeffRef(c, c) *= 2.0;
  return system;
}

}  // namespace

FreeBody::FreeBody(const Lattice& lattice) : system_(tied(lattice)), solver_(system_) {}

std::vector<Vector6> FreeBody::at_rest(const std::vector<Vector6>& load, double tolerance,
                                       const base::ProgressCallback& told) {
  return motions_in(system_, solver_.solve(loads_on(system_, load), tolerance, told));
}

namespace {

std::vector<int> number_the_free(const Lattice& lattice, const std::vector<char>& present) {
  std::vector<std::array<int, 2>> beams;
  for (std::size_t b = 0; b < present.size(); ++b)
    if (present[b]) beams.push_back(lattice.ends[b]);
  std::vector<char> held(lattice.grip.size());
  for (std::size_t i = 0; i < held.size(); ++i) held[i] = lattice.grip[i] != packing::Grip::none;
  const std::vector<char> joined = packing::reached_from(held, beams);
  std::vector<int> number(held.size(), -1);
  int count = 0;
  for (std::size_t i = 0; i < held.size(); ++i)
    if (!held[i] && joined[i]) number[i] = count++;
  return number;
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

/// The top grip moved, all else where it was.
std::vector<Vector6> gripped(const Lattice& lattice, const Pull& pull) {
  std::vector<Vector6> q(lattice.centre.size(), Vector6::Zero());
  for (std::size_t i = 0; i < q.size(); ++i)
    if (lattice.grip[i] == packing::Grip::top) {
      q[i][0] = pull.middle * pull.shear;
      q[i][1] = pull.at(lattice.centre[i].x() / lattice.box.length);
    }
  return q;
}

}  // namespace

std::vector<Vector6> stretched_at_rest(const Lattice& lattice, const std::vector<char>& present,
                                       const Pull& pull, const base::ProgressCallback& told) {
  std::vector<Vector6> q = gripped(lattice, pull);
  const StaticSystem system = assemble(lattice, number_the_free(lattice, present), present,
                                       [&](int b) { return stiffness_of(lattice.beam[b]); });
  if (system.centre.empty()) return q;
  const Eigen::VectorXd load = loads_on(
      system, forces_on(lattice, present, q, [](const Beam& beam, const Vector6& i, const Vector6& j) {
        return loads_of(beam, i, j);
      }));
  const std::vector<Vector6> moved = motions_in(system, StaticSolver(system).solve(load, 1e-13, told));
  for (std::size_t i = 0; i < q.size(); ++i)
    if (system.number[i] >= 0) q[i] = moved[i];
  return q;
}

std::vector<Vector6> stretched_at_rest_corotational(const Lattice& lattice, const std::vector<char>& present,
                                                    const Pull& pull, const base::ProgressCallback& told) {
  constexpr double inner_tolerance = 1e-5;
  constexpr int most_rounds = 20;
  constexpr double usual_rounds = 5.0;  // the linear solution among them
  int solved = 0;
  const base::ProgressCallback tell = [&](double done) {
    return !told || told(std::min(0.99, (solved + done) / usual_rounds));
  };
  // A beam's stretch is the difference of two lengths, rounded to some 1e-16 of them.
  const double strain = std::abs(pull.middle) * std::hypot(1.0, pull.shear) / lattice.box.height;
  const double balanced = std::max(1e-11, 1e-15 / strain);
  std::vector<Pose> pose;
  for (const Vector6& q : stretched_at_rest(lattice, present, pull, tell)) pose.push_back(pose_of(q));
  ++solved;
  const auto load_of = [](const Beam& beam, const Pose& i, const Pose& j) { return loads_of(beam, i, j); };
  const std::vector<int> number = number_the_free(lattice, present);
  double scale = 0.0, unbalance = 0.0;
  for (int round = 0; round < most_rounds; ++round) {
    const StaticSystem system = assemble(lattice, number, present, [&](int b) -> Matrix12 {
      const auto& [i, j] = lattice.ends[b];
      const Matrix12 k = tangent_of(lattice.beam[b], pose[i], pose[j]);
      return 0.5 * (k + k.transpose());  // what is not symmetric of one beam cancels at equilibrium
    });
    const std::vector<Vector6> force = forces_on(lattice, present, pose, load_of);
    const Eigen::VectorXd load = loads_on(system, force);
    unbalance = load.norm();
    if (round == 0)
      for (std::size_t i = 0; i < force.size(); ++i)
        if (system.number[i] < 0) scale += force[i].head<3>().squaredNorm();
    if (unbalance <= balanced * std::sqrt(scale)) {
      std::vector<Vector6> q;
      q.reserve(pose.size());
      for (const Pose& p : pose) q.push_back(motion_of(p));
      return q;
    }
    const std::vector<Vector6> moves =
        motions_in(system, StaticSolver(system).solve(load, inner_tolerance, tell));
    ++solved;
    for (std::size_t i = 0; i < pose.size(); ++i) {
      if (system.number[i] < 0) continue;
      const Pose moved = pose_of(moves[i]);
      pose[i].u += moved.u;
      pose[i].turn = (moved.turn * pose[i].turn).normalized();
    }
  }
  throw StaticsError(
      fmt::format("the corotational pre-stress did not converge in {} Newton steps: {:.3g} of the grips' "
                  "forces left, limit {:.3g}",
                  most_rounds, unbalance / std::sqrt(scale), balanced));
}

}  // namespace rift::lattice

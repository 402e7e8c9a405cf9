#pragma once

#include <Eigen/SparseCholesky>
#include <Eigen/SparseCore>

#include <functional>
#include <vector>

namespace rift::lattice {

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

}  // namespace rift::lattice

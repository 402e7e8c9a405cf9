#pragma once

#include "engine/base/interrupted.hpp"
#include "engine/lattice/rigid_patches.hpp"

namespace rift::lattice {

/// Conjugate gradients for K q = f over elements joined by rows, without the matrix K; ready for many loads.
/// All sums are added up in one order, so that the bits do not depend on the number of threads.
template <class Row>
class StaticSolver {
 public:
  /// @param[in] threads  0 for one per core. Throws StaticsError where K is not positive definite.
  StaticSolver(const StaticRows<Row>& system, int threads);

  /// The unknowns under a load, [element][6] both; forces on elements that only turn count for nothing.
  /// Throws StaticsError where the relative residual stays above the tolerance, Interrupted. Progress counts
  /// the digits of the residual.
  Eigen::VectorXd solve(const Eigen::VectorXd& load, double tolerance,
                        const base::ProgressCallback& told = {});

  int iterations() const { return iterations_; }  // of the last solution

 private:
  /// K p; returns p . K p.
  double multiply(const Eigen::VectorXd& p, Eigen::VectorXd& kp);

  Blocks blocks_;
  std::vector<Share<Row>> shares_;
  /// Takes what would displace the elements that only turn out of a vector.
  void keep_in_place(Eigen::VectorXd& vector) const;

  Vector6 tie_;
  std::vector<int> turning_;
  RigidPatches patches_;
  int iterations_ = 0;
};

}  // namespace rift::lattice

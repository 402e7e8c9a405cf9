#pragma once

#include "engine/base/interrupted.hpp"
#include "engine/lattice/lattice.hpp"

#include <Eigen/SparseCore>

#include <functional>
#include <memory>
#include <stdexcept>
#include <vector>

namespace rift::lattice {

/// A linear system of statics could not be solved to its tolerance.
struct StaticsError : std::runtime_error {
  using std::runtime_error::runtime_error;
};

/// K q = f over the free elements of a lattice, in the unknowns (u, R theta) with R the mean radius, which
/// puts forces and moments on one scale.
struct StaticSystem {
  using Matrix = Eigen::SparseMatrix<double>;
  std::vector<int> number;              // of each element among the free ones, -1 where held
  std::vector<Eigen::Vector3d> centre;  // of the free ones [m]
  double mean_radius = 0;               // R [m]
  Matrix k;
};

using StiffnessOf = std::function<Matrix12(int beam)>;

/// @param[in] number   of each element among the free ones, -1 where held
/// @param[in] present  B, 0 for a beam that is not there
StaticSystem assemble(const Lattice& lattice, std::vector<int> number, const std::vector<char>& present,
                      const StiffnessOf& stiffness);

/// The loads on the free elements, in the unknowns' scale. @param[in] force  N forces and moments [N, N m]
Eigen::VectorXd loads_on(const StaticSystem& system, const std::vector<Vector6>& force);

/// Motions of all elements [m, rad], those that are held staying where they are.
std::vector<Vector6> motions_in(const StaticSystem& system, const Eigen::VectorXd& unknown);

/// Conjugate gradients over a system that must outlive it; ready for many loads.
class StaticSolver {
 public:
  explicit StaticSolver(const StaticSystem& system);
  ~StaticSolver();
  /// Throws StaticsError where the relative residual stays above the tolerance, Interrupted. What is told is
  /// done by the digits of the residual.
  Eigen::VectorXd solve(const Eigen::VectorXd& load, double tolerance, const base::FractionTold& told = {});

 private:
  struct ConjugateGradients;  // Eigen's, which takes long to compile
  const StaticSystem& system_;
  std::unique_ptr<ConjugateGradients> iteration_;
};

}  // namespace rift::lattice

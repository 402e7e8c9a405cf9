#include "tests/engine/lattice/dense.hpp"

#include "tests/engine/lattice/hand_made.hpp"

#include <Eigen/Dense>

namespace rift::lattice::hand_made {

Eigen::MatrixXd dense_stiffness(const Lattice& lattice) {
  const long size = 6 * static_cast<long>(lattice.centre.size());
  Eigen::MatrixXd k = Eigen::MatrixXd::Zero(size, size);
  for (std::size_t b = 0; b < lattice.beam.size(); ++b) {
    const Matrix12 beam = stiffness_of(lattice.beam[b]);
    for (int end = 0; end < 2; ++end)
      for (int other = 0; other < 2; ++other)
        k.block<6, 6>(6 * lattice.ends[b][end], 6 * lattice.ends[b][other]) +=
            beam.block<6, 6>(6 * end, 6 * other);
  }
  return k;
}

Modes modes_of(const Eigen::MatrixXd& stiffness, const Eigen::MatrixXd& mass) {
  const Eigen::GeneralizedSelfAdjointEigenSolver<Eigen::MatrixXd> solver(stiffness, mass);
  return {solver.eigenvalues(), solver.eigenvectors()};
}

double highest_omega_squared(const Lattice& lattice) {
  const Eigen::VectorXd root = mobility(lattice).cwiseSqrt();
  const Eigen::MatrixXd symmetric = root.asDiagonal() * dense_stiffness(lattice) * root.asDiagonal();
  return Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd>(symmetric, Eigen::EigenvaluesOnly)
      .eigenvalues()
      .maxCoeff();
}

Eigen::VectorXd solution_of(const Eigen::MatrixXd& a, const Eigen::VectorXd& b) { return a.llt().solve(b); }

}  // namespace rift::lattice::hand_made

#include "engine/lattice/modes.hpp"

#include <Eigen/Dense>
#include <Eigen/Eigenvalues>

#include <cmath>
#include <numbers>

namespace rift::lattice {

using Eigen::VectorXd;

VectorXd root_mobility(const Lattice& lattice) {
  VectorXd root = VectorXd::Zero(6 * static_cast<long>(lattice.mass.size()));
  for (long i = 0; i < static_cast<long>(lattice.mass.size()); ++i) {
    if (!lattice.is_gripped(i)) root.segment<3>(6 * i).setConstant(1.0 / std::sqrt(lattice.mass[i]));
    if (!lattice.cannot_turn(i)) root.segment<3>(6 * i + 3).setConstant(1.0 / std::sqrt(lattice.inertia[i]));
  }
  return root;
}

HighestMode highest_mode(const Lattice& lattice) {
  const VectorXd root = root_mobility(lattice);
  Eigen::MatrixXd k = Eigen::MatrixXd::Zero(root.size(), root.size());
  for (std::size_t b = 0; b < lattice.beam.size(); ++b) {
    const Matrix12 part = stiffness_of(lattice.beam[b]);
    const auto& e = lattice.ends[b];
    for (int r : {0, 1})
      for (int c : {0, 1}) k.block<6, 6>(6 * e[r], 6 * e[c]) += part.block<6, 6>(6 * r, 6 * c);
  }
  const Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd> solver(root.asDiagonal() * k * root.asDiagonal());
  const long last = root.size() - 1;
  return {std::sqrt(solver.eigenvalues()[last]), root.cwiseProduct(solver.eigenvectors().col(last))};
}

ModeStep step_of_mode(double omega_dt, double beta) {
  const double h = omega_dt * omega_dt;
  return {1.0 - (1.0 + beta) * h / 4.0, 1.0 + (beta - 1.0) * h / 2.0};
}

double ModeStep::growth() const {
  const double discriminant = half_trace * half_trace - determinant;
  if (discriminant <= 0.0) return 0.5 * std::log(determinant);
  return std::log(std::abs(half_trace) + std::sqrt(discriminant));
}

double ModeStep::turn() const {
  if (half_trace * half_trace < determinant) return std::acos(half_trace / std::sqrt(determinant));
  return half_trace < 0.0 ? std::numbers::pi : 0.0;
}

}  // namespace rift::lattice

#pragma once

#include "engine/lattice/lattice.hpp"

#include <Eigen/Core>

/// Dense algebra on small lattices: what the engine's iterations are compared with. Compiled once for all
/// tests, for Eigen's decompositions take long to compile.
namespace rift::lattice::hand_made {

/// K over all elements, 6 N x 6 N.
Eigen::MatrixXd dense_stiffness(const Lattice& lattice);

/// Solutions of K x = lambda M x: values ascending, vectors in columns, x^T M x = 1.
struct Modes {
  Eigen::VectorXd value;
  Eigen::MatrixXd vector;
};
Modes modes_of(const Eigen::MatrixXd& stiffness, const Eigen::MatrixXd& mass);

/// Highest omega^2 of K x = omega^2 M x over the elements not gripped.
double highest_omega_squared(const Lattice& lattice);

/// x of a x = b, with a symmetric and positive definite.
Eigen::VectorXd solution_of(const Eigen::MatrixXd& a, const Eigen::VectorXd& b);

}  // namespace rift::lattice::hand_made

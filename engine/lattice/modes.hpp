#pragma once

#include "engine/lattice/lattice.hpp"

#include <Eigen/Core>

namespace rift::lattice {

/// M^-1/2 of each degree of freedom [kg^-1/2, kg^-1/2 / m], 6 N, 0 where gripped.
Eigen::VectorXd root_mobility(const Lattice& lattice);

/// A lattice's highest mode of vibration, by dense algebra: for lattices of some hundred elements.
struct HighestMode {
  double omega = 0;       // [1/s]
  Eigen::VectorXd shape;  // 6 N, mass-normalised, zero where gripped
};
HighestMode highest_mode(const Lattice& lattice);

/// What one step of velocity Verlet does to a mode: the matrix of two rows that takes its position and its
/// speed on, as far as its eigenvalues need it [paper eqs. (1), (2)].
struct ModeStep {
  double half_trace = 0, determinant = 0;

  /// ln of the spectral radius: by how much the step lets the amplitude grow, at best 0 for beta = 1.
  double growth() const;
  /// By what angle the step turns the mode in the plane of position and speed [rad]: that of the complex
  /// eigenvalues, 0 or pi where they are real.
  double turn() const;
};

/// Determinant 1 + (beta - 1) h / 2 and trace 2 - (1 + beta) h / 2, h = (omega dt)^2.
ModeStep step_of_mode(double omega_dt, double beta);

}  // namespace rift::lattice

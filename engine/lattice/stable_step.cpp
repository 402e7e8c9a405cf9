#include "engine/lattice/stable_step.hpp"

#include <Eigen/Eigenvalues>

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>
#include <numeric>
#include <random>

namespace rift::lattice {
namespace {

constexpr double settled =
    1e-5;  // relative change of omega_max over one batch of rounds; kept as a margin, too
constexpr int batch = 50, most_batches = 40;

using Operator = std::function<void(const Eigen::VectorXd&, Eigen::VectorXd&)>;

/// How near an iteration is to its end, by how its changes have fallen from 1 towards the one that ends it.
double share_of_digits(double change, double last_change) {
  if (!(change > 0.0)) return 0.0;
  return std::clamp(std::log(change) / std::log(last_change), 0.0, 1.0);
}

/// Largest eigenvalue of a symmetric operator by Lanczos iteration (Paige 1972, without reorthogonalisation:
/// rounding only repeats eigenvalues that have converged already).
double largest_eigenvalue(const Operator& apply, long size, const base::ProgressCallback& told) {
  Eigen::VectorXd v(size), last = Eigen::VectorXd::Zero(size), w(size);
  std::mt19937_64 random(20);
  for (long k = 0; k < size; ++k) v[k] = static_cast<double>(random() >> 11) * 0x1.0p-53 - 0.5;
  v.normalize();
  std::vector<double> diagonal, off;
  double largest = 0.0, beta = 0.0, done = 0.0;
  for (int b = 0; b < most_batches; ++b) {
    for (int k = 0; k < batch; ++k) {
      base::tell_or_stop(told, done, "computing the critical step");
      apply(v, w);
      const double alpha = v.dot(w);
      w -= alpha * v + beta * last;
      diagonal.push_back(alpha);
      beta = w.norm();
      if (!(beta > 1e-14 * std::abs(alpha))) break;  // the whole of an invariant space is found
      off.push_back(beta);
      last = v;
      v = w / beta;
    }
    const long m = static_cast<long>(diagonal.size());
    Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd> tridiagonal;
    tridiagonal.computeFromTridiagonal(Eigen::Map<Eigen::VectorXd>(diagonal.data(), m),
                                       Eigen::Map<Eigen::VectorXd>(off.data(), m - 1),
                                       Eigen::EigenvaluesOnly);
    const double now = tridiagonal.eigenvalues().maxCoeff();
    const bool complete = static_cast<long>(off.size()) < m;
    if (complete || std::abs(now - largest) < 2.0 * settled * now) return now;
    done = std::max(done, share_of_digits(std::abs(now - largest) / now, 2.0 * settled));
    largest = now;
  }
  throw std::runtime_error("the lattice's highest frequency did not converge in 2000 Lanczos iterations");
}

/// 1 / sqrt(mass) per degree of freedom, 0 where gripped: turns K x = omega^2 M x into a symmetric problem.
Eigen::VectorXd inverse_root_mass(const Lattice& lattice) {
  Eigen::VectorXd root = Eigen::VectorXd::Zero(6 * static_cast<long>(lattice.mass.size()));
  for (std::size_t i = 0; i < lattice.mass.size(); ++i) {
    if (lattice.grip[i] != packing::Grip::none) continue;
    root.segment<3>(6 * static_cast<long>(i)).setConstant(1.0 / std::sqrt(lattice.mass[i]));
    root.segment<3>(6 * static_cast<long>(i) + 3).setConstant(1.0 / std::sqrt(lattice.inertia[i]));
  }
  return root;
}

std::vector<BeamRow> all_rows(const Lattice& lattice) {
  std::vector<BeamRow> rows;
  for (int b = 0; b < static_cast<int>(lattice.beam.size()); ++b) rows.push_back(row_of(lattice, b));
  return rows;
}

double step_from(double omega_squared) {
  if (!(omega_squared > 0.0)) return std::numeric_limits<double>::infinity();
  return 2.0 / std::sqrt(omega_squared);
}

/// omega^2_max <= max over beams of the largest eigenvalue of (k_beam, the beam's share of its elements'
/// masses), each element's mass shared evenly among its beams (Irons and Treharne 1971). Stretch, twist and
/// bending do not mix.
double element_bound(const Lattice& lattice) {
  std::vector<int> valence(lattice.mass.size(), 0);
  for (const auto& [i, j] : lattice.ends) ++valence[i], ++valence[j];
  double worst = 0.0;
  for (std::size_t b = 0; b < lattice.beam.size(); ++b) {
    const auto& [i, j] = lattice.ends[b];
    const Beam& beam = lattice.beam[b];
    const auto yield = [&](int e, double mass) {  // of one end to a unit load: none where gripped
      return lattice.grip[e] == packing::Grip::none ? valence[e] / mass : 0.0;
    };
    const double mi = yield(i, lattice.mass[i]), mj = yield(j, lattice.mass[j]);
    const double Ii = yield(i, lattice.inertia[i]), Ij = yield(j, lattice.inertia[j]);
    // Bending: angles a = B x with stiffness w [[2, 1], [1, 2]], so omega^2 are the eigenvalues of w
    // [[2,1],[1,2]] B M^-1 B^T.
    const double chord = (mi + mj) / (beam.length * beam.length);
    Eigen::Matrix2d stiffness, flexibility;
    stiffness << 2.0, 1.0, 1.0, 2.0;
    flexibility << chord + Ii, chord, chord, chord + Ij;
    const Eigen::Matrix2d product = beam.bending * stiffness * flexibility;
    const double half_trace = 0.5 * product.trace();
    const double bending =
        half_trace + std::sqrt(std::max(0.0, half_trace * half_trace - product.determinant()));
    worst = std::max({worst, beam.axial * (mi + mj), beam.twist * (Ii + Ij), bending});
  }
  return step_from(worst);
}

}  // namespace

StableStep stable_step(const Lattice& lattice, const base::ProgressCallback& told) {
  const Eigen::VectorXd root = inverse_root_mass(lattice);
  const std::vector<BeamRow> rows = all_rows(lattice);
  Eigen::VectorXd q(root.size());
  const Operator apply = [&](const Eigen::VectorXd& x, Eigen::VectorXd& y) {
    q = root.cwiseProduct(x);
    y.setZero();
    add_beam_forces(rows, q.data(), y.data());
    y = -root.cwiseProduct(y);
  };
  const double omega_squared = largest_eigenvalue(apply, root.size(), told);
  return {.critical = step_from(omega_squared) * (1.0 - settled), .element_bound = element_bound(lattice)};
}

double damped_critical_step(const Lattice& lattice, const ViscousDamping& damping, double undamped,
                            const base::ProgressCallback& told) {
  if (damping.beam.empty() || !std::isfinite(undamped)) return undamped;
  const Eigen::VectorXd root = inverse_root_mass(lattice);
  const std::vector<BeamRow> rows = all_rows(lattice);
  const std::vector<double> intact(lattice.beam.size(), 1.0);
  ViscousDamping scratch = damping;
  double work = 0.0;
  Eigen::VectorXd q(root.size()), rate(root.size());
  double dt = undamped, done = 0.0;
  const base::ProgressCallback tell = [&](double) { return !told || told(done); };
  // lambda(dt) grows as dt falls, so the iteration alternates about its limit; the mean of two iterates
  // contracts.
  for (int round = 0; round < 60; ++round) {
    const Operator apply = [&](const Eigen::VectorXd& x, Eigen::VectorXd& y) {
      q = root.cwiseProduct(x);
      rate = q * (2.0 / dt);
      y.setZero();
      add_beam_forces(rows, q.data(), y.data());
      add_damping_forces(scratch, rate.data(), intact.data(), dt, y.data(), work);
      y = -root.cwiseProduct(y);
    };
    const double next = step_from(largest_eigenvalue(apply, root.size(), tell));
    const double change = std::abs(next - dt);
    const bool last = change < settled * dt;
    done = std::max(done, share_of_digits(change / dt, settled));
    dt = 0.5 * (dt + next);
    if (last) break;
  }
  return dt * (1.0 - settled);
}

}  // namespace rift::lattice

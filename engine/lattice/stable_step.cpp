#include "engine/lattice/stable_step.hpp"

#include "engine/lattice/blocks.hpp"

#include <Eigen/Eigenvalues>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>
#include <random>

namespace rift::lattice {
namespace {

constexpr double settled =
    1e-5;  // relative change of omega_max over one batch of rounds; kept as a margin, too
constexpr int batch = 50, most_batches = 40;

/// How near an iteration is to its end, by how its changes have fallen from 1 towards the one that ends it.
double share_of_digits(double change, double last_change) {
  if (!(change > 0.0)) return 0.0;
  return std::clamp(std::log(change) / std::log(last_change), 0.0, 1.0);
}

/// 1 / sqrt(mass) per degree of freedom, 0 where gripped: turns K x = omega^2 M x into a symmetric problem.
Eigen::VectorXd inverse_root_mass(const Lattice& lattice) {
  Eigen::VectorXd root = Eigen::VectorXd::Zero(6 * static_cast<long>(lattice.mass.size()));
  for (std::size_t i = 0; i < lattice.mass.size(); ++i) {
    const long at = 6 * static_cast<long>(i);
    if (!lattice.is_gripped(i)) root.segment<3>(at).setConstant(1.0 / std::sqrt(lattice.mass[i]));
    if (!lattice.cannot_turn(i)) root.segment<3>(at + 3).setConstant(1.0 / std::sqrt(lattice.inertia[i]));
  }
  return root;
}

std::vector<BeamRow> all_rows(const Lattice& lattice) {
  std::vector<BeamRow> rows;
  for (int b = 0; b < static_cast<int>(lattice.beam.size()); ++b) rows.push_back(row_of(lattice, b));
  return rows;
}

/// The damping of each beam, whose rates are `rate` times its motions.
std::vector<DampingRow> damping_rows(const ViscousDamping& damping, double rate) {
  std::vector<DampingRow> rows;
  for (const DampedBeam& b : damping.beam) {
    const double alpha = rate * (b.at_surface ? damping.alpha_at_surface : damping.alpha_elsewhere);
    rows.push_back({b.i, b.j, b.axis.x(), b.axis.y(), b.axis.z(), alpha * b.axial, alpha * (b.twist - b.bend),
                    alpha * b.bend});
  }
  return rows;
}

/// M^-1/2 (K + mu C) M^-1/2 of a lattice, its elements shared out among threads. The bits of a product do not
/// depend on their number.
class Vibration {
 public:
  Vibration(const Lattice& lattice, int threads)
      : blocks_(static_cast<int>(lattice.mass.size()), threads),
        root_(inverse_root_mass(lattice)),
        moved_(root_.size()),
        beams_(shared_out(blocks_.ends(), all_rows(lattice))),
        damping_(shared_out(blocks_.ends(), std::vector<DampingRow>{})) {}
  void damp(const ViscousDamping& damping, double mu) {
    damping_ = shared_out(blocks_.ends(), damping_rows(damping, mu));
  }
  long size() const { return root_.size(); }

  void multiply(const Eigen::VectorXd& x, Eigen::VectorXd& y) {
    for_numbers([&](long k) { moved_[k] = root_[k] * x[k]; });
    blocks_.each_share([&](int s) {
      const Share<BeamRow>& share = beams_[s];
      const long first = 6L * share.begin, last = 6L * share.end;
      y.segment(first, last - first).setZero();
      add_loads(share, moved_.data(), y.data());
      add_loads(damping_[s], moved_.data(), y.data());
      for (long k = first; k < last; ++k) y[k] *= -root_[k];
    });
  }
  /// Does it with every number of a vector.
  template <class Task>
  void for_numbers(const Task& task) {
    blocks_.each_block([&](int begin, int end) {
      for (long k = 6L * begin; k < 6L * end; ++k) task(k);
    });
  }

 private:
  Blocks blocks_;
  Eigen::VectorXd root_, moved_;
  std::vector<Share<BeamRow>> beams_;
  std::vector<Share<DampingRow>> damping_;
};

/// Largest eigenvalue of a symmetric operator by Lanczos iteration (Paige 1972, without reorthogonalisation:
/// rounding only repeats eigenvalues that have converged already).
double largest_eigenvalue(Vibration& vibration, const base::ProgressCallback& told) {
  const long size = vibration.size();
  Eigen::VectorXd v(size), last = Eigen::VectorXd::Zero(size), w(size);
  std::mt19937_64 random(20);
  for (long k = 0; k < size; ++k) v[k] = static_cast<double>(random() >> 11) * 0x1.0p-53 - 0.5;
  v.normalize();
  std::vector<double> diagonal, off;
  double largest = 0.0, beta = 0.0, done = 0.0;
  for (int b = 0; b < most_batches; ++b) {
    for (int k = 0; k < batch; ++k) {
      base::tell_or_stop(told, done, "computing the critical step");
      vibration.multiply(v, w);
      const double alpha = v.dot(w);
      vibration.for_numbers([&](long n) { w[n] -= alpha * v[n] + beta * last[n]; });
      diagonal.push_back(alpha);
      beta = w.norm();
      if (!(beta > 1e-14 * std::abs(alpha))) break;  // the whole of an invariant space is found
      off.push_back(beta);
      vibration.for_numbers([&](long n) { last[n] = v[n], v[n] = w[n] / beta; });
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
    // Of one end to a unit force and to a unit moment: none where a grip holds it.
    const auto slides = [&](int e) { return lattice.is_gripped(e) ? 0.0 : valence[e] / lattice.mass[e]; };
    const auto turns = [&](int e) { return lattice.cannot_turn(e) ? 0.0 : valence[e] / lattice.inertia[e]; };
    const double mi = slides(i), mj = slides(j), Ii = turns(i), Ij = turns(j);
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

/// lambda_max(M^-1 C) <= max over beams of the largest eigenvalue of (c_beam, the beam's share of its
/// elements' masses), as in element_bound(); of a beam without damping there is no share.
double damping_bound(const Lattice& lattice, const ViscousDamping& damping) {
  const std::vector<DampingRow> rows = damping_rows(damping, 1.0);
  std::vector<int> valence(lattice.mass.size(), 0);
  for (const DampingRow& row : rows) ++valence[row.i], ++valence[row.j];
  double worst = 0.0;
  for (const DampingRow& row : rows) {
    double slides = 0.0, turns = 0.0;
    for (const int e : {row.i, row.j}) {
      if (!lattice.is_gripped(e)) slides += valence[e] / lattice.mass[e];
      if (!lattice.cannot_turn(e)) turns += valence[e] / lattice.inertia[e];
    }
    worst = std::max({worst, row.axial * slides, row.bend * turns, (row.bend + row.twist) * turns});
  }
  return worst;
}

/// The larger root of mu^2 = lambda + slope (mu - at).
double crossing_of(double lambda, double slope, double at) {
  return 0.5 * slope + std::sqrt(std::max(0.0, 0.25 * slope * slope + lambda - slope * at));
}

}  // namespace

StableStep stable_step(const Lattice& lattice, const base::ProgressCallback& told, int threads) {
  Vibration vibration(lattice, threads);
  const double omega_squared = largest_eigenvalue(vibration, told);
  return {.critical = step_from(omega_squared) * (1.0 - settled), .element_bound = element_bound(lattice)};
}

double damped_critical_step(const Lattice& lattice, const ViscousDamping& damping, double undamped,
                            const base::ProgressCallback& told, int threads) {
  if (damping.beam.empty() || !std::isfinite(undamped)) return undamped;
  constexpr int most_rounds = 60;
  const double omega = 2.0 * (1.0 - settled) / undamped, steepest = damping_bound(lattice, damping);
  Vibration vibration(lattice, threads);
  double mu = omega, done = 0.0, shown = 0.0;
  const base::ProgressCallback tell = [&](double in_round) {
    shown = std::max(shown, done + (1.0 - done) * in_round);
    return !told || told(shown);
  };
  for (int round = 0; round < most_rounds; ++round) {
    vibration.damp(damping, mu);
    const double lambda = largest_eigenvalue(vibration, tell);
    // lambda is convex in mu: beyond mu it rises at least as steeply as its chord from 0, and no more steeply
    // than `steepest`.
    const double least = crossing_of(lambda, (lambda - omega * omega) / mu, mu),
                 most = crossing_of(lambda, steepest, mu);
    if (std::min(most - least, least - mu) < settled * least) return 2.0 / least * (1.0 - settled);
    done = std::max(done, share_of_digits((least - mu) / least, settled));
    mu = least;
  }
  throw std::runtime_error("the critical step with damping did not converge");
}

}  // namespace rift::lattice

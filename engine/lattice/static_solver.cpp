#include "engine/lattice/static_solver.hpp"

#include "engine/lattice/statics.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>

namespace rift::lattice {
namespace {

constexpr double patch_edge = 6.0;  // edge in mean radii: the quickest of 4, 6, 8, 12 at 20,000

double dot_of(const Eigen::VectorXd& a, const Eigen::VectorXd& b, int begin, int end) {
  return a.segment(6L * begin, 6L * (end - begin)).dot(b.segment(6L * begin, 6L * (end - begin)));
}

}  // namespace

template <class Row>
StaticSolver<Row>::StaticSolver(const StaticRows<Row>& system, int threads)
    : blocks_(static_cast<int>(system.centre.size()), threads),
      shares_(shared_out(blocks_.ends(), system.row)),
      tie_(system.tie),
      turning_(system.turning),
      patches_(system, patch_edge * system.mean_radius) {}

template <class Row>
double StaticSolver<Row>::multiply(const Eigen::VectorXd& p, Eigen::VectorXd& kp) {
  const auto loads_on_share = [&](int s) {
    const Share<Row>& share = shares_[s];
    kp.segment(6L * share.begin, 6L * (share.end - share.begin)).setZero();
    add_loads(share, p.data(), kp.data());
    if (s == 0) kp.head<6>() -= tie_.cwiseProduct(p.head<6>());
  };
  // What the rows add are the forces that resist, -K p.
  return -blocks_.sum(loads_on_share, [&](int begin, int end) { return dot_of(p, kp, begin, end); });
}

template <class Row>
void StaticSolver<Row>::keep_in_place(Eigen::VectorXd& vector) const {
  for (const int i : turning_) vector.segment<3>(6L * i).setZero();
}

template <class Row>
Eigen::VectorXd StaticSolver<Row>::solve(const Eigen::VectorXd& load, double tolerance,
                                         const base::ProgressCallback& told) {
  // Elements that are held stand behind the others and do not move.
  const long size = load.size(), with_held = size + 6;
  const int most_iterations = static_cast<int>(2 * size);
  Eigen::VectorXd x = Eigen::VectorXd::Zero(size), r = load, z(size), kp(size);
  Eigen::VectorXd p = Eigen::VectorXd::Zero(with_held);
  keep_in_place(r);
  const double first2 = blocks_.sum([&](int begin, int end) { return dot_of(r, r, begin, end); });
  double residual2 = first2, along = 0.0, done = 0.0;
  for (iterations_ = 0; residual2 > tolerance * tolerance * first2; ++iterations_) {
    if (told) {
      const double digits = 0.5 * std::log(residual2 / first2) / std::log(tolerance);
      base::tell_or_stop(told, done = std::clamp(digits, done, 1.0), "solving the statics");
    }
    const double before = along;
    along = patches_.solve(blocks_, r, z);
    const double keep = iterations_ == 0 ? 0.0 : along / before;
    blocks_.each_block([&](int begin, int end) { patches_.advance(begin, end, z, keep, p); });
    keep_in_place(p);
    const double step = along / multiply(p, kp);
    keep_in_place(kp);
    residual2 = blocks_.sum([&](int begin, int end) {
      for (long k = 6L * begin; k < 6L * end; ++k) x[k] += step * p[k], r[k] += step * kp[k];
      return dot_of(r, r, begin, end);
    });
    if (!std::isfinite(residual2) || iterations_ == most_iterations) break;
  }
  if (!(residual2 <= tolerance * tolerance * first2))
    throw StaticsError(fmt::format(
        "the statics did not converge: relative residual {:.3g} after {} iterations (limit {:.3g})",
        std::sqrt(residual2 / first2), iterations_, tolerance));
  return x;
}

template class StaticSolver<BeamRow>;
template class StaticSolver<StiffnessRow>;

}  // namespace rift::lattice

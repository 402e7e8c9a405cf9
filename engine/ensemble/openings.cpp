#include "engine/ensemble/state.hpp"

#include <algorithm>
#include <cassert>

namespace rift::ensemble {

/// In the closed form of the kernels   [forms.hpp, Linear::energy]: with d = u_j - u_i and, across the axis,
/// s = theta_i + theta_j - (2/l) n x d and t = n.(theta_j - theta_i),
///   2 U / k_a = (n.d)^2 + (k_t / k_a) t^2 + (2 w / k_a) (3/4 s^2 + 1/4 (|theta_j - theta_i|^2 - t^2))
template <class Real>
void State::open_beams_among(int first, int last, int lane, const std::vector<double>& threshold,
                             std::vector<OpenBeam>& open) const {
  const Real* q = arrays_.q.data<Real>() + lane;
  const double* base = arrays_.base.data();
  const long stride = lanes_;
  for (int k = first; k < last; ++k) {
    const OpeningRow& b = opening_row_[k];
    const double(&n)[3] = b.axis;
    const Real *qi = q + 6L * stride * b.i, *qj = q + 6L * stride * b.j;
    const double *base_i = base + 6L * b.i, *base_j = base + 6L * b.j;
    double d[3], sum[3], difference[3];
    for (int c = 0; c < 3; ++c) {
      const double turn_i = static_cast<double>(qi[(c + 3) * stride]) + base_i[c + 3],
                   turn_j = static_cast<double>(qj[(c + 3) * stride]) + base_j[c + 3];
      d[c] = (static_cast<double>(qj[c * stride]) - static_cast<double>(qi[c * stride])) +
             (base_j[c] - base_i[c]);
      sum[c] = turn_i + turn_j, difference[c] = turn_j - turn_i;
    }
    const auto dot = [](const double* a, const double* c) { return a[0] * c[0] + a[1] * c[1] + a[2] * c[2]; };
    const double stretch = dot(n, d), t = dot(n, difference), along = dot(n, sum);
    const double across[3] = {n[1] * d[2] - n[2] * d[1], n[2] * d[0] - n[0] * d[2],
                              n[0] * d[1] - n[1] * d[0]};
    double s[3];
    for (int c = 0; c < 3; ++c) s[c] = sum[c] - along * n[c] - b.two_per_length * across[c];
    const double square = stretch * stretch + b.twist * t * t +
                          b.bending * (0.75 * dot(s, s) + 0.25 * (dot(difference, difference) - t * t));
    if (square > threshold[k] && stretch > 0.0) open.push_back({k, std::sqrt(square)});
  }
}

std::vector<State::OpenBeam> State::open_beams(int lane, const std::vector<double>& threshold) const {
  assert(options_.kinematics == lattice::Kinematics::linear);
  constexpr int worth_a_thread = 2000;  // beams
  const int count = static_cast<int>(opening_row_.size());
  const int shares = std::clamp(count / worth_a_thread, 1, threads());
  std::vector<std::vector<OpenBeam>> open(shares);
  const auto find = [&](int share) {
    const int first = static_cast<int>(static_cast<long>(count) * share / shares),
              last = static_cast<int>(static_cast<long>(count) * (share + 1) / shares);
    if (options_.precision == Precision::double_precision)
      open_beams_among<double>(first, last, lane, threshold, open[share]);
    else
      open_beams_among<float>(first, last, lane, threshold, open[share]);
  };
  threads_->run(shares, find);
  for (int share = 1; share < shares; ++share)
    open.front().insert(open.front().end(), open[share].begin(), open[share].end());
  return std::move(open.front());
}

}  // namespace rift::ensemble

#include "engine/ensemble/state.hpp"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <limits>

namespace rift::ensemble {
namespace {

/// A whole beam is looked at after a step that it began above this share of the opening which softens it. One
/// that opens by more than the rest within a step is seen a step later.
constexpr double watched_from = 0.5;

}  // namespace

/// In the closed form of the kernels   [forms.hpp, Linear::energy]: with d = u_j - u_i and, across the axis,
/// s = theta_i + theta_j - (2/l) n x d and t = n.(theta_j - theta_i),
///   2 U / k_a = (n.d)^2 + (k_t / k_a) t^2 + (2 w / k_a) (3/4 s^2 + 1/4 (|theta_j - theta_i|^2 - t^2))
template <class Real>
double State::opening_of(const OpeningRow& b, int lane) const {
  const long stride = lanes_;
  const Real* q = arrays_.q.data<Real>() + lane;
  const Real *qi = q + 6L * stride * b.i, *qj = q + 6L * stride * b.j;
  const double *base_i = arrays_.base.data() + 6L * b.i, *base_j = arrays_.base.data() + 6L * b.j;
  const double(&n)[3] = b.axis;
  double d[3], sum[3], difference[3];
  for (int c = 0; c < 3; ++c) {
    const double turn_i = static_cast<double>(qi[(c + 3) * stride]) + base_i[c + 3],
                 turn_j = static_cast<double>(qj[(c + 3) * stride]) + base_j[c + 3];
    d[c] =
        (static_cast<double>(qj[c * stride]) - static_cast<double>(qi[c * stride])) + (base_j[c] - base_i[c]);
    sum[c] = turn_i + turn_j, difference[c] = turn_j - turn_i;
  }
  const auto dot = [](const double* a, const double* c) { return a[0] * c[0] + a[1] * c[1] + a[2] * c[2]; };
  const double stretch = dot(n, d), t = dot(n, difference), along = dot(n, sum);
  if (stretch <= 0.0) return 0.0;
  const double across[3] = {n[1] * d[2] - n[2] * d[1], n[2] * d[0] - n[0] * d[2], n[0] * d[1] - n[1] * d[0]};
  double s[3];
  for (int c = 0; c < 3; ++c) s[c] = sum[c] - along * n[c] - b.two_per_length * across[c];
  return std::sqrt(stretch * stretch + b.twist * t * t +
                   b.bending * (0.75 * dot(s, s) + 0.25 * (dot(difference, difference) - t * t)));
}

double State::opening(int k, int lane) const {
  assert(options_.kinematics == lattice::Kinematics::linear);
  return options_.precision == Precision::double_precision ? opening_of<double>(opening_row_[k], lane)
                                                           : opening_of<float>(opening_row_[k], lane);
}

void State::find_base_openings() {
  if (!options_.breaking) return;
  base_opening_.clear();
  for (const fracture::DamageableBeam& d : damageable_) {
    const auto& [i, j] = lattice_->ends[d.beam];
    const lattice::Beam& beam = lattice_->beam[d.beam];
    const double energy = lattice::energy_of(beam, lattice::strain_of(beam, base_[i], base_[j]));
    base_opening_.push_back(std::sqrt(2.0 * energy / beam.axial));
  }
}

/// The walk knows the change since the base state. Openings are a norm of what is strained: that of the
/// change and that of the base state together are at least that of both.
double State::watch_above(int k, int lane) const {
  if (factor(k, lane) != 1.0) return std::numeric_limits<double>::infinity();
  const double left = watched_from * first_opening_[lane][k] - base_opening_[k];
  return left > 0.0 ? 0.5 * lattice_->beam[damageable_[k].beam].axial * left * left : -1.0;
}

void State::set_left(int k, int lane) {
  if (part_.empty() || lane >= static_cast<int>(first_opening_.size()) || first_opening_[lane].empty())
    return;
  for (const auto& part : part_) part->set_left(k, lane, factor(k, lane), watch_above(k, lane));
}

void State::add_watched(int lane, std::vector<int>& k) const {
  for (const auto& part : part_) part->add_watched(lane, k);
}

}  // namespace rift::ensemble

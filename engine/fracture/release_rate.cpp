#include "engine/fracture/release_rate.hpp"

#include "engine/base/numbers.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace rift::fracture {

namespace {

using results::RatePoint;
using results::Sample;

/// Energy that has left the lattice other than by damping and between the faces [J].
double released(const Sample& s) {
  return s.work_external_j - s.elastic_j - s.kinetic_translation_j - s.kinetic_rotation_j +
         s.step_correction_j - s.damping_j - s.numerical_damping_j - s.contact_j;
}

/// The energies at a tip position between two rows, each column interpolated.
Sample books_at(const std::vector<Sample>& lane, double tip) {
  const auto [k, part] = base::interval_at(lane, tip, &Sample::tip_m);
  const Sample &p = lane[k - 1], &q = lane[k];
  Sample s = p;
  s.tip_m = tip;
  for (double Sample::*column :
       {&Sample::elastic_j, &Sample::kinetic_translation_j, &Sample::kinetic_rotation_j,
        &Sample::step_correction_j, &Sample::fracture_j, &Sample::damping_j, &Sample::numerical_damping_j,
        &Sample::contact_j, &Sample::work_external_j})
    s.*column += part * (q.*column - p.*column);
  return s;
}

const Sample& row_nearest(const std::vector<Sample>& lane, double tip) {
  return *std::min_element(lane.begin(), lane.end(), [&](const Sample& a, const Sample& b) {
    return std::abs(a.tip_m - tip) < std::abs(b.tip_m - tip);
  });
}

}  // namespace

// The middle's: G_I0 is linear in a. Without a slope it is g_i0 to the last bit.
double mean_g_i0(const RateScale& scale, double from, double to) {
  return scale.g_i0 + scale.g_i0_slope * 0.5 * (from + to);
}

RatePoint rate_between(const Sample& from, const Sample& to, const RateScale& scale) {
  const double unit =
      scale.thickness * (to.tip_m - from.tip_m) * mean_g_i0(scale, from.tip_m, to.tip_m) * scale.tips;
  const double balance = (released(to) - released(from)) / unit;
  const double fracture = (to.fracture_j - from.fracture_j) / unit;
  const double ratio = balance + (to.damping_j - from.damping_j) / unit;
  return {.tip_m = 0.5 * (from.tip_m + to.tip_m),
          .ratio = ratio,
          .ratio_fracture = fracture,
          .ratio_paper = ratio + (to.kinetic_rotation_j - from.kinetic_rotation_j) / unit,
          .ratio_difference = balance - fracture};
}

RatePoint rate_around(const std::vector<Sample>& lane, double tip, double width, const RateScale& scale) {
  const double from = tip - 0.5 * width, to = tip + 0.5 * width;
  constexpr double none = std::numeric_limits<double>::quiet_NaN();
  if (lane.size() < 2 || from < lane.front().tip_m || to > lane.back().tip_m)
    return {
        .tip_m = tip, .ratio = none, .ratio_fracture = none, .ratio_paper = none, .ratio_difference = none};
  RatePoint rate = rate_between(books_at(lane, from), books_at(lane, to), scale);
  rate.tip_m = tip;
  return rate;
}

std::vector<RatePoint> rate_curve(const std::vector<Sample>& lane, const RateScale& scale) {
  std::vector<RatePoint> curve;
  const double half = 0.005 * scale.length;
  for (const Sample& s : lane) {
    if (s.tip_m - half < lane.front().tip_m || s.tip_m + half > lane.back().tip_m) continue;
    if (scale.g_i0_slope > 0.0 && s.tip_m < half) continue;
    curve.push_back(rate_around(lane, s.tip_m, 2.0 * half, scale));
  }
  return curve;
}

Plateau plateau_of(const std::vector<Sample>& lane, const std::array<double, 2>& window,
                   const RateScale& scale) {
  Plateau plateau;
  if (lane.empty()) return plateau;
  const Sample &first = row_nearest(lane, window[0]), &last = row_nearest(lane, window[1]);
  const double slack = 0.01 * (window[1] - window[0]);
  if (std::abs(first.tip_m - window[0]) > slack || std::abs(last.tip_m - window[1]) > slack) return plateau;
  plateau.mean = rate_between(first, last, scale);
  plateau.window_m = {first.tip_m, last.tip_m};
  plateau.reached = true;
  const Sample& middle = row_nearest(lane, 0.5 * (window[0] + window[1]));
  plateau.trend = rate_between(middle, last, scale).ratio - rate_between(first, middle, scale).ratio;
  const Sample* from = &first;
  double sum = 0.0, squares = 0.0;
  for (int k = 1; k <= sub_windows; ++k) {
    const Sample& to = row_nearest(lane, window[0] + k * (window[1] - window[0]) / sub_windows);
    const double ratio = rate_between(*from, to, scale).ratio;
    sum += ratio, squares += ratio * ratio;
    from = &to;
  }
  const double mean = sum / sub_windows;
  plateau.scatter =
      std::sqrt(std::max(0.0, squares / sub_windows - mean * mean) * sub_windows / (sub_windows - 1));
  return plateau;
}

}  // namespace rift::fracture

#include "engine/theory/strip_transient.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace rift::theory {
namespace {

struct Row {
  double v_over_cr, early, late;  // G/G_I0 over 0.2 to 0.4 and 0.4 to 0.6 of the length
};

constexpr std::array table{Row{0.1, 1.000, 0.999},  Row{0.2, 0.999, 0.999}, Row{0.3, 0.999, 0.999},
                           Row{0.4, 0.997, 0.998},  Row{0.5, 1.003, 0.999}, Row{0.6, 0.996, 0.993},
                           Row{0.7, 0.993, 1.015},  Row{0.8, 1.078, 0.960}, Row{0.9, 0.956, 1.106},
                           Row{0.95, 0.615, 0.927}, Row{1.0, 0.04, 0.04}};

/// G/G_I0 by finite differences over tenths of the height, from an advance of 2 heights on.
constexpr double arrival_from = 2.0, arrival_step = 0.1;
constexpr int arrival_stretches = 12, stretches_of_mean = 10;
struct Arrival {
  double v_over_cr;
  std::array<double, arrival_stretches> over_g_i0;
};

constexpr std::array arrivals{
    Arrival{0.3, {0.997, 1.002, 0.993, 0.999, 0.999, 0.997, 0.997, 0.995, 1.000, 0.996, 0.994, 1.001}},
    Arrival{0.5, {1.015, 0.986, 0.978, 0.980, 0.999, 1.006, 0.995, 1.004, 1.005, 0.990, 0.986, 0.988}},
    Arrival{0.7, {0.995, 0.989, 0.983, 0.973, 1.032, 1.042, 1.043, 1.038, 1.003, 0.984, 0.951, 0.937}}};

}  // namespace

std::array<TransientStretch, 2> strip_transient(double v_over_cr) {
  std::array<TransientStretch, 2> stretch{TransientStretch{0.2, 0.4}, TransientStretch{0.4, 0.6}};
  constexpr double nan = std::numeric_limits<double>::quiet_NaN();
  stretch[0].over_g_i0 = stretch[1].over_g_i0 = nan;
  if (!(v_over_cr > 0.0 && v_over_cr <= table.back().v_over_cr)) return stretch;
  const double v = std::max(v_over_cr, table.front().v_over_cr);
  const auto above =
      std::find_if(table.begin() + 1, table.end() - 1, [v](const Row& row) { return v <= row.v_over_cr; });
  const Row &a = *(above - 1), &b = *above;
  const double part = (v - a.v_over_cr) / (b.v_over_cr - a.v_over_cr);
  stretch[0].over_g_i0 = std::lerp(a.early, b.early, part);
  stretch[1].over_g_i0 = std::lerp(a.late, b.late, part);
  return stretch;
}

double strip_arrival(double v_over_cr, double from, double to) {
  constexpr double slack = 1e-9, same_velocity = 0.01;
  if (!(from >= arrival_from - slack && from < to &&
        to <= arrival_from + arrival_step * arrival_stretches + slack))
    return std::numeric_limits<double>::quiet_NaN();
  const double mean = strip_transient(v_over_cr)[1].over_g_i0;  // from 2 to 3 heights
  const auto row = std::find_if(arrivals.begin(), arrivals.end(), [v_over_cr](const Arrival& a) {
    return std::abs(a.v_over_cr - v_over_cr) <= same_velocity;
  });
  if (row == arrivals.end()) return mean;
  double sum = 0.0, whole = 0.0;
  for (int k = 0; k < arrival_stretches; ++k) {
    const double low = arrival_from + arrival_step * k, value = row->over_g_i0[static_cast<std::size_t>(k)];
    sum += value * std::max(0.0, std::min(to, low + arrival_step) - std::max(from, low));
    if (k < stretches_of_mean) whole += value / stretches_of_mean;
  }
  return mean / whole * sum / (to - from);
}

}  // namespace rift::theory

#include "engine/fracture/equation_of_motion.hpp"

#include "engine/base/numbers.hpp"

#include <algorithm>
#include <cmath>

namespace rift::fracture {
namespace {

/// What a beam counts in a window behind the tip [J].
double weighted_energy(const ReleasedBeam& beam, double tip, double window) {
  const double x = (tip - beam.position) / window;
  if (x <= 0.0 || x >= 1.0) return 0.0;
  return 6.0 * x * (1.0 - x) * beam.energy / response_to_velocity(beam.over_cr);
}

}  // namespace

double response_to_velocity(double over_cr) { return 1.0 - over_cr; }

double driving_force(const std::vector<ReleasedBeam>& released, double tip, double window, double thickness) {
  double energy = 0.0;
  for (const ReleasedBeam& beam : released) energy += weighted_energy(beam, tip, window);
  return energy / (thickness * window);
}

double driving_force_error(const std::vector<ReleasedBeam>& released, double tip, double window,
                           double thickness) {
  double squares = 0.0;
  for (const ReleasedBeam& beam : released) squares += std::pow(weighted_energy(beam, tip, window), 2);
  return std::sqrt(squares) / (thickness * window);
}

double critical_rate(const CriticalRate& toughness, double over_cr, double rayleigh_speed, double position) {
  const double at = toughness.against == CriticalRate::Against::position   ? position
                    : toughness.against == CriticalRate::Against::velocity ? over_cr * rayleigh_speed
                                                                           : over_cr;
  const auto& row = toughness.row;
  if (at <= row.front()[0]) return row.front()[1];
  if (at > row.back()[0]) return row.back()[1];
  const std::size_t k = base::interval_at(row, at, [](const auto& r) { return r[0]; }).k;
  const auto& [x0, y0] = row[k - 1];
  const auto& [x1, y1] = row[k];
  return y0 + (y1 - y0) * (at - x0) / (x1 - x0);
}

CriticalRate in_window(const CriticalRate& toughness, double tip, double window) {
  constexpr int parts = 48;
  if (toughness.against != CriticalRate::Against::position) return toughness;
  double sum = 0.0;
  for (int k = 0; k < parts; ++k) {
    const double x = (k + 0.5) / parts;
    sum += 6.0 * x * (1.0 - x) * critical_rate(toughness, 0.0, 0.0, tip - x * window) / parts;
  }
  return {toughness.against, {{tip, sum}}};
}

double velocity_over_cr(double driving, const CriticalRate& toughness, double rayleigh_speed, double position,
                        double fastest) {
  constexpr int parts = 190;  // in which a root is looked for
  const auto too_much = [&](double v) {
    return driving * response_to_velocity(v) - critical_rate(toughness, v, rayleigh_speed, position);
  };
  if (too_much(fastest) >= 0.0) return fastest;
  for (int k = parts - 1; k >= 0; --k) {
    double low = fastest * k / parts, high = fastest * (k + 1) / parts;
    if (too_much(low) < 0.0) continue;
    while (high - low > 1e-9) {
      const double middle = 0.5 * (low + high);
      (too_much(middle) >= 0.0 ? low : high) = middle;
    }
    return low;
  }
  return 0.0;
}

}  // namespace rift::fracture

#include "engine/theory/wave_loaded_crack.hpp"

#include "engine/theory/references.hpp"

#include <algorithm>
#include <numbers>

namespace rift::theory {
namespace {

/// y at x on the line through the rows, ascending in x; as at its ends beyond them.
double along(const std::vector<double>& x, const std::vector<double>& y, double at) {
  const auto above = std::upper_bound(x.begin(), x.end(), at);
  if (above == x.begin()) return y.front();
  if (above == x.end()) return y.back();
  const auto k = static_cast<std::size_t>(above - x.begin());
  return y[k - 1] + (y[k] - y[k - 1]) * (at - x[k - 1]) / (x[k] - x[k - 1]);
}

}  // namespace

double WaveLoadedCrack::time_of(double advance_m) const { return along(advance, time, advance_m); }
double WaveLoadedCrack::advance_at(double time_s) const { return along(time, advance, time_s); }

/// By the velocity as parameter: t' = tau / g(v), and a = int v dt' = v t' - int t' dv.
WaveLoadedCrack wave_loaded_crack(double young_modulus, double poisson_ratio, double density, Plane plane,
                                  double release_rate, double traction, double height) {
  constexpr int steps = 400;
  constexpr double fastest = 0.95;  // c_R
  const WaveSpeeds speed = wave_speeds(young_modulus, poisson_ratio, density, plane);
  WaveLoadedCrack crack{
      .arrival = 0.5 * height / speed.dilatational,
      .delay = std::numbers::pi * release_rate * density * speed.dilatational / (16.0 * traction * traction),
      .rayleigh = speed.rayleigh};
  double sum = 0.0, before = crack.delay;  // int t' dv over c_R; t' at the last velocity
  for (int k = 0; k <= steps; ++k) {
    const double x = fastest * k / steps;
    const double since = crack.delay / freund(x, poisson_ratio, plane).g;
    if (k > 0) sum += 0.5 * (before + since) * fastest / steps;
    before = since;
    crack.advance.push_back(speed.rayleigh * (x * since - sum));
    crack.time.push_back(crack.arrival + since);
  }
  return crack;
}

}  // namespace rift::theory

#include "engine/history/crack_history.hpp"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <limits>

namespace rift::history {
namespace {

const CrackStretch& stretch_at(const CrackHistory& history, double time) {
  const auto after = std::upper_bound(history.stretch.begin() + 1, history.stretch.end(), time,
                                      [](double t, const CrackStretch& s) { return t < s.time; });
  return *(after - 1);
}

/// How long a stretch takes for a way that is not negative [s].
double time_for(const CrackStretch& s, double way) {
  if (way <= 0.0) return 0.0;
  if (s.acceleration == 0.0) return way / s.speed;  // infinity for a tip at rest
  const double square = s.speed * s.speed + 2.0 * s.acceleration * way;
  if (square < 0.0) return std::numeric_limits<double>::infinity();
  return 2.0 * way / (s.speed + std::sqrt(square));
}

}  // namespace

CrackHistory history_of(double start, const std::vector<SpeedUntil>& pieces) {
  assert(!pieces.empty());
  CrackHistory history;
  double time = 0.0, position = start;
  for (const auto& [speed, until] : pieces) {
    history.stretch.push_back({time, position, speed});
    if (until > position) {
      time += (until - position) / speed;
      position = until;
    }
  }
  return history;
}

void turn_to(CrackHistory& history, double time, double speed) {
  const double position = tip_at(history, time);
  std::erase_if(history.stretch, [&](const CrackStretch& s) { return s.time >= time; });
  history.stretch.push_back({time, position, speed});
}

double tip_at(const CrackHistory& history, double time) {
  const CrackStretch& s = stretch_at(history, time);
  const double passed = time - s.time;
  return s.position + (s.speed + 0.5 * s.acceleration * passed) * passed;
}

double speed_at(const CrackHistory& history, double time) {
  const CrackStretch& s = stretch_at(history, time);
  return s.speed + s.acceleration * (time - s.time);
}

double highest_speed(const CrackHistory& history) {
  double highest = history.stretch.back().speed;
  for (std::size_t k = 0; k + 1 < history.stretch.size(); ++k) {
    const CrackStretch& s = history.stretch[k];
    highest = std::max({highest, s.speed, s.speed + s.acceleration * (history.stretch[k + 1].time - s.time)});
  }
  return highest;
}

double time_of_arrival(const CrackHistory& history, double position) {
  std::size_t k = 0;
  while (k + 1 < history.stretch.size() && history.stretch[k + 1].position < position) ++k;
  const CrackStretch& s = history.stretch[k];
  const double time = s.time + time_for(s, position - s.position);
  return k + 1 < history.stretch.size() ? std::min(time, history.stretch[k + 1].time) : time;
}

}  // namespace rift::history

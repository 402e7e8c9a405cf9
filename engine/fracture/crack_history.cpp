#include "engine/fracture/crack_history.hpp"

#include <cassert>

namespace rift {
namespace {

const CrackStretch& stretch_at(const CrackHistory& history, double time) {
  std::size_t k = history.stretch.size() - 1;
  while (k > 0 && history.stretch[k].time > time) --k;
  return history.stretch[k];
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
  return s.position + s.speed * (time - s.time);
}

double speed_at(const CrackHistory& history, double time) { return stretch_at(history, time).speed; }

double time_of_arrival(const CrackHistory& history, double position) {
  std::size_t k = history.stretch.size() - 1;
  while (k > 0 && history.stretch[k].position > position) --k;
  const CrackStretch& s = history.stretch[k];
  return s.time + (position - s.position) / s.speed;
}

}  // namespace rift

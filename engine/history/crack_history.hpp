#pragma once

#include <vector>

namespace rift::history {

/// A stretch of the crack's history: from `time` [s] on the tip runs from `position` [m] at `speed` [m/s],
/// which grows by `acceleration` [m/s2] and stays above or at 0.
struct CrackStretch {
  double time = 0, position = 0, speed = 0, acceleration = 0;
};

/// Tip position against time, never backward; the first stretch starts at time 0, the last has no end.
struct CrackHistory {
  std::vector<CrackStretch> stretch;
};

/// A speed [m/s] that holds until the tip reaches `until` [m].
struct SpeedUntil {
  double speed = 0, until = 0;
};

/// The history that starts at `start` [m] and keeps each speed until its position; the last one holds for
/// ever.
CrackHistory history_of(double start, const std::vector<SpeedUntil>& pieces);

/// The same until `time`, and `speed` [m/s] from then on.
void turn_to(CrackHistory& history, double time, double speed);

double tip_at(const CrackHistory& history, double time);    // [m]
double speed_at(const CrackHistory& history, double time);  // [m/s]
double highest_speed(const CrackHistory& history);          // [m/s]

/// When the tip first is at a position that is not behind the start [s]; infinity where it never comes there.
double time_of_arrival(const CrackHistory& history, double position);

}  // namespace rift::history

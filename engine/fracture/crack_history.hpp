#pragma once

#include <vector>

namespace rift {

/// A stretch of the crack's history: from `time` [s] on the tip runs from `position` [m] at `speed` [m/s].
struct CrackStretch {
  double time = 0, position = 0, speed = 0;
};

/// Tip position against time, piecewise linear; the first stretch starts at time 0.
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

double tip_at(const CrackHistory& history, double time);               // [m]
double speed_at(const CrackHistory& history, double time);             // [m/s]
double time_of_arrival(const CrackHistory& history, double position);  // [s]; position not behind the start

}  // namespace rift

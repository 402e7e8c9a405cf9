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

/// One row of a measured history: the tip was at `position` [m] at `time` [s], give or take a standard
/// `uncertainty` [m], 0 where none is known.
struct HistoryPoint {
  double time = 0, position = 0, uncertainty = 0;
  bool operator==(const HistoryPoint&) const = default;
};

enum class Smoothing { monotone, none };

/// The history of a tip, made of what was measured, in the time of the measurement.
struct SmoothedHistory {
  CrackHistory history;   // its time 0 is that of the first row
  double first_time = 0;  // [s] of the first row
  double end = 0;         // [m] where it ends
  double chi2 = 0;        // mean of ((fit - row) / uncertainty)^2, 0 where no uncertainty is known
  double scatter =
      0;  // standard deviation of the rows around the fit [m], for the degrees of freedom that it has
  double degrees_of_freedom = 0;  // that the fit has (trace of the hat matrix)
};

/// Through every row by straight lines, or (monotone) the history a(t) = start + integral of v, v >= 0 and
/// piecewise linear, that has the least of
///     sum ((a(t_i) - a_i) / u_i)^2 + lambda * integral of (dv/dt)^2 dt,
/// a penalised spline (Eilers and Marx 1996). Where uncertainties are known lambda is the largest with which
/// the rows lie as near to the fit as they say, chi2 <= 1 (Morozov 1966); else that of the least generalised
/// cross-validation (Craven and Wahba 1979).
/// @param[in] rows   at least two, in time; without smoothing never backward
/// @param[in] start  where the tip is at the first row's time [m]
SmoothedHistory smoothed_history(const std::vector<HistoryPoint>& rows, double start, Smoothing smoothing);

/// Where the tip of a history was at each row's time [m].
std::vector<double> positions_at_rows(const SmoothedHistory& course, const std::vector<HistoryPoint>& rows);

}  // namespace rift::history

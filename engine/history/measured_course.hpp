#pragma once

#include "engine/history/crack_history.hpp"

#include <vector>

namespace rift::history {

/// One row of a measured history: the tip was at `position` [m] at `time` [s], give or take a standard
/// `uncertainty` [m], 0 where none is known.
struct HistoryPoint {
  double time = 0, position = 0, uncertainty = 0;
  bool operator==(const HistoryPoint&) const = default;
};

enum class Smoothing { monotone, none };

/// How a tip went, made of what was measured, in the time of the measurement.
struct Course {
  CrackHistory history;   // its time 0 is that of the first row
  double first_time = 0;  // [s] of the first row
  double end = 0;         // [m] where it ends
  double chi2 = 0;        // mean of ((fit - row) / uncertainty)^2, 0 where no uncertainty is known
  double scatter = 0;     // standard deviation of the rows around the fit [m], for the freedoms that it has
  double freedoms = 0;    // that the fit has (trace of the hat matrix)
};

/// Through every row by straight lines, or (monotone) the course a(t) = start + integral of v, v >= 0 and
/// piecewise linear, that has the least of
///     sum ((a(t_i) - a_i) / u_i)^2 + lambda * integral of (dv/dt)^2 dt,
/// a penalised spline (Eilers and Marx 1996). Where uncertainties are known lambda is the largest with which
/// the rows lie as near to the fit as they say, chi2 <= 1 (Morozov 1966); else that of the least generalised
/// cross-validation (Craven and Wahba 1979).
/// @param[in] rows   at least two, in time; without smoothing never backward
/// @param[in] start  where the tip is at the first row's time [m]
Course course_of(const std::vector<HistoryPoint>& rows, double start, Smoothing smoothing);

/// Where the tip of a course was at each row's time [m].
std::vector<double> positions_at_rows(const Course& course, const std::vector<HistoryPoint>& rows);

}  // namespace rift::history

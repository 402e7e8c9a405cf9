#pragma once

#include "engine/scene/preset.hpp"

#include <set>
#include <string>
#include <vector>

namespace rift::scene {

/// Mistakes that show only when parameters are seen together: contradictions, an order along the crack's way,
/// sizes that do not fit. A check that would rest on a key of `invalid` (already reported) is left out.
std::vector<Issue> validate(const Preset& preset, const std::set<std::string>& invalid);

/// The keys which say otherwise what `key` says, so that a preset has one of them: layers for thickness. The
/// start of the crack is among those of a measured history, whose first row it is.
std::vector<std::string> rivals_of(const std::string& key);

// What can be wrong with the rows of [crack]: each is found row by row, at its line where a file holds it.

/// Why a record of measured times, whose first is given [s], is none from near 0 on: a clock's time stamps
/// have lost digits before they come here. Empty where it is one.
std::string clock_trouble(double first_time);

/// The middle one of the times from row to row [s]; there are at least two rows.
double median_interval(const std::vector<history::HistoryPoint>& rows);

/// A history goes forward in time, never back in position, misses no rows, and begins at crack.start. Noise
/// may look like going back where it is smoothed: by no more than three standard uncertainties.
std::vector<Issue> history_issues(const Preset& preset);

/// Velocities or positions rise, and nothing is below 0.
std::vector<Issue> toughness_issues(const Preset& preset);

/// A load curve goes forward in time, holds the crack's first moment and, where it moves the grip, all of a
/// measured history, and loads the plate then.
std::vector<Issue> load_issues(const Preset& preset);

/// Points lie in the plate, and no two neighbours at one place.
std::vector<Issue> path_issues(const Preset& preset);

/// Whether the smoothed history goes through nearly all of its rows, for which nobody gives an uncertainty:
/// noise in them is then not known.
bool follows_every_row(const Scene& scene, const history::SmoothedHistory& course);

/// What is worth a look in rows without a defect, a line each: frames that a camera seems to have missed,
/// with their times, rows whose noise is not known, and a crack path that crosses itself.
std::vector<std::string> notes_on_rows(const Preset& preset);

}  // namespace rift::scene

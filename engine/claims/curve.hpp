#pragma once

#include "engine/study/runner.hpp"

#include <string>
#include <vector>

namespace rift::claims {

using study::SummaryRow;

/// Elements of the paper's plate.
inline constexpr int paper_elements = 20000;

/// The scenarios of a study that a curve is drawn through; the defaults are the paper's progressive release.
struct Selection {
  std::string technique = "progressive";
  double relaxation = 1.0, damage_zone_ratio = 1.0;  // of a progressive release
  std::string damping_region = "none";
  int elements = 0;  // 0: those of the plate that stands for the paper's
  double length_m = 0.2;
  std::string path = "0.5 H";
  std::string dt_fraction = "-";  // as the axis shows it; "-" for the default step
};

/// Simple release of the paper, its damping in `region`.
Selection simple_release(const std::string& region = "none");

/// True where a row is of the selection; a row whose crack changes its velocity is of none.
bool selects(const Selection& selection, const SummaryRow& row);

/// Ratio at one velocity, one entry per specimen; the same number of specimens need not be at all velocities.
struct CurvePoint {
  double v = 0;                               // [c_r]
  std::vector<long> seed;                     // of the specimens, ascending
  std::vector<double> ratio;                  // ratio of each
  std::vector<double> trend;                  // of each along its window: second half less first
  double broberg = 0, freund = 0, strip = 0;  // NaN where not defined
  double wall_s = 0;                          // of all of them
};
using Curve = std::vector<CurvePoint>;

/// The ratio against velocity of the selected rows, velocities ascending. Rows without a ratio (the window
/// was not reached) are left out.
Curve curve_of(const std::vector<SummaryRow>& rows, const Selection& selection);

/// The points with from <= v <= to, a rounding error apart; and those outside.
Curve within(const Curve& curve, double from, double to);
Curve outside(const Curve& curve, double from, double to);

/// Energy that the release of one beam takes, the mean over those that the crack crosses [J].
double release_energy_per_beam(const SummaryRow& row);

/// Standard deviation of numbers; 0 of a single one, which shows none.
double scatter_of(const std::vector<double>& numbers);

/// Straight line through points by least squares, and the share of the variance it explains (R^2; 1 for
/// points on a line). NaN for less than three points.
struct Line {
  double slope = 0, r_squared = 0;
};
Line line_through(const std::vector<double>& x, const std::vector<double>& y);

// The words of a claim mean what follows, fixed before any result was seen. Each judgement tells what was
// measured, whichever way it goes.

/// "near", "agrees": mean |ratio - Broberg| over the named velocities at most this.
inline constexpr double near_margin = 0.05;
/// "too low", "too high": mean signed difference below minus this, above plus this.
inline constexpr double offset_margin = 0.03;
/// "no influence": mean |difference| at most this.
inline constexpr double influence_margin = 0.02;
/// "quasi-constant": the second half of the window less the first, mean of the specimens, at most this or
/// within two of its standard errors. What scatters along the window is the noise of single beams.
inline constexpr double constant_margin = 0.05;
inline constexpr double constant_errors = 2.0;
/// A number that the paper gives of one specimen: ours holds within one standard deviation of a single
/// specimen's, and is not decidable within two.
inline constexpr double value_errors = 1.0, undecided_errors = 2.0;

/// A margin as the report lists it, fixed before any result.
struct Margin {
  std::string words, rule, source;  // the last: the paper's text, or ours
};
std::vector<Margin> margins();

enum class Verdict { holds, does_not_hold, not_decidable };
const char* name_of(Verdict verdict);  // "holds", "does not hold", "not decidable"
inline Verdict yes_or_no(bool yes) { return yes ? Verdict::holds : Verdict::does_not_hold; }

/// A verdict and what it rests on: "0.6-1.0: mean |delta| 0.043, scatter 0.008".
struct Judgement {
  Verdict verdict = Verdict::not_decidable;
  std::string measured;
};

/// Velocities of the claims [c_r].
const std::vector<double>& claimed_velocities();

/// Mean |ratio - Broberg| of the means over specimens; the signed one; NaN of an empty curve.
double mean_distance(const Curve& curve);
double mean_offset(const Curve& curve);

/// Scatter of the specimens: standard deviation of the ratio over them, mean over the velocities that have
/// more than one; 0 where none has. A claim whose margin is below it is not decidable.
double specimen_scatter(const Curve& curve);

/// A stretch of velocities, of which every claimed one must be there.
struct Span {
  double from = 0.01, to = 1.0;
};

Judgement is_near(const Curve& curve, Span span);
Judgement is_too_low(const Curve& curve, Span span);
Judgement is_too_high(const Curve& curve, Span span);

/// Near within the span and not near outside it.
Judgement agrees_only_in(const Curve& curve, Span span);

/// Smaller mean |ratio - Broberg|. Compared specimen by specimen, those which have all the velocities in both
/// curves; not decidable where the difference scatters over the specimens more than it amounts to.
Judgement is_better(const Curve& curve, const Curve& than, Span span);

/// Mean |difference| of two curves of the same specimens.
Judgement has_no_influence(const Curve& curve, const Curve& reference, Span span);

/// |mean difference| of two curves of the same specimens at one velocity against a value of the paper's.
Judgement differs_by(const Curve& curve, const Curve& reference, double v, double value);

/// Trend of the ratio along the window, its mean over specimens beside its standard error, at one velocity.
Judgement is_quasi_constant(const CurvePoint& point);

/// The same at more than half of the velocities of the span.
Judgement is_mostly_constant(const Curve& curve, Span span);

/// Ratio at one velocity within the margin of `value`, or below it.
Judgement is_near_value(const Curve& curve, double v, double value);
Judgement is_below(const Curve& curve, double v, double value);

/// A claim of several parts: does not hold where one does not, is not decidable where one is not, else holds.
/// The labels stand before what was measured.
struct Part {
  std::string label;
  Judgement judgement;
};
Judgement all_of(const std::vector<Part>& parts);

/// "0.6-1.0"
std::string span_text(Span span);

}  // namespace rift::claims

#pragma once

#include "engine/study/runner.hpp"

#include <string>
#include <vector>

namespace rift::study {

/// Elements of the paper's plate.
inline constexpr int paper_elements = 20000;

/// Which scenarios of a study a curve is drawn through; the defaults are the paper's progressive release.
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

/// Whether a row is of the selection. A row that is null, or whose crack changes its velocity, is of none.
bool selects(const Selection& selection, const SummaryRow& row);

/// Ratio at one velocity, one entry per specimen; the same number of specimens need not be at all velocities.
struct CurvePoint {
  double v = 0;                               // [c_r]
  std::vector<long> seed;                     // of the specimens, ascending
  std::vector<double> ratio;                  // ratio_with_damping of each
  std::vector<double> plateau_scatter;        // of each over its window
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

/// Mean of numbers, and the standard deviation of a sample of them (0 for one); NaN for none.
double mean_of(const std::vector<double>& numbers);
double deviation_of(const std::vector<double>& numbers);

/// A number of a row, NaN where it is null or missing.
double number_in(const SummaryRow& row, const char* name);

/// A text of a row, empty where it is null or missing.
std::string text_in(const SummaryRow& row, const char* name);

/// The text of an axis of a row, or `absent` where the study does not name it.
std::string axis_in(const SummaryRow& row, const char* axis, const std::string& absent);

}  // namespace rift::study

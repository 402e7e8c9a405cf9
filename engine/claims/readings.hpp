#pragma once

#include "engine/claims/claims.hpp"

#include <array>
#include <string>
#include <vector>

/// Readings: what the paper leaves open of how its ratio was computed, each choice at once. Which claims hold
/// rests on them, and no verdict is picked from among them   [model.md §10].
namespace rift::claims {

enum class Kinetic { all, translation };  // energy of motion that the balance counts
/// Where the ratio is read. default_window: 0.2-0.4 L, above 0.8 c_R 0.4-0.6 L (the presets'). text: where the
/// paper says that the ratio is constant, over 0.1 L: from 0.1 L for P-NRT ("between 10 % and 20 %"), from 0.2 L
/// for S-NRT ("after an advance of 20 %"), from 0.4 L above 0.8 c_R ("about 40 %"). early: 0.1-0.2 L for all ("the
/// early stage").
enum class WindowChoice { default_window, text, early };
/// in_situ and bulk at the plate's coordination of 6; matched: bulk beams in a packing so loose that the plate is
/// as stiff as the cylinder that they were calibrated on.
enum class Beams { in_situ, bulk, matched };

struct Reading {
  Kinetic kinetic = Kinetic::all;
  std::string kinematics = "linear";
  WindowChoice window = WindowChoice::default_window;
  Beams beams = Beams::in_situ;

  bool operator==(const Reading&) const = default;
};

const char* name_of(Kinetic kinetic);
const char* name_of(WindowChoice window);
const char* name_of(Beams beams);

/// The project's: all kinetic energy, linear beams, the default window.
Reading project_reading(Beams beams);
/// The letter of the paper: kinetic energy of translation (eq. 7), beams that turn with their elements (section
/// 2.1), the windows that its text names.
Reading letter_of_paper(Beams beams);
/// "project", "letter" or nothing.
std::string title_of(const Reading& reading);

/// All combinations, beams running slowest.
std::vector<Reading> all_readings();

/// Tip positions over the length between which a reading takes the ratio of a row.
std::array<double, 2> window_of(WindowChoice window, const SummaryRow& row);

/// The ratio of a row over a window from its series: energy that left the lattice at the crack, damping counted
/// in, over b da G_I0; NaN where the series does not reach over it.
double ratio_over(const SeriesTable& series, const SummaryRow& row, Kinetic kinetic,
                  const std::array<double, 2>& window);

/// The evidence as a reading has it: the rows of its beams and kinematics, each ratio, scatter, trend and window
/// taken anew from its series (asked for).
/// @param[in] matched_coordination  of the third stiffness
Evidence evidence_under(const Evidence& all, const Reading& reading, double matched_coordination);

/// The claims that readings can decide: those judged by plates of one size, of the presets that reading_presets()
/// names.
std::vector<const Claim*> claims_of_readings();
std::vector<std::string> reading_presets();

/// All scenarios of the readings over those of a quick reproduction: linear and corotational beams, bulk and
/// in-situ at the presets' coordination, bulk at the matched one.
PaperStudy study_of_readings(const PaperStudy& quick, double matched_coordination);

/// A verdict under two readings: theirs where they agree, else that it depends, naming each.
std::string verdict_of_both(const Judgement& project, const Judgement& letter);

}  // namespace rift::claims

#pragma once

#include "engine/scene/preset.hpp"
#include "engine/study/runner.hpp"

#include <optional>
#include <string>
#include <vector>

/// Error against run time: what a scene is tried with, one thing at a time, to see what buys time and what it
/// costs in accuracy.
namespace rift::accuracy {

using study::SummaryRow;

/// A property of the scene that is varied. `together` holds combinations worth recommending.
enum class Factor { scene, time_step, precision, elements, kinematics, prestress, samples, together };
const char* name_of(Factor factor);  // "time step"

/// A way to compute the scene. Cases of one factor and label differ in the seed only.
struct Case {
  Factor factor = Factor::scene;
  std::string label;  // "0.4 of critical, single"
  scene::Scene scene;
  std::string cannot_be = {};  // why it is not tried; empty where it is
};

struct AccuracyOptions {
  bool quick = false;              // a fourth of the elements, no ramp
  std::vector<int> elements = {};  // numbers of elements to try; none: what is affordable
  int seeds = 3;                   // specimens of each number of elements
};

struct AccuracyPlan {
  scene::Preset preset;            // the scene all cases start from, at rest by the static solve
  std::vector<Case> cases;         // factor by factor; the first is the scene itself
  std::vector<std::string> notes;  // what the user should know of the choice
};

/// The cases of a preset without issues, without lanes or a study:
///   time step   0.05 to 0.98 of critical, double             each against 0.05, same lattice
///   precision   the same steps above 0.1 in single           each against double at its step
///   elements    `options.elements` or N/16, N/4, N (and 4 N where all then takes at most 150 s), always
///               N itself; several seeds of each               against the finest
///   kinematics  linear, corotational                          a difference of models
///   pre-stress  static, ramp in the paper's time for the height, or as the preset's keys say
///   samples     25 to 1,600                                   against the most
///   together    0.4 to 0.9 of critical, single, 25 samples
/// A step in seconds that the preset gives holds wherever the time step is not what is varied.
AccuracyPlan plan_accuracy(const scene::Preset& preset, const AccuracyOptions& options);

/// Seconds that a plan takes from nothing, roughly: at 100 M beam-steps/s.
double estimated_seconds(const AccuracyPlan& plan);

/// The scene `count` times, velocities 1e-6 apart: what as many lanes of equal work march.
std::vector<scene::Scene> side_by_side(const scene::Scene& scene, int count);

/// A case and what came of it.
struct CaseResult {
  Case setup;
  std::optional<SummaryRow> row;  // none where it cannot be, or is not computed yet
};

struct AccuracyRun {
  std::vector<CaseResult> results;  // in the order of the plan
  simulation::Outcome outcome = simulation::Outcome::finished;
  int computed = 0, found = 0;
};

/// Computes a plan's cases one after the other, so that each has its pass and its wall time for itself,
/// and keeps each in the folder as study::run_study() does: what is there is found. A case that cannot run
/// says why in `cannot_be`; only the first one, the scene itself, throws InputError. Progress tells how far
/// the whole plan is.
AccuracyRun run_cases(const AccuracyPlan& plan, const study::StudyOptions& options, base::Cache& cache,
                      const simulation::BuildInfo& build, const study::StudyObserver& observer);

/// A case as often as lanes side by side are fastest, in one pass: rows whose wall times are one
/// scenario's share. Empty where it was stopped.
std::vector<SummaryRow> fill_lanes(const AccuracyPlan& plan, const scene::Scene& scene,
                                   const study::StudyOptions& options, base::Cache& cache,
                                   const simulation::BuildInfo& build, const study::StudyObserver& observer);

}  // namespace rift::accuracy

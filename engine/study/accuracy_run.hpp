#pragma once

#include "engine/study/accuracy.hpp"
#include "engine/study/runner.hpp"

#include <string>
#include <vector>

namespace rift::study {

// What a number tends to as its resolution is refined, and whether that can be told.

/// A number at a resolution.
struct Level {
  double h = 0;            // step, size of an element, ...: 0 is the limit; in any unit
  double value = 0;        // [-]
  double uncertainty = 0;  // standard error of the value, 0 where it is exact but for rounding
};

/// Richardson's extrapolation from the three finest levels, where these show one order:
///   f(h) = f_0 + C h^p,  p = ln((f_3 - f_2) / (f_2 - f_1)) / ln r,  f_0 = f_1 - (f_2 - f_1) / (r^p - 1)
struct Convergence {
  bool clean = false;
  double order = 0;  // p; NaN where it is not clean
  double limit = 0;  // f_0; the finest value where it is not clean, NaN of no levels
  std::string text;  // "observed order 1.98", "no clean order: ..."
};

/// Levels in any order. The order counts as clean where the three finest are a factor r = h_2/h_1 = h_3/h_2
/// apart, both differences exceed twice their uncertainty and 1e-6, 0.5 <= p <= 4.5, and the next coarser
/// level, where it is there at the same factor, shows p within 0.5.
Convergence converge(std::vector<Level> levels);

/// A variant and what came of it.
struct Tried {
  Variant variant;
  SummaryRow row;  // null where it cannot be, or is not computed yet
};

struct AccuracyRun {
  std::vector<Tried> tried;  // in the order of the plan
  simulation::Outcome outcome = simulation::Outcome::finished;
  int computed = 0, found = 0;
};

/// Computes a plan's variants one after the other, so that each has its pass and its wall time for itself,
/// and keeps each in the folder as run_study() does: what is there is found. A variant that cannot run says
/// why in `cannot_be`; only the first one, the scene itself, throws InputError. Progress tells how far the
/// whole plan is.
AccuracyRun try_variants(const AccuracyPlan& plan, const StudyOptions& options, base::Cache& cache,
                         const simulation::BuildInfo& build, const StudyObserver& observer);

/// A variant as often as lanes side by side are fastest, in one pass: rows whose wall times are one
/// scenario's share. Empty where it was stopped.
std::vector<SummaryRow> fill_lanes(const AccuracyPlan& plan, const scene::Scene& scene,
                                   const StudyOptions& options, base::Cache& cache,
                                   const simulation::BuildInfo& build, const StudyObserver& observer);

}  // namespace rift::study

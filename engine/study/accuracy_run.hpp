#pragma once

#include "engine/study/accuracy.hpp"
#include "engine/study/runner.hpp"

#include <vector>

namespace rift::study {

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

#include "engine/study/accuracy_run.hpp"

#include "engine/study/cost.hpp"
#include "engine/study/curve.hpp"
#include "engine/study/passes.hpp"

namespace rift::study {
namespace {

/// Preparation beside the march: packing and pre-stress come from the cache for most variants.
constexpr double cached_share = 0.2;

double cost_of(const Variant& v) {
  return v.cannot_be.empty() ? estimated_cost(v.scene) + cached_share * estimated_preparation(v.scene) : 0.0;
}

scene::Preset study_of(const AccuracyPlan& plan, const std::vector<scene::Scene>& scenes) {
  scene::Preset preset = plan.preset;
  for (const scene::Scene& scene : scenes) preset.study.push_back(study_row_of(scene));
  return preset;
}

std::string reasons(const scene::InputError& error) {
  std::string text;
  for (const scene::Issue& issue : error.issues)
    text += (text.empty() ? "" : "; ") + issue.key + " " + issue.text;
  return text;
}

StudyOptions in_shared_folder(StudyOptions options) {
  options.shared = true;
  return options;
}

}  // namespace

AccuracyRun try_variants(const AccuracyPlan& plan, const StudyOptions& options, base::Cache& cache,
                         const simulation::BuildInfo& build, const StudyObserver& observer) {
  AccuracyRun run;
  double all = 0.0, before = 0.0;
  for (const Variant& v : plan.variants) all += cost_of(v);
  for (const Variant& v : plan.variants) {
    run.tried.push_back({v, nullptr});
    Tried& now = run.tried.back();
    if (!v.cannot_be.empty() || run.outcome == simulation::Outcome::stopped) continue;
    StudyObserver part;
    part.progress = [&](std::string_view stage, double done) {
      return !observer.progress || observer.progress(stage, (before + done * cost_of(v)) / all);
    };
    part.finished = [&](const SummaryRow& row, int, int) {
      if (observer.finished)
        observer.finished(row, static_cast<int>(run.tried.size()), static_cast<int>(plan.variants.size()));
    };
    try {
      const StudyResult result =
          run_study(study_of(plan, {v.scene}), in_shared_folder(options), cache, build, part);
      run.computed += result.computed, run.found += result.found;
      now.row = result.rows.front();
      if (result.outcome != simulation::Outcome::finished) run.outcome = result.outcome;
    } catch (const scene::InputError& error) {
      if (run.tried.size() == 1) throw;
      now.variant.cannot_be = reasons(error);
    }
    if (now.row.is_object() &&
        text_in(now.row, "outcome") == simulation::name_of(simulation::Outcome::diverged))
      now.variant.cannot_be = "diverged: " + text_in(now.row, "outcome_where");
    before += cost_of(v);
  }
  return run;
}

std::vector<SummaryRow> fill_lanes(const AccuracyPlan& plan, const scene::Scene& scene,
                                   const StudyOptions& options, base::Cache& cache,
                                   const simulation::BuildInfo& build, const StudyObserver& observer) {
  const int lanes = lanes_of_many(scene.solver.precision);
  const StudyResult result = run_study(study_of(plan, side_by_side(scene, lanes)), in_shared_folder(options),
                                       cache, build, observer);
  return result.outcome == simulation::Outcome::stopped ? std::vector<SummaryRow>{} : result.rows;
}

}  // namespace rift::study

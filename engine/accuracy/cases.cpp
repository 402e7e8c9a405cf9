#include "engine/accuracy/cases.hpp"

#include "engine/scene/derived.hpp"
#include "engine/scene/issue.hpp"
#include "engine/scene/parameters.hpp"
#include "engine/scene/validation.hpp"
#include "engine/scene/values_text.hpp"
#include "engine/study/plan.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <set>

namespace rift::accuracy {
namespace {

constexpr double step_fractions[] = {0.05, 0.1, 0.2, 0.4, 0.6, 0.8, 0.9, 0.98};
constexpr double least_single = 0.15, least_together = 0.35, most_together = 0.95;  // of critical
constexpr int few_samples = 25, most_samples = 1600;
constexpr int fewest_elements = 100, fewest_quick = 1000, finer = 4;
constexpr double affordable_s = 150.0;

// The paper's ramp: 20,000 + 10,000 steps of 2.35e-8 s on a plate 40 mm high with c_r = 2200 m/s [model.md
// §4]
constexpr double paper_ramp_s = 0.47e-3, paper_height_m = 0.04, paper_rayleigh_speed = 2200.0;

std::string grouped(int n) {
  std::string text = std::to_string(n);
  for (int at = static_cast<int>(text.size()) - 3; at > 0; at -= 3)
    text.insert(static_cast<std::size_t>(at), ",");
  return text;
}

std::string issues_text(const std::vector<scene::Issue>& issues) {
  std::string text;
  for (const scene::Issue& issue : issues) text += (text.empty() ? "" : "; ") + scene::without_place(issue);
  return text;
}

/// The preset with another scene; contradictions are reported as if they stood in the preset, without its own
/// values, which are not those of the scene.
std::vector<scene::Issue> contradictions_of(const scene::Preset& preset, const scene::Scene& scene) {
  scene::Preset varied = preset;
  varied.scene = scene;
  std::vector<scene::Issue> issues = scene::validate(varied, {});
  for (scene::Issue& issue : issues) issue.value.clear();
  return issues;
}

struct Planning {
  AccuracyPlan plan;
  bool quick = false;

  const scene::Scene& base() const { return plan.preset.scene; }
  void add(Factor factor, std::string label, const scene::Scene& scene) {
    plan.cases.push_back(
        {factor, std::move(label), scene, issues_text(contradictions_of(plan.preset, scene))});
  }
};

void take_quarter(Planning& p) {
  scene::Scene quarter = p.base();
  quarter.specimen.elements /= finer;
  const bool sound =
      quarter.specimen.elements >= fewest_quick && contradictions_of(p.plan.preset, quarter).empty();
  if (sound) p.plan.preset.scene = quarter;
  p.plan.notes.push_back(sound ? fmt::format("quick: the same scene with {} elements, a fourth, and no ramp",
                                             grouped(quarter.specimen.elements))
                               : std::string("quick: no ramp; a fourth of these elements would be too few"));
}

/// The scene that all cases start from.
Planning start_from(const scene::Preset& preset, bool quick) {
  Planning p{.plan = {.preset = preset, .cases = {}, .notes = {}}, .quick = quick};
  scene::Scene& scene = p.plan.preset.scene;
  p.plan.preset.study.clear();
  p.plan.preset.lanes.clear();
  scene.output.frames = 0;
  if (scene.loading.method == scene::LoadingMethod::ramp) {
    scene.loading.method = scene::LoadingMethod::static_solve;
    p.plan.notes.push_back(quick ? "the preset's ramp is left out: all variants start from the static solve"
                                 : "the preset's ramp is a variant of its own (pre-stress); all other "
                                   "variants start from the static solve");
  }
  if (quick) take_quarter(p);
  if (scene.specimen.thickness)
    p.plan.notes.push_back(
        "the preset gives a thickness, which is kept while the number of elements is varied, so the number "
        "of layers varies too");
  // A variant that sets the one must not be refused because it contradicts the other.
  if (scene.solver.dt)
    p.plan.notes.push_back(
        "the preset gives its time step in seconds, which is used wherever the step is not varied");
  p.plan.preset.origins.erase("solver.dt");
  return p;
}

scene::Scene with_step(scene::Scene scene, double fraction, ensemble::Precision precision) {
  scene.solver.dt.reset();
  scene.solver.dt_fraction = fraction;
  scene.solver.precision = precision;
  return scene;
}

std::string step_label(double fraction, ensemble::Precision precision) {
  return fmt::format("{:g} of critical{}", fraction,
                     precision == ensemble::Precision::single_precision ? ", single" : "");
}

void add_steps(Planning& p) {
  using enum ensemble::Precision;
  for (const double f : step_fractions)
    p.add(Factor::time_step, step_label(f, double_precision), with_step(p.base(), f, double_precision));
  for (const double f : step_fractions)
    if (f > least_single)
      p.add(Factor::precision, step_label(f, single_precision), with_step(p.base(), f, single_precision));
}

void add_elements(Planning& p, const std::set<int>& levels, int seeds) {
  for (const int n : levels)
    for (int k = 0; k < seeds; ++k) {
      scene::Scene scene = p.base();
      scene.specimen.elements = n;
      scene.specimen.seed += k;
      p.add(Factor::elements, grouped(n) + " elements", scene);
    }
}

void add_kinematics(Planning& p) {
  for (const lattice::Kinematics kinematics :
       {lattice::Kinematics::linear, lattice::Kinematics::corotational}) {
    scene::Scene scene = p.base();
    scene.solver.kinematics = kinematics;
    p.add(Factor::kinematics, scene::word_of("solver.kinematics", kinematics), scene);
  }
}

/// A ramp as the preset's own keys say, else in the paper's time, which grows with the height.
scene::Scene ramped(const scene::Preset& preset) {
  scene::Scene scene = preset.scene;
  scene.loading.method = scene::LoadingMethod::ramp;
  const double time = paper_ramp_s * scene.specimen.height / paper_height_m * paper_rayleigh_speed /
                      scene::rayleigh_speed(scene);
  const double wanted = std::ceil(time / study::estimated_steps(scene).step_s);
  const scene::Range allowed = scene::find_parameter("loading.ramp_steps")->range;
  if (auto issue = scene::range_issue(preset, scene,
                                      {"a ramp", wanted, allowed, "steps", {"solver.dt", "specimen.height"}}))
    throw scene::InputError({*issue});
  const int steps = static_cast<int>(wanted);
  if (!preset.origins.contains("loading.ramp_steps")) scene.loading.ramp_steps = steps;
  if (!preset.origins.contains("loading.hold_steps")) scene.loading.hold_steps = steps / 2;
  return scene;
}

void add_prestress(Planning& p) {
  if (p.quick) return;
  p.add(Factor::prestress, "static", p.base());
  const scene::Scene ramp = ramped(p.plan.preset);
  p.add(
      Factor::prestress,
      fmt::format("ramp, {} + {} steps", grouped(ramp.loading.ramp_steps), grouped(ramp.loading.hold_steps)),
      ramp);
}

void add_samples(Planning& p) {
  const std::set<int> levels = p.quick
                                   ? std::set<int>{few_samples, p.base().output.samples, most_samples}
                                   : std::set<int>{few_samples, 100, p.base().output.samples, most_samples};
  for (const int samples : levels) {
    scene::Scene scene = p.base();
    scene.output.samples = samples;
    p.add(Factor::samples, grouped(samples) + " samples", scene);
  }
}

void add_together(Planning& p) {
  for (const double f : step_fractions) {
    if (f < least_together || f > most_together) continue;
    scene::Scene scene = with_step(p.base(), f, ensemble::Precision::single_precision);
    scene.output.samples = few_samples;
    p.add(Factor::together,
          fmt::format("{}, {} samples", step_label(f, ensemble::Precision::single_precision), few_samples),
          scene);
  }
}

std::set<int> default_levels(int elements, bool quick) {
  std::set<int> levels{elements, elements / finer};
  if (!quick) levels.insert(elements / (finer * finer));
  std::erase_if(levels, [&](int n) { return n < fewest_elements && n != elements; });
  return levels;
}

AccuracyPlan planned(Planning p, const std::set<int>& levels, int seeds) {
  p.add(Factor::scene, "as it is", p.base());
  add_steps(p);
  add_elements(p, levels, seeds);
  add_kinematics(p);
  add_prestress(p);
  add_samples(p);
  add_together(p);
  return std::move(p.plan);
}

}  // namespace

const char* name_of(Factor factor) {
  constexpr const char* names[] = {"scene",      "time step",  "precision", "elements",
                                   "kinematics", "pre-stress", "samples",   "together"};
  return names[static_cast<std::size_t>(factor)];
}

AccuracyPlan plan_accuracy(const scene::Preset& preset, const AccuracyOptions& options) {
  const Planning start = start_from(preset, options.quick);
  const int elements = start.base().specimen.elements;
  if (!options.elements.empty()) {
    std::set<int> levels(options.elements.begin(), options.elements.end());
    levels.insert(elements);
    return planned(start, levels, options.seeds);
  }
  const std::set<int> levels = default_levels(elements, options.quick);
  AccuracyPlan plan = planned(start, levels, options.seeds);
  if (options.quick) return plan;
  std::set<int> more = levels;
  more.insert(finer * elements);
  AccuracyPlan longer = planned(start, more, options.seeds);
  if (estimated_seconds(longer) <= affordable_s) return longer;
  plan.notes.push_back(fmt::format("{} elements would take {:.0f} min in total; --elements includes them",
                                   grouped(finer * elements), std::ceil(estimated_seconds(longer) / 60.0)));
  return plan;
}

double estimated_seconds(const AccuracyPlan& plan) {
  double beam_steps = 0.0;
  std::set<std::string> scenarios, lattices;
  for (const Case& v : plan.cases) {
    if (!v.cannot_be.empty() || !scenarios.insert(scene::values_text(v.scene)).second) continue;
    beam_steps += study::estimated_cost(v.scene);
    const bool corotational = v.scene.solver.kinematics == lattice::Kinematics::corotational;
    const std::string lattice =
        fmt::format("{} {} {}", v.scene.specimen.elements, v.scene.specimen.seed, corotational);
    if (lattices.insert(lattice).second) beam_steps += study::estimated_preparation(v.scene);
  }
  return beam_steps / study::assumed_beam_steps_per_s;
}

std::vector<scene::Scene> side_by_side(const scene::Scene& scene, int count) {
  std::vector<scene::Scene> scenes(static_cast<std::size_t>(count), scene);
  for (std::size_t k = 0; k < scenes.size(); ++k)
    for (scene::VelocityPiece& piece : scenes[k].crack.velocity)
      piece.speed.value *= 1.0 - 1e-6 * static_cast<double>(k + 1);
  return scenes;
}

namespace {

/// Preparation beside the march: packing and pre-stress come from the cache for most cases.
constexpr double cached_share = 0.2;

double cost_of(const Case& v) {
  return v.cannot_be.empty()
             ? study::estimated_cost(v.scene) + cached_share * study::estimated_preparation(v.scene)
             : 0.0;
}

scene::Preset study_of(const AccuracyPlan& plan, const std::vector<scene::Scene>& scenes) {
  scene::Preset preset = plan.preset;
  for (const scene::Scene& scene : scenes) preset.study.push_back(study::study_row_of(scene));
  return preset;
}

study::StudyOptions in_shared_folder(study::StudyOptions options) {
  options.shared = true;
  return options;
}

}  // namespace

AccuracyRun run_cases(const AccuracyPlan& plan, const study::StudyOptions& options, base::Cache& cache,
                      const simulation::BuildInfo& build, const study::StudyObserver& observer) {
  AccuracyRun run;
  double all = 0.0, before = 0.0;
  for (const Case& v : plan.cases) all += cost_of(v);
  for (const Case& v : plan.cases) {
    run.results.push_back({v, std::nullopt});
    CaseResult& now = run.results.back();
    if (!v.cannot_be.empty() || run.outcome == simulation::Outcome::stopped) continue;
    study::StudyObserver part;
    part.progress = [&](std::string_view stage, double done) {
      return !observer.progress || observer.progress(stage, (before + done * cost_of(v)) / all);
    };
    part.finished = [&](const SummaryRow& row, int, int) {
      if (observer.finished)
        observer.finished(row, static_cast<int>(run.results.size()), static_cast<int>(plan.cases.size()));
    };
    try {
      const study::StudyResult result =
          study::run_study(study_of(plan, {v.scene}), in_shared_folder(options), cache, build, part);
      run.computed += result.computed, run.found += result.found;
      now.row = result.rows.front();
      if (result.outcome != simulation::Outcome::finished) run.outcome = result.outcome;
    } catch (const scene::InputError& error) {
      if (run.results.size() == 1) throw;
      now.setup.cannot_be = issues_text(error.issues);
    }
    if (now.row && now.row->outcome == simulation::name_of(simulation::Outcome::diverged))
      now.setup.cannot_be = "diverged: " + now.row->outcome_where;
    before += cost_of(v);
  }
  return run;
}

std::vector<SummaryRow> fill_lanes(const AccuracyPlan& plan, const scene::Scene& scene,
                                   const study::StudyOptions& options, base::Cache& cache,
                                   const simulation::BuildInfo& build, const study::StudyObserver& observer) {
  const int lanes = study::lanes_of_many(scene.solver.precision);
  const study::StudyResult result = study::run_study(study_of(plan, side_by_side(scene, lanes)),
                                                     in_shared_folder(options), cache, build, observer);
  std::vector<SummaryRow> rows;
  if (result.outcome != simulation::Outcome::stopped)
    for (const std::optional<SummaryRow>& row : result.rows)
      if (row) rows.push_back(*row);
  return rows;
}

}  // namespace rift::accuracy

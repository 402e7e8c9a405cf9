#include "engine/accuracy/cases.hpp"
#include "engine/accuracy/judgement.hpp"
#include "engine/study/plan.hpp"
#include "tests/expectations.hpp"
#include "tests/shared_cache.hpp"
#include "tests/temporary_folder.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <set>

namespace rift::accuracy {
namespace {

scene::Preset preset_of(const std::string& text) {
  scene::Preset preset = scene::read_preset_text(text, "x.toml");
  for (const scene::Issue& issue : preset.issues) ADD_FAILURE() << scene::to_text(issue);
  return preset;
}

std::vector<Case> of(const AccuracyPlan& plan, Factor factor) {
  std::vector<Case> found;
  for (const Case& v : plan.cases)
    if (v.factor == factor) found.push_back(v);
  return found;
}

std::set<int> numbers_of_elements(const AccuracyPlan& plan) {
  std::set<int> numbers;
  for (const Case& v : of(plan, Factor::elements)) numbers.insert(v.scene.specimen.elements);
  return numbers;
}

TEST(AccuracyPlan, BeginsWithTheSceneItself) {
  const AccuracyPlan plan = plan_accuracy(preset_of("[crack]\nvelocity = \"0.3 c_r\"\n"), {});
  EXPECT_EQ(plan.cases.front().factor, Factor::scene);
  EXPECT_FALSE(plan.cases.front().scene.solver.dt_fraction);
  for (const Case& v : not_empty(plan.cases)) {
    EXPECT_EQ(v.scene.output.frames, 0);
    EXPECT_EQ(v.scene.crack.velocity.front().speed.value, 0.3) << v.label;
    EXPECT_EQ(v.cannot_be, "") << v.label;
  }
}

TEST(AccuracyPlan, VariesTheStepInBothPrecisions) {
  const AccuracyPlan plan = plan_accuracy(preset_of(""), {});
  EXPECT_EQ(of(plan, Factor::time_step).front().label, "0.05 of critical");
  EXPECT_EQ(of(plan, Factor::time_step).back().label, "0.98 of critical");
  for (const Case& v : not_empty(of(plan, Factor::time_step)))
    EXPECT_EQ(v.scene.solver.precision, ensemble::Precision::double_precision);
  for (const Case& v : not_empty(of(plan, Factor::precision)))
    EXPECT_EQ(v.scene.solver.precision, ensemble::Precision::single_precision);
  EXPECT_EQ(of(plan, Factor::precision).size() + 2, of(plan, Factor::time_step).size());
}

TEST(AccuracyPlan, TakesAStepInSecondsOutWhereTheFractionIsVaried) {
  const AccuracyPlan plan = plan_accuracy(preset_of("[solver]\ndt = \"2e-8 s\"\n"), {});
  for (const Case& v : not_empty(of(plan, Factor::time_step))) {
    EXPECT_FALSE(v.scene.solver.dt);
    EXPECT_EQ(v.cannot_be, "");
  }
  for (const Case& v : not_empty(of(plan, Factor::elements))) EXPECT_EQ(v.scene.solver.dt, 2e-8);
}

TEST(AccuracyPlan, TriesElementsOnSeveralSpecimensTheScenesOwnNumberAmongThem) {
  const AccuracyPlan plan =
      plan_accuracy(preset_of("[specimen]\nseed = 7\n"), {.elements = {5000}, .seeds = 2});
  EXPECT_EQ(numbers_of_elements(plan), (std::set<int>{5000, 20000}));
  const std::vector<Case> elements = of(plan, Factor::elements);
  ASSERT_EQ(elements.size(), 4u);
  EXPECT_EQ(elements[0].scene.specimen.seed, 7);
  EXPECT_EQ(elements[1].scene.specimen.seed, 8);
  EXPECT_EQ(elements[0].label, "5,000 elements");
  EXPECT_EQ(elements[0].scene.specimen.layers, 2.0);
}

TEST(AccuracyPlan, TakesAFinerLatticeOnlyWhereThatIsAffordable) {
  const std::string half_size = "[specimen]\nlength = \"100 mm\"\nheight = \"20 mm\"\nelements = ";
  EXPECT_TRUE(numbers_of_elements(plan_accuracy(preset_of(half_size + "5000\n"), {})).contains(20000));
  const AccuracyPlan plan = plan_accuracy(preset_of("[specimen]\nelements = 80000\n"), {});
  EXPECT_FALSE(numbers_of_elements(plan).contains(320000));
  ASSERT_FALSE(plan.notes.empty());
  EXPECT_TRUE(contains(plan.notes.back(), "320,000 elements would take"));
}

TEST(AccuracyPlan, TakesARampAsAVariantAndNothingElse) {
  const AccuracyPlan plan = plan_accuracy(
      preset_of("[loading]\nmethod = \"ramp\"\nramp_steps = 7000\n[solver]\ndt = \"2e-8 s\"\n"), {});
  for (const Case& v : not_empty(plan.cases)) {
    const bool ramp = v.scene.loading.method == scene::LoadingMethod::ramp;
    EXPECT_EQ(ramp, v.factor == Factor::prestress && v.label.starts_with("ramp")) << v.label;
    EXPECT_EQ(v.scene.loading.ramp_steps, 7000);
  }
  ASSERT_FALSE(plan.notes.empty());
  EXPECT_TRUE(contains(plan.notes.front(), "the preset's ramp"));
}

TEST(AccuracyPlan, RampsInThePapersTimeWhateverTheStep) {
  const AccuracyPlan plan = plan_accuracy(preset_of("[solver]\ndt_fraction = 0.3\n"), {});
  const scene::Scene ramp = of(plan, Factor::prestress).back().scene;
  EXPECT_NEAR(ramp.loading.ramp_steps * study::estimated_steps(ramp).step_s, 0.47e-3, 1e-6);
  EXPECT_EQ(ramp.loading.hold_steps, ramp.loading.ramp_steps / 2);
}

TEST(AccuracyPlan, SaysWhyAVariantCannotBe) {
  const AccuracyPlan plan =
      plan_accuracy(preset_of("[specimen]\nthickness = \"2 mm\"\n"), {.elements = {300, 20000}, .seeds = 1});
  const std::vector<Case> elements = of(plan, Factor::elements);
  EXPECT_TRUE(elements.front().cannot_be.starts_with("specimen.thickness: is thinner than one element"))
      << elements.front().cannot_be;
  EXPECT_EQ(elements.back().cannot_be, "");
  EXPECT_TRUE(contains(plan.notes.front(), "thickness, which is kept"));
}

TEST(AccuracyPlan, QuickTakesAFourthOfTheElementsAndNoRamp) {
  const AccuracyPlan plan = plan_accuracy(preset_of(""), {.quick = true});
  EXPECT_EQ(plan.cases.front().scene.specimen.elements, 5000);
  EXPECT_EQ(numbers_of_elements(plan), (std::set<int>{1250, 5000}));
  EXPECT_TRUE(of(plan, Factor::prestress).empty());
  EXPECT_LT(estimated_seconds(plan), estimated_seconds(plan_accuracy(preset_of(""), {})) / 4.0);
  const AccuracyPlan small = plan_accuracy(preset_of("[specimen]\nelements = 1250\n"), {.quick = true});
  EXPECT_EQ(small.cases.front().scene.specimen.elements, 1250);
}

TEST(AccuracyPlan, SetsScenesSideBySideThatDifferByAHair) {
  const std::vector<scene::Scene> scenes = side_by_side(preset_of("").scene, 3);
  ASSERT_EQ(scenes.size(), 3u);
  std::set<double> speeds;
  for (const scene::Scene& scene : scenes) {
    speeds.insert(scene.crack.velocity.front().speed.value);
    EXPECT_NEAR(scene.crack.velocity.front().speed.value, 0.5, 1e-5);
  }
  EXPECT_EQ(speeds.size(), 3u);
}

/// Made-up results of a plan: order 2 in the step, order 1 in the element's size, single precision 1e-4 off,
/// specimens that scatter, corotational beams 0.05 off, a time as long as there is work.
std::vector<CaseResult> made_up(const AccuracyPlan& plan, double scatter) {
  std::vector<CaseResult> results;
  for (const Case& v : plan.cases) {
    const scene::Scene& s = v.scene;
    const double step = s.solver.dt_fraction.value_or(0.5), size = std::sqrt(1000.0 / s.specimen.elements);
    double ratio = 0.6 + 0.02 * step * step + 0.1 * size + scatter * static_cast<double>(s.specimen.seed - 2);
    if (s.solver.precision == ensemble::Precision::single_precision) ratio += 1e-4;
    if (s.solver.kinematics == lattice::Kinematics::corotational) ratio += 0.05;
    const double wall = s.specimen.elements / step * (s.output.samples > 100 ? 2e-4 : 1e-4);
    SummaryRow row;
    row.outcome = "finished";
    row.ratio = ratio, row.error_broberg = ratio - 0.52;
    row.wall_fracture_s = wall, row.wall_prestress_s = 100.0;
    row.prestress_method = s.loading.method == scene::LoadingMethod::ramp ? "ramp" : "static";
    results.push_back({v, row});
  }
  return results;
}

AccuracyPlan plan_of_tests() {
  return plan_accuracy(preset_of("[specimen]\nelements = 4000\n"), {.elements = {1000, 16000}, .seeds = 3});
}

const AccuracyLine& line_of(const Accuracy& a, Factor factor, const std::string& label) {
  const auto found = std::find_if(a.lines.begin(), a.lines.end(), [&](const AccuracyLine& line) {
    return line.factor == factor && line.label == label;
  });
  if (found == a.lines.end()) throw std::runtime_error("no line " + label);
  return *found;
}

TEST(Accuracy, ComparesStepsWithTheirLimitOnTheSameSpecimen) {
  const Accuracy a = judge_accuracy(made_up(plan_of_tests(), 0.01), 0.01);
  EXPECT_NEAR(line_of(a, Factor::time_step, "0.9 of critical").error, 0.02 * 0.81, 1e-12);
  EXPECT_NEAR(a.lines.front().error, 0.02 * 0.25, 1e-12);  // the scene's default step
  EXPECT_NEAR(a.reference.front().convergence.order, 2.0, 1e-6);
}

TEST(Accuracy, ComparesSinglePrecisionWithDoubleAtTheSameStep) {
  const Accuracy a = judge_accuracy(made_up(plan_of_tests(), 0.01), 0.01);
  EXPECT_NEAR(line_of(a, Factor::precision, "0.9 of critical, single").error, 1e-4, 1e-12);
}

TEST(Accuracy, TakesTheOrderOfTheElementsToItsLimitWhereSpecimensAgree) {
  const Accuracy a = judge_accuracy(made_up(plan_of_tests(), 1e-4), 0.01);
  const AccuracyLine& coarse = line_of(a, Factor::elements, "1,000 elements");
  EXPECT_EQ(coarse.specimens, 3);
  EXPECT_NEAR(coarse.error, 0.1, 1e-9);
  EXPECT_TRUE(coarse.resolved());
  EXPECT_NEAR(a.specimen_scatter, 1e-4, 1e-12);
}

TEST(Accuracy, DoesNotResolveWhatIsBelowTheScatterOfSpecimens) {
  const Accuracy a = judge_accuracy(made_up(plan_of_tests(), 0.2), 0.01);
  const AccuracyLine& coarse = line_of(a, Factor::elements, "1,000 elements");
  EXPECT_FALSE(coarse.resolved());
  EXPECT_NEAR(coarse.error, 0.1 * 0.75, 1e-9);  // the finest value, not its limit
  EXPECT_NEAR(coarse.uncertainty, 1.32128 * 0.2 * std::sqrt(2.0 / 3.0), 1e-6);  // of three specimens
}

TEST(Accuracy, PutsThePartsTogetherWithoutTheDeviationOfOneSpecimen) {
  const Accuracy a = judge_accuracy(made_up(plan_of_tests(), 1e-4), 0.01);
  // Step 0.02 f^2, lattice 0.1 sqrt(1000 / 4000); the specimen, 1e-4 below its kind, in neither.
  EXPECT_NEAR(line_of(a, Factor::time_step, "0.9 of critical").converged, 0.0162 + 0.05, 1e-9);
  EXPECT_NEAR(line_of(a, Factor::elements, "1,000 elements").converged, 0.005 + 0.1, 1e-9);
}

TEST(Accuracy, TellsKinematicsAsADifferenceOfModelsAndNoError) {
  const Accuracy a = judge_accuracy(made_up(plan_of_tests(), 1e-4), 0.01);
  const AccuracyLine& line = line_of(a, Factor::kinematics, "corotational");
  EXPECT_NEAR(line.error, 0.05, 1e-9);
  EXPECT_TRUE(std::isnan(line.converged));
}

TEST(Accuracy, CountsTheMarchOfARampAndNoStaticSolve) {
  const Accuracy a = judge_accuracy(made_up(plan_of_tests(), 1e-4), 0.01);
  for (const AccuracyLine& line : not_empty(a.lines))
    EXPECT_EQ(line.wall_s > 100.0, line.label.starts_with("ramp")) << line.label;
}

TEST(Accuracy, RecommendsTheCheapestWithinTheGoal) {
  const std::vector<CaseResult> results = made_up(plan_of_tests(), 1e-4);
  const Accuracy a = judge_accuracy(results, 0.01);
  ASSERT_GE(a.recommended, 0);
  // 0.6 of critical is 0.0073 off, 0.8 already 0.0129.
  EXPECT_EQ(a.lines[a.recommended].label, "0.6 of critical, single, 25 samples");
  EXPECT_EQ(judge_accuracy(results, 1e-6).recommended, -1);
  ASSERT_GT(a.front.size(), 1U);
  for (std::size_t k = 1; k < a.front.size(); ++k) {
    EXPECT_GE(a.lines[a.front[k]].wall_s, a.lines[a.front[k - 1]].wall_s);
    EXPECT_LT(std::abs(a.lines[a.front[k]].step_error), std::abs(a.lines[a.front[k - 1]].step_error));
  }
}

TEST(Accuracy, RecommendsWithTheErrorOfTheLatticeApart) {
  const std::vector<CaseResult> results = made_up(plan_of_tests(), 1e-4);
  const Accuracy a = judge_accuracy(results, 0.01);
  EXPECT_NEAR(a.lattice_error, 0.05, 1e-9);
  EXPECT_EQ(a.recommended_whole, -1);  // 16,000 elements are 0.025 off
  const int whole = judge_accuracy(results, 0.06).recommended_whole;
  ASSERT_GE(whole, 0);
  EXPECT_EQ(a.lines[whole].label, "0.6 of critical, single, 25 samples");  // 0.05 + 0.0073
}

TEST(Accuracy, LeavesOutWhatCannotBe) {
  std::vector<CaseResult> results = made_up(plan_of_tests(), 1e-4);
  for (CaseResult& t : results)
    if (t.setup.factor == Factor::together) t.row = std::nullopt, t.setup.cannot_be = "a reason";
  const Accuracy a = judge_accuracy(results, 0.06);
  EXPECT_NE(a.lines[a.recommended].factor, Factor::together);
  EXPECT_EQ(line_of(a, Factor::together, "0.6 of critical, single, 25 samples").cannot_be, "a reason");
}

const simulation::BuildInfo accuracy_build{"0.1.0", "a compiler"};

/// 500 elements, damped so much that only small steps are stable.
AccuracyPlan tiny_plan() {
  AccuracyPlan plan = plan_accuracy(preset_of(R"(
[specimen]
length = "36 mm"
height = "12 mm"
layers = 2
elements = 500
coordination = 5.6
[loading]
displacement = "0.6 mm"
[crack]
end = "16 mm"
[output]
samples = 30
window = [0.2, 0.4]
[damping]
region = "all"
alpha = 0.1
[solver]
dt_fraction = 0.5
)"),
                                    {.quick = true, .elements = {}, .seeds = 1});
  std::erase_if(plan.cases, [](const Case& v) {
    return v.factor != Factor::scene && v.label != "0.6 of critical" && v.label != "0.98 of critical";
  });
  return plan;
}

study::StudyOptions accuracy_into(const std::filesystem::path& folder) {
  study::StudyOptions options;
  options.folder = folder;
  options.threads = 1;
  return options;
}

TEST(AccuracyRun, SaysWhatCannotRunAndGoesOn) {
  const TemporaryFolder folder;
  double last = 0.0;
  study::StudyObserver observer;
  observer.progress = [&](std::string_view, double done) {
    EXPECT_GE(done, last);
    EXPECT_LE(done, 1.0);
    last = done;
    return true;
  };
  const AccuracyRun run =
      run_cases(tiny_plan(), accuracy_into(folder.path()), shared_cache(), accuracy_build, observer);
  ASSERT_EQ(run.results.size(), 3u);
  EXPECT_TRUE(run.results[0].row);
  ASSERT_TRUE(run.results[1].row);
  EXPECT_FALSE(run.results[2].row);
  EXPECT_TRUE(contains(run.results[2].setup.cannot_be, "solver.dt_fraction = 0.98: makes a step of"));
  EXPECT_EQ(run.computed, 2);
  const AccuracyRun again =
      run_cases(tiny_plan(), accuracy_into(folder.path()), shared_cache(), accuracy_build, {});
  EXPECT_EQ(again.computed, 0);
  EXPECT_EQ(to_json(again.results[1].row.value()), to_json(*run.results[1].row));  // its wall time too
}

TEST(AccuracyRun, GivesEachVariantAPassOfItsOwn) {
  const TemporaryFolder folder;
  const AccuracyRun run =
      run_cases(tiny_plan(), accuracy_into(folder.path()), shared_cache(), accuracy_build, {});
  ASSERT_TRUE(run.results.front().row);
  for (const CaseResult& t : not_empty(run.results)) EXPECT_EQ(t.row ? t.row->lanes : 1, 1);
}

TEST(AccuracyRun, ThrowsWhereTheSceneItselfCannotBe) {
  const TemporaryFolder folder;
  AccuracyPlan plan = tiny_plan();
  plan.cases.front().scene.solver.dt_fraction = 0.99;
  EXPECT_THROW(run_cases(plan, accuracy_into(folder.path()), shared_cache(), accuracy_build, {}),
               scene::InputError);
}

TEST(AccuracyRun, FillsARegisterInOnePass) {
  const TemporaryFolder folder;
  const AccuracyPlan plan = tiny_plan();
  const std::vector<SummaryRow> rows = fill_lanes(
      plan, plan.cases.front().scene, accuracy_into(folder.path()), shared_cache(), accuracy_build, {});
  ASSERT_EQ(static_cast<int>(rows.size()), study::lanes_of_many(ensemble::Precision::double_precision));
  for (const SummaryRow& row : rows) EXPECT_EQ(row.lanes, static_cast<double>(rows.size()));
}

}  // namespace
}  // namespace rift::accuracy

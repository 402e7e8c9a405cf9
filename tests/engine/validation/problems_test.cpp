#include "engine/validation/problems.hpp"

#include "engine/scene/derived.hpp"
#include "engine/theory/wave_loaded_crack.hpp"
#include "engine/validation/crack_shape.hpp"
#include "tests/shared_cache.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <filesystem>

namespace rift::validation {
namespace {

constexpr double radius = 0.4e-3;

/// Beams that are gone in threes along a line, at a speed.
void add_branch(FreeCrack& crack, Eigen::Vector2d from, Eigen::Vector2d to, double begin, double speed) {
  const double way = (to - from).norm();
  for (double s = 0.0; s <= way; s += radius)
    for (const double off : {-0.5, 0.0, 0.5})
      crack.gone.push_back(
          {begin + s / speed, from + s / way * (to - from) + Eigen::Vector2d(0, off * radius)});
}

FreeCrack plate() {
  FreeCrack crack;
  crack.length = 0.1, crack.height = 0.04, crack.thickness = 2e-3, crack.notch = 0.05;
  crack.mean_radius = radius;
  return crack;
}

TEST(CrackShape, HasTheLengthAndTheTipsOfItsBranches) {
  FreeCrack one = plate();
  add_branch(one, {0.05, 0.02}, {0.1, 0.02}, 0.0, 1000.0);
  EXPECT_EQ(shape_of(one).tips_at_edge, 1);
  EXPECT_NEAR(shape_of(one).length, 0.05, 0.001);
  FreeCrack two = plate();
  add_branch(two, {0.05, 0.02}, {0.07, 0.02}, 0.0, 1000.0);
  add_branch(two, {0.07, 0.02}, {0.1, 0.035}, 2e-5, 1000.0);
  add_branch(two, {0.07, 0.02}, {0.1, 0.005}, 2e-5, 1000.0);
  EXPECT_EQ(shape_of(two).tips_at_edge, 2);
  EXPECT_NEAR(shape_of(two).length, 0.02 + 2.0 * std::hypot(0.03, 0.015), 0.003);
  two.gone.push_back({1e-5, {0.099, 0.02}});  // two beams by themselves are no branch
  two.gone.push_back({1e-5, {0.099, 0.0201}});
  EXPECT_EQ(shape_of(two).tips_at_edge, 2);
}

TEST(CrackShape, SpeedIsTheSlopeOfTheWholeWay) {
  FreeCrack crack = plate();
  add_branch(crack, {0.05, 0.02}, {0.1, 0.02}, 1e-5, 900.0);
  EXPECT_NEAR(fitted_speed(crack, 2e-3, 15e-3), 900.0, 5.0);
  EXPECT_TRUE(std::isnan(fitted_speed(crack, 20e-3, 15e-3)));
  FreeCrack stops = plate();
  add_branch(stops, {0.05, 0.02}, {0.08, 0.02}, 1e-5, 900.0);
  EXPECT_TRUE(std::isnan(fitted_speed(stops, 2e-3, 15e-3)));
}

TEST(TimeReached, GoesByLinesOrByRows) {
  const std::vector<std::array<double, 2>> rows{{1.0, 0.0}, {2.0, 4.0}, {5.0, 10.0}};
  EXPECT_DOUBLE_EQ(time_reached(rows, 1.0), 1.25);
  EXPECT_DOUBLE_EQ(time_reached(rows, 1.0, true), 2.0);
  EXPECT_DOUBLE_EQ(time_reached(rows, 7.0), 3.5);
  EXPECT_TRUE(std::isnan(time_reached(rows, 11.0)));
  EXPECT_DOUBLE_EQ(value_at(rows, 3.5), 7.0);
  EXPECT_DOUBLE_EQ(value_at(rows, 0.0), 0.0);
  EXPECT_DOUBLE_EQ(value_at(rows, 9.0), 10.0);
}

const Problem& problem_of(const std::string& name) {
  for (const Problem& problem : problems())
    if (problem.name == name) return problem;
  throw std::invalid_argument(name);
}

scene::Preset preset_of(const std::string& name, const std::vector<std::string>& overrides = {}) {
  return scene::read_preset(std::filesystem::path(RIFT_SOURCE_DIR) / "presets" / (name + ".toml"), overrides);
}

/// A crack that runs as the exact one does, `late` times later after the waves met.
FreeCrack exact_crack(const scene::Scene& scene, double late, double energy) {
  FreeCrack crack = plate();
  crack.height = scene.specimen.height, crack.notch = scene.crack.start, crack.length = scene.specimen.length;
  crack.young_modulus = scene.material.young_modulus, crack.poisson_ratio = scene.material.poisson_ratio;
  const theory::WaveLoadedCrack theory = theory::wave_loaded_crack(
      crack.young_modulus, crack.poisson_ratio, scene::density(scene), scene.material.plane,
      scene.breaking.release_rate.value(), scene.loading.traction.value(), crack.height);
  crack.fracture.push_back({0.0, 0.0});
  for (double a = 0.0; a < 18e-3; a += 0.05e-3) {
    const double time = theory.arrival + late * (theory.time_of(a) - theory.arrival);
    for (int n = 0; n < 3; ++n) crack.gone.push_back({time, {crack.notch + a, 0.5 * crack.height}});
    crack.fracture.push_back({time, energy * scene.breaking.release_rate.value() * crack.thickness * a});
  }
  return crack;
}

TEST(Judge, FindsTheExactHistoryExactAndALateOneLate) {
  const scene::Scene scene = preset_of("freund_wave").scene;
  const Problem& problem = problem_of("freund_wave");
  const auto verdicts = [&](double late, double energy) {
    std::string all;
    for (const Finding& finding : judge(problem, scene, {exact_crack(scene, late, energy)}))
      all += std::string(name_of(finding.verdict)) + "; ";
    return all;
  };
  EXPECT_EQ(verdicts(1.0, 1.0), "holds; holds; holds; holds; reported; holds; ");
  EXPECT_EQ(verdicts(1.15, 1.0), "does not hold; holds; does not hold; holds; reported; holds; ");
  EXPECT_EQ(verdicts(1.0, 1.2), "holds; holds; holds; does not hold; reported; holds; ");
  std::vector<FreeCrack> coarse{exact_crack(scene, 1.0, 1.0)};
  coarse.front().mean_radius = 0.6e-3;
  EXPECT_EQ(judge(problem, scene, coarse).front().verdict, Verdict::not_judged);
  std::vector<FreeCrack> stops{exact_crack(scene, 1.0, 1.0), exact_crack(scene, 1.0, 1.0)};
  stops.back().gone.resize(stops.back().gone.size() / 2);  // one that does not get there counts
  EXPECT_EQ(judge(problem, scene, stops).front().verdict, Verdict::does_not_hold);
  EXPECT_NE(judge(problem, scene, stops).front().measured.find("(1 of 2)"), std::string::npos);
}

TEST(Judge, CountsTheTipsOfEachPacking) {
  const scene::Scene scene = preset_of("borden_branching").scene;
  FreeCrack branches = plate();
  add_branch(branches, {0.05, 0.02}, {0.1, 0.035}, 11e-6, 900.0);
  add_branch(branches, {0.05, 0.02}, {0.1, 0.005}, 11e-6, 900.0);
  std::stable_sort(branches.gone.begin(), branches.gone.end(),
                   [](const GoneBeam& a, const GoneBeam& b) { return a.time < b.time; });
  const double length = 2.0 * std::hypot(0.05, 0.015);
  branches.fracture = {{0.0, 0.0},
                       {60e-6, scene.breaking.release_rate.value() * branches.thickness * length}};
  FreeCrack straight = plate();
  add_branch(straight, {0.05, 0.02}, {0.1, 0.02}, 11e-6, 900.0);
  straight.fracture = {{0.0, 0.0}, {60e-6, scene.breaking.release_rate.value() * 2e-3 * 0.05}};
  const Problem& problem = problem_of("borden_branching");
  for (const Finding& finding : judge(problem, scene, {branches, branches, straight}))
    EXPECT_EQ(finding.verdict, Verdict::holds) << finding.rule << ": " << finding.measured;
  EXPECT_EQ(judge(problem, scene, {branches, straight, straight})[2].verdict, Verdict::does_not_hold);
}

// The lattice of a realisation is the same, its notch comes from the other face.
TEST(FreeCrack, OfAMirroredRealisationRunsFromItsNotchToo) {
  const scene::Scene scene = preset_of("borden_branching").scene;
  base::Cache cache = shared_cache();
  std::vector<FreeCrack> cracks;
  for (const bool mirrored : {false, true}) {
    const Realisation realisation{21, mirrored, 1000};
    const scene::Preset preset = preset_of("borden_branching", overrides_of(scene, realisation));
    ASSERT_TRUE(preset.issues.empty()) << to_text(preset.issues.front());
    cracks.push_back(run_free_cracks(preset, {preset.scene}, realisation, mirrored, cache, {}, 1).front());
    const FreeCrack& crack = cracks.back();
    ASSERT_GT(crack.gone.size(), 5U);
    EXPECT_NEAR(crack.gone.front().at.x(), crack.notch, 6.0 * crack.mean_radius);
    EXPECT_GT(tip_history(crack).back()[1], crack.notch + 0.01);
    EXPECT_LT(crack.balance_error, 1e-11);
  }
  EXPECT_NE(cracks[0].gone.front().time, cracks[1].gone.front().time);
  EXPECT_EQ(cracks[0].young_modulus, scene.material.young_modulus);
  EXPECT_NE(cracks[1].young_modulus, scene.material.young_modulus);
  EXPECT_NEAR(cracks[1].young_modulus / scene.material.young_modulus, 1.0, 0.2);
}

}  // namespace
}  // namespace rift::validation

#include "engine/calibration/calibrate.hpp"

#include "engine/base/interrupted.hpp"
#include "engine/scene/parameters.hpp"

#include <gtest/gtest.h>
#include <unistd.h>

#include <algorithm>
#include <atomic>
#include <cmath>
#include <filesystem>

namespace rift::calibration {
namespace {

scene::Scene small_scene() {
  scene::Scene scene = scene::default_scene();
  scene.specimen.shape = packing::Shape::cylinder;
  scene.calibration = {.sizes = {300, 600}, .packings = 2, .elements = 400, .radius_ratios = {0.2, 0.4, 0.8}};
  return scene;
}

TEST(Calibrate, FindsBeamsThatShowTheModulusAndPoissonsRatio) {
  base::Cache none;
  const scene::Scene scene = small_scene();
  const Calibrated c = calibrate(scene, 3e9, 0.25, none);
  EXPECT_NEAR(c.poisson_ratio.mean, 0.25, 2e-4);
  const auto pressed =
      press_cylinders(cylinders_for(scene, 400, {{c.micro.radius_ratio, c.micro.poisson_ratio}}), none);
  EXPECT_NEAR(c.micro.young_modulus * young_of(pressed).front().mean, 3e9, 1.0);
  EXPECT_NEAR(poisson_of(pressed).front().mean, 0.25, 2e-4);
  EXPECT_GT(c.radius_ratio_deviation, 0.0);
  EXPECT_LT(c.attainable[0], 0.2);
  EXPECT_GT(c.attainable[1], 0.3);
}

TEST(Calibrate, RefusesWhatNoBeamOfTheScanMakesAndSaysTheRange) {
  base::Cache none;
  try {
    calibrate(small_scene(), 3e9, 0.49, none);
    FAIL();
  } catch (const OutOfReach& error) {
    EXPECT_GT(error.attainable[1], error.attainable[0]);
    EXPECT_NE(std::string(error.what()).find("0.49 is out of reach of these beams: the cylinders show 0."),
              std::string::npos);
  }
}

TEST(PressCylinders, AreTheSameWithAnyThreadsAndFromTheCache) {
  const std::filesystem::path folder =
      std::filesystem::temp_directory_path() / ("rift_cylinders_" + std::to_string(::getpid()));
  base::Cache cache{folder, {}}, none;
  const auto tests = cylinders_for(small_scene(), 300, {{0.3, 0.3}, {0.5, 0.3}});
  const auto one = press_cylinders(tests, none, {}, 1), two = press_cylinders(tests, cache, {}, 2);
  double told = 0.0;
  const auto again = press_cylinders(tests, cache, [&](double done) {
    told = done;
    return true;
  });
  EXPECT_EQ(told, 1.0);
  ASSERT_FALSE(tests.empty());
  for (std::size_t k = 0; k < tests.size(); ++k)
    for (std::size_t b = 0; b < 2; ++b) {
      EXPECT_EQ(one[k].responses[b].young_over_micro, two[k].responses[b].young_over_micro);
      EXPECT_EQ(one[k].responses[b].young_over_micro, again[k].responses[b].young_over_micro);
      EXPECT_EQ(one[k].responses[b].ends_over_micro, again[k].responses[b].ends_over_micro);
      EXPECT_EQ(one[k].responses[b].poisson_ratio, again[k].responses[b].poisson_ratio);
      EXPECT_EQ(one[k].core_coordination, again[k].core_coordination);
    }
  std::filesystem::remove_all(folder);
}

TEST(PressCylinders, StopWhenToldTo) {
  base::Cache none;
  EXPECT_THROW(press_cylinders(cylinders_for(small_scene(), 300, {{}}), none, [](double) { return false; }),
               base::Interrupted);
}

TEST(CylindersFor, HaveSeedsThatFollowAndTheSpecimensPacking) {
  scene::Scene scene = small_scene();
  scene.specimen.seed = 7, scene.specimen.coordination = 6.2;
  const auto tests = cylinders_for(scene, 300, {{}});
  ASSERT_EQ(tests.size(), 2u);
  EXPECT_EQ(tests[0].packing.seed, 7u);
  EXPECT_EQ(tests[1].packing.seed, 8u);
  EXPECT_EQ(tests[0].packing.coordination, 6.2);
  EXPECT_EQ(tests[0].packing.box.height, 2.0 * tests[0].packing.box.length);
}

TEST(CalibrationStudy, HasARowForEveryResult) {
  base::Cache none;
  const auto rows = rows_of(study_calibration(small_scene(), none, {}, 0));
  // sizes 2 x 2, scan 2 x 3, twisted 2 x 2, boxes 2 x 2
  ASSERT_EQ(rows.size(), 4u + 6 + 4 + 4);
  EXPECT_EQ(std::ranges::count(rows, "box",
                               [](const auto& r) { return r.at("series").template get<std::string>(); }),
            4);
  for (const auto& row : rows) EXPECT_GT(row.at("young_over_micro").get<double>(), 0.0);
}

TEST(Scattered, IsTheMeanAndTheDeviationOfOne) {
  const Scattered s = scattered({1.0, 2.0, 3.0});
  EXPECT_DOUBLE_EQ(s.mean, 2.0);
  EXPECT_DOUBLE_EQ(s.deviation, 1.0);
  EXPECT_TRUE(std::isnan(scattered({1.0}).deviation));
}

}  // namespace
}  // namespace rift::calibration

#include "engine/claims/readings.hpp"

#include "engine/scene/preset.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>

namespace rift::claims {
namespace {

constexpr double length = 0.2, thickness = 0.002, g_i0 = 500.0;

SummaryRow row_of(const char* technique, double v) {
  SummaryRow row;
  row.crack_velocity_over_cr = v, row.technique = technique, row.relaxation = 1, row.damage_zone_ratio = 1;
  row.damping_region = "none", row.stiffness = "in-situ", row.kinematics = "linear", row.coordination = 6.0;
  row.seed = 1, row.elements = 5000, row.length_m = length, row.thickness_m = thickness;
  row.g_i0_j_m2 = g_i0, row.broberg = 0.5, row.window_over_length = {0.2, 0.4};
  return row;
}

/// Up to 0.15 L the crack takes `early` of G_I0, then `late`; rotation holds 0.1 of what has arrived.
SeriesTable series_of(double early, double late) {
  SeriesTable s;
  for (int k = 0; k <= 100; ++k) {
    const double tip = 0.005 * k * length, corner = 0.15 * length;
    const double taken = thickness * g_i0 * (early * std::min(tip, corner) + late * std::max(0.0, tip - corner));
    const double turning = 0.1 * thickness * g_i0 * tip;
    s.phase.emplace_back("fracture");
    s.column["tip_m"].push_back(tip);
    s.column["energy_elastic_j"].push_back(100.0 - taken - turning);
    s.column["energy_kinetic_rotation_j"].push_back(turning);
    for (const char* name : {"energy_kinetic_translation_j", "energy_step_correction_j", "work_external_j",
                             "energy_numerical_damping_j", "energy_contact_j"})
      s.column[name].push_back(0.0);
  }
  return s;
}

TEST(Reading, TakesTheRatioOverAWindowWithOrWithoutRotation) {
  const SummaryRow row = row_of("progressive", 0.5);
  const SeriesTable series = series_of(0.8, 0.6);
  EXPECT_NEAR(ratio_over(series, row, Kinetic::all, {0.2, 0.4}), 0.6, 1e-9);
  EXPECT_NEAR(ratio_over(series, row, Kinetic::translation, {0.2, 0.4}), 0.7, 1e-9);
  EXPECT_NEAR(ratio_over(series, row, Kinetic::all, {0.1, 0.2}), 0.7, 1e-9);
  EXPECT_TRUE(std::isnan(ratio_over(series, row, Kinetic::all, {0.4, 0.6})));
}

TEST(Reading, HasTheWindowsThatTheTextNames) {
  using Window = std::array<double, 2>;
  EXPECT_EQ(window_of(WindowChoice::text, row_of("progressive", 0.8)), (Window{0.1, 0.2}));
  EXPECT_EQ(window_of(WindowChoice::text, row_of("simple", 0.5)), (Window{0.2, 0.3}));
  EXPECT_EQ(window_of(WindowChoice::text, row_of("simple", 0.9)), (Window{0.4, 0.5}));
  EXPECT_EQ(window_of(WindowChoice::early, row_of("simple", 1.0)), (Window{0.1, 0.2}));
  EXPECT_EQ(window_of(WindowChoice::default_window, row_of("simple", 1.0)), (Window{0.2, 0.4}));
}

TEST(Reading, SeesRowsOfItsBeamsAndKinematicsOnly) {
  SummaryRow bulk = row_of("progressive", 0.5), loose = bulk, turned = bulk;
  bulk.stiffness = loose.stiffness = "bulk", loose.coordination = 5.03, turned.kinematics = "corotational";
  const Evidence all{.rows = {row_of("progressive", 0.5), bulk, loose, turned},
                     .series = [](const SummaryRow&) { return series_of(0.8, 0.6); }};
  const auto seen = [&](const Reading& reading) { return evidence_under(all, reading, 5.0).rows; };
  for (const Beams beams : {Beams::in_situ, Beams::bulk, Beams::matched})
    EXPECT_EQ(seen(project_reading(beams)).size(), 1U) << name_of(beams);
  EXPECT_NEAR(seen(project_reading(Beams::matched)).front().coordination, 5.03, 1e-12);
  const std::vector<SummaryRow> letter = seen(letter_of_paper(Beams::in_situ));
  ASSERT_EQ(letter.size(), 1U);
  EXPECT_NEAR(letter.front().ratio, 0.8, 1e-9);        // 0.1-0.2 L, rotation not counted
  EXPECT_NEAR(letter.front().ratio_trend, -0.2, 1e-9);
  EXPECT_NEAR(letter.front().error_broberg, 0.3, 1e-9);
}

TEST(Reading, IsOneOfAllThatThePaperLeavesOpen) {
  const std::vector<Reading> all = all_readings();
  EXPECT_EQ(all.size(), 36U);
  for (const Beams beams : {Beams::in_situ, Beams::bulk, Beams::matched})
    for (const Reading& one : {project_reading(beams), letter_of_paper(beams)})
      EXPECT_EQ(std::count(all.begin(), all.end(), one), 1);
}

TEST(Reading, AVerdictThatDiffersDependsOnIt) {
  const Judgement yes{Verdict::holds, ""}, no{Verdict::does_not_hold, ""};
  EXPECT_EQ(verdict_of_both(yes, yes), "holds");
  EXPECT_EQ(verdict_of_both(yes, no),
            "depends on the reading: holds by the project's, does not hold by the paper's letter");
}

TEST(Readings, DoubleTheKinematicsAndTripleTheBeams) {
  scene::Preset preset = scene::read_preset_text(
      "[study]\nseed = [1, 2]\ncrack_velocity = [\"0.5 c_r\"]\nstiffness = [\"bulk\", \"in-situ\"]\n", "x.toml");
  ASSERT_TRUE(preset.issues.empty());
  const PaperStudy study = study_of_readings(merge_presets({{"a", preset}}, Effort::quick), 5.1);
  EXPECT_EQ(study.preset.study.size(), 2U * 2U * 3U);
  EXPECT_EQ(std::count_if(study.preset.study.begin(), study.preset.study.end(),
                          [](const auto& row) { return row.scene.specimen.coordination == 5.1; }),
            4);
}

}  // namespace
}  // namespace rift::claims

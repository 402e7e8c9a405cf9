#include "studio/text/run_table.hpp"

#include "tests/studio/run_rift.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace rift::studio {
namespace {

/// A finished run of the quickstart's kind.
results::LaneSummary finished() {
  results::LaneSummary s;
  s.crack_velocity_over_cr = 0.5, s.crack_course = "constant", s.tips = 1;
  s.technique = "progressive", s.relaxation_name = "linear", s.damage_zone_ratio = 1;
  s.damping_region = "none", s.stiffness = "in-situ", s.prestress_method = "static";
  s.elements = 5000, s.beams = 15027, s.beams_crossed = 424, s.rattlers = 1, s.coordination = 6.011;
  s.mean_radius_m = 4.884e-4, s.micro_young_modulus_pa = 202.4e9, s.density_kg_m3 = 667.1;
  s.dt_s = 7.001e-8, s.dt_fraction = 0.5, s.steps = 786, s.steps_per_beam = 6.3;
  s.g_i0_reference = "strip", s.g_i0_j_m2 = 274730, s.g_id_j_m2 = 155360;
  s.ratio = s.ratio_fracture = 0.566;
  s.ratio_paper = 0.666, s.ratio_scatter = 0.088;
  s.window_over_length = {0.2, 0.4};
  s.echo_free_over_length = 0.056, s.broberg = 0.520, s.freund = 0.525, s.strip = 1;
  s.energy_initial_j = 54.32, s.energy_elastic_j = 29.22, s.energy_kinetic_translation_j = 7.2;
  s.energy_kinetic_rotation_j = 0.1, s.energy_fracture_j = 17.91, s.energy_damping_j = 0;
  s.energy_numerical_damping_j = 0, s.ledger_residual = 4e-14, s.ledger_limit = 1e-10, s.ledger_closes = true;
  s.outcome = "finished";
  return s;
}

results::LaneSummary stopped() {
  results::LaneSummary s = finished();
  s.outcome = "stopped", s.outcome_where = "step 100";
  s.ratio = s.ratio_fracture = s.ratio_paper = s.ratio_scatter = NAN;
  s.g_id_j_m2 = NAN;
  return s;
}

TEST(RunTable, SaysWhatTheScatterIsAndGivesBothRatesInOneUnit) {
  const std::string text = run_table(finished(), false);
  EXPECT_TRUE(contains(text, "0.566 ± 0.088 along the window, tip at 0.2 to 0.4 of the length\n")) << text;
  EXPECT_TRUE(contains(text, "274.73 kJ/m² of the strip   G_ID 155.36 kJ/m²\n"));
  EXPECT_TRUE(contains(text, "  balance error         4.0e-14 of the largest energy, limit 1e-10\n"));
  EXPECT_TRUE(contains(text, "0.5 c_R, progressive release"));
  EXPECT_TRUE(contains(text, "6.3 steps per beam release"));
}

TEST(RunTable, CountsOneRattlerAndSeveral) {
  results::LaneSummary s = finished();
  EXPECT_TRUE(contains(run_table(s, false), ", 1 rattler, "));
  s.rattlers = 12;
  EXPECT_TRUE(contains(run_table(s, false), ", 12 rattlers, "));
}

TEST(RunTable, SaysWhyARatioIsNotDefined) {
  const std::string text = run_table(stopped(), false);
  EXPECT_TRUE(
      contains(text,
               "G_ID / G_I0           not defined: the run was stopped before the tip had crossed the "
               "measuring window, 0.2 to 0.4 of the length\n"))
      << text;
  EXPECT_FALSE(contains(text, "G_ID -"));
  EXPECT_FALSE(contains(text, "±"));
  results::LaneSummary steered = stopped();
  steered.outcome = "finished", steered.steering = {{10, "crack_velocity", "0.3 c_r"}};
  EXPECT_TRUE(contains(run_table(steered, false), "not defined: the run was steered while the tip crossed"));
  results::LaneSummary diverged = stopped();
  diverged.outcome = "diverged";
  EXPECT_TRUE(contains(run_table(diverged, false), "not defined: the run diverged before"));
}

TEST(RunTable, SaysWhereTheoryDoesNotApplyAndLeavesOutAnUnknownReflection) {
  results::LaneSummary s = finished();
  EXPECT_TRUE(contains(run_table(s, false), "first boundary reflection reaches the tip at 0.056"));
  s.crack_velocity_over_cr = s.broberg = s.freund = s.strip = s.echo_free_over_length = NAN;
  s.crack_course = "by itself", s.arrest_m = 0.04;
  const std::string text = run_table(s, false);
  EXPECT_TRUE(contains(text, "predicted velocity, arrested at 40 mm, progressive release")) << text;
  EXPECT_TRUE(contains(text, "theory                not defined: it needs a constant velocity up to c_R\n"));
  EXPECT_FALSE(contains(text, "reflection"));
}

TEST(RunTable, HasNoNegativeZero) {
  results::LaneSummary s = finished();
  s.friction = 0, s.energy_contact_j = -1e-9, s.energy_damping_j = -1e-12;
  const std::string text = run_table(s, false);
  EXPECT_TRUE(contains(text, "0.00 damping, 0.00 contact of the faces")) << text;
  EXPECT_FALSE(contains(text, "-0.00"));
}

TEST(RunTable, SaysThatABalanceDoesNotClose) {
  results::LaneSummary s = finished();
  s.ledger_residual = 3e-3, s.ledger_closes = false;
  EXPECT_TRUE(contains(run_table(s, false),
                       "3.0e-03 of the largest energy, limit 1e-10: THE ENERGY BALANCE DOES NOT CLOSE\n"));
  EXPECT_TRUE(contains(run_table(s, true), "\x1b[31m3.0e-03"));
}

TEST(RunTable, SaysByWhichClockAMeasuredHistoryGoes) {
  results::LaneSummary lane = finished();
  EXPECT_EQ(run_table(lane, false).find("clock"), std::string::npos);
  lane.history_clock_s = -31.18e-6;
  EXPECT_NE(run_table(lane, false).find("time of the measured history = time of the run \u2212 31.18 µs"),
            std::string::npos)
      << run_table(lane, false);
  EXPECT_EQ(history_clock_text(4e-6), "time of the measured history = time of the run + 4 µs");
}

}  // namespace
}  // namespace rift::studio

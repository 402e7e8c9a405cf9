#include "engine/results/lane_summary.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <set>
#include <string>
#include <vector>

namespace rift::results {
namespace {

using Json = nlohmann::ordered_json;

/// A summary in which every column holds something else.
LaneSummary filled(const char* course = "by itself") {
  LaneSummary s;
  double next = 0.5;
  for (const SummaryColumn& column : summary_columns()) {
    next += 1.0;
    if (const auto* number = std::get_if<double LaneSummary::*>(&column.member)) s.** number = next;
    if (const auto* whole = std::get_if<WholeNumber>(&column.member)) s.*whole->member = std::floor(next);
    if (const auto* text = std::get_if<std::string LaneSummary::*>(&column.member)) s.** text = column.name;
    if (const auto* truth = std::get_if<bool LaneSummary::*>(&column.member)) s.** truth = true;
    if (const auto* list = std::get_if<std::vector<double> LaneSummary::*>(&column.member))
      s.** list = {next, NAN};
  }
  s.window_over_length = {0.25, 0.75};
  s.left_out = {"damping", "gauges"};
  s.steering = {{21, "crack_velocity", "0.3 c_r"}};
  s.crack_course = course;
  return s;
}

/// The columns that such a crack has.
std::vector<std::string> columns_of(const LaneSummary& s) {
  std::vector<std::string> names;
  for (const SummaryColumn& column : summary_columns())
    if (!column.is_there || column.is_there(s)) names.emplace_back(column.name);
  return names;
}

class LaneSummaryOf : public testing::TestWithParam<const char*> {};

TEST_P(LaneSummaryOf, IsReadBackAsItWasWritten) {
  const Json json = to_json(filled(GetParam()));
  EXPECT_EQ(json.size(), columns_of(filled(GetParam())).size());
  EXPECT_EQ(to_json(lane_summary_of(Json::parse(json.dump()))), Json::parse(json.dump()));
}

TEST_P(LaneSummaryOf, HasItsColumnsInTheirOrderThoseOfTheScenarioFirst) {
  std::vector<std::string> names;
  const Json json = to_json(filled(GetParam()));
  for (const auto& [name, value] : json.items()) names.push_back(name);
  EXPECT_EQ(names, columns_of(filled(GetParam())));
  EXPECT_EQ(std::set<std::string>(names.begin(), names.end()).size(), names.size());
  EXPECT_EQ(std::string(scenario_columns().back().name), "seed");
  EXPECT_EQ(to_json(filled(GetParam()), scenario_columns()).size(), scenario_columns().size());
}

INSTANTIATE_TEST_SUITE_P(Cracks, LaneSummaryOf, testing::Values("by itself", "free"),
                         [](const auto& course) { return course.index == 0 ? "Predicted" : "Free"; });

TEST(LaneSummary, OfVersion01IsReadUnderThePresentNames) {
  const LaneSummary s = lane_summary_of(Json{{"ratio", 0.340},
                                             {"ratio_release", 0.341},
                                             {"ratio_with_damping", 0.374},
                                             {"ratio_translation_only", 0.350}});
  EXPECT_EQ(s.ratio, 0.374);
  EXPECT_EQ(s.ratio_fracture, 0.341);
  EXPECT_NEAR(s.ratio_paper, 0.350 + 0.034, 1e-15);
  EXPECT_NEAR(s.ratio_difference, -0.001, 1e-15);
}

TEST(LaneSummary, WritesNullForWhatIsUndefinedAndWholeNumbersWithoutAFraction) {
  LaneSummary s;
  s.elements = 20000, s.beta = 1.0, s.dt_critical_damped_s = INFINITY;
  const Json json = to_json(s);
  EXPECT_EQ(json.at("elements").dump(), "20000");
  EXPECT_EQ(json.at("beta").dump(), "1.0");
  EXPECT_TRUE(json.at("ratio").is_null());
  EXPECT_TRUE(json.at("dt_critical_damped_s").is_null());
  EXPECT_TRUE(json.at("outcome_where").is_null());
  EXPECT_EQ(json.at("wake_cell_m"), Json::array());
}

TEST(LaneSummary, HasFrictionSteeringAndArrestOnlyWhereTheyAre) {
  LaneSummary s;
  for (const char* name : {"friction", "steering", "arrest_m"})
    EXPECT_FALSE(to_json(s).contains(name)) << name;
  s.friction = 0.0, s.steering = {{1, "beta", "0.9"}}, s.crack_course = "by itself";
  EXPECT_EQ(to_json(s).at("friction"), 0.0);
  EXPECT_EQ(to_json(s).at("steering").at(0).at("step"), 1);
  EXPECT_TRUE(to_json(s).at("arrest_m").is_null());
}

TEST(LaneSummary, OfAnOlderFileLeavesUndefinedWhatItLacksOrHasOfAnotherType) {
  const LaneSummary s = lane_summary_of(
      {{"ratio", "0.5"}, {"seed", 3}, {"technique", 1}, {"ledger_closes", "yes"}, {"gone_since", 1.0}});
  EXPECT_TRUE(std::isnan(s.ratio));
  EXPECT_TRUE(std::isnan(s.elements));
  EXPECT_EQ(s.seed, 3.0);
  EXPECT_EQ(s.technique, "");
  EXPECT_FALSE(s.ledger_closes);
  EXPECT_TRUE(std::isnan(lane_summary_of(nullptr).seed));
  EXPECT_TRUE(lane_summaries_of("none").empty());
}

TEST(LaneTitle, SaysTechniqueAndVelocityAndWhatTellsThemApart) {
  LaneSummary simple;
  simple.technique = "simple", simple.crack_velocity_over_cr = 0.1, simple.damping_alpha = 0.0;
  LaneSummary progressive = simple;
  progressive.technique = "progressive", progressive.damage_zone_ratio = 5;
  LaneSummary damped = simple;
  damped.damping_alpha = 0.0002, damped.damping_region = "all";
  using Titles = std::vector<std::string>;
  EXPECT_EQ(lane_titles({simple}), (Titles{"simple release, 0.1 c_R"}));
  EXPECT_EQ(lane_titles({simple, progressive}),
            (Titles{"simple release, 0.1 c_R", "progressive release, r_l = 5, 0.1 c_R"}));
  EXPECT_EQ(lane_titles({simple, damped}), (Titles{"undamped, simple release, 0.1 c_R",
                                                   "alpha = 0.0002 everywhere, simple release, 0.1 c_R"}));
}

}  // namespace
}  // namespace rift::results

#include "studio/reports/accuracy_report.hpp"
#include "tests/studio/run_rift.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace rift::studio {
namespace {

/// A line whose errors are all of one size.
accuracy::AccuracyLine line(accuracy::Factor factor, const std::string& label, double value, double error,
                            double wall) {
  accuracy::AccuracyLine l;
  l.factor = factor, l.label = label, l.value = value, l.wall_s = wall;
  l.ratio = 0.5 + error, l.error = l.step_error = l.converged = error;
  l.specimens = 1;
  return l;
}

accuracy::Accuracy steps() {
  accuracy::Accuracy a;
  a.specimen_scatter = 0.02;
  a.lines = {line(accuracy::Factor::scene, "as it is", NAN, 2e-3, 0.2),
             line(accuracy::Factor::time_step, "0.1 of critical", 0.1, 0.0, 1.0),
             line(accuracy::Factor::time_step, "0.2 of critical", 0.2, 4e-4, 0.5),
             line(accuracy::Factor::time_step, "0.4 of critical", 0.4, -1.6e-3, 0.25)};
  a.reference = {{accuracy::Factor::time_step,
                  "the limit",
                  0.5,
                  {.clean = true, .order = 2.0, .limit = 0.5, .text = "observed order 2.00"}}};
  a.front = {0, 3, 2, 1};
  a.recommended = 0;
  return a;
}

const NamedChart& chart_of(const std::vector<NamedChart>& charts, const std::string& name) {
  for (const NamedChart& named : charts)
    if (named.name == name) return named;
  throw std::runtime_error("no chart " + name);
}

TEST(AccuracyCharts, LeaveOutAnErrorOfZeroAndSaySo) {
  const std::vector<NamedChart> charts = accuracy_charts({}, steps(), 0.01);
  for (const char* name : {"work_precision", "error_step"}) {
    const NamedChart& named = chart_of(charts, name);
    EXPECT_TRUE(contains(named.caption, "1 with an error below 1e-07"));
    for (const ChartSeries& series : not_empty(std::get<Chart>(named.chart).series))
      for (const double y : not_empty(series.y)) EXPECT_GT(y, 0.0);
  }
}

TEST(AccuracyCharts, DrawTheFrontTheGoalAndTheScatterBesideWorkAndPrecision) {
  const auto chart = std::get<Chart>(chart_of(accuracy_charts({}, steps(), 0.01), "work_precision").chart);
  std::vector<std::string> labels;
  for (const ChartSeries& series : chart.series) labels.push_back(series.label);
  EXPECT_EQ(labels,
            (std::vector<std::string>{"time step, double", "the scene unchanged", "efficient front",
                                      "recommended: as it is", "goal 0.01", "scatter between specimens"}));
  const ChartSeries& front = chart.series[2];  // the reference has no error to be drawn
  EXPECT_EQ(front.x, (std::vector{0.2, 0.25, 0.5}));
  EXPECT_EQ(front.text, (std::vector<std::string>{"recommended", "0.4 of critical", "0.2 of critical"}));
  EXPECT_EQ(chart.series[0].style, ChartSeries::Style::points);  // only the front is joined
}

TEST(AccuracyCharts, TellTheObservedOrder) {
  const auto chart = std::get<Chart>(chart_of(accuracy_charts({}, steps(), 0.01), "error_step").chart);
  ASSERT_EQ(chart.series.size(), 2u);
  EXPECT_EQ(chart.series[0].label, "double, observed order 2.00");
  EXPECT_NEAR(chart.series[1].y.front() / chart.series[1].y.back(), 0.25, 1e-12);  // 0.2 and 0.4
}

TEST(AccuracyReport, RecommendsWithErrorTimeAndGoal) {
  AccuracyReport report;
  report.accuracy = steps();
  EXPECT_EQ(recommendation_text(report), "as it is: error +0.0020 in 0.20 s (goal 0.01)");
  report.lanes.resize(2);
  report.lanes[0].wall_fracture_s = 0.03, report.lanes[1].wall_fracture_s = 0.05;
  EXPECT_TRUE(contains(recommendation_text(report), ", 2 lanes side by side 0.040 s each"));
  report.accuracy.recommended = -1;
  EXPECT_EQ(recommendation_text(report),
            "no variant is within the goal of 0.01; the most accurate one is 0.1 of critical");
}

TEST(AccuracyReport, TellsWhatCannotBe) {
  accuracy::Accuracy a = steps();
  a.lines[3].cannot_be = "a reason";
  const Table table = accuracy_table(a);
  EXPECT_EQ(table.rows[3].back(), "not computed: a reason");
  EXPECT_EQ(table.rows[1][3], "0");
  EXPECT_EQ(table.rows[2][3], "+4.0e-04");
}

}  // namespace
}  // namespace rift::studio

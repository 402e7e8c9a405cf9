#include "studio/reports/work_precision.hpp"

#include "studio/reports/study_report.hpp"
#include "tests/studio/run_rift.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

namespace rift::studio {
namespace {

/// Rows whose axes are given as texts, in their order.
class Rows {
 public:
  Rows& add(study::AxisTexts axes, double ratio, double seconds) {
    study::SummaryRow row;
    row.axes = std::move(axes);
    row.row = static_cast<int>(rows_.size());
    row.ratio = ratio;
    row.broberg = 0.5, row.error_broberg = ratio - 0.5;
    row.cost_s = seconds;
    row.outcome = "finished";
    rows_.emplace_back(row);
    return *this;
  }
  const study::StudyRows& all() const { return rows_; }

 private:
  study::StudyRows rows_;
};

/// Three steps on two specimens; the finest is the reference of each specimen.
study::StudyRows three_steps() {
  return Rows()
      .add({{"dt_fraction", "0.8"}, {"seed", "1"}}, 0.54, 1.0)
      .add({{"dt_fraction", "0.4"}, {"seed", "1"}}, 0.51, 2.0)
      .add({{"dt_fraction", "0.1"}, {"seed", "1"}}, 0.50, 8.0)
      .add({{"dt_fraction", "0.8"}, {"seed", "2"}}, 0.66, 1.0)
      .add({{"dt_fraction", "0.4"}, {"seed", "2"}}, 0.61, 2.0)
      .add({{"dt_fraction", "0.1"}, {"seed", "2"}}, 0.60, 8.0)
      .all();
}

TEST(ConvergedErrors, AreAgainstTheMostAccurateScenarioOfTheSameSpecimen) {
  const study::StudyRows rows = with_converged_errors(three_steps());
  EXPECT_NEAR(rows[0]->error_converged, 0.04, 1e-12);
  EXPECT_NEAR(rows[1]->error_converged, 0.01, 1e-12);
  EXPECT_NEAR(rows[3]->error_converged, 0.06, 1e-12);
  EXPECT_TRUE(std::isnan(rows[2]->error_converged) && std::isnan(rows[5]->error_converged));
}

TEST(ConvergedErrors, NeedAScenarioThatIsBestInEveryAxisOfAccuracy) {
  const study::StudyRows rows =
      with_converged_errors(Rows()
                                .add({{"dt_fraction", "0.1"}, {"precision", "single"}}, 0.5, 1.0)
                                .add({{"dt_fraction", "0.4"}, {"precision", "double"}}, 0.6, 1.0)
                                .all());
  EXPECT_TRUE(std::isnan(rows[0]->error_converged) && std::isnan(rows[1]->error_converged));
}

TEST(ConvergedErrors, KeepWhatIsKnownAlready) {
  study::StudyRows rows = three_steps();
  rows[0]->error_converged = 0.123;
  EXPECT_EQ(with_converged_errors(rows)[0]->error_converged, 0.123);
}

TEST(WorkPrecision, MarksSchemesWithoutAFasterAndNearerOne) {
  Rows rows;
  rows.add({{"technique", "simple"}, {"crack_velocity", "0.3 c_r"}}, 0.40, 1.0);
  rows.add({{"technique", "a"}, {"crack_velocity", "0.3 c_r"}}, 0.45, 2.0);
  rows.add({{"technique", "b"}, {"crack_velocity", "0.3 c_r"}}, 0.44, 3.0);  // slower and farther than a
  rows.add({{"technique", "simple"}, {"crack_velocity", "0.5 c_r"}}, 0.49, 0.5);
  const WorkPrecision work = work_precision(rows.all());
  EXPECT_FALSE(work.converged);
  EXPECT_EQ(work.schemes.size(), 3U);
  EXPECT_EQ(work.problems.size(), 2U);  // another velocity is another problem
  ASSERT_EQ(work.points.size(), 4U);
  EXPECT_TRUE(work.points[0].efficient && work.points[1].efficient && work.points[3].efficient);
  EXPECT_FALSE(work.points[2].efficient);
}

TEST(WorkPrecision, ASpecimensErrorsGiveMeanAndScatterAndAReferenceHasNone) {
  const WorkPrecision work = work_precision(with_converged_errors(three_steps()));
  ASSERT_TRUE(work.converged);
  ASSERT_EQ(work.points.size(), 3U);
  EXPECT_NEAR(work.points[0].error, 0.05, 1e-12);
  EXPECT_NEAR(work.points[0].scatter, 0.02 / std::sqrt(2.0), 1e-12);
  EXPECT_EQ(work.points[0].specimens, 2);
  EXPECT_TRUE(work.points[2].reference);
  EXPECT_FALSE(work.points[2].efficient);
}

TEST(WorkPrecisionCharts, NameEachPointAndDrawTheFront) {
  const std::vector<NamedChart> charts =
      work_precision_charts(work_precision(with_converged_errors(three_steps())));
  ASSERT_EQ(charts.size(), 1U);
  const auto& chart = std::get<Chart>(charts[0].chart);
  EXPECT_EQ(chart.title, "Error against run time");
  ASSERT_EQ(chart.series.size(), 3U);
  EXPECT_EQ(chart.series[0].label, "1: 0.8 of critical");
  EXPECT_EQ(chart.series[0].text, std::vector<std::string>{"1"});
  EXPECT_EQ(chart.series[2].label, "efficient front");
  EXPECT_EQ(chart.series[2].x, (std::vector{1.0, 2.0}));
}

TEST(WorkPrecisionCharts, WithoutAReferenceShowTheDifferenceToBrobergAndCallItSo) {
  study::StudyRows rows = Rows()
                              .add({{"technique", "simple"}, {"seed", "1"}}, 0.4, 1.0)
                              .add({{"technique", "progressive"}, {"seed", "1"}}, 0.48, 2.0)
                              .all();
  rows = with_converged_errors(std::move(rows));
  const WorkPrecision work = work_precision(rows);
  const NamedChart named = work_precision_charts(work).at(0);
  EXPECT_EQ(std::get<Chart>(named.chart).title, "Difference to Broberg against run time");
  EXPECT_TRUE(contains(named.caption, "no numerical error"));
  EXPECT_TRUE(contains(work_precision_text(work), "dt_fraction = [0.05, 0.5]"));
  for (const std::string& head : not_empty(work_precision_table(work).head))
    EXPECT_EQ(head.find("error"), std::string::npos) << head;
}

TEST(WorkPrecisionTable, NumbersSchemesAsTheChartDoes) {
  const Table table = work_precision_table(work_precision(with_converged_errors(three_steps())));
  ASSERT_EQ(table.rows.size(), 3U);
  EXPECT_EQ(table.rows[1].front(), "2");
  EXPECT_EQ(table.rows[0].back(), "efficient");
  EXPECT_EQ(table.rows[2].back(), "reference");
}

TEST(ScenarioTable, HasAnErrorWhereOneIsKnown) {
  const std::vector<std::string> without = scenario_table(three_steps()).head,
                                 with = scenario_table(with_converged_errors(three_steps())).head;
  EXPECT_EQ(std::count(without.begin(), without.end(), "error"), 0);
  EXPECT_EQ(std::count(with.begin(), with.end(), "error"), 1);
}

}  // namespace
}  // namespace rift::studio

#include "studio/reports/experiment_charts.hpp"

#include "studio/charts/chart_script.hpp"

#include <gtest/gtest.h>

#include <algorithm>

namespace rift::studio {
namespace {

/// Two points along a crack, at 0.2 and 0.4 c_R, and a law that goes on from rest to c_R.
ExperimentReport two_points() {
  ExperimentReport report;
  report.rows = {{0.0, 0.0, 0.0}, {1e-5, 1e-2, 0.0}};
  experiment::Experiment& e = report.experiment;
  e.rayleigh_speed = 1000;
  e.course.history = history::history_of(0.0, {{1000, 0.01}});
  for (const double v : {0.2, 0.4}) {
    experiment::CriticalPoint p;
    p.position = 0.1 * v, p.time = 1e-4 * v, p.over_cr = v;
    p.as_paper = 1000 * v, p.uncertainty = 50, p.quasi_static = 900 * v;
    p.corrected = 1200 * v, p.corrected_uncertainty = 60;
    e.along.push_back(p);
  }
  e.law = {{0, 100, 50}, {0.2, 200, 50}, {0.4, 400, 50}, {1, 1000, 50}};
  return report;
}

const Chart& chart_named(const std::vector<NamedChart>& charts, const std::string& name) {
  const auto at =
      std::find_if(charts.begin(), charts.end(), [&](const NamedChart& c) { return c.name == name; });
  return std::get<Chart>(at->chart);
}

const ChartSeries& series_called(const Chart& chart, const std::string& label, int which = 0) {
  for (const ChartSeries& s : chart.series)
    if (s.label == label && which-- == 0) return s;
  throw std::runtime_error("no series " + label);
}

TEST(ExperimentCharts, DrawWhatNothingMeasuredDashed) {
  const Chart chart = chart_named(experiment_charts(two_points()), "rate_velocity");
  const ChartSeries& fit = series_called(chart, "monotone fit of the uncorrected");
  EXPECT_EQ(fit.x, (std::vector{0.2, 0.4}));
  EXPECT_EQ(fit.style, ChartSeries::Style::line);
  for (const auto& [which, ends] : {std::pair{0, std::vector{0.0, 0.2}}, {1, std::vector{0.4, 1.0}}}) {
    const ChartSeries& beyond = series_called(chart, "continued beyond the measured velocities", which);
    EXPECT_EQ(beyond.style, ChartSeries::Style::dashed);
    EXPECT_EQ(beyond.x, ends);
  }
}

TEST(ExperimentCharts, DrawAFitOfOnePoolOverAllMeasuredVelocities) {
  ExperimentReport report = two_points();
  report.experiment.law = {{0, 300, 40}, {0.3, 300, 50}, {1, 300, 60}};  // it did not rise
  const Chart chart = chart_named(experiment_charts(report), "rate_velocity");
  EXPECT_EQ(series_called(chart, "monotone fit of the uncorrected").x, (std::vector{0.2, 0.3, 0.4}));
}

TEST(ExperimentCharts, SayWhatTheirBandsAreAndNameAllRows) {
  const std::vector<NamedChart> charts = experiment_charts(two_points());
  for (const char* name : {"rate_position", "rate_time", "rate_velocity"}) {
    const Chart& chart = chart_named(charts, name);
    const bool of_fit = std::string(name) == "rate_velocity";  // the corrected rate has a band in the others
    const ChartSeries& band = series_called(chart, "± two standard uncertainties", of_fit ? 0 : 1);
    EXPECT_EQ(band.style, ChartSeries::Style::band);
    EXPECT_NEAR(band.error.front(), 0.1, 1e-12) << name;  // kJ/m²
    for (const std::string& series : series_names(chart.series))
      EXPECT_EQ(series.find("series "), std::string::npos) << name << ": " << series;
  }
}

}  // namespace
}  // namespace rift::studio

#include "studio/reports/study_charts.hpp"

#include "tests/studio/run_rift.hpp"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <fstream>
#include <set>

namespace rift::studio {
namespace {

namespace fs = std::filesystem;

/// Three relaxations, two zones, two dampings, two velocities, two specimens; simple release has neither
/// relaxation nor zone.
study::StudyRows four_parameters() {
  study::StudyRows rows;
  const auto add = [&](const char* technique, const char* relaxation, const char* zone) {
    for (const char* alpha : {"0", "0.02"})
      for (const auto& [text, v] : {std::pair{"0.3 c_r", 0.3}, {"0.6 c_r", 0.6}})
        for (const char* seed : {"1", "2"}) {
          study::SummaryRow row;
          row.axes = {{"technique", technique}, {"relaxation", relaxation}, {"damage_zone_ratio", zone},
                      {"damping_alpha", alpha}, {"crack_velocity", text},   {"seed", seed}};
          row.row = static_cast<int>(rows.size());
          row.crack_velocity_over_cr = v, row.ratio = 0.5, row.poisson_ratio = 0.3;
          row.plane = "stress";
          rows.emplace_back(row);
        }
  };
  add("simple", "-", "-");
  for (const char* relaxation : {"linear", "square-root", "quadratic"})
    for (const char* zone : {"1", "4"}) add("progressive", relaxation, zone);
  return rows;
}

// Twenty-eight curves in one chart left their plot sixty pixels.
TEST(StudyCharts, ManyCurvesBecomeSmallMultiplesWithSequentialColours) {
  const std::vector<NamedChart> charts = velocity_charts(four_parameters());
  ASSERT_EQ(charts.size(), 1U);
  const auto& grid = std::get<ChartGrid>(charts[0].chart);
  ASSERT_EQ(grid.panels.size(), 7U);
  EXPECT_EQ(grid.panels[0].title, "simple");
  EXPECT_EQ(grid.panels[1].title, "progressive, linear, r_l = 1");
  for (const ChartPanel& panel : grid.panels) {
    ASSERT_EQ(panel.series.size(), 5U) << panel.title;  // two dampings and three theories
    EXPECT_EQ(panel.series[0].label, "α = 0");
    EXPECT_EQ(panel.series[0].shade, 0.0);
    EXPECT_EQ(panel.series[1].shade, 1.0);
    EXPECT_EQ(panel.series[2].label, "Broberg");
  }
}

TEST(StudyCharts, FewCurvesStayTogether) {
  study::StudyRows rows = four_parameters();
  std::erase_if(rows, [](const auto& row) {
    return value_of_axis(row->axes, "technique") == "progressive" &&
           value_of_axis(row->axes, "damage_zone_ratio") == "4";
  });
  std::erase_if(rows, [](const auto& row) { return value_of_axis(row->axes, "damping_alpha") != "0"; });
  const std::vector<NamedChart> charts = velocity_charts(rows);
  ASSERT_EQ(charts.size(), 1U);
  const auto& chart = std::get<Chart>(charts[0].chart);
  ASSERT_EQ(chart.series.size(), 7U);
  EXPECT_EQ(chart.series[0].label, "simple");
  EXPECT_EQ(chart.series[1].label, "progressive, linear, r_l = 1");  // the damping is not varied any more
}

TEST(StudyCharts, SpecimensAreABandAroundTheirMean) {
  study::StudyRows rows = four_parameters();
  const TemporaryFolder folder;
  std::vector<fs::path> series;
  for (const auto& row : rows) {
    series.push_back(folder.path() / fmt::format("{}.csv", row->row));
    std::ofstream(series.back()) << "phase,tip_m,ratio\nfracture,-0.001,0.1\n"  // outside the plate
                                 << (value_of_axis(row->axes, "seed") == "1"
                                         ? "fracture,0,0.2\nfracture,0.01,0.4\nfracture,0.02,0.6\n"
                                         : "fracture,0,0.4\nfracture,0.02,0.8\n");
  }
  const std::vector<NamedChart> charts = tip_charts(rows, series);
  ASSERT_FALSE(charts.empty());
  const auto& grid = std::get<ChartGrid>(charts[0].chart);
  ASSERT_EQ(grid.panels.size(), 7U * 2U - 2U);  // a chart holds twelve of the fourteen panels
  ASSERT_EQ(grid.panels[0].series.size(), 4U);  // two velocities, each with a mean and a band
  const ChartSeries &mean = grid.panels[0].series[0], &band = grid.panels[0].series[1];
  EXPECT_EQ(mean.label, "0.3 c_R");
  EXPECT_EQ(band.style, ChartSeries::Style::band);
  EXPECT_EQ(band.label, "specimens, least to largest");          // in the key
  EXPECT_EQ(band.name, "0.3 c_R, specimens, least to largest");  // in the csv
  ASSERT_EQ(mean.y.size(), 3U);
  EXPECT_EQ(mean.x.front(), 0.0);
  EXPECT_NEAR(mean.y[1], 0.5, 1e-12);  // 0.4, and 0.6 between the other's points
  EXPECT_NEAR(band.error[1], 0.1, 1e-12);
}

TEST(AxesLabel, ReadsAsTheFieldWrites) {
  EXPECT_EQ(axes_label({{"technique", "progressive"},
                        {"relaxation", "1.5"},
                        {"damage_zone_ratio", "4"},
                        {"damping_alpha", "0.02"},
                        {"crack_velocity", "0.5 c_r"},
                        {"dt_fraction", "0.1"}}),
            "progressive, p = 1.5, r_l = 4, α = 0.02, 0.5 c_R, 0.1 of critical");
}

}  // namespace
}  // namespace rift::studio

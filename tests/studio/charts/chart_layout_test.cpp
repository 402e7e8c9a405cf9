#include "studio/charts/chart_layout.hpp"

#include "studio/charts/chart_script.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <set>
#include <tuple>

namespace rift::studio {
namespace {

TEST(Label, OfDataIsShownLetterByLetter) {
  EXPECT_EQ(escape_label("run_01^{a}@&~\\"), "run\\_01\\^\\{a\\}\\@\\&\\~\\\\");
  EXPECT_EQ(plain_text(escape_label("run_01^{a}@&~\\")), "run_01^{a}@&~\\");
  EXPECT_EQ(plain_text("G_{ID} / c_r"), "G_ID / c_r");
  EXPECT_EQ(script_string("it's\nα"), "'it''s α'");
  EXPECT_EQ(letters("α_{r}"), 3U);
}

TEST(ChartData, NamesEachSeriesOnce) {
  Chart chart;
  for (const char* label : {"a", "a", "", "x, \"y\""}) chart.series.push_back({label, {1}, {2}, {}, {}, 0});
  EXPECT_EQ(series_names(chart), (std::vector<std::string>{"a", "a (2)", "series 3", "x; 'y'"}));
}

TEST(ChartLook, TellsThirtySeriesApart) {
  std::set<std::tuple<std::string, int, int>> seen;
  for (int k = 0; k < 30; ++k) {
    const SeriesLook look = series_look(k, 0);
    seen.insert({look.colour, look.dash, look.shape});
  }
  EXPECT_EQ(seen.size(), 30U);
  EXPECT_NE(series_look(-1, 0).dash, series_look(-1, 1).dash);
}

TEST(KeyPlace, IsOutsideTheAxes) {
  Chart chart;
  chart.series = {{"rising", {0, 1}, {0, 1}, {}, ChartSeries::Style::line, 0}};
  EXPECT_EQ(key_place(chart), KeyPlace::right);
  EXPECT_NE(key_lines(chart).find("set rmargin at screen"), std::string::npos);
  chart.series[0].label = std::string(60, 'x');
  EXPECT_EQ(key_place(chart), KeyPlace::below);
  EXPECT_NE(key_lines(chart).find("set key outside below"), std::string::npos);
  chart.series[0].label.clear();
  EXPECT_EQ(key_place(chart), KeyPlace::none);
}

TEST(KeyPlace, MakesRoomForManySeries) {
  Chart chart;
  chart.series = {{"one", {0, 1}, {0, 1}, {}, ChartSeries::Style::line, 0}};
  const int height = picture_height(chart);
  chart.series.assign(30, chart.series[0]);
  EXPECT_GT(picture_height(chart), height);
}

TEST(ChartSeries, KeepsBarsBesideTheirPoints) {
  ChartSeries series{.x = {1}, .y = {2}};
  series.add(2, 3);
  series.add(3, 4, 0.5);
  ASSERT_EQ(series.error.size(), 3U);
  EXPECT_TRUE(std::isnan(series.error[0]) && std::isnan(series.error[1]));
  EXPECT_EQ(series.error[2], 0.5);
}

TEST(MarkLabels, StandInRowsWhereTheyWouldMeet) {
  Chart chart;
  chart.x_range = {0.0, 1.0};
  chart.marks = {
      {0.5, 0.5, "echo of the boundary"}, {0.52, 0.52, "second echo"}, {0.99, 1.0, "the end of all"}};
  const std::vector<MarkLabel> labels = mark_labels(chart, {0, 1});
  EXPECT_EQ(labels[0].row, 0);
  EXPECT_EQ(labels[1].row, 1);
  EXPECT_EQ(labels[2].row, 0);
  EXPECT_EQ(labels[2].side, MarkLabel::Side::right);
}

TEST(HeatMapData, LeavesOutWhatIsNotANumber) {
  const HeatMap map{"", "", "", "", {0.1, 0.5}, {4}, {1.5, std::nan("")}, {"a,b", ""}, {}};
  EXPECT_EQ(chart_data(map), "column,row,x,y,value,text\n0,0,0.1,4,1.5,a;b\n");
}

}  // namespace
}  // namespace rift::studio

#include "studio/charts/chart_layout.hpp"

#include "studio/charts/chart_script.hpp"
#include "studio/charts/label.hpp"
#include "studio/charts/text_width.hpp"

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
  EXPECT_EQ(series_names(chart.series), (std::vector<std::string>{"a", "a (2)", "series 3", "x; 'y'"}));
  chart.series[2].name = "a, G_{ID} band";
  EXPECT_EQ(series_names(chart.series)[2], "a; G_ID band");
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

TEST(ChartLook, ADashedSeriesDiffersFromTheLineOfItsColour) {
  const auto sample = [](ChartSeries::Style style, int colour) {
    return key_sample({ChartSeries{.style = style, .colour = colour}, 0}, "a", "b", "c", "d", "e");
  };
  for (int colour = 0; colour < 4; ++colour)
    EXPECT_NE(sample(ChartSeries::Style::line, colour), sample(ChartSeries::Style::dashed, colour)) << colour;
}

TEST(ChartLook, OrderedSeriesHaveSequentialColoursAndSolidLines) {
  std::vector<ChartSeries> series(3);
  shade_in_order(series);
  EXPECT_EQ(look_of(series[0], 0).colour, "#440154");
  EXPECT_EQ(look_of(series[1], 0).colour, "#2a788e");
  EXPECT_EQ(look_of(series[2], 0).colour, "#7ad151");
  for (ChartSeries& s : series) EXPECT_EQ(look_of(s, 0).dash, 1);
}

TEST(Axis, LeavesRoomBelowALevelThatIsTheLowestOfItsData) {
  Chart chart;
  chart.series.push_back({"cylinders", {1, 2}, {0.32, 0.34}, {}, {}, 0});
  chart.series.push_back(level("paper", 0.3, 1, 2));
  EXPECT_NEAR(range_below_levels(chart).min.value(), 0.3 - 0.04 * 0.04, 1e-12);
  EXPECT_FALSE(range_below_levels(chart).max.has_value());
  chart.series[1] = {"strip", {0, 0.5, 1}, {0.3, 0.3, std::nan("")}, {}, {}, -1};  // not defined at its end
  EXPECT_TRUE(range_below_levels(chart).min.has_value());
  chart.series[1] = level("paper", 0.33, 1, 2);
  EXPECT_FALSE(range_below_levels(chart).min.has_value());
}

TEST(Axis, BeginsOnALevelOfZeroOrWhereItsEndIsGiven) {
  Chart chart;
  chart.series.push_back({"ratio", {1, 2}, {0.5, 1}, {}, {}, 0});
  chart.series.push_back(level("none", 0, 1, 2));
  EXPECT_FALSE(range_below_levels(chart).min.has_value());
  chart.series[1] = level("half", 0.5, 1, 2);
  chart.y_range.min = 0.5;
  EXPECT_EQ(range_below_levels(chart).min, 0.5);
}

TEST(Axis, TicksOfAShortLogarithmicOneHaveRoomForTheirNumbers) {
  Chart chart;
  chart.log_x = true;
  chart.series.push_back({"run time", {0.008, 0.0134}, {1, 2}, {}, {}, 0});
  EXPECT_NE(chart_script(chart, "c").find("set xtics (0.008, 0.01, 0.012, 0.014)\n"), std::string::npos)
      << chart_script(chart, "c");
}

TEST(LabelString, KeepsTheBlankBehindASubscript) {
  EXPECT_EQ(label_string("G_{ID} / c_R [-]"), "'G_{ID}\u2060 / c_R\u2060 [-]'");
  EXPECT_EQ(label_string(escape_label("run_a b")), "'run\\_a b'");
  EXPECT_EQ(label_string("E_µ = 356 GPa, r_µ [-]"), "'E_µ\u2060 = 356 GPa, r_µ\u2060 [-]'");
}

TEST(TextWidth, IsThatOfTheFontAndCountsNoMarkup) {
  EXPECT_NEAR(text_px("20000 elements", 14), 14e-3 * 8142, 1e-9);  // DejaVu Sans
  EXPECT_EQ(text_px("G_{ID}", 14), text_px("G_ID", 14));
  EXPECT_GT(text_px("ω", 14), text_px("i", 14));
}

TEST(WrappedLabel, BreaksAfterCommasAndLosesNothing) {
  const std::vector<std::string> lines = wrapped_label("progressive, square-root, r_l = 1", 170, 12);
  EXPECT_EQ(lines, (std::vector<std::string>{"progressive, square-root,", "r_l = 1"}));
  EXPECT_EQ(wrapped_label("indivisible", 10, 12), std::vector<std::string>{"indivisible"});
}

Chart chart_of(std::size_t series, const std::string& label) {
  Chart chart;
  for (std::size_t k = 0; k < series; ++k)
    chart.series.push_back({label + std::to_string(k), {0, 1}, {0, 1}, {}, ChartSeries::Style::line, 0});
  return chart;
}

TEST(KeyLayout, IsBesideThePlotWhereItFitsAndElseBelow) {
  EXPECT_EQ(key_layout(chart_of(1, "rising")).place, KeyPlace::right);
  EXPECT_EQ(key_layout(chart_of(1, std::string(60, 'x'))).place, KeyPlace::below);
  EXPECT_EQ(key_layout(chart_of(28, "rising")).place, KeyPlace::below);
  EXPECT_EQ(key_layout(chart_of(0, "")).place, KeyPlace::none);
}

TEST(KeyEntries, ALabelOfSeveralColoursIsGrey) {
  Chart chart = chart_of(3, "a");
  for (int k = 0; k < 3; ++k)
    chart.series.push_back({"band", {0, 1}, {0, 1}, {1, 1}, ChartSeries::Style::band, k});
  const std::vector<KeyEntry> entries = key_entries(chart.series);
  ASSERT_EQ(entries.size(), 4U);
  EXPECT_EQ(entries[3].series.label, "band");
  EXPECT_LT(entries[3].series.colour, 0);
  EXPECT_EQ(entries[0].series.colour, 0);
}

// A key of many long labels once left sixty pixels to the plot.
TEST(PlotArea, HasItsLeastSizeWhateverTheKeyHolds) {
  for (const std::size_t series : {1U, 7U, 14U, 28U})
    for (const char* label :
         {"v", "square root, r_l = 1", "progressive, square-root, r_l = 4, α = 0.02, 0.5 c_R"}) {
      const Chart chart = chart_of(series, label);
      const PlotArea area = plot_area(chart);
      const KeyLayout key = key_layout(chart);
      EXPECT_GE(area.width(), least_plot_width) << series << label;
      EXPECT_GE(area.height(), least_plot_height) << series << label;
      EXPECT_GE(static_cast<std::size_t>(key.rows * key.columns), series);
      EXPECT_LE(key.place == KeyPlace::right ? area.right + key.width_px() : area.left + key.width_px(),
                chart_width)
          << series << label;
      EXPECT_GE(key.place == KeyPlace::below ? area.bottom : 1e9, key.height_px());
    }
}

TEST(GridLayout, PanelsAreApartAndWithinThePicture) {
  ChartGrid grid;
  for (int k = 0; k < 7; ++k)
    grid.panels.push_back({"progressive, square-root, r_l = " + std::to_string(k), chart_of(3, "v").series});
  const GridLayout layout = grid_layout(grid);
  ASSERT_EQ(layout.panels.size(), 7U);
  EXPECT_EQ(key_entries(grid).size(), 3U);  // each label once
  for (const PlotArea& a : layout.panels) {
    EXPECT_GE(a.width(), 230);
    EXPECT_GE(a.height(), 190);
    EXPECT_LE(a.right, chart_width);
    EXPECT_LE(a.top, layout.height);
    for (const PlotArea& b : layout.panels) {
      if (&a == &b) continue;
      EXPECT_TRUE(a.right < b.left || b.right < a.left || a.top < b.bottom || b.top < a.bottom);
    }
  }
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

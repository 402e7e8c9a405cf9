#include "studio/charts/chart.hpp"

#include "engine/base/world_error.hpp"
#include "studio/charts/gnuplot.hpp"
#include "studio/charts/label.hpp"
#include "tests/studio/run_rift.hpp"

#include <cmath>
#include <cstdlib>
#include <limits>
#include <map>
#include <regex>
#include <set>
#include <sstream>

namespace rift::studio {
namespace {

namespace fs = std::filesystem;
constexpr double nan = std::numeric_limits<double>::quiet_NaN();

/// Three series with all that a csv and a script could trip over.
Chart small_chart() {
  Chart chart;
  chart.title = "G_{ID} / G_{I0} of \"two\" speeds, it's a test";
  chart.x_label = "crack speed c / c_r [-]";
  chart.y_label = "G_{ID} / G_{I0} [-]";
  chart.series = {{"progressive, r_l = 1",
                   {0.1, 0.2, 1.0 / 3.0},
                   {0.9, nan, 0.7},
                   {0.1, 0.1, nan},
                   ChartSeries::Style::line_points,
                   0},
                  {escape_label("run_01 {a}"), {0.1, 0.2}, {1e-300, 0.1}, {}, ChartSeries::Style::points, 1},
                  {"Broberg", {0.0, 1.0}, {1.0, 0.0}, {}, ChartSeries::Style::dashed, -1}};
  chart.marks = {{0.5, 0.5, "echo"}, {0.6, 0.7, "window"}};
  return chart;
}

HeatMap small_map() {
  return {"map",          "c / c_r [-]",           "r_l [-]", "ratio [-]", {0.1, 0.5}, {1, 4},
          {1, 2, nan, 4}, {"a_b", "c,d", "", "4"}, {}};
}

/// What `draw` complains of; empty where it does not.
template <class Draw>
std::string complaint(const Draw& draw) {
  try {
    draw();
  } catch (const base::WorldError& error) {
    return error.what();
  }
  return {};
}

/// Sets a variable of the environment until the end of the scope.
class Environment {
 public:
  Environment(const char* name, const std::string& value) : name_(name), former_(std::getenv(name)) {
    setenv(name, value.c_str(), 1);
  }
  Environment(const Environment&) = delete;
  Environment& operator=(const Environment&) = delete;
  ~Environment() { setenv(name_, former_.c_str(), 1); }

 private:
  const char* name_;
  std::string former_;
};

std::multiset<std::string> ids(const std::string& svg) {
  std::multiset<std::string> found;
  for (const std::string quote : {"'", "\""})
    for (std::size_t at = 0; (at = svg.find(" id=" + quote, at)) != std::string::npos;) {
      at += 5;
      found.insert(svg.substr(at, svg.find(quote, at) - at));
    }
  return found;
}

TEST(DrawChart, LeavesPicturesDataAndScript) {
  const TemporaryFolder folder;
  const DrawnChart drawn = draw_chart(small_chart(), folder.path() / "new" / "folder", "ratio");
  EXPECT_GT(fs::file_size(drawn.svg), 5000U);
  EXPECT_EQ(read_text(drawn.png).substr(1, 3), "PNG");
  EXPECT_TRUE(contains(read_text(drawn.data), "series,x,y,error\n"));
  EXPECT_TRUE(contains(read_text(drawn.script), "data = 'ratio.csv'"));
  EXPECT_EQ(std::distance(fs::directory_iterator(drawn.svg.parent_path()), {}), 4);
}

TEST(DrawChart, DrawsEverySeriesOfAnyLabel) {
  const TemporaryFolder folder;
  const DrawnChart drawn = draw_chart(small_chart(), folder.path(), "ratio");
  EXPECT_TRUE(contains(drawn.svg_text, "run_01 {a}"));
  EXPECT_TRUE(contains(drawn.svg_text, "it's a test"));
  for (std::size_t k = 0; k < 3; ++k) {  // the key shows a series even where none of its rows was found
    Chart moved = small_chart();
    moved.series[k].y[1] = 0.5;
    EXPECT_NE(drawn.svg_text, draw_chart(moved, folder.path(), "ratio").svg_text) << k;
  }
}

// The title of the x axis once lay below the picture.
TEST(DrawChart, EveryTextStandsWithinThePicture) {
  const TemporaryFolder folder;
  ChartGrid grid{.title = "grid", .x_label = "x [-]", .y_label = "y [-]"};
  grid.panels.assign(7, {"panel", small_chart().series});
  Chart many = small_chart();
  for (int k = 0; k < 30; ++k)
    many.series.push_back({"series of a long label, " + std::to_string(k), {0.1}, {1}});
  const std::regex place("translate\\(([0-9.-]+),([0-9.-]+)\\)[^>]*>\\s*<text>");
  for (const DrawnChart& drawn :
       {draw_chart(small_chart(), folder.path(), "one"), draw_chart(many, folder.path(), "many"),
        draw_chart(grid, folder.path(), "grid")}) {
    std::smatch size;
    ASSERT_TRUE(std::regex_search(drawn.svg_text, size, std::regex("viewBox=\"0 0 (\\d+) (\\d+)\"")));
    int texts = 0;
    for (std::sregex_iterator at(drawn.svg_text.begin(), drawn.svg_text.end(), place), end; at != end;
         ++at, ++texts) {
      EXPECT_GT(std::stod((*at)[1]), 0.0) << drawn.svg;
      EXPECT_LT(std::stod((*at)[1]), std::stod(size[1])) << drawn.svg;
      EXPECT_GT(std::stod((*at)[2]), 10.0) << drawn.svg;
      EXPECT_LT(std::stod((*at)[2]), std::stod(size[2]) - 4.0) << drawn.svg;
    }
    EXPECT_GT(texts, 12) << drawn.svg;
  }
}

TEST(DrawChart, PanelsOfAGridDrawTheirOwnRows) {
  const TemporaryFolder folder;
  ChartGrid grid;
  grid.panels = {{"first", {{"a", {0, 1}, {0, 1}}}}, {"second", {{"a", {0, 1}, {0, 1}}}}};
  const std::string former = draw_chart(grid, folder.path(), "grid").svg_text;
  EXPECT_TRUE(contains(read_text(folder.path() / "grid.csv"), "series,x,y,error,panel\na,0,0,,1\n"));
  for (ChartPanel& panel : grid.panels) {
    panel.series[0].y[1] = 0.5;
    EXPECT_NE(draw_chart(grid, folder.path(), "grid").svg_text, former);
    panel.series[0].y[1] = 1;
  }
}

TEST(DrawChart, ScriptRunsByHand) {
  const TemporaryFolder folder;
  const DrawnChart drawn = draw_chart(small_chart(), folder.path(), "ratio");
  const DrawnChart map = draw_chart(small_map(), folder.path(), "map");
  const std::string former = read_text(drawn.svg);
  for (const fs::path& file : {drawn.svg, drawn.png, map.svg, map.png}) fs::remove(file);
  const Ran ran = run_shell("cd '" + folder.path().string() + "' && gnuplot ratio.gp && gnuplot map.gp");
  EXPECT_EQ(ran.exit_code, 0) << ran.err;
  EXPECT_EQ(ran.err, "");
  EXPECT_EQ(read_text(drawn.svg), former);
  for (const fs::path& file : {drawn.png, map.svg, map.png}) EXPECT_GT(fs::file_size(file), 3000U);
}

TEST(DrawChart, CsvGivesTheNumbersBack) {
  const TemporaryFolder folder;
  const Chart chart = small_chart();
  std::istringstream csv(read_text(draw_chart(chart, folder.path(), "ratio").data));
  std::map<std::string, ChartSeries> read;
  std::string line, name, x, y, error;
  std::getline(csv, line);
  while (std::getline(csv, line)) {
    std::istringstream fields(line);
    std::getline(fields, name, ','), std::getline(fields, x, ','), std::getline(fields, y, ',');
    if (!std::getline(fields, error)) error.clear();
    read[name].x.push_back(std::strtod(x.c_str(), nullptr));
    read[name].y.push_back(std::strtod(y.c_str(), nullptr));
    read[name].error.push_back(error.empty() ? -1.0 : std::strtod(error.c_str(), nullptr));
  }
  ASSERT_EQ(read.size(), 3U);
  EXPECT_EQ(read["progressive; r_l = 1"].x, (std::vector{0.1, 1.0 / 3.0}));
  EXPECT_EQ(read["progressive; r_l = 1"].y, (std::vector{0.9, 0.7}));
  EXPECT_EQ(read["progressive; r_l = 1"].error, (std::vector{0.1, -1.0}));
  EXPECT_EQ(read["run_01 {a}"].y, chart.series[1].y);
  EXPECT_EQ(read["Broberg"].x, chart.series[2].x);
}

TEST(DrawChart, TwoChartsFitOnePage) {
  const TemporaryFolder folder;
  const std::string page = draw_chart(small_chart(), folder.path(), "first").svg_text +
                           draw_chart(small_chart(), folder.path(), "second").svg_text +
                           draw_chart(small_map(), folder.path(), "map").svg_text;
  const std::multiset<std::string> all = ids(page);
  EXPECT_GT(all.size(), 30U);
  for (const std::string& id : all) EXPECT_EQ(all.count(id), 1U) << id;
  int references = 0;
  for (const std::string before : {"href='#", "url(#"})
    for (std::size_t at = 0; (at = page.find(before, at)) != std::string::npos; ++references) {
      at += before.size();
      const std::string id = page.substr(at, page.find_first_of("')", at) - at);
      EXPECT_EQ(all.count(id), 1U) << id;
    }
  EXPECT_GT(references, 0);
  EXPECT_EQ(page.find("<?xml"), std::string::npos);
  EXPECT_EQ(page.find("<title>"), std::string::npos);
  EXPECT_TRUE(contains(page, "aria-label=\"G_ID / G_I0 of &quot;two&quot; speeds, it's a test\""));
}

TEST(DrawChart, WithoutGnuplotSaysWhatToInstall) {
  const TemporaryFolder folder, empty;
  const Environment path("PATH", empty.path().string());
  const std::string said = complaint([&] { draw_chart(small_chart(), folder.path(), "ratio"); });
  EXPECT_EQ(said, "cannot draw " + (folder.path() / "ratio.svg").string() +
                      ": gnuplot is not installed: apt install gnuplot-nox; the data and the script are in " +
                      folder.path().string());
  EXPECT_TRUE(fs::exists(folder.path() / "ratio.csv"));
  EXPECT_TRUE(fs::exists(folder.path() / "ratio.gp"));
}

TEST(DrawChart, RefusesWhatCannotBeDrawnOrWritten) {
  const TemporaryFolder folder;
  EXPECT_TRUE(contains(complaint([&] { draw_chart(Chart{}, folder.path(), "ratio"); }),
                       "ratio: the chart has no points"));
  Chart negative = small_chart();
  negative.log_y = true;
  for (ChartSeries& s : negative.series) s.y.assign(s.y.size(), -1.0);
  EXPECT_TRUE(contains(complaint([&] { draw_chart(negative, folder.path(), "negative"); }),
                       "the chart has no points"));
  write_text(folder.path() / "file", "");
  EXPECT_TRUE(contains(complaint([&] { draw_chart(small_chart(), folder.path() / "file", "ratio"); }),
                       (folder.path() / "file").string()));
}

TEST(RunScript, ThatFailsLeavesNoHalfOfAPicture) {
  const TemporaryFolder folder;
  const DrawnChart drawn = draw_chart(small_chart(), folder.path(), "ratio");
  const std::string svg = read_text(drawn.svg), script = read_text(drawn.script);
  write_text(drawn.script, script + "this is no command\n");
  const std::string said = complaint([&] { run_script(folder.path(), "ratio"); });
  EXPECT_TRUE(contains(said, "cannot draw " + drawn.svg.string() + ": gnuplot on " + drawn.script.string()));
  EXPECT_TRUE(contains(said, "invalid command"));
  EXPECT_EQ(read_text(drawn.svg), svg);
  EXPECT_EQ(std::distance(fs::directory_iterator(folder.path()), {}), 4);

  write_text(drawn.script, "set terminal svg\nset output svg\nset print png\nprint 'x'\n");
  EXPECT_TRUE(contains(complaint([&] { run_script(folder.path(), "ratio"); }), "gnuplot wrote an"));
  EXPECT_EQ(read_text(drawn.svg), svg);
}

TEST(DrawChart, DoesNotReadTheUsersOwnSettings) {
  const TemporaryFolder home, folder;
  write_text(home.path() / ".gnuplot", "this is no command\n");
  const Environment variable("HOME", home.path().string());
  EXPECT_EQ(complaint([&] { draw_chart(small_chart(), folder.path(), "ratio"); }), "");
}

}  // namespace
}  // namespace rift::studio

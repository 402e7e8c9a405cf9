#include "engine/results/json_input.hpp"
#include "studio/workbench/lesson.hpp"
#include "tests/studio/commands/tiny_plate.hpp"

#include <gtest/gtest.h>

#include <array>
#include <regex>

namespace rift::studio {
namespace {

namespace fs = std::filesystem;

/// Each kind of page in a browser without a window (Debian's chromium), as wide as a desktop's and as a
/// tablet's: nothing is wider than the window, tables included, which would scroll by themselves.
class ReportPage : public testing::Test {
 protected:
  void SetUp() override {
    if (run_shell("command -v chromium").exit_code != 0) GTEST_SKIP() << "chromium is not installed";
  }

  void expect_fits(const fs::path& page) const {
    ASSERT_TRUE(fs::exists(page)) << page;
    const std::string html = read_text(page);
    for (const char* part : {"<h1>", "version", "machine", "made", "rift "})
      EXPECT_TRUE(contains(html, part));
    for (const int width : {1200, 800}) {
      const std::array<int, 3> widths = widths_in_browser(html, width);
      EXPECT_LE(widths[0], widths[1]) << page << " scrolls sideways at " << width;
      EXPECT_LE(widths[2], 0) << page << " has a table that is cut at " << width;
    }
  }

  fs::path path() const { return folder_.path(); }

 private:
  /// What the page scrolls over, what is seen, and by how much the widest table exceeds its place.
  std::array<int, 3> widths_in_browser(const std::string& html, int width) const {
    const fs::path seen = folder_.path() / "seen.html";
    write_text(seen, html + R"(<script>
      const beyond = [...document.querySelectorAll(".wide")].map(t => t.scrollWidth - t.clientWidth);
      document.body.dataset.widths =
        [document.scrollingElement.scrollWidth, innerWidth, Math.max(0, ...beyond)].join(" ");
      </script>)");
    const Ran ran =
        run_shell("HOME='" + folder_.path().string() +
                  "' chromium --headless --no-sandbox --disable-gpu --window-size=" + std::to_string(width) +
                  ",1000 --dump-dom 'file://" + seen.string() + "'");
    std::smatch found;
    if (!std::regex_search(ran.out, found, std::regex("data-widths=\"(\\d+) (\\d+) (-?\\d+)\""))) {
      ADD_FAILURE() << "chromium showed nothing: " << ran.err;
      return {};
    }
    return {std::stoi(found[1]), std::stoi(found[2]), std::stoi(found[3])};
  }

  TemporaryFolder folder_;
};

TEST_F(ReportPage, OfAStudyFitsTheWindow) {
  const TinyPlate plate;
  std::string text = read_text(plate.preset());
  text.erase(text.find("velocity = "), std::string("velocity = \"0.5 c_r\"\n").size());
  write_text(plate.preset(), text +
                                 "[damping]\nregion = \"all\"\n[study]\n"
                                 "technique = [\"simple\", \"progressive\"]\n"
                                 "relaxation = [\"linear\", \"square-root\"]\ndamage_zone_ratio = [1, 4]\n"
                                 "damping_alpha = [0, 0.01]\ncrack_velocity = [\"0.3 c_r\", \"0.5 c_r\"]\n"
                                 "dt_fraction = [0.25, 0.5]\n");
  const Ran ran =
      run_rift("study '" + plate.preset().string() + "' --quiet --out '" + plate.out().string() + "'",
               plate.environment());
  ASSERT_EQ(ran.exit_code, 0) << ran.err;
  expect_fits(plate.out() / "report.html");
}

TEST_F(ReportPage, OfAnExperimentAndOfItsInstrumentsFitTheWindow) {
  const TinyPlate plate;
  std::string text = read_text(plate.preset());
  text.replace(text.find("velocity = "), std::string("velocity = \"0.5 c_r\"\nend = \"30 mm\"").size(),
               "history = \"measured.csv\"\ndamage_zone_ratio = 2\ntoughness_window = 6");
  write_text(plate.preset(), text);
  std::string rows = "time [us];position [mm];uncertainty [mm]\n";
  for (int k = 0; k <= 18; ++k)
    rows += std::to_string(2 * k) + ";" + std::to_string(5.0 + 1.76 * k) + ";0.06\n";
  write_text(plate.path() / "measured.csv", rows);
  const Ran ran = run_rift("experiment '" + plate.preset().string() +
                               "' --quiet --resamples 2 --specimens 2 --out '" + plate.out().string() + "'",
                           plate.environment());
  ASSERT_EQ(ran.exit_code, 0) << ran.err;
  expect_fits(plate.out() / "report.html");
  const fs::path run = plate.out() / "run";
  ASSERT_EQ(run_rift("measure '" + run.string() + "' --inner 4 --grid 2 --quiet").exit_code, 0);
  expect_fits(run / "measure/report.html");
}

TEST_F(ReportPage, OfAnAccuracyFitsTheWindow) {
  const TinyPlate plate;
  const Ran ran =
      run_rift("accuracy '" + plate.preset().string() + "' --quick --seeds 1 --elements 300 --quiet --out '" +
                   plate.out().string() + "'",
               plate.environment());
  ASSERT_EQ(ran.exit_code, 0) << ran.err;
  expect_fits(plate.out() / "report.html");
}

TEST_F(ReportPage, OfACalibrationFitsTheWindow) {
  const fs::path out = path() / "out";
  const Ran ran = run_rift(
      "calibrate --young '3.2 GPa' --poisson 0.25 --set calibration.elements=300 --set "
      "calibration.packings=2 "
      "--set 'calibration.radius_ratios=[0.2, 0.4, 0.8]' --set 'calibration.sizes=[200, 300]' --quiet --out "
      "'" +
      out.string() + "'");
  ASSERT_EQ(ran.exit_code, 0) << ran.err;
  expect_fits(out / "report.html");
}

TEST_F(ReportPage, OfTheStabilitySuiteFitsTheWindow) {
  const fs::path out = path() / "out";
  const Ran ran = run_rift("stability --quick --only pre-strain --quiet --out '" + out.string() + "'");
  ASSERT_EQ(ran.exit_code, 0) << ran.err;
  expect_fits(out / "report.html");
}

TEST_F(ReportPage, OfTheReproductionFitsTheWindow) {
  const fs::path out = path() / "out";
  ASSERT_EQ(run_rift("reproduce fig01 fig09 fig10 --quiet --out '" + out.string() + "'").exit_code, 0);
  expect_fits(out / "report.html");
}

TEST_F(ReportPage, OfAPackingFitsTheWindow) {
  const fs::path out = path() / "out";
  ASSERT_EQ(run_rift("pack --set specimen.elements=500 --set specimen.coordination=5.5 --quiet --out '" +
                     out.string() + "'")
                .exit_code,
            0);
  expect_fits(out / "report.html");
}

TEST_F(ReportPage, OfALessonFitsTheWindow) {
  const TinyPlate plate;
  write_text(plate.preset(),
             read_text(plate.preset()) +
                 "[[lanes]]\ntechnique = \"simple\"\n[[lanes]]\ntechnique = \"progressive\"\n");
  ASSERT_EQ(plate.run("--quiet").exit_code, 0);
  const fs::path summary = plate.out() / "summary.json";
  const Lanes lanes =
      results::lane_summaries_of(results::read_json(read_text(summary), summary).at("scenarios"));
  Live live;
  for (const std::string& title : results::lane_titles(lanes)) {
    live.lanes.emplace_back().title = title;
    live.lanes.back().rates = {{.tip_m = 0.01, .ratio = 0.5}, {.tip_m = 0.02, .ratio = 0.6}};
  }
  write_handout(lesson_of("node-release"), lanes, live, {{}, "there is no renderer"},
                plate.out() / "handout.html");
  expect_fits(plate.out() / "handout.html");
}

}  // namespace
}  // namespace rift::studio

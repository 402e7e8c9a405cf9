#include "tests/studio/view/xterm.hpp"

#include "tests/expectations.hpp"
#include "tests/viz/drawn_plate.hpp"

#include <chrono>
#include <functional>
#include <thread>

namespace rift::studio {
namespace {

namespace plate = viz::drawn_plate;

/// The picture within the screen: 36 rows above four of text.
viz::Job job_of_window(const std::filesystem::path& run) {
  viz::Job job = plate::job_for(run);
  job.width = Xterm::columns * Xterm::cell_width, job.height = (Xterm::rows - 5) * Xterm::cell_height;
  return job;
}

viz::Colour at(const viz::Image& screen, const viz::Job& job, const std::array<double, 2>& place) {
  return plate::pixel(screen, place[0], place[1] + screen.height - job.height);
}

std::array<double, 2> place_of_element(const viz::Job& job, int i, int moment) {
  const auto p = plate::geometry().position[i];
  return plate::place_of(job, {p[0], p[1] + plate::frame(moment).displacement[i][1]}, {0, 0});
}

/// Sixels have a palette.
constexpr double alike = 0.12;
constexpr viz::Colour dark{0.05, 0.05, 0.05}, white{1, 1, 1};

testing::AssertionResult shows(const Xterm& xterm, const viz::Job& job, const std::array<double, 2>& place,
                               const viz::Colour& colour) {
  viz::Colour seen{};
  for (int k = 0; k < 2 * patience_s; ++k) {
    seen = at(xterm.screenshot(), job, place);
    if (plate::apart(seen, colour) < alike) return testing::AssertionSuccess();
    std::this_thread::sleep_for(std::chrono::milliseconds(400));
  }
  return testing::AssertionFailure() << "is " << seen[0] << " " << seen[1] << " " << seen[2];
}

TEST(Xterm, ShowsThePictureWhereItIsAndTakesItAwayOnLeaving) {
  if (!Xterm::there()) GTEST_SKIP() << "no xterm, Xvfb or import";
  const TemporaryFolder folder;
  const auto run = plate::write_run(folder / "run");
  const viz::Job job = job_of_window(run);
  const Xterm xterm("'" RIFT_EXE "' view '" + run.string() + "'");
  const int i = plate::element(33, 6);
  const auto colour_of = [&](int moment) {
    return viz::colour_at(*viz::find_colour_map("coolwarm"),
                          plate::frame(moment).displacement[i][1] / plate::pulled);
  };
  ASSERT_TRUE(shows(xterm, job, place_of_element(job, i, 0), colour_of(0)));
  xterm.type("...");
  const auto tip =
      plate::place_of(job, {plate::tip_at_moment(3), 0.5 * plate::height + 0.5 * plate::pulled}, {0, 0});
  EXPECT_TRUE(shows(xterm, job, tip, dark));
  const auto opened = plate::place_of(job, {0.005, 0.5 * plate::height + 0.5 * plate::pulled}, {0, 0});
  EXPECT_TRUE(shows(xterm, job, opened, white));
  xterm.type("q");
  EXPECT_TRUE(shows(xterm, job, place_of_element(job, i, 3), white));
}

TEST(Xterm, HelpAndAZoomReplaceThePicture) {
  if (!Xterm::there()) GTEST_SKIP() << "no xterm, Xvfb or import";
  const TemporaryFolder folder;
  const auto run = plate::write_run(folder / "run");
  const viz::Job job = job_of_window(run);
  const Xterm xterm("'" RIFT_EXE "' view '" + run.string() + "' --no-chart");
  viz::Job shown = job;
  shown.look.chart = viz::Chart::none;
  const auto beside = plate::place_of(shown, {-0.3e-3, 0.5 * plate::height}, {0, 0});  // left of the plate
  const auto first = place_of_element(shown, plate::element(0, 7), 0);
  const viz::Colour red =
      viz::colour_at(*viz::find_colour_map("coolwarm"),
                     plate::frame(0).displacement[plate::element(0, 7)][1] / plate::pulled);
  ASSERT_TRUE(shows(xterm, shown, first, red));
  xterm.type("?");
  EXPECT_TRUE(shows(xterm, shown, first, white)) << "the picture is not behind the help";
  xterm.type("?");
  EXPECT_TRUE(shows(xterm, shown, first, red));
  EXPECT_TRUE(shows(xterm, shown, beside, white));
  xterm.type("++++");
  bool filled = false;
  for (int k = 0; k < 2 * patience_s && !filled; ++k) {
    filled = plate::apart(at(xterm.screenshot(), shown, beside), white) > 0.2;
    std::this_thread::sleep_for(std::chrono::milliseconds(400));
  }
  EXPECT_TRUE(filled) << "nearer, the plate reaches beyond its former edge";
}

}  // namespace
}  // namespace rift::studio

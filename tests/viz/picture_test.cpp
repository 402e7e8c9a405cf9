#include "tests/viz/drawn_plate.hpp"
#include "viz/png.hpp"

#include <set>

namespace rift::viz {
namespace {

using namespace drawn_plate;

std::array<double, 2> centre_of(int element, const results::Frame& frame, double magnification) {
  const auto p = geometry().position[element];
  return {p[0] + magnification * frame.displacement[element][0],
          p[1] + magnification * frame.displacement[element][1]};
}

int colours_in(const Image& image) {
  std::set<std::array<std::uint8_t, 3>> seen;
  for (std::size_t k = 0; k + 2 < image.rgb.size(); k += 3)
    seen.insert({image.rgb[k], image.rgb[k + 1], image.rgb[k + 2]});
  return static_cast<int>(seen.size());
}

/// Share of the bytes that differ by more than a quarter of the scale.
double share_apart(const Image& a, const Image& b) {
  EXPECT_EQ(a.rgb.size(), b.rgb.size());
  std::size_t apart = 0;
  for (std::size_t k = 0; k < std::min(a.rgb.size(), b.rgb.size()); ++k)
    apart += std::abs(a.rgb[k] - b.rgb[k]) > 64 ? 1 : 0;
  return static_cast<double>(apart) / static_cast<double>(a.rgb.size());
}

TEST(Picture, AnElementHasTheColourOfItsDisplacement) {
  const TemporaryFolder folder;
  const Job job = job_for(write_run(folder / "run"));
  const Image image = drawn(job, 3);
  const results::Frame shown = frame(3);
  for (const int column : {2, 20, 33})
    for (int row = 0; row < rows; ++row) {
      const int i = element(column, row);
      const auto [x, y] = place_of(job, centre_of(i, shown, 1), {0, 0});
      const Colour expected = colour_at(*find_colour_map("coolwarm"), shown.displacement[i][1] / pulled);
      EXPECT_LT(apart(pixel(image, x, y), expected), 0.04) << "element " << i;
    }
}

TEST(Picture, ItIsWhiteWhereNothingIs) {
  const TemporaryFolder folder;
  const Job job = job_for(write_run(folder / "run"));
  const Image image = drawn(job, 3);
  const auto [x, y] = place_of(job, {0.005, 0.5 * height + 0.5 * pulled}, {0, 0});  // in the open crack
  EXPECT_LT(apart(pixel(image, x, y), {1, 1, 1}), 0.01);
  const auto [below_x, below_y] = place_of(job, {0.02, -0.2e-3}, {0, 0});
  EXPECT_LT(apart(pixel(image, below_x, below_y), {1, 1, 1}), 0.01);
}

/// Four elements that touch leave a pore between them, through which the background once showed.
TEST(Picture, ItIsClosedBetweenTheElements) {
  const TemporaryFolder folder;
  Job job = job_for(write_run(folder / "run"));
  job.look.colours = "inferno", job.look.field = "vx", job.look.range = {0, 1000};  // nearly black
  const Image image = drawn(job, 3);
  for (int column = 16; column < 36; ++column)
    for (int row = 1; row < rows; ++row) {
      if (row == rows / 2) continue;  // on the path of the crack pores stay open
      const double y = 1e-3 * row * (1 + pulled / height);
      const auto [px, py] = place_of(job, {1e-3 * column, y}, {0, 0});
      EXPECT_GT(apart(pixel(image, px, py), {1, 1, 1}), 0.5) << column << ", " << row;
    }
}

TEST(Picture, TheTipIsADarkDotWhereTheTipIs) {
  const TemporaryFolder folder;
  const Job job = job_for(write_run(folder / "run"));
  for (const int moment : {1, 4}) {
    const Image image = drawn(job, moment);
    const auto [x, y] = place_of(job, {tip_at_moment(moment), 0.5 * height + 0.5 * pulled}, {0, 0});
    EXPECT_LT(apart(pixel(image, x, y), {0.05, 0.05, 0.05}), 0.02) << "moment " << moment;
  }
  const auto [x, y] = place_of(job, {tip_at_moment(1), 0.5 * height + 0.5 * pulled}, {0, 0});
  EXPECT_GT(apart(pixel(drawn(job, 4), x, y), {0.05, 0.05, 0.05}), 0.5);
}

int pixels_like(const Image& image, const Colour& colour) {
  int count = 0;
  for (int y = 0; y < image.height; ++y)
    for (int x = 0; x < image.width; ++x) count += apart(pixel(image, x, y), colour) < 0.05 ? 1 : 0;
  return count;
}

TEST(Picture, TheBudgetHasALineForFrictionWhereItTakesSomething) {
  const TemporaryFolder folder;
  const Colour contact{204 / 255.0, 121 / 255.0, 167 / 255.0};
  EXPECT_GT(pixels_like(drawn(job_for(write_run(folder / "rubs", 6, 1, 0.5)), 5), contact), 100);
  EXPECT_EQ(pixels_like(drawn(job_for(write_run(folder / "meets", 6, 1, 1e-5)), 5), contact), 0);
  EXPECT_EQ(pixels_like(drawn(job_for(write_run(folder / "free")), 5), contact), 0);
}

TEST(Picture, ACloseUpFollowsTheTip) {
  const TemporaryFolder folder;
  Job job = job_for(write_run(folder / "run"));
  job.look.camera = Camera::tip;
  job.look.close_up_m = 4e-3;
  for (const int moment : {2, 5}) {
    const std::array<double, 2> tip{tip_at_moment(moment), 0.5 * height + 0.5 * pulled};
    const auto [x, y] = place_of(job, tip, tip);
    EXPECT_LT(apart(pixel(drawn(job, moment), x, y), {0.05, 0.05, 0.05}), 0.02) << "moment " << moment;
  }
}

TEST(Picture, BeamsShowWhatTheyStillBear) {
  const TemporaryFolder folder;
  Job job = job_for(write_run(folder / "run"));
  job.look.beams = Beams::all;
  job.look.spheres = false;
  job.look.camera = Camera::tip;
  job.look.close_up_m = 4e-3;
  const results::Frame shown = frame(3);
  const std::array<double, 2> tip{tip_at_moment(3), 0.5 * height + 0.5 * pulled};
  const Image image = drawn(job, 3);
  const auto middle_of_crossing = [&](int column) {
    const auto a = centre_of(element(column, rows / 2 - 1), shown, 1),
               b = centre_of(element(column, rows / 2), shown, 1);
    const auto [x, y] = place_of(job, {0.5 * (a[0] + b[0]), 0.5 * (a[1] + b[1])}, tip);
    return pixel(image, x, y);
  };
  const Colour broken = middle_of_crossing(10), softening = middle_of_crossing(13),
               whole = middle_of_crossing(15);
  EXPECT_GT(broken[0], 0.6) << "pale";
  EXPECT_NEAR(broken[0], broken[2], 0.15);
  EXPECT_GT(softening[0], softening[2] + 0.5) << "between yellow and red";
  EXPECT_LT(whole[0], 0.4) << "dark";
}

TEST(Picture, TheChartGrowsWithTime) {
  const TemporaryFolder folder;
  const Job job = job_for(write_run(folder / "run"));
  const auto blue_pixels = [&](int moment) {
    const Image image = drawn(job, moment);
    int count = 0;
    for (int y = 0; y < image.height / 3; ++y)
      for (int x = 0; x < image.width; ++x)
        count += apart(pixel(image, x, y), {0, 114 / 255.0, 178 / 255.0}) < 0.02 ? 1 : 0;
    return count;
  };
  const int early = blue_pixels(1), late = blue_pixels(5);
  EXPECT_GT(early, 50);
  EXPECT_GT(late, 2 * early);
}

/// The column within a box in which most pixels have a colour, and how many.
std::array<int, 2> column_like(const Image& image, const Box& box, const Colour& colour) {
  std::array<int, 2> best{};
  for (int x = static_cast<int>(box.x0); x < static_cast<int>(box.x1); ++x) {
    int count = 0;
    for (int y = static_cast<int>(box.y0); y < static_cast<int>(box.y1); ++y)
      count += apart(pixel(image, x, y), colour) < 0.05 ? 1 : 0;
    if (count > best[1]) best = {x, count};
  }
  return best;
}

TEST(Picture, WholeChartsShowTheWholeRunWithALineAtTheMoment) {
  const TemporaryFolder folder;
  Job job = job_for(write_run(folder / "run"));
  job.width = 1280, job.height = 720;
  job.look.chart = Chart::whole;
  const Extent plate{length, height + pulled, 0.5 * height};
  const Layout layout = layout_of(job, plate);
  const Colour ink_of_line{33 / 255.0, 38 / 255.0, 46 / 255.0}, blue{0, 114 / 255.0, 178 / 255.0};
  const Image first = drawn(job, 1), second = drawn(job, 2), third = drawn(job, 3);
  for (const Box& box : {layout.chart.front(), layout.ratio}) {
    const auto a = column_like(first, box, ink_of_line), b = column_like(second, box, ink_of_line),
               c = column_like(third, box, ink_of_line);
    for (const auto& column : {a, b, c}) EXPECT_GT(column[1], 0.4 * box.height());
    EXPECT_GT(b[0], a[0] + 10);
    EXPECT_NEAR(b[0] - a[0], c[0] - b[0], 2) << "as far as the moments are apart";
  }
  EXPECT_NEAR(pixels_like(first, blue), pixels_like(third, blue), 30) << "the energies of the whole run";
  EXPECT_GT(pixels_like(first, {0, 0, 0}), 200) << "the release rate";
}

TEST(Picture, TwoRunsOfTheRendererGiveTheSameBytes) {
  const TemporaryFolder folder;
  const Job job = job_for(write_run(folder / "run", 6, 2), 2);
  for (const Gl gl : {Gl::osmesa, Gl::egl}) EXPECT_EQ(drawn(job, 4, gl).rgb, drawn(job, 4, gl).rgb);
}

TEST(Picture, AFrameIsThatOfItsTimeWhateverWasDrawnBefore) {
  const TemporaryFolder folder;
  const Job job = job_for(write_run(folder / "run"));
  Renderer renderer(job, Gl::osmesa, false, programs());
  std::vector<Image> images;
  for (const double time : {5e-6, 2e-6}) renderer.ask(time);
  for (int k = 0; k < 2; ++k) images.push_back(renderer.next());
  EXPECT_EQ(images[0].rgb, drawn(job, 5).rgb);
  EXPECT_EQ(images[1].rgb, drawn(job, 2).rgb);
  EXPECT_NE(images[0].rgb, images[1].rgb);
}

TEST(Picture, BothWaysToOpenGlDrawTheSame) {
  const TemporaryFolder folder;
  const Job job = job_for(write_run(folder / "run"));
  const Image osmesa = drawn(job, 3, Gl::osmesa), egl = drawn(job, 3, Gl::egl);
  EXPECT_GT(colours_in(osmesa), 100);
  EXPECT_LT(share_apart(osmesa, egl), 0.01);
}

/// A look that a baseline is kept of.
struct Kept {
  const char* name;
  int lanes;
  void (*change)(Job&);
};

class Baseline : public testing::TestWithParam<Kept> {};

TEST_P(Baseline, IsMetByThePicture) {
  const TemporaryFolder folder;
  Job job = job_for(write_run(folder / "run", 6, GetParam().lanes), GetParam().lanes);
  GetParam().change(job);
  const Image image = drawn(job, 4);
  EXPECT_GT(colours_in(image), 100);
  const std::filesystem::path kept = std::filesystem::path(RIFT_SOURCE_DIR) / "tests/data/pictures" /
                                     (std::string(GetParam().name) + ".png");
  if (getenv("RIFT_KEEP_PICTURES") != nullptr) write_png(kept, image);
  EXPECT_LT(share_apart(image, read_png(kept)), 0.01)
      << "RIFT_KEEP_PICTURES=1 keeps the new picture as " << kept;
}

INSTANTIATE_TEST_SUITE_P(Picture, Baseline,
                         testing::Values(Kept{"plate", 1, [](Job&) {}}, Kept{"four_panes", 4, [](Job&) {}},
                                         Kept{"tip", 1,
                                              [](Job& j) {
                                                j.look.camera = Camera::tip, j.look.close_up_m = 5e-3,
                                                j.look.beams = Beams::all;
                                              }},
                                         Kept{"side", 1, [](Job& j) { j.look.camera = Camera::side; }},
                                         Kept{"boundaries", 1,
                                              [](Job& j) {
                                                j.look.boundaries = true, j.look.chart = Chart::none,
                                                j.look.magnification = 0;
                                              }},
                                         Kept{"large_text", 2, [](Job& j) { j.look.large_text = true; }}),
                         [](const auto& kept) { return std::string(kept.param.name); });

}  // namespace
}  // namespace rift::viz

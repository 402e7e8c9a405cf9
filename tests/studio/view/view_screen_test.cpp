#include "studio/view/view_screen.hpp"

#include "tests/expectations.hpp"
#include "tests/viz/drawn_plate.hpp"

#include <chrono>
#include <cmath>
#include <functional>
#include <thread>

namespace rift::studio {
namespace {

namespace plate = viz::drawn_plate;

/// The viewer without a terminal: it is given room, drawn, and looked at.
class Viewer {
 public:
  explicit Viewer(viz::Request request, bool symbols = false, bool pictures = true)
      : screen_(std::move(request), viz::Gl::any, RIFT_EXE) {
    screen_.commands_go_to(commands);
    room_ = {.pictures = pictures, .symbols = symbols, .cell_width = 8, .cell_height = 16};
    round();
  }
  explicit Viewer(const std::filesystem::path& run) : Viewer(request_for(run)) {}

  static viz::Request request_for(const std::filesystem::path& run) {
    viz::Request request;
    request.runs = {run};
    return request;
  }

  void round() {
    screen_.take_room(room_);
    (void)screen_.look();
    Canvas canvas(width_, 34);
    screen_.draw(canvas, Glyphs::unicode);
    text_.clear();
    for (int y = 0; y < 34; ++y) text_ += canvas.row(y) + "\n";
    const auto picture = screen_.picture();
    if (picture && takes_) room_.shown = picture->number;
  }
  /// The terminal has another width.
  void resize(int width) {
    width_ = width;
    round();
  }
  /// The terminal takes no more pictures, or each at once.
  void take_pictures(bool wanted) { takes_ = wanted; }
  /// Of pictures.
  void limit_width(int pixels) {
    room_.most_width = pixels;
    round();
  }
  [[nodiscard]] testing::AssertionResult has_picture() {
    return until([&] { return screen_.picture().has_value(); });
  }
  void press(int key) {
    (void)screen_.press({key});
    round();
  }
  void type(const std::string& letters) {
    for (const char c : letters) (void)screen_.press({c});
    press(key_enter);
  }
  void mouse(int key, int x, int y) {
    (void)screen_.press({key, x, y});
    round();
  }
  [[nodiscard]] testing::AssertionResult until(const std::function<bool()>& is_so) {
    const auto patience = std::chrono::steady_clock::now() + std::chrono::seconds(patience_s);
    while (!is_so()) {
      if (std::chrono::steady_clock::now() > patience) return testing::AssertionFailure() << text_;
      std::this_thread::sleep_for(std::chrono::milliseconds(5));
      round();
    }
    return testing::AssertionSuccess();
  }
  [[nodiscard]] testing::AssertionResult shows(const std::string& part) {
    return until([&] { return text_.find(part) != std::string::npos; });
  }
  /// The picture of the present state, all of its pixels.
  std::optional<ScreenPicture> picture() {
    int at_rest = 0;  // rounds in which nothing moves and nothing is being drawn
    EXPECT_TRUE(until([&] {
      const bool rests = screen_.picture() && screen_.picture()->width == 800 && screen_.patience_ms() > 20 &&
                         screen_.wakened_by() < 0;
      at_rest = rests ? at_rest + 1 : 0;
      return at_rest > 3;
    }));
    return screen_.picture();
  }
  std::vector<std::string> commands;

 private:
  ViewScreen screen_;
  PictureRoom room_;
  int width_ = 100;
  bool takes_ = true;
  std::string text_;
};

/// The cell in which a point of the plate is drawn.
std::array<int, 2> cell_of(const viz::Job& job, const std::array<double, 2>& point) {
  const auto [x, y] = plate::place_of(job, point, {0, 0});
  return {static_cast<int>(x / 8), static_cast<int>((job.height - y) / 16)};
}

viz::Job job_shown(const std::filesystem::path& run) {
  viz::Job job = plate::job_for(run);
  job.width = 800, job.height = 480;
  return job;
}

TEST(ViewScreen, OpensARunThatGoesOnAtItsNewestMoment) {
  const TemporaryFolder folder;
  const auto run = plate::write_run(folder / "run");
  const auto journal = run / results::journal_name;
  std::filesystem::resize_file(journal, std::filesystem::file_size(journal) - 2000);  // within the last frame
  Viewer viewer(run);
  EXPECT_TRUE(viewer.shows("frame 5 of 5 so far   t = 4.0 µs   tip 16.0 mm"));
}

TEST(ViewScreen, ShowsThePictureOfItsCommand) {
  const TemporaryFolder folder;
  const auto run = plate::write_run(folder / "run");
  Viewer viewer(run);
  ASSERT_TRUE(viewer.shows("frame 1 of 6   t = 0.0 µs   tip 0.0 mm"));
  for (int k = 0; k < 3; ++k) viewer.press('.');
  ASSERT_TRUE(viewer.shows("frame 4 of 6   t = 3.0 µs   tip 12.0 mm   v 0.50 c_R   uy 0 to 0.4 mm"));
  viewer.press('+');
  viewer.press('D');
  viewer.press('c');
  const auto shown = viewer.picture();
  ASSERT_TRUE(shown);
  ASSERT_EQ(viewer.commands.size(), 1U);
  const auto file = folder / "again.png";
  const std::string command = viewer.commands[0] + " --picture '" + file.string() + "' --quiet";
  ASSERT_EQ(
      std::system(("PATH=" + plate::programs().string() + ":$PATH " + command + " > /dev/null").c_str()), 0)
      << command;
  const viz::Image again = viz::read_png(file);
  ASSERT_EQ(again.width, shown->width);
  EXPECT_TRUE(std::equal(again.rgb.begin(), again.rgb.end(), shown->rgb.begin(), shown->rgb.end()));
}

TEST(ViewScreen, TheCommandTurnsTheChartOnWhereThePresetTurnsItOff) {
  const TemporaryFolder folder;
  viz::Request request = Viewer::request_for(plate::write_run(folder / "run"));
  Viewer whole(request);
  whole.press('c');
  EXPECT_TRUE(contains(whole.commands.back(), " --chart whole "));
  request.chart = "growing";  // asked for
  Viewer growing(request);
  growing.press('c');
  EXPECT_TRUE(contains(growing.commands.back(), " --chart growing "));
  growing.press('e');
  growing.press('c');
  EXPECT_TRUE(contains(growing.commands.back(), " --chart none "));
}

TEST(ViewScreen, PlaysToTheEndAndJumpsToATypedTimeOrTip) {
  const TemporaryFolder folder;
  Viewer viewer(plate::write_run(folder / "run"));
  viewer.press(' ');
  EXPECT_TRUE(viewer.shows("frame 6 of 6"));
  viewer.press('t');
  viewer.type("2 us");
  EXPECT_TRUE(viewer.shows("frame 3 of 6"));
  viewer.press('t');
  viewer.type("17 mm");
  EXPECT_TRUE(viewer.shows("frame 5 of 6"));
  viewer.press('t');
  viewer.type("soon");
  EXPECT_TRUE(viewer.shows("'soon' is neither a time such as 12 us nor a tip position such as 30 mm"));
  viewer.press(key_home);
  EXPECT_TRUE(viewer.shows("frame 1 of 6"));
}

TEST(ViewScreen, AClickNamesTheElementAndTwoMeasure) {
  const TemporaryFolder folder;
  const auto run = plate::write_run(folder / "run");
  Viewer viewer(run);
  ASSERT_TRUE(viewer.picture());
  const viz::Job job = job_shown(run);
  const auto centre = [&](int i) {
    const auto p = plate::geometry().position[i];
    return std::array<double, 2>{p[0], p[1] + plate::frame(0).displacement[i][1]};
  };
  const int a = plate::element(10, 6), b = plate::element(30, 6);
  for (const int i : {a, b}) {
    const auto [x, y] = cell_of(job, centre(i));
    viewer.mouse(key_click, x, y);
    viewer.mouse(key_release, x, y);
    ASSERT_TRUE(viewer.shows("element " + std::to_string(i) + " "));
    EXPECT_TRUE(viewer.shows("gauge 0, "));
  }
  EXPECT_TRUE(viewer.shows("distance 20 mm unloaded, 20 mm now"));
}

TEST(ViewScreen, TheCrosshairAsksWhatIsUnderIt) {
  const TemporaryFolder folder;
  Viewer viewer(plate::write_run(folder / "run"));
  const auto before = viewer.picture();
  const std::vector<std::uint8_t> plain(before->rgb.begin(), before->rgb.end());
  viewer.press('i');
  const auto with = viewer.picture();
  EXPECT_FALSE(std::equal(plain.begin(), plain.end(), with->rgb.begin(), with->rgb.end()));
  const int i = plate::element(20, 6);  // its column is just beside the middle of the plate
  const auto p = plate::geometry().position[i];
  const viz::Job job = job_shown(folder / "run");
  const auto at = plate::place_of(job, {p[0], p[1] + plate::frame(0).displacement[i][1]}, {0, 0});
  const auto middle =
      plate::place_of(job, {0.5 * plate::length, 0.5 * (plate::height + plate::pulled)}, {0, 0});
  for (int k = 0; k < std::lround(100 * (at[1] - middle[1]) / 480); ++k) viewer.press(key_up);
  for (int k = 0; k < std::lround(100 * (at[0] - middle[0]) / 800); ++k) viewer.press(key_right);
  viewer.press(key_enter);
  EXPECT_TRUE(viewer.shows("element " + std::to_string(i) + " "));
  viewer.press('i');
  const auto without = viewer.picture();
  EXPECT_TRUE(std::equal(plain.begin(), plain.end(), without->rgb.begin(), without->rgb.end()));
}

TEST(ViewScreen, DraggingMovesThePlateAndIsNoClick) {
  const TemporaryFolder folder;
  Viewer viewer(plate::write_run(folder / "run"));
  ASSERT_TRUE(viewer.picture());
  viewer.mouse(key_click, 50, 8);
  viewer.mouse(key_drag, 55, 8);
  viewer.mouse(key_release, 55, 8);
  viewer.press('c');
  ASSERT_EQ(viewer.commands.size(), 1U);
  const viz::Job job = job_shown(folder / "run");
  const viz::Extent plate{plate::length, plate::height + plate::pulled, 0.5 * plate::height};
  const viz::Box picture = viz::layout_of(job, plate).panes.front().picture;
  const viz::Window window = viz::window_of(job.look, picture, plate, {0, 0});
  const double moved_m = 40 * window.height / picture.height();
  const std::size_t at = viewer.commands[0].find("--view ");
  ASSERT_NE(at, std::string::npos);
  EXPECT_NEAR(std::stod(viewer.commands[0].substr(at + 7)), 1e3 * (0.5 * plate::length - moved_m), 1e-3);
}

TEST(ViewScreen, KeysChangeTheLookAndPassOverWhatIsNotStored) {
  const TemporaryFolder folder;
  Viewer viewer(plate::write_run(folder / "run"));
  for (const char* field : {"uz", "u", "vx", "vy", "vz", "v", "kinetic", "damage", "ux", "uy"}) {
    viewer.press('f');
    EXPECT_TRUE(viewer.shows(std::string("   ") + field + " ")) << "elastic energies are not stored";
  }
  viewer.press('r');
  EXPECT_TRUE(viewer.shows("range: of each moment"));
  viewer.press('r');
  for (int k = 0; k < 20; ++k) viewer.press(key_backspace);
  viewer.type("0.1,0.3");
  EXPECT_TRUE(viewer.shows("uy 0.1 to 0.3 mm"));
  viewer.press('x');
  viewer.press(key_backspace);
  viewer.type("4");
  EXPECT_TRUE(viewer.shows("displacements x 4"));
  viewer.press('v');
  EXPECT_TRUE(viewer.shows("camera: tip"));
  viewer.press('b');
  viewer.press('e');
  viewer.press('c');
  EXPECT_TRUE(contains(viewer.commands.back(),
                       "--camera tip --close-up 0.02 --beams crossing --magnification 4 --chart none"));
}

TEST(ViewScreen, AnotherSizeIsDrawnAlsoWhileAPictureWaitsToBeSent) {
  const TemporaryFolder folder;
  Viewer viewer(plate::write_run(folder / "run"));
  ASSERT_TRUE(viewer.picture());
  for (int k = 0; k < 12; ++k) viewer.press('<');  // minutes until it has been played
  viewer.press(' ');
  viewer.take_pictures(false);
  viewer.press('i');  // a new picture that is not sent
  viewer.resize(80);
  EXPECT_TRUE(viewer.has_picture());
}

TEST(ViewScreen, APictureOfTheSamePixelsIsThereAlsoAtAnotherPlace) {
  const TemporaryFolder folder;
  Viewer viewer(plate::write_run(folder / "run"));
  viewer.limit_width(720);
  ASSERT_TRUE(viewer.has_picture());
  viewer.resize(98);
  EXPECT_TRUE(viewer.has_picture()) << "one cell further to the left";
}

TEST(ViewScreen, SymbolsHaveNoTextsInThePictureAndFilesDo) {
  const TemporaryFolder folder;
  Viewer viewer(Viewer::request_for(plate::write_run(folder / "run")), true);
  ASSERT_TRUE(viewer.picture());
  viewer.press('c');
  EXPECT_FALSE(contains(viewer.commands.back(), "--no-text"));
  EXPECT_TRUE(contains(viewer.commands.back(), "--size 1280x720"));
}

TEST(ViewScreen, TwoPicturesThatAreSavedAtOnceHaveFilesOfTheirOwn) {
  const TemporaryFolder folder;
  const auto run = plate::write_run(folder / "run");
  Viewer viewer(run);
  viewer.press('p');
  viewer.press('p');
  EXPECT_TRUE(viewer.until([&] {
    return std::filesystem::exists(run / "view.png") && std::filesystem::exists(run / "view_2.png");
  }));
}

TEST(ViewScreen, WithoutPicturesThePlateIsInCells) {
  const TemporaryFolder folder;
  Viewer viewer(Viewer::request_for(plate::write_run(folder / "run")), false, false);
  EXPECT_TRUE(viewer.shows("the plate is in cells"));
  EXPECT_TRUE(viewer.shows("▀"));
  viewer.press('.');
  EXPECT_TRUE(viewer.shows("frame 2 of 6   t = 1.0 µs   tip 4.0 mm"));
}

TEST(ViewScreen, UpToFourLanesAreSideBySide) {
  const TemporaryFolder folder;
  viz::Request request = Viewer::request_for(plate::write_run(folder / "run", 6, 4));
  Viewer viewer(request);
  ASSERT_TRUE(viewer.picture());
  viewer.press('c');
  EXPECT_FALSE(contains(viewer.commands.back(), "--lane"));
  request.lanes = {1, 3};
  Viewer two(request);
  two.press('c');
  EXPECT_TRUE(contains(two.commands.back(), "--lane 1 --lane 3 --field"));
  EXPECT_THROW(Viewer(plate::write_run(folder / "five", 6, 5)), viz::BadRequest);
}

}  // namespace
}  // namespace rift::studio

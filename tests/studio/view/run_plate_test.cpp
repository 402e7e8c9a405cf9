#include "studio/view/run_plate.hpp"

#include "tests/expectations.hpp"
#include "tests/viz/drawn_plate.hpp"

#include <chrono>
#include <functional>
#include <thread>

namespace rift::studio {
namespace {

namespace plate = viz::drawn_plate;

constexpr Area place{2, 3, 60, 20};

testing::AssertionResult looks_until(PlatePicture& picture, const PictureRoom& room,
                                     const std::function<bool()>& is_so, const PlateView& view = {.lanes = {0}}) {
  const auto until = std::chrono::steady_clock::now() + std::chrono::seconds(patience_s);
  while (!is_so()) {
    if (std::chrono::steady_clock::now() > until) return testing::AssertionFailure() << picture.trouble();
    picture.look(place, room, view);
    std::this_thread::sleep_for(std::chrono::milliseconds(5));
  }
  return testing::AssertionSuccess();
}

const PictureRoom kitty{.pictures = true, .cell_width = 10, .cell_height = 20};

TEST(RunPlate, BeforeTheFirstFrameOfARunThatGoesOnSaysSo) {
  const TemporaryFolder folder;
  const auto run = folder / "run";
  std::filesystem::create_directories(run);
  results::JournalWriter journal(run / results::journal_name);
  journal.write(results::RunHeader{plate::header().dump()});
  journal.write(plate::geometry());
  journal.flush();
  const auto picture = plate_of_runs({run}, plate::programs());
  ASSERT_TRUE(looks_until(*picture, kitty, [&] { return !picture->trouble().empty(); }));
  EXPECT_EQ(picture->trouble(), "no frame is stored yet");
  for (int k = 0; k < 3; ++k) journal.write(plate::frame(k));
  journal.flush();
  ASSERT_TRUE(looks_until(*picture, kitty, [&] { return picture->picture().has_value(); }));
  EXPECT_EQ(picture->trouble(), "");
  EXPECT_EQ(picture->picture()->width, 600);
}

TEST(RunPlate, IsNoLargerThanTheTerminalsLargestPicture) {
  const TemporaryFolder folder;
  const auto picture = plate_of_runs({plate::write_run(folder / "run")}, plate::programs());
  PictureRoom room = kitty;
  room.most_width = 400, room.most_height = 300;
  ASSERT_TRUE(looks_until(*picture, room, [&] { return picture->picture().has_value(); }));
  EXPECT_EQ(picture->picture()->area.x, 12);
  EXPECT_EQ(picture->picture()->area.width, 40);
  EXPECT_EQ(picture->picture()->width, 400);
  EXPECT_EQ(picture->picture()->height, 300);
}

TEST(RunPlate, ShowsTwoRunsAtAMomentOfTheirs) {
  const TemporaryFolder folder;
  const std::vector<std::filesystem::path> runs{plate::write_run(folder / "a"), plate::write_run(folder / "b")};
  const auto picture = plate_of_runs(runs, plate::programs());
  PlateView view{.until = 0};
  ASSERT_TRUE(looks_until(*picture, kitty, [&] { return picture->picture().has_value(); }, view));
  const std::uint64_t number = picture->picture()->number;
  const std::vector<std::uint8_t> first(picture->picture()->rgb.begin(), picture->picture()->rgb.end());
  view.until = 1;
  ASSERT_TRUE(looks_until(*picture, kitty, [&] { return picture->picture()->number > number; }, view));
  const auto last = picture->picture()->rgb;
  EXPECT_FALSE(std::equal(first.begin(), first.end(), last.begin(), last.end()));
}

TEST(RunPlate, WithoutADrawingProgramSaysSo) {
  const TemporaryFolder folder;
  const auto picture = plate_of_runs({plate::write_run(folder / "run")}, folder / "nothing");
  EXPECT_TRUE(contains(picture->trouble(), "cannot start "));
}

}  // namespace
}  // namespace rift::studio

#include "viz/record.hpp"

#include "tests/viz/scripts.hpp"
#include "viz/png.hpp"

#include <thread>

namespace rift::viz {
namespace {

using namespace drawn_plate;
namespace fs = std::filesystem;

const Making with_programs{.gl = Gl::osmesa, .programs = programs()};

TEST(Record, PicturesAreTheFramesOfTheirTimes) {
  const TemporaryFolder folder;
  const Job job = job_for(write_run(folder / "run"));
  const std::vector<double> times{0, 2e-6, 5e-6};
  make_pictures(job, times, folder / "pngs", with_programs);
  EXPECT_EQ(read_png(folder / "pngs" / "frame_000001.png").rgb, drawn(job, 2).rgb);
  EXPECT_EQ(read_png(folder / "pngs" / "frame_000002.png").rgb, drawn(job, 5).rgb);
  EXPECT_FALSE(fs::exists(folder / "pngs" / "frame_000003.png"));
  make_pictures(job, std::vector<double>{0}, folder / "pngs", with_programs);
  EXPECT_FALSE(fs::exists(folder / "pngs" / "frame_000001.png")) << "of the earlier film";
}

TEST(Record, AFilmThatIsStoppedLeavesNothing) {
  const TemporaryFolder folder;
  const Job job = job_for(write_run(folder / "run"));
  Making making = with_programs;
  making.go_on = [](std::size_t done, std::size_t) { return done < 2; };
  const std::vector<double> times{0, 1e-6, 2e-6, 3e-6};
  EXPECT_THROW(make_film(job, times, 10, folder / "a.mp4", making), Stopped);
  EXPECT_FALSE(fs::exists(folder / "a.mp4") ||
               std::distance(fs::directory_iterator(folder / "."), fs::directory_iterator()) != 1);
}

TEST(Record, ARunThatGoesOnIsFollowedToItsEnd) {
  const TemporaryFolder folder;
  const fs::path run = write_run(folder / "run", 6), growing = folder / "growing";
  fs::create_directories(growing);
  const std::uintmax_t whole = fs::file_size(run / results::journal_name);
  fs::copy_file(run / results::journal_name, growing / results::journal_name);
  fs::resize_file(growing / results::journal_name, whole / 2);
  std::atomic<bool> ended = false;
  std::size_t most = 0;
  Making making = with_programs;
  making.go_on = [&](std::size_t done, std::size_t) {
    most = std::max(most, done + 1);
    return true;
  };
  std::thread writer([&] {
    std::this_thread::sleep_for(std::chrono::milliseconds(500));
    fs::copy_file(run / results::journal_name, growing / results::journal_name,
                  fs::copy_options::overwrite_existing);
    ended = true;
  });
  follow_film(job_for(growing), 10, folder / "a.mp4", making, ended);
  writer.join();
  EXPECT_EQ(most, 6U);
  EXPECT_GT(fs::file_size(folder / "a.mp4"), 1000U);
}

}  // namespace
}  // namespace rift::viz

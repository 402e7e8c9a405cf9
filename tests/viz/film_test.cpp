#include "viz/film.hpp"

#include "tests/full_disk.hpp"
#include "tests/viz/scripts.hpp"
#include "viz/png.hpp"

namespace rift::viz {
namespace {

namespace fs = std::filesystem;

Image grey(int shade) {
  Image image{64, 32, std::vector<std::uint8_t>(64 * 32 * 3, static_cast<std::uint8_t>(shade))};
  image.rgb[0] = 255;  // so that rows and channels can be told
  return image;
}

/// What ffprobe says of the frames.
int frames_in(const fs::path& film) {
  const std::string command =
      "ffprobe -v error -count_frames -select_streams v:0 -show_entries stream=nb_read_frames -of "
      "csv=p=0 '" +
      film.string() + "'";
  FILE* pipe = popen(command.c_str(), "r");
  int frames = -1;
  if (fscanf(pipe, "%d", &frames) != 1) frames = -1;
  pclose(pipe);
  return frames;
}

void make(const fs::path& path, int frames) {
  Film film(path, 64, 32, 10);
  for (int k = 0; k < frames; ++k) film.add(grey(20 * k));
  film.finish();
}

std::string failure_of(const fs::path& path, int frames) {
  try {
    make(path, frames);
  } catch (const FilmFailed& failure) {
    return failure.what();
  }
  return "no failure";
}

std::size_t files_in(const fs::path& folder) {
  return static_cast<std::size_t>(std::distance(fs::directory_iterator(folder), fs::directory_iterator{}));
}

TEST(Film, HoldsAllItsFramesInEveryFormat) {
  const TemporaryFolder folder;
  for (const char* name : {"a.mp4", "a.webm", "a.gif"}) {
    make(folder / name, 7);
    EXPECT_EQ(frames_in(folder / name), 7) << name;
  }
}

TEST(Film, OfWhichNothingIsFinishedLeavesNothing) {
  const TemporaryFolder folder;
  {
    Film film(folder / "a.mp4", 64, 32, 10);
    film.add(grey(7));
  }
  EXPECT_EQ(files_in(folder.path()), 0U);
}

TEST(Film, WithoutFfmpegSaysSo) {
  const TemporaryFolder folder;
  const PathOf path(folder.path().string());
  EXPECT_EQ(failure_of(folder / "a.mp4", 3), "cannot start ffmpeg: No such file or directory");
  EXPECT_FALSE(fs::exists(folder / "a.mp4"));
}

TEST(Film, ThatFfmpegCannotMakeIsNotThere) {
  const TemporaryFolder folder, programs;
  const auto with = [&](const std::string& script) {
    write_script(programs / "ffmpeg", script);
    const PathOf path(programs.path().string() + ":/bin:/usr/bin");
    return failure_of(folder / "a.mp4", 40);
  };
  EXPECT_EQ(with("cat >/dev/null; echo 'No space left on device' >&2; exit 1"),
            "ffmpeg ended with code 1: No space left on device");
  EXPECT_EQ(with("kill -9 $$"), "ffmpeg was killed by signal 9 (Killed)");
  EXPECT_EQ(with("cat >/dev/null; exit 0"), "ffmpeg wrote no data");
  EXPECT_EQ(with("cat >/dev/null; for last; do true; done; echo half >\"${last#file:}\"\n"
                 "echo 'Error closing file: No space left on device' >&2"),
            "ffmpeg ended with code 0: Error closing file: No space left on device");
  EXPECT_EQ(files_in(folder.path()), 0U);
}

TEST(Film, HasAnEndingThatIsKnown) {
  for (const char* name : {"a.mp4", "b.webm", "c.gif"}) EXPECT_TRUE(is_film_name(name)) << name;
  for (const char* name : {"a.avi", "mp4", "a.mp4.png"}) EXPECT_FALSE(is_film_name(name)) << name;
}

TEST(Png, ComesBackAsItWas) {
  const TemporaryFolder folder;
  const Image image = grey(77);
  write_png(folder / "a.png", image);
  const Image back = read_png(folder / "a.png");
  EXPECT_EQ(back.width, 64);
  EXPECT_EQ(back.height, 32);
  EXPECT_EQ(back.rgb, image.rgb);
  EXPECT_THROW(write_png(folder / "nowhere" / "a.png", image), std::runtime_error);
  EXPECT_THROW((void)read_png(folder / "b.png"), std::runtime_error);
}

TEST(Png, OnAFullDiskIsAnErrorAndNoFile) {
  const TemporaryFolder folder;
  {
    const FullDisk full(20);
    EXPECT_THROW(write_png(folder / "a.png", grey(1)), std::runtime_error);
  }
  EXPECT_TRUE(fs::is_empty(folder / "."));
}

}  // namespace
}  // namespace rift::viz

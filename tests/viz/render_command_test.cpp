#include "tests/studio/commands/tiny_plate.hpp"
#include "tests/studio/run_rift.hpp"
#include "tests/viz/scripts.hpp"
#include "viz/png.hpp"

namespace rift::studio {
namespace {

namespace fs = std::filesystem;
using viz::drawn_plate::write_run;

/// `rift render ARGUMENTS` in a folder.
Ran render_in(const TemporaryFolder& folder, const std::string& arguments,
              const std::string& environment = "") {
  return run_shell("cd '" + folder.path().string() + "' && env -u DISPLAY " + environment +
                   " '" RIFT_EXE "' render " + arguments);
}

TEST(Render, MakesAFilmInTheRunsFolderByDefault) {
  const TemporaryFolder folder;
  write_run(folder / "run");
  const Ran ran = render_in(folder, "run --size 320x180");
  EXPECT_EQ(ran.exit_code, 0) << ran.err;
  EXPECT_EQ(ran.out, "run/film_uy.mp4\n");
  EXPECT_GT(fs::file_size(folder / "run" / "film_uy.mp4"), 1000U);
}

TEST(Render, MakesOnePictureAPosterAndASequence) {
  const TemporaryFolder folder;
  write_run(folder / "run");
  const Ran ran =
      render_in(folder, "run --size 320x180 --at 0.5 --picture a.png --poster --png frames --frames 3");
  EXPECT_EQ(ran.exit_code, 0) << ran.err;
  EXPECT_EQ(ran.out, "a.png\nframes\nrun/poster_uy.png\n");
  EXPECT_EQ(viz::read_png(folder / "a.png").width, 320);
  EXPECT_TRUE(fs::exists(folder / "frames" / "frame_000002.png"));
  EXPECT_FALSE(fs::exists(folder / "frames" / "frame_000003.png"));
}

TEST(Render, DrawsARunWhoseNameIsNoUtf8) {
  const TemporaryFolder folder;
  const std::string name = "r\xe9s\x1b[2J\nb";
  write_run(folder / name);
  const Ran ran = render_in(folder, "'" + name + "' --size 320x180 --poster --film 'f\xe9.mp4'");
  EXPECT_EQ(ran.exit_code, 0) << ran.err;
  EXPECT_EQ(ran.err, "");
  EXPECT_EQ(ran.out, "f\xe9.mp4\nf\xe9.png\n");
  EXPECT_GT(fs::file_size(folder / "f\xe9.mp4"), 1000U);
  EXPECT_EQ(viz::read_png(folder / "f\xe9.png").width, 320);
}

TEST(Render, NeverOverwritesSilently) {
  const TemporaryFolder folder;
  write_run(folder / "run");
  write_text(folder / "a.mp4", "precious");
  const Ran ran = render_in(folder, "run --film a.mp4");
  EXPECT_EQ(ran.exit_code, 2);
  EXPECT_EQ(ran.err, "rift: a.mp4 exists already: --force replaces it\n");
  EXPECT_EQ(read_text(folder / "a.mp4"), "precious");
  EXPECT_EQ(render_in(folder, "run --film a.mp4 --force --size 320x180").exit_code, 0);
  EXPECT_NE(read_text(folder / "a.mp4"), "precious");
}

TEST(Render, RoundsOddSizesWithANote) {
  const TemporaryFolder folder;
  write_run(folder / "run");
  const Ran ran = render_in(folder, "run --size 321x181 --at 0 --picture a.png");
  EXPECT_EQ(ran.exit_code, 0);
  EXPECT_EQ(ran.err, "rift render: --size 321x181: drawn as 322x182, because films need even numbers\n");
  EXPECT_EQ(viz::read_png(folder / "a.png").width, 322);
}

TEST(Render, TellsEveryMistakeAndMakesNothing) {
  const TemporaryFolder folder;
  write_run(folder / "run");
  const auto complaint = [&](const std::string& arguments) {
    const Ran ran = render_in(folder, arguments);
    EXPECT_EQ(ran.exit_code, 2) << arguments;
    EXPECT_EQ(ran.out, "") << arguments;
    return ran.err;
  };
  EXPECT_EQ(complaint("nothing"), "rift render: nothing: no such run\n");
  EXPECT_EQ(complaint("run --size 1e9x2"),
            "rift render: --size 1e9x2: expected a width and a height in pixels such as 1280x720\n");
  EXPECT_EQ(complaint("run --size 99999x720"),
            "rift render: --size 99999x720: must lie between 320x180 and 8192x8192\n");
  EXPECT_EQ(complaint("run --range 3"),
            "rift render: --range 3: expected two ascending numbers such as 0,2\n");
  EXPECT_EQ(complaint("run --film a.avi"), "rift render: --film a.avi: must end in .mp4, .webm or .gif\n");
  EXPECT_TRUE(contains(complaint("run --frames 7"), "--frames 7: the run holds 6 frames"));
  EXPECT_TRUE(contains(complaint("run --field speed"), "speed"));
  EXPECT_TRUE(contains(complaint("run --at 1.5"), "1.5"));
  EXPECT_FALSE(fs::exists(folder / "run" / "film_uy.mp4"));
}

TEST(Render, KeepsTheFramesWhereFfmpegIsMissingOrDies) {
  const TemporaryFolder folder, programs;
  write_run(folder / "run");
  const std::string only_ours = "PATH='" + programs.path().string() + "'";
  const Ran missing = render_in(folder, "run --size 320x180 --film a.mp4", only_ours);
  EXPECT_EQ(missing.exit_code, 1);
  EXPECT_EQ(missing.err,
            "rift render: cannot start ffmpeg: No such file or directory; the frames are drawn as pictures "
            "instead\n");
  EXPECT_EQ(missing.out, "a_frames\n");
  EXPECT_TRUE(fs::exists(folder / "a_frames" / "frame_000005.png"));
  viz::write_script(programs / "ffmpeg", "/bin/head -c 400000 >/dev/null; kill -9 $$");
  const Ran killed = render_in(folder, "run --size 320x180 --film b.mp4", only_ours);
  EXPECT_EQ(killed.exit_code, 1);
  EXPECT_TRUE(contains(killed.err,
                       "ffmpeg was killed by signal 9 (Killed); the frames are drawn as pictures instead"));
  EXPECT_TRUE(fs::exists(folder / "b_frames" / "frame_000005.png"));
  for (const auto& entry : fs::directory_iterator(folder / "."))
    EXPECT_FALSE(entry.path().filename().string().starts_with("b.mp4")) << entry.path();
}

TEST(Render, IntoAFolderThatIsNotThereFailsWithAReason) {
  const TemporaryFolder folder;
  write_run(folder / "run");
  const Ran ran = render_in(folder, "run --size 320x180 --at 0 --picture nowhere/a.png");
  EXPECT_EQ(ran.exit_code, 1);
  EXPECT_TRUE(contains(ran.err, "nowhere/a.png"));
  const Ran film = render_in(folder, "run --size 320x180 --film no/such/a.mp4");
  EXPECT_EQ(film.exit_code, 1);
  EXPECT_EQ(film.err, "rift: cannot write no/such/a.mp4: there is no folder no/such\n") << "before any frame";
  EXPECT_FALSE(fs::exists(folder / "no"));
}

TEST(Render, TwoAtOnceLeaveAWholeFilm) {
  const TemporaryFolder folder;
  write_run(folder / "run");
  const std::string once =
      "(env HOME=/nowhere '" RIFT_EXE "' render run --size 320x180 --film a.mp4 >/dev/null; echo rc $?) & ";
  const Ran ran = run_shell("cd '" + (folder / ".").string() + "' && bash -c \"" + once + once + "wait\"");
  EXPECT_EQ(ran.out, "rc 0\nrc 0\n") << ran.err;
  EXPECT_EQ(run_shell("ffprobe -v error -count_frames -show_entries stream=nb_read_frames -of csv '" +
                      (folder / "a.mp4").string() + "'")
                .out,
            "stream,6\n");
}

/// `rift run` of a tiny plate.
Ran run_tiny(const TinyPlate& tiny, const std::string& arguments, const std::string& environment = "") {
  return run_shell("env -u DISPLAY " + tiny.environment() + " " + environment + " '" RIFT_EXE "' run '" +
                   tiny.preset().string() + "' --out '" + tiny.out().string() + "' --size 320x180 " +
                   arguments);
}

TEST(RunWithRender, LeavesAFilmAndTheSameRun) {
  const TinyPlate tiny;
  const Ran ran = run_tiny(tiny, "--render");
  EXPECT_EQ(ran.exit_code, 0) << ran.err;
  EXPECT_TRUE(contains(ran.out, (tiny.out() / "film_uy.mp4").string()));
  EXPECT_GT(fs::file_size(tiny.out() / "film_uy.mp4"), 1000U);
  const std::string samples = read_text(tiny.out() / "series.csv");
  EXPECT_EQ(run_tiny(tiny, "--force").exit_code, 0);
  EXPECT_EQ(read_text(tiny.out() / "series.csv"), samples);
}

TEST(RunWithRender, AFieldWhoseRangeIsNotKnownIsDrawnAfterTheRun) {
  const TinyPlate tiny;
  const Ran ran = run_tiny(tiny, "--render --field v --set 'output.fields=[\"velocity\"]'");
  EXPECT_EQ(ran.exit_code, 0) << ran.err;
  EXPECT_GT(fs::file_size(tiny.out() / "film_v.mp4"), 1000U);
}

TEST(RunWithRender, TellsMistakesBeforeAnythingIsComputed) {
  const TinyPlate tiny;
  const auto complaint = [&](const std::string& arguments) {
    const Ran ran = run_tiny(tiny, arguments);
    EXPECT_EQ(ran.exit_code, 2) << arguments;
    EXPECT_FALSE(fs::exists(tiny.out())) << arguments;
    return ran.err;
  };
  EXPECT_EQ(complaint("--render --field v"),
            "rift run: --render: output.fields has no \"velocity\", which the field v needs\n");
  EXPECT_EQ(complaint("--render --set output.frames=0"),
            "rift run: --render: output.frames = 0 is too few for a film\n");
  EXPECT_EQ(complaint("--film a.avi"), "rift run: --film a.avi: must end in .mp4, .webm or .gif\n");
}

TEST(RunWithRender, NeverOverwritesAFilmSilently) {
  const TinyPlate tiny;
  const std::string film = (tiny.path() / "mine.mp4").string();
  write_text(film, "precious");
  const Ran ran = run_tiny(tiny, "--film '" + film + "'");
  EXPECT_EQ(ran.exit_code, 2);
  EXPECT_EQ(ran.err, "rift run: " + film + " exists already: --force replaces it\n");
  EXPECT_EQ(read_text(film), "precious");
  EXPECT_FALSE(fs::exists(tiny.out()));
}

TEST(RunWithRender, AFilmThatFailsNeverTouchesTheRun) {
  const TinyPlate tiny;
  const Ran ran = run_tiny(tiny, "--render", "PATH=/nowhere");
  EXPECT_EQ(ran.exit_code, 1);
  EXPECT_EQ(ran.err, "rift run: no film: cannot start ffmpeg: No such file or directory\n");
  EXPECT_TRUE(fs::exists(tiny.out() / "summary.json"));
  EXPECT_FALSE(fs::exists(tiny.out() / "film_uy.mp4"));
}

}  // namespace
}  // namespace rift::studio

#include "tests/studio/commands/pseudo_terminal.hpp"
#include "tests/studio/commands/terminal.hpp"
#include "tests/studio/commands/tiny_plate.hpp"
#include "tests/studio/view/kitty_screen.hpp"
#include "tests/viz/drawn_plate.hpp"

#include <fstream>
#include <sstream>

namespace rift::studio {
namespace {

namespace plate = viz::drawn_plate;

std::string view_of_run(const std::filesystem::path& run, const std::string& options = "") {
  return "env -u TMUX -u STY -u COLORTERM LC_ALL=C.UTF-8 '" RIFT_EXE "' view '" + run.string() + "' " +
         options;
}

/// The drawing program that a process has started.
pid_t child_of(pid_t process) {
  std::ifstream file("/proc/" + std::to_string(process) + "/task/" + std::to_string(process) + "/children");
  pid_t child = -1;
  file >> child;
  return child;
}

bool is_there(pid_t process) { return process > 0 && kill(process, 0) == 0; }

TEST(ViewInATerminal, KittyIsShownThePictureWithTheTipWhereItIs) {
  const TemporaryFolder folder;
  KittyScreen screen(view_of_run(plate::write_run(folder / "run")));
  ASSERT_TRUE(screen.shows_picture(1));
  screen.type("...");
  viz::Job job = plate::job_for(folder / "run");
  job.width = 1000, job.height = 500;  // 25 rows of 20 pixels
  const auto tip =
      plate::place_of(job, {plate::tip_at_moment(3), 0.5 * plate::height + 0.5 * plate::pulled}, {0, 0});
  const viz::Image& image = screen.image();
  ASSERT_TRUE(screen.reads_until([&] {
    return image.width == job.width && image.height == job.height &&
           plate::apart(plate::pixel(image, tip[0], tip[1]), {0.05, 0.05, 0.05}) < 0.02;
  }));
  const int i = plate::element(33, 6);
  const auto p = plate::geometry().position[i];
  const double uy = plate::frame(3).displacement[i][1];
  const auto at = plate::place_of(job, {p[0], p[1] + uy}, {0, 0});
  const auto colour = viz::colour_at(*viz::find_colour_map("coolwarm"), uy / plate::pulled);
  EXPECT_LT(plate::apart(plate::pixel(image, at[0], at[1]), colour), 0.04);
  screen.type("q");
  EXPECT_EQ(screen.exit_code(), 0);
  EXPECT_EQ(screen.images_there(), 0) << "the picture is taken away on leaving";
}

TEST(ViewInATerminal, OfKittyOneImageIsThereHoweverManyWereShown) {
  const TemporaryFolder folder;
  KittyScreen screen(view_of_run(plate::write_run(folder / "run")));
  ASSERT_TRUE(screen.shows_picture(1));
  for (int k = 0; k < 8; ++k) {
    screen.type(k % 2 == 0 ? "." : ",");
    ASSERT_TRUE(screen.shows_picture(k + 2));
    EXPECT_TRUE(screen.has_images(1));
  }
}

TEST(ViewInATerminal, ThePictureFollowsTheSize) {
  const TemporaryFolder folder;
  KittyScreen screen(view_of_run(plate::write_run(folder / "run")));
  ASSERT_TRUE(screen.rests());
  screen.resize(80, 24);
  ASSERT_TRUE(screen.reads_until([&] { return screen.image().width == 800; }));
  EXPECT_EQ(screen.image().height, 380);
  EXPECT_TRUE(screen.has_images(1));
  screen.resize(20, 5);
  ASSERT_TRUE(screen.shows("20x5 is too small"));
  EXPECT_TRUE(screen.has_images(0));
}

TEST(ViewInATerminal, WhatItOnceAnsweredHoldsWhereItIsLateAfterAnotherSize) {
  const TemporaryFolder folder;
  KittyScreen screen(view_of_run(plate::write_run(folder / "run")));
  ASSERT_TRUE(screen.rests());
  screen.be_silent();
  screen.resize(80, 24);
  EXPECT_TRUE(screen.reads_until([&] { return screen.image().width == 800; }));
}

TEST(ViewInATerminal, HelpIsNotBehindThePicture) {
  const TemporaryFolder folder;
  KittyScreen screen(view_of_run(plate::write_run(folder / "run")));
  ASSERT_TRUE(screen.rests());
  screen.type("?");
  ASSERT_TRUE(screen.shows("keys of this screen"));
  EXPECT_TRUE(screen.has_images(0));
  const int before = screen.pictures();
  screen.type("?");
  ASSERT_TRUE(screen.shows_picture(before + 1));
}

TEST(ViewInATerminal, AKilledDrawingProgramIsStartedAgain) {
  const TemporaryFolder folder;
  KittyScreen screen(view_of_run(plate::write_run(folder / "run")));
  ASSERT_TRUE(screen.rests());
  const pid_t program = child_of(screen.process());
  ASSERT_TRUE(is_there(program));
  const int before = screen.pictures();
  ASSERT_EQ(kill(program, SIGKILL), 0);
  screen.type(".");
  EXPECT_TRUE(screen.shows("(Killed)")) << "one word: the message's lines break by the program's path";
  EXPECT_TRUE(screen.shows_picture(before + 1));
  screen.type("q");
  EXPECT_EQ(screen.exit_code(), 0);
}

TEST(ViewInATerminal, WithTheViewerGoesTheDrawingProgram) {
  const TemporaryFolder folder;
  for (const bool by_hanging_up : {true, false}) {
    KittyScreen screen(view_of_run(plate::write_run(folder / (by_hanging_up ? "a" : "b"))));
    ASSERT_TRUE(screen.rests());
    const pid_t program = child_of(screen.process());
    ASSERT_TRUE(is_there(program));
    if (by_hanging_up)
      screen.hang_up();
    else
      ASSERT_EQ(kill(screen.process(), SIGKILL), 0);
    (void)screen.exit_code();
    for (int k = 0; k < 10 * patience_s && is_there(program); ++k) usleep(100000);
    EXPECT_FALSE(is_there(program));
  }
}

TEST(ViewInATerminal, OneThatAnswersNothingGetsSymbolsAndALateAnswerIsNoKey) {
  const TemporaryFolder folder;
  PseudoTerminal terminal(view_of_run(plate::write_run(folder / "run")));
  ASSERT_TRUE(terminal.shows("frame 1 of 6"));
  ASSERT_TRUE(terminal.shows("\xE2\x96")) << "a block";
  EXPECT_EQ(terminal.said().find("\033P"), std::string::npos);
  EXPECT_EQ(terminal.said().find("\033_Ga=T"), std::string::npos);
  terminal.type("\033_Gi=31;OK\033\\\033[?62;4c");  // escape alone would leave
  terminal.type("?");
  EXPECT_TRUE(terminal.shows("keys of this screen"));
  terminal.type("qq");
  EXPECT_EQ(terminal.exit_code(), 0);
}

TEST(ViewInATerminal, APanelSwitchesItsPlateBetweenCellsAndPicture) {
  const TemporaryFolder folder;
  const auto run = plate::write_run(folder / "run");
  KittyScreen screen("env -u TMUX -u STY LC_ALL=C.UTF-8 '" RIFT_EXE "' watch '" + run.string() + "'");
  ASSERT_TRUE(screen.shows("G_ID/G_I0"));
  screen.type("p");
  ASSERT_TRUE(screen.shows_picture(1));
  EXPECT_EQ(screen.image().width, 1000) << "the width of the screen";
  screen.type("p");
  ASSERT_TRUE(screen.has_images(0));
  screen.type("q");
  EXPECT_EQ(screen.exit_code(), 0);
}

TEST(ViewInATerminal, OnASlowLineAMovingPictureIsInLettersAndARestingOneInPixels) {
  const TemporaryFolder folder;
  KittyScreen screen(view_of_run(plate::write_run(folder / "run")), 2.0);
  ASSERT_TRUE(screen.rests());
  const int before = screen.pictures();
  screen.type("<<<<< ");  // plays for some ten seconds
  ASSERT_TRUE(screen.shows("\xE2\x96")) << "a block";
  EXPECT_EQ(screen.pictures(), before);
  screen.type(" ");
  ASSERT_TRUE(screen.shows_picture(before + 1));
  EXPECT_EQ(screen.image().width, 1000);
}

/// A shell script that views a run and then says what a shell would have read from the terminal.
std::string then_reads(const TemporaryFolder& folder, const std::filesystem::path& run) {
  const auto script = folder / "script.sh";
  std::ofstream(script) << view_of_run(run)
                        << "\nIFS= read -r -t 2 -n 30 rest\nprintf 'left <%q>\\n' \"$rest\"\n";
  return "bash '" + script.string() + "'";
}

TEST(ViewInATerminal, AnAnswerThatComesLateIsNotLeftToTheShell) {
  const TemporaryFolder folder;
  PseudoTerminal terminal(then_reads(folder, plate::write_run(folder / "run")));
  ASSERT_TRUE(terminal.shows("frame 1 of 6"));
  terminal.type("q\033[?62;4c");
  EXPECT_TRUE(terminal.shows("left <''>"));
}

TEST(ViewInATerminal, TheAnswerToTheLastPictureIsNotLeftToTheShell) {
  const TemporaryFolder folder;
  KittyScreen screen(then_reads(folder, plate::write_run(folder / "run")), 0.3);
  ASSERT_TRUE(screen.rests());
  const int before = screen.pictures();
  screen.type(".");
  ASSERT_TRUE(screen.shows_picture(before + 1));
  screen.type("q");  // while its answer is still to come
  EXPECT_TRUE(screen.shows("left <''>"));
}

TEST(ViewInATerminal, DraggingIsReportedAgainAfterCtrlZ) {
  const TemporaryFolder folder;
  PseudoTerminal terminal("bash --norc -i");
  terminal.type(view_of_run(plate::write_run(folder / "run")) + "\n");
  ASSERT_TRUE(terminal.shows("frame 1 of 6"));
  const auto times = [&] {
    int count = 0;
    const std::string drags = "\033[?1002h";
    for (std::size_t at = 0; (at = terminal.said().find(drags, at)) != std::string::npos; ++at) ++count;
    return count;
  };
  ASSERT_TRUE(terminal.reads_until([&] { return times() == 1; }));
  terminal.type("\x1a");
  ASSERT_TRUE(terminal.shows("Stopped"));
  EXPECT_EQ(times(), 1);
  terminal.type("fg\n");
  EXPECT_TRUE(terminal.reads_until([&] { return times() == 2; }));
}

TEST(ViewInATerminal, ControlCharactersOfAFoldersNameDoNotReachTheTerminal) {
  const TemporaryFolder folder;
  const auto run = plate::write_run(folder / "a\033]0;taken\ab");
  PseudoTerminal terminal(view_of_run(run));
  ASSERT_TRUE(terminal.shows("frame 1 of 6"));
  terminal.type("c");
  ASSERT_TRUE(terminal.shows("--magnification"));
  terminal.type("q");
  EXPECT_EQ(terminal.exit_code(), 0);
  EXPECT_TRUE(contains(terminal.said(), "]0;taken"));
  EXPECT_EQ(terminal.said().find("\033]0;taken"), std::string::npos);
}

TEST(Graphics, AWrongVariableIsRefusedBeforeARunStarts) {
  const TinyPlate plate;
  const auto run = plate.path() / "new";
  PseudoTerminal terminal("env RIFT_GRAPHICS=png '" RIFT_EXE "' run '" + plate.preset().string() + "' --out '" +
                          run.string() + "'");
  EXPECT_EQ(terminal.exit_code(), 2);
  EXPECT_TRUE(contains(terminal.said(), "RIFT_GRAPHICS=png: must be auto"));
  EXPECT_FALSE(std::filesystem::exists(run));
}

TEST(ViewInATerminal, AForcedWayIsTaken) {
  const TemporaryFolder folder;
  const auto run = plate::write_run(folder / "run");
  PseudoTerminal sixel(view_of_run(run, "--graphics sixel"));
  EXPECT_TRUE(sixel.shows("\033P"));
  PseudoTerminal iterm("env RIFT_GRAPHICS=iterm " + view_of_run(run));
  EXPECT_TRUE(iterm.shows("\033]1337;File=inline=1"));
  PseudoTerminal cells(view_of_run(run, "--graphics cells"));
  EXPECT_TRUE(cells.shows("the plate is in cells"));
}

TEST(ViewInATerminal, TmuxGetsSymbolsAndIsGivenBackWhenStopped) {
  if (!RealTerminal::there()) GTEST_SKIP() << "no tmux";
  const TemporaryFolder folder;
  const auto run = plate::write_run(folder / "run");
  const RealTerminal terminal("view_" + folder.path().filename().string(), "bash --norc -i", 100, 30);
  terminal.send("'\"" RIFT_EXE "\" view \"" + run.string() + "\"; echo left with $?' Enter");
  ASSERT_TRUE(terminal.shows("frame 1 of 6"));
  ASSERT_TRUE(terminal.shows("\xE2\x96"));
  terminal.send("C-z");
  ASSERT_TRUE(terminal.shows("Stopped"));
  terminal.send("fg Enter");
  ASSERT_TRUE(terminal.shows("frame 1 of 6"));
  ASSERT_TRUE(terminal.shows("\xE2\x96"));
  terminal.send("Space");
  EXPECT_TRUE(terminal.shows("frame 6 of 6"));
  terminal.send("q");
  EXPECT_TRUE(terminal.shows("left with"));
}

TEST(View, BadInputIsAMessage) {
  const TemporaryFolder folder;
  const auto run = plate::write_run(folder / "run");
  const auto refused = [](const std::string& arguments, int code, const std::string& part) {
    const Ran ran = run_rift("view " + arguments);
    EXPECT_EQ(ran.exit_code, code) << arguments;
    EXPECT_TRUE(contains(ran.err, part)) << ran.err;
    EXPECT_EQ(ran.out, "");
    EXPECT_EQ(ran.err.find('\033'), std::string::npos);
  };
  refused("'" + run.string() + "'", 2, "needs a terminal");
  refused("'" + folder.path().string() + "/none'", 2, "no such run");
  std::filesystem::create_directories(folder / "empty");
  refused("'" + (folder / "empty").string() + "'", 2, "holds no run");
  refused("'" + run.string() + "' --field elastic", 2, "holds no field elastic; its fields are ux, uy");
  refused("'" + run.string() + "' --graphics png", 2, "--graphics");
  refused("'" + run.string() + "' --view 1,2,3", 2, "expected five numbers");
  refused("'" + plate::write_run(folder / "bare", 0).string() + "'", 2, "holds no frames: run it with");
  const Ran variable = run_rift("view '" + run.string() + "'", "RIFT_GRAPHICS=png");
  EXPECT_EQ(variable.exit_code, 2);
  EXPECT_TRUE(
      contains(variable.err, "RIFT_GRAPHICS=png: must be auto, kitty, sixel, iterm, symbols or cells"));
}

}  // namespace
}  // namespace rift::studio

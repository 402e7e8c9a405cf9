#include "tests/studio/commands/pseudo_terminal.hpp"
#include "tests/studio/commands/terminal.hpp"
#include "tests/studio/commands/tiny_plate.hpp"

#include <csignal>

namespace rift::studio {
namespace {

namespace fs = std::filesystem;

TEST(Studio, WithoutATerminalSaysWhatToUse) {
  for (const char* arguments : {"", "studio", "studio quickstart", "studio --lesson node-release"}) {
    const Ran ran = run_rift(arguments);
    EXPECT_EQ(ran.exit_code, 2) << arguments;
    EXPECT_TRUE(contains(ran.err, "rift run PRESET")) << arguments;
    EXPECT_EQ(ran.out, "") << arguments;
  }
}

TEST(Studio, DrawsNoTextInWhiteOrPaleGreyWhichALightTerminalDoesNotShow) {
  for (const std::string name : {"xterm", "xterm-256color"}) {
    PseudoTerminal terminal("env TERM=" + name +
                            " RIFT_PRESETS='" RIFT_SOURCE_DIR "/presets' '" RIFT_EXE "' studio study_four");
    const auto said = [&](const char* part) { return terminal.said().find(part) != std::string::npos; };
    ASSERT_TRUE(terminal.reads_until([&] { return said("left out") || said("built without"); })) << name;
    if (said("built without")) GTEST_SKIP() << "no panels in this build";
    for (const char* colour : {"\x1b[37m", "\x1b[97m", "38;5;250m", "38;5;255m"})
      EXPECT_FALSE(said(colour)) << name << ", " << colour + 1;
  }
}

/// A folder to work in with one preset of its own, which marches for some seconds at most.
struct Place {
  TinyPlate plate;
  Place() {
    fs::create_directories(plate.path() / "presets");
    std::string text = read_text(plate.preset());
    text.replace(text.find("velocity = \"0.5 c_r\""), 20, "velocity = \"0.002 c_r\"");
    text += "fields = [\"displacement\"]\n";
    write_text(plate.path() / "presets" / "plate_tiny.toml", text);
    EXPECT_EQ(run_rift("run '" + (plate.path() / "presets" / "plate_tiny.toml").string() +
                           "' --quiet --set crack.technique=simple --set 'crack.velocity=0.5 c_r' --out '" +
                           (runs() / "other").string() + "'",
                       plate.environment())
                  .exit_code,
              0);
  }
  fs::path runs() const { return plate.path() / "runs"; }
  std::string command(const std::string& arguments) const {
    return "cd '" + plate.path().string() + "' && env " + plate.environment() + " RIFT_PRESETS='" +
           (plate.path() / "presets").string() + "' XDG_DATA_HOME='" + plate.path().string() +
           "/data' '" RIFT_EXE "' " + arguments;
  }
  std::string name() const { return plate.path().filename().string(); }
};

TEST(Studio, LeadsFromHomeThroughAFormAndASteeredRunToAComparison) {
  if (!RealTerminal::there()) GTEST_SKIP() << "no tmux";
  const Place place;
  const RealTerminal terminal(place.name(), place.command(""));
  ASSERT_TRUE(terminal.shows("plate_tiny"));
  if (terminal.screen().find("built without") != std::string::npos) GTEST_SKIP() << "no panels in this build";
  EXPECT_TRUE(terminal.shows("Recent runs"));
  terminal.send("'?'");
  EXPECT_TRUE(terminal.shows("keys of this screen"));
  terminal.send("'?'");
  terminal.send("Tab Enter");  // past the runs
  EXPECT_TRUE(terminal.shows("ready to run"));
  terminal.send("Escape r");  // the letter is not for the screen behind the form
  EXPECT_TRUE(terminal.shows("Recent runs"));
  terminal.send("Enter");
  EXPECT_TRUE(terminal.shows("ready to run"));
  EXPECT_TRUE(terminal.shows("of the critical"));
  terminal.send("r");
  EXPECT_TRUE(terminal.shows("running"));
  terminal.send("Space");
  EXPECT_TRUE(terminal.shows("paused"));
  terminal.send("x");
  EXPECT_TRUE(terminal.shows("change lane 1 from now on"));
  terminal.send("3");
  EXPECT_TRUE(terminal.shows("damage_zone_ratio of lane 1: 1"));
  terminal.send("BSpace 4 Enter");
  EXPECT_TRUE(terminal.shows("damage_zone_ratio = 4; kept in steering.toml"));
  EXPECT_TRUE(contains(read_text(place.runs() / "plate_tiny" / "steering.toml"), "damage_zone_ratio = 4"));
  terminal.send("f");
  EXPECT_TRUE(terminal.shows("frame"));
  EXPECT_TRUE(terminal.shows("paused"));  // drawing never blocks the panel
  terminal.send("Space");
  terminal.send("s");
  EXPECT_TRUE(terminal.shows("plate_tiny  stopped"));
  terminal.send("q");
  EXPECT_TRUE(terminal.shows("ready to run"));
  terminal.send("q");
  EXPECT_TRUE(terminal.shows("Recent runs"));
  terminal.send("g Space j Space c");
  EXPECT_TRUE(terminal.shows("2 scenarios side by side"));
  EXPECT_TRUE(terminal.shows("G_ID / G_I0"));
  terminal.resize(50, 12);
  EXPECT_TRUE(terminal.shows("50x12 is too small: 60x16 needed"));
  terminal.resize(80, 24);
  EXPECT_TRUE(terminal.shows("2 scenarios side by side"));
  terminal.send("q");
  EXPECT_TRUE(terminal.shows("Recent runs"));
  terminal.send("q");
  EXPECT_TRUE(terminal.shows("left with 0"));
}

TEST(Studio, RunShowsThePanelAndLeavesItsTableBehind) {
  if (!RealTerminal::there()) GTEST_SKIP() << "no tmux";
  const Place place;
  const RealTerminal terminal(place.name(), place.command("run plate_tiny --set 'crack.velocity=0.02 c_r'"));
  EXPECT_TRUE(terminal.shows("space pause"));
  EXPECT_TRUE(terminal.shows("left with 0"));
  EXPECT_TRUE(contains(terminal.screen(), "G_ID / G_I0"));
  EXPECT_TRUE(contains(terminal.screen(), "summary.json"));
}

/// A run of its own name that takes a minute, so that a signal meets this one and no other.
struct LongRun {
  Place place;
  std::string out = "out_" + place.name();
  std::string command() const {
    return place.command("run plate_tiny --set 'crack.velocity=0.001 c_r' --out " + out);
  }
  void send(const std::string& signal) const {
    run_shell("pkill -" + signal + " -f -- '--out " + out + "$'");
  }
};

TEST(Studio, ASignalStopsTheRunKeepsItAndGivesTheTerminalBack) {
  if (!RealTerminal::there()) GTEST_SKIP() << "no tmux";
  for (const int number : {SIGTERM, SIGHUP, SIGINT}) {
    const LongRun run;
    const RealTerminal terminal(run.place.name(), run.command());
    EXPECT_TRUE(terminal.shows("running"));
    run.send(std::to_string(number));
    EXPECT_TRUE(terminal.shows("left with " + std::to_string(128 + number)));
    EXPECT_TRUE(contains(read_text(run.place.plate.path() / run.out / "summary.json"), "\"stopped\""))
        << number;
  }
}

TEST(Studio, ACrashGivesTheTerminalBackAndNamesTheRun) {
  if (!RealTerminal::there()) GTEST_SKIP() << "no tmux";
  const LongRun run;
  const RealTerminal terminal(run.place.name(), run.command() + "; stty -a");
  EXPECT_TRUE(terminal.shows("running"));
  run.send("SEGV");
  EXPECT_TRUE(terminal.shows("rift: crashed (signal 11)"));
  EXPECT_TRUE(terminal.shows("the run is stored in out"));
  EXPECT_TRUE(terminal.shows(" icanon"));
  EXPECT_TRUE(terminal.shows(" echo "));
}

TEST(Studio, WithoutUtf8ThereIsNothingButAscii) {
  if (!RealTerminal::there()) GTEST_SKIP() << "no tmux";
  const Place place;
  const RealTerminal terminal(place.name(), "LC_ALL=C; export LC_ALL; " + place.command("watch runs/other"));
  EXPECT_TRUE(terminal.shows("other  finished"));
  EXPECT_TRUE(terminal.shows("G_ID/G_I0"));
  for (const char letter : not_empty(terminal.screen()))
    EXPECT_TRUE(static_cast<unsigned char>(letter) < 128);
}

TEST(Studio, ATerminalThatIsNotKnownIsNamed) {
  if (!RealTerminal::there()) GTEST_SKIP() << "no tmux";
  const Place place;
  const RealTerminal terminal(place.name(),
                              "TERM=nosuch; export TERM; " + place.command("studio") + "; " +
                                  place.command("run plate_tiny --set 'crack.velocity=0.5 c_r' --out out"));
  EXPECT_TRUE(terminal.shows("does not know (TERM=nosuch)"));
  EXPECT_TRUE(terminal.shows("G_ID / G_I0"));  // a run does without its panel
  EXPECT_TRUE(terminal.shows("left with 0"));
}

TEST(Studio, WithoutColoursThePlateIsInGreys) {
  if (!RealTerminal::there()) GTEST_SKIP() << "no tmux";
  const Place place;
  const RealTerminal terminal(place.name(),
                              "NO_COLOR=1; export NO_COLOR; " + place.command("watch runs/other"));
  EXPECT_TRUE(terminal.shows("other  finished"));
  for (const char* grey : {"·····", "█████", "▒"}) EXPECT_TRUE(terminal.shows(grey));
}

TEST(Studio, ControlZGivesTheTerminalBackUntilItGoesOn) {
  if (!RealTerminal::there()) GTEST_SKIP() << "no tmux";
  const Place place;
  const RealTerminal terminal(place.name(), "bash --norc");
  terminal.send("\"" + place.command("watch runs/other") + "\" Enter");
  EXPECT_TRUE(terminal.shows("other  finished"));
  terminal.send("C-z");
  EXPECT_TRUE(terminal.shows("Stopped"));
  terminal.send("fg Enter");
  EXPECT_TRUE(terminal.shows("other  finished"));
  terminal.send("q");
}

}  // namespace
}  // namespace rift::studio

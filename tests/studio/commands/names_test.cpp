#include "engine/base/text.hpp"
#include "tests/studio/commands/tiny_plate.hpp"

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include <string>

namespace rift::studio {
namespace {

namespace fs = std::filesystem;
using Json = nlohmann::json;

/// A Latin-1 letter, a sequence that clears a terminal, a second line.
const std::string hostile = "r\xe9s\x1b[2J\nb";

/// Whether it is UTF-8 without control characters but line breaks and tabs.
testing::AssertionResult is_harmless(const std::string& text) {
  if (base::escaped(text, "\n\t") == text) return testing::AssertionSuccess();
  return testing::AssertionFailure() << base::escaped(text, "\n\t");
}

/// Folders, presets and tables with such names.
class HostileNames : public testing::Test {
 protected:
  HostileNames() {
    fs::create_directories(place());
    fs::copy_file(plate_.preset(), preset());
  }
  fs::path place() const { return plate_.path() / hostile; }
  fs::path preset() const { return place() / (hostile + ".toml"); }
  fs::path out() const { return place() / "out"; }
  static std::string quoted(const fs::path& path) { return "'" + path.string() + "'"; }

  /// `rift ARGUMENTS`, whose texts must be harmless.
  Ran rift(const std::string& arguments) const {
    const Ran ran = run_rift(arguments, plate_.environment());
    EXPECT_TRUE(is_harmless(ran.out)) << base::escaped(arguments);
    EXPECT_TRUE(is_harmless(ran.err)) << base::escaped(arguments);
    return ran;
  }
  void works(const std::string& arguments) const {
    const Ran ran = rift(arguments);
    EXPECT_EQ(ran.exit_code, 0) << base::escaped(arguments) << ran.err;
    if (arguments.find("--json") != std::string::npos) {
      EXPECT_TRUE(Json::accept(ran.out)) << base::escaped(arguments) << ran.out;
    }
  }
  void run() const { works("run " + quoted(preset()) + " --quiet --out " + quoted(out())); }
  /// What is there to be read in a browser or a spreadsheet.
  void has_harmless_pages(const fs::path& folder) const {
    int pages = 0;
    for (const auto& entry : fs::recursive_directory_iterator(folder))
      for (const char* kind : {".html", ".svg", ".json", ".csv", ".gp", ".toml"})
        if (entry.path().extension() == kind) {
          ++pages;
          EXPECT_TRUE(is_harmless(read_text(entry.path()))) << entry.path().filename();
        }
    EXPECT_GT(pages, 1);
  }

  TinyPlate plate_;
};

TEST_F(HostileNames, AreRunVerifiedAndGoneOnWith) {
  works("run " + quoted(preset()) + " --json --out " + quoted(out()));
  works("run " + quoted(preset()) + " --plain --force --out " + quoted(out()));
  works("resume " + quoted(out()));
  works("verify " + quoted(out()));
  works("verify --json " + quoted(out()));
  has_harmless_pages(out());
}

TEST_F(HostileNames, AreCheckedPackedAndListed) {
  works("check " + quoted(preset()));
  works("check --json " + quoted(preset()));
  works("check --print-config " + quoted(preset()));
  works("pack " + quoted(preset()) + " --out " + quoted(out()));
  works("pack --json " + quoted(preset()));
  has_harmless_pages(out());
  for (const char* how : {"list", "list --json"}) {
    const Ran ran = run_rift(how, "RIFT_PRESETS=" + quoted(place()));
    EXPECT_EQ(ran.exit_code, 0) << ran.err;
    EXPECT_TRUE(is_harmless(ran.out)) << how;
  }
}

TEST_F(HostileNames, AreExportedUnderTheirVeryPaths) {
  run();
  for (const std::string kind : {"csv", "paraview", "pvd", "ovito"}) {
    const Ran ran = run_rift("export " + quoted(out()) + " --to " + kind);
    EXPECT_EQ(ran.exit_code, 0) << ran.err;
    EXPECT_TRUE(fs::exists(fs::path(ran.out.substr(0, ran.out.size() - 1)))) << kind;
  }
}

TEST_F(HostileNames, AreMeasured) {
  run();
  works("measure " + quoted(out()) + " --inner 4 --grid 2 --quiet");
  works("measure " + quoted(out()) + " --inner 4 --grid 2 --quiet --json");
  has_harmless_pages(out() / "measure");
}

TEST_F(HostileNames, AreStudiedAndGoneOnWith) {
  std::string text = read_text(preset());
  text.erase(text.find("velocity = "), std::string("velocity = \"0.5 c_r\"\n").size());
  write_text(preset(), text + "[study]\ncrack_velocity = [\"0.3 c_r\", \"0.5 c_r\"]\n");
  works("study " + quoted(preset()) + " --out " + quoted(out()));
  const Ran again = rift("study " + quoted(preset()) + " --out " + quoted(out()));
  EXPECT_TRUE(contains(again.out, "0 computed, 2 reused"));
  works("study --json --quiet " + quoted(preset()) + " --out " + quoted(out()));
  has_harmless_pages(out());
}

TEST_F(HostileNames, AreReadAsAMeasuredCrackAndGoneOnWith) {
  write_text(place() / (hostile + ".csv"),
             "time [us];position [mm]\n0;5\n4;8.5\n8;12.1\n12;15.6\n16;19\n20;22.5\n24;26\n28;29.5\n32;33\n");
  const std::string arguments = quoted(preset()) + " --set 'crack.history=" + hostile + ".csv' --quiet ";
  std::string text = read_text(preset());
  text.erase(text.find("velocity = "), std::string("velocity = \"0.5 c_r\"\n").size());
  text.erase(text.find("end = "), std::string("end = \"30 mm\"\n").size());
  write_text(preset(), text);
  const Ran ran =
      run_shell("cd " + quoted(place()) + " && env " + plate_.environment() + " '" RIFT_EXE "' experiment " +
                arguments + "--resamples 0 --no-application --json --out out");
  EXPECT_EQ(ran.exit_code, 0) << ran.err;
  EXPECT_TRUE(Json::accept(ran.out)) << ran.out;
  EXPECT_TRUE(is_harmless(ran.out));
  EXPECT_TRUE(is_harmless(ran.err));
  has_harmless_pages(out());
}

TEST_F(HostileNames, TakeACalibration) {
  works(
      "calibrate --young '3.2 GPa' --poisson 0.25 --set calibration.elements=300 --set "
      "calibration.packings=2 "
      "--set 'calibration.radius_ratios=[0.2, 0.4, 0.8]' --set 'calibration.sizes=[200, 300]' --out " +
      quoted(out()));
  has_harmless_pages(out());
}

TEST_F(HostileNames, InAMessageStayOnItsLine) {
  for (const std::string& arguments :
       {"run " + quoted(place() / (hostile + "_missing")), "check " + quoted(place()),
        "run " + quoted(preset()) + " --quiet --out " + quoted(place()),
        "verify " + quoted(place() / "missing"), "resume " + quoted(place()),
        "export " + quoted(place()) + " --to csv", "measure " + quoted(place()),
        "check " + quoted(preset()) + " --set '" + hostile + "=1'",
        "check " + quoted(preset()) + " '" + hostile + "'",
        "check quickstart --set crack.history=" + quoted(place() / "missing.csv")}) {
    const Ran ran = rift(arguments);
    EXPECT_TRUE(ran.exit_code == 1 || ran.exit_code == 2) << base::escaped(arguments) << ran.exit_code;
    EXPECT_EQ(ran.err.find("\nb"), std::string::npos) << ran.err;
    EXPECT_FALSE(ran.err.empty());
  }
}

}  // namespace
}  // namespace rift::studio

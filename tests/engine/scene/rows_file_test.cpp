#include "engine/base/files.hpp"
#include "engine/scene/derived.hpp"
#include "engine/scene/parameters.hpp"
#include "engine/scene/preset.hpp"
#include "tests/expectations.hpp"

#include <gtest/gtest.h>

#include <filesystem>

namespace rift::scene {
namespace {

namespace fs = std::filesystem;

/// A folder of its own with a file in it, gone afterwards.
struct Folder {
  fs::path path = fs::temp_directory_path() /
                  ("rift_rows_" + std::string(testing::UnitTest::GetInstance()->current_test_info()->name()));
  Folder() { fs::remove_all(path), fs::create_directories(path); }
  ~Folder() { fs::remove_all(path); }
  std::string write(const char* name, const std::string& text) const {
    base::write_whole_file(path / name, text);
    return (path / name).string();
  }
};

/// The complaints_of_rows about x.csv as [crack] `key` of a plate of 100 mm, without the folder's name.
std::string complaints_of_rows(const char* key, const std::string& csv, const std::string& more = {}) {
  const Folder folder;
  folder.write("x.csv", csv);
  const std::string preset = folder.write(
      "x.toml", std::string("[specimen]\nlength = \"100 mm\"\n[crack]\n") + key + " = \"x.csv\"\n" + more);
  std::string out;
  for (const Issue& issue : read_preset(preset).issues) out += to_text(issue) + "\n";
  const std::string prefix = folder.path.string() + "/";
  for (auto at = out.find(prefix); at != out.npos; at = out.find(prefix)) out.erase(at, prefix.size());
  return out;
}

const std::string head = "time [us];position [mm]\n";
constexpr const char* noise_hint = ": noisy rows need a column uncertainty\n";

struct Defect {
  std::string csv, complaint;
};

TEST(HistoryFile, NamesEveryDefectWithItsLine) {
  const std::vector<Defect> defects{
      {"", "x.csv:1: holds no header, such as \"time [ms];position [mm]\"\n"},
      {"# nothing\n\n", "x.csv:2: holds no header, such as \"time [ms];position [mm]\"\n"},
      {head, "x.toml:4: crack.history = \"x.csv\": x.csv: holds a header and no rows\n"},
      {"tme [us];position [mm]\n0;1\n", "x.csv:1: unknown column 'tme', did you mean 'time'?\n"},
      {"time;position [mm]\n0;1\n", "x.csv:1: column 'time' has no unit: write \"time [ms]\"\n"},
      {"time [mm];position [mm]\n0;1\n",
       "x.csv:1: column 'time': unknown unit 'mm' for a time: use s, ms, us or ns\n"},
      {"time [us];time [us];position [mm]\n0;0;1\n", "x.csv:1: the header has two columns 'time'\n"},
      {head + "0;1\n1\n", "x.csv:3: 1 column, where the header has 2\n"},
      {head + "0;1\n1;2;3\n", "x.csv:3: 3 columns, where the header has 2\n"},
      {head + "0;1\n1;\n", "x.csv:3: position is empty\n"},
      {head + "0;1\n1;x\n", "x.csv:3: position 'x' is not a number\n"},
      {head + "0;1\n1;1,5\n", "x.csv:3: position '1,5' is not a number: use a decimal point\n"},
      {head + "0;1\nnan;2\n", "x.csv:3: time 'nan' is not finite\n"},
      {head + "0;1\n1;inf\n", "x.csv:3: position 'inf' is not finite\n"},
      {head + "0;1\n1;1e999\n", "x.csv:3: position '1e999' is not a number\n"},
      {head + "0;1\n", "x.csv:2: is the only row: a history needs two\n"},
      {head + "0;1\n2;2\n2;3\n", "x.csv:4: time 2 us is there twice\n"},
      {head + "0;1\n2;2\n1;3\n", "x.csv:4: time falls from 2 us to 1 us\n"},
      {head + "0;1\n1;4\n2;3\n", std::string("x.csv:4: position falls from 4 mm to 3 mm") + noise_hint},
      {head + "0;-1\n1;4\n", "x.csv:2: position -1 mm must not lie below 0\n"},
      {head + "0;1\n1;2\n2;3e6\n", "x.csv:4: position 3000 m must not lie beyond 100 m\n"},
      {head + "0;1\n1;2\n2e10;3\n", "x.csv:4: time 20000 s must lie within 1000 s\n"},
      {head + "0;1\n1e-9;2\n2;3\n", "x.csv:3: time 1e-15 s follows within 1e-12 s\n"},
      {"time [us];position [mm];uncertainty [mm]\n0;1;1e-7\n1;2;1e-7\n",
       "x.csv:2: uncertainty 1e-10 m must lie in [1 nm, 100 m]\nx.csv:3: uncertainty 1e-10 m must lie in [1 "
       "nm, 100 m]\n"},
      {head + "0;1\n1;1\n2;1\n",
       "x.csv:4: the crack does not advance: the last position must lie beyond the first\n"},
      {head + "0;1\n1;2\n2;3\n3;4\n60;5\n",
       "x.csv:6: no row for 57 us after 3 us, 57 times the usual 1 us: rows are missing, or raise "
       "crack.history_gap (10)\n"},
      {"time [us];position [mm];uncertainty [mm]\n0;1;0.1\n1;2;0\n",
       "x.csv:3: uncertainty 0 m must lie above 0\n"},
      {"time [us];position [mm];uncertainty [mm]\n0;1;-0.1\n1;2;0.1\n",
       "x.csv:2: uncertainty -100 um must lie above 0\n"},
      {"time [us];position [mm];uncertainty [mm]\n0;1;0.1\n1;4;0.1\n2;3;0.1\n3;5;0.1\n",
       "x.csv:4: position falls from 4 mm to 3 mm, more than 3 standard uncertainties of the step, 424.264 "
       "um\n"},
      {head + "0;1\n1;60\n",
       "x.toml:4: crack.history = \"x.csv\": reaches 26.8 c_r: it must lie in (0, 2] c_r, here (0, 4400 "
       "m/s]\n"},
  };
  for (const Defect& defect : defects) {
    EXPECT_EQ(complaints_of_rows("history", defect.csv), defect.complaint) << defect.csv;
  }
}

TEST(HistoryFile, OfNoisyRowsWithoutUncertaintiesSaysOnceHowTheyScatter) {
  std::string rows = head;  // ± 1 mm on 1 mm a row, by turns
  for (int k = 0; k < 12; ++k)
    rows += std::to_string(k) + ";" + std::to_string(5 + k + (k % 2 == 0 ? 1 : -1)) + "\n";
  const std::string said = complaints_of_rows("history", rows);
  const std::string hint = " (the rows scatter by about 1.6 mm, one standard deviation)\n";
  EXPECT_TRUE(
      said.starts_with("x.csv:3: position falls from 6 mm to 5 mm: noisy rows need a column "
                       "uncertainty" +
                       hint))
      << said;
  EXPECT_EQ(said.find(hint), said.rfind(hint));
  EXPECT_NE(said.find("x.csv:5: position falls from 8 mm to 7 mm" + std::string(noise_hint)), said.npos);
}

TEST(HistoryFile, ThatLeavesThePlateIsNamed) {
  EXPECT_EQ(
      complaints_of_rows("history", head + "0;1\n100;99\n200;120\n", "smoothing = \"none\"\n"),
      "x.toml:4: crack.history = \"x.csv\": continues to 120 mm, beyond the end of the plate, 100 mm\n");
}

TEST(HistoryFile, ThatGoesBackIsNoNoiseWhereNothingIsSmoothed) {
  EXPECT_EQ(
      complaints_of_rows("history", "time [us];position [mm];uncertainty [mm]\n0;1;1\n1;4;1\n2;3;1\n3;5;1\n",
                         "smoothing = \"none\"\n"),
      "x.csv:4: position falls from 4 mm to 3 mm: noisy rows need crack.smoothing = \"monotone\"\n");
}

TEST(HistoryFile, ContradictsWhatSaysTheSameOtherwise) {
  const std::string good = head + "0;10\n10;14\n20;20\n";
  EXPECT_EQ(complaints_of_rows("history", good), "");
  EXPECT_EQ(complaints_of_rows("history", good, "velocity = \"0.3 c_r\"\n"),
            "x.toml:4: crack.history = \"x.csv\": excludes crack.velocity (line 5): give one of them\n");
  EXPECT_EQ(
      complaints_of_rows("history", good, "start = \"5 mm\"\n"),
      "x.toml:5: crack.start = \"5 mm\": the history begins at 10 mm: leave crack.start out, or cut the "
      "history there\n");
  EXPECT_EQ(complaints_of_rows("history", good, "smoothing = \"none\"\nend = \"30 mm\"\n"),
            "x.toml:6: crack.end = \"30 mm\": lies beyond the history, which ends at 20 mm\n");
  EXPECT_EQ(complaints_of_rows("history", good, "toughness = [[\"0 c_r\", \"1 J/m2\"]]\n"),
            "x.toml:4: crack.history = \"x.csv\": excludes crack.toughness (line 5): give one of them\n");
}

TEST(HistoryFile, IsReadToTheLastBitWhateverItsCommasAndUnits) {
  const std::vector<history::HistoryPoint> rows{{0.1e-6, 0.0021, 0.0001}, {0.47e-3, 0.0125, 0.0002}};
  for (const char* csv :
       {"# by hand\r\ntime [us];position [mm];uncertainty [mm]\r\n0.1;2.1;0.1\r\n470;12.5;0.2\r\n",
        "time [ms]\tposition [cm]\tuncertainty [um]\n0.0001\t0.21\t100\n+0.47\t1.25\t200",
        "\xEF\xBB\xBFuncertainty (m),position (m),time (s)\n1e-4,2.1e-3,1e-7\n\n# "
        "more\n2e-4,12.5e-3,4.7e-4\n"}) {
    const Folder folder;
    const Preset preset = read_preset_text(
        "", "x.toml", {"crack.history=" + folder.write("h.csv", csv), "crack.smoothing=none"});
    ASSERT_TRUE(preset.issues.empty()) << to_text(preset.issues.front());
    EXPECT_EQ(preset.scene.crack.history, rows);
    EXPECT_EQ(preset.scene.crack.start, 0.0021);  // where the history begins
    const Preset again = read_preset_text(preset_text(preset.scene), "again");
    ASSERT_TRUE(again.issues.empty()) << to_text(again.issues.front());
    EXPECT_EQ(again.scene.crack.history, rows);
  }
}

TEST(HistoryFile, OfAClocksTimeStampsIsNamedOnce) {
  std::string csv = "time [s];position [mm]\n";
  for (int k = 0; k < 1000; ++k)
    csv += "1467394337.00" + std::to_string(1000 + k) + ";" + std::to_string(k) + "\n";
  EXPECT_EQ(
      complaints_of_rows("history", csv),
      "x.csv:2: time 1467394337 s counts from a clock's epoch: subtract the first row's time from all, in "
      "the program that recorded them, before their last digits are lost: times must lie within 1000 s\n");
}

TEST(HistoryFile, OfTwentyThousandRowsIsReadAndReadAgain) {
  std::string csv = "time [us];position [mm]\n";
  for (int k = 0; k < 20000; ++k)
    csv += std::to_string(0.1 * k) + ";" + std::to_string(10 + 0.003 * k) + "\n";
  const Folder folder;
  const Preset preset =
      read_preset_text("", "x.toml", {"crack.history=" + folder.write("h.csv", csv), "crack.smoothing=none"});
  ASSERT_TRUE(preset.issues.empty()) << to_text(preset.issues.front());
  EXPECT_EQ(preset.scene.crack.history.size(), 20000u);
  EXPECT_EQ(read_preset_text(preset_text(preset), "again").scene.crack.history, preset.scene.crack.history);
}

// What a run keeps of its preset is read again when it is resumed.
TEST(HistoryFile, OfManyRowsIsKeptInTheEffectivePreset) {
  std::string csv = "time [us];position [mm];uncertainty [mm]\n";
  for (int k = 0; k < 2000; ++k)
    csv += std::to_string(0.1 * k) + ";" + std::to_string(10 + 0.01 * k) + ";0.1\n";
  const Folder folder;
  Preset preset = read_preset_text("", "x.toml", {"crack.history=" + folder.write("h.csv", csv)});
  ASSERT_TRUE(preset.issues.empty()) << to_text(preset.issues.front());
  for (int k = 0; k < 200; ++k) preset.scene.crack.path.point.push_back({1e-3 * k, 0.0101});
  const Preset again = read_preset_text(preset_text(preset), "again");
  ASSERT_TRUE(again.issues.empty()) << to_text(again.issues.front());
  EXPECT_EQ(again.scene.crack.history, preset.scene.crack.history);
  EXPECT_EQ(again.scene.crack.path.point, preset.scene.crack.path.point);
}

TEST(HistoryFile, OfNoPlaceOrNoSizeIsNamed) {
  EXPECT_EQ(to_text(read_preset_text("[crack]\nhistory = \"gone.csv\"\n", "x.toml").issues.at(0)),
            "x.toml:2: crack.history = \"gone.csv\": gone.csv: no such file");
  std::string many = "x [mm];y [mm]\n";
  for (int k = 0; k <= 10000; ++k) many += std::to_string(k) + ";20\n";
  EXPECT_EQ(complaints_of_rows("path", many), "x.csv:10002: more than 10000 rows: thin them out\n");
  EXPECT_EQ(complaints_of_rows("history", std::string((std::size_t{64} << 20) + 1, '#')),
            "x.toml:4: crack.history = \"x.csv\": x.csv: larger than 64 MiB: thin its rows out\n");
}

TEST(HistoryRows, WrittenInThePresetAreCheckedAsThoseOfAFile) {
  const auto said = [](const std::string& rows) {
    const Preset preset = read_preset_text("[crack]\nhistory = " + rows + "\n", "x.toml");
    return preset.issues.empty() ? std::string() : preset.issues.front().text;
  };
  EXPECT_EQ(said("[[\"0 us\", \"10 mm\"], [\"20 us\", \"18 mm\"]]"), "");
  EXPECT_EQ(said("[[0, 0.01], [2e-5, 0.005]]"), "row 2: position falls from 10 mm to 5 mm" +
                                                    std::string(": noisy rows need a column uncertainty"));
  EXPECT_EQ(said("[[0, 0.01], [2e-5]]"),
            "row 2: expected rows of time and position such as [\"4 us\", \"12 mm\"], got a list");
  EXPECT_EQ(said("[[0, \"10 us\"], [1, 2]]"),
            "row 1, position: unknown unit 'us' for a length: use m, mm, um or nm");
  EXPECT_EQ(said("3"),
            "expected rows of time and position such as [\"4 us\", \"12 mm\"], got a whole number");
}

TEST(PathFile, NamesPointsThatCannotBe) {
  EXPECT_EQ(complaints_of_rows("path", "x [mm];y [mm]\n0;20\n60;50\n100;20\n"),
            "x.csv:3: (60 mm, 50 mm) lies outside the plate, 100 mm x 40 mm\n");
  EXPECT_EQ(complaints_of_rows("path", "x [mm];y [mm]\n0;20\n0;20\n"),
            "x.csv:3: is the same point as the row before\n");
  EXPECT_EQ(complaints_of_rows("path", "x [mm];y [mm]\n0;20\n"),
            "x.csv:2: is the only point: a path needs two\n");
  EXPECT_EQ(
      complaints_of_rows("path", "x [mm];y [mm]\n0;20\n30;20\n"),
      "x.toml:4: crack.path = \"x.csv\": the measuring window, 20 mm to 40 mm, ends beyond the end of the "
      "path, 30 mm\n");
  EXPECT_EQ(complaints_of_rows("path", "x [mm];y [mm]\n0;20\n100;30\n"), "");
  const Preset straight = read_preset_text("[crack]\npath_shape = \"spline\"\n", "x.toml");
  EXPECT_EQ(to_text(straight.issues.at(0)),
            "x.toml:2: crack.path_shape = \"spline\": goes with a crack.path through points only");
}

TEST(ToughnessFile, IsAgainstVelocityOrPosition) {
  const Folder folder;
  const auto read = [&](const std::string& csv) {
    const Preset preset = read_preset_text("", "x.toml", {"crack.toughness=" + folder.write("t.csv", csv)});
    EXPECT_TRUE(preset.issues.empty()) << to_text(preset.issues.front());
    const Preset again = read_preset_text(preset_text(preset.scene), "again");
    EXPECT_EQ(again.scene.crack.toughness, preset.scene.crack.toughness);
    return preset.scene.crack.toughness;
  };
  using enum fracture::CriticalRate::Against;
  EXPECT_EQ(read("velocity [c_r];release_rate [kJ/m2]\n0;1.5\n0.9;4\n"),
            (fracture::CriticalRate{velocity_over_cr, {{0.0, 1500.0}, {0.9, 4000.0}}}));
  EXPECT_EQ(read("velocity [m/s];release_rate [J/m2]\n0;1500\n700;4000\n"),
            (fracture::CriticalRate{velocity, {{0.0, 1500.0}, {700.0, 4000.0}}}));
  EXPECT_EQ(read("position [mm];release_rate [N/mm]\n10;1.5\n90;4\n"),
            (fracture::CriticalRate{position, {{0.01, 1500.0}, {0.09, 4000.0}}}));
  EXPECT_EQ(complaints_of_rows("toughness", "velocity [c_r];release_rate [J/m2]\n0.2;5\n0.1;-3\n"),
            "x.csv:3: release rate -3 J/m2 must lie above 0\n"
            "x.csv:3: velocity 0.1 does not lie above the 0.2 of the row before\n");
}

TEST(LoadFile, NamesEveryDefectWithItsLine) {
  const std::string head = "time [us];displacement [mm]\n";
  const auto said = [](const std::string& csv, const std::string& more = {}) {
    const Folder folder;
    folder.write("x.csv", csv);
    const std::string preset = folder.write(
        "x.toml",
        "[crack]\nhistory = [[10e-6, 10e-3], [20e-6, 14e-3]]\n[loading]\ncurve = \"x.csv\"\n" + more);
    std::string out;
    for (const Issue& issue : read_preset(preset).issues) out += to_text(issue) + "\n";
    const std::string prefix = folder.path.string() + "/";
    for (auto at = out.find(prefix); at != out.npos; at = out.find(prefix)) out.erase(at, prefix.size());
    return out;
  };
  EXPECT_EQ(said(head + "0;1\n15;1.1\n30;1.2\n"), "");
  EXPECT_EQ(said("time [us],force [kN]\n0,1\n15,2\n"), "") << "a force is needed as the crack starts only";
  EXPECT_EQ(said(head + "0;1\n"), "x.csv:2: is the only row: a curve needs two\n");
  EXPECT_EQ(said(head + "0;1\n20;1\n15;2\n"), "x.csv:4: time falls from 20 us to 15 us\n");
  EXPECT_EQ(said(head + "0;1\n20;1\n20;2\n30;2\n"), "x.csv:4: time 20 us is there twice\n");
  EXPECT_EQ(said(head + "0;1\n20;inf\n"), "x.csv:3: displacement 'inf' is not finite\n");
  EXPECT_EQ(said(head + "0;1\n20;20000\n"), "x.csv:3: 20 m must lie within 10 m\n");
  EXPECT_EQ(said(head + "0;1\n2000000000;1\n"), "x.csv:3: time 2000 s must lie within 1000 s\n");
  EXPECT_EQ(said(head + "12;1\n30;1\n"),
            "x.csv:2: the curve begins at 12 us, after the crack, which starts at 10 us\n");
  EXPECT_EQ(said(head + "0;1\n15;1\n"), "x.csv:3: the curve ends at 15 us, before the history does, 20 us\n");
  EXPECT_EQ(said("time [us];force [N]\n0;1\n5;1\n"),
            "x.csv:3: the curve ends at 5 us, before the crack starts, 10 us\n");
  EXPECT_EQ(
      said("time [us];load [N]\n0;1\n5;1\n"),
      "x.csv:1: the header has no column displacement [mm], force [N] or grip_force [N]: it has 'time' and "
      "'load'\n");
  EXPECT_EQ(
      said(head + "0;0\n30;0\n"),
      "x.toml:4: loading.curve = \"x.csv\": is 0 when the crack starts: the plate would not be strained\n");
  EXPECT_EQ(
      said("time [us];force [N]\n0;-1\n30;-1\n"),
      "x.toml:4: loading.curve = \"x.csv\": below 0 needs crack.friction: the faces of the crack would pass "
      "through each other\n");
  EXPECT_EQ(
      said(head + "0;1\n30;1\n", "displacement = \"2 mm\"\n"),
      "x.toml:4: loading.curve = \"x.csv\": excludes loading.displacement (line 5): give one of them\n");
  EXPECT_EQ(said(head + "0;1\n30;1\n", "force = \"2 kN\"\n"),
            "x.toml:4: loading.curve = \"x.csv\": excludes loading.force (line 5): give one of them\n");
  EXPECT_EQ(said(head + "0;1\n30;1\n", "method = \"ramp\"\n"),
            "x.toml:4: loading.curve = \"x.csv\": goes with loading.method = \"static\" only\n");
  EXPECT_EQ(said(head + "0;1\n30;1\n", "tilt = 0.2\n"),
            "x.toml:4: loading.curve = \"x.csv\": moves the grip along y alone: leave loading.tilt and "
            "loading.shear "
            "out\n");
  EXPECT_EQ(said("time [us];force [N]\n0;1\n15;2\n", "[material]\nstiffness = \"bulk\"\n"),
            "x.toml:4: loading.curve = \"x.csv\": a force does not go with material.stiffness = \"bulk\", "
            "whose plate "
            "is not as stiff as the material\n");
}

TEST(LoadFile, ThatPressesLaterOrIsOfTwoLoadsIsNamed) {
  const std::string preset = "history = [[10e-6, 10e-3], [20e-6, 14e-3]]\n[loading]\ncurve = \"l.csv\"\n";
  const auto said = [&](const std::string& csv) {
    const Folder folder;
    folder.write("l.csv", csv);
    std::string out;
    for (const Issue& issue : read_preset(folder.write("x.toml", "[crack]\n" + preset)).issues)
      out += to_text(issue).substr(folder.path.string().size() + 1) + "\n";
    return out;
  };
  const char* presses =
      " compresses the plate while the crack runs, which needs crack.friction: the faces would pass through "
      "each other\n";
  EXPECT_EQ(said("time [us];displacement [mm]\n0;1\n20;-1\n30;-2\n"),
            std::string("l.csv:3: -1 mm") + presses + "l.csv:4: -2 mm" + presses);
  EXPECT_EQ(said("time [us];grip_force [N]\n0;100\n30;100\n"), "");
  EXPECT_TRUE(
      said("time [us];displacement [mm];force [N]\n0;1;2\n")
          .ends_with("l.csv:1: the header has displacement and force: only one of them can be read\n"));
}

TEST(LoadRows, AreOfTheFirstOnesKindAndReadBackToTheBit) {
  const auto curve = [](const std::string& rows) {
    const Preset preset = read_preset_text("[loading]\ncurve = " + rows, "x.toml");
    EXPECT_TRUE(preset.issues.empty());
    const LoadCurve& read = preset.scene.loading.curve;
    EXPECT_EQ(read_preset_text(preset_text(preset), "again.toml").scene.loading.curve, read);
    return read;
  };
  const LoadCurve force = curve("[[0, \"2 kN\"], [\"4 us\", 3000.1]]");
  EXPECT_EQ(force.of, LoadCurve::Of::force);
  EXPECT_EQ(force.row, (std::vector<std::array<double, 2>>{{0, 2000}, {4e-6, 3000.1}}));
  EXPECT_EQ(curve("[[0, \"2 mm\"], [1e-5, \"3 mm\"]]").of, LoadCurve::Of::displacement);
  const auto said = [](const std::string& rows) {
    return to_text(read_preset_text("[loading]\ncurve = " + rows, "x.toml").issues.at(0));
  };
  EXPECT_TRUE(said("[[0, \"2 kN\"], [1, \"2 mm\"]]")
                  .ends_with("row 2, force: unknown unit 'mm' for a force: use kN, N or mN"));
  EXPECT_TRUE(said("[[0, 2], [1, 2]]")
                  .ends_with("expected rows such as [\"4 us\", \"2 mm\"] or [\"4 us\", \"20 kN\"]"));
}

TEST(LoadAt, IsStraightBetweenTheRowsAndStandsBeyondThem) {
  const LoadCurve curve{.row = {{1.0, 10.0}, {2.0, 14.0}, {4.0, 14.0}}};
  EXPECT_EQ(load_at(curve, 0.0), 10.0);
  EXPECT_EQ(load_at(curve, 1.25), 11.0);
  EXPECT_EQ(load_at(curve, 3.0), 14.0);
  EXPECT_EQ(load_at(curve, 9.0), 14.0);
}

TEST(ToughnessRows, AreAllOfTheFirstOnesKind) {
  const auto said = [](const std::string& rows) {
    const Preset preset = read_preset_text("[crack]\ntoughness = " + rows + "\n", "x.toml");
    return preset.issues.empty() ? std::string() : preset.issues.front().text;
  };
  EXPECT_EQ(said(R"([["0.1 c_r", "5 J/m2"], ["0.5 c_r", 9]])"), "");
  EXPECT_EQ(said(R"([["0.1 c_r", "5 J/m2"], ["10 mm", "5 J/m2"]])"),
            "row 2, velocity: \"10 mm\" must be in c_r, as in the first row");
  EXPECT_EQ(said(R"([["10 mm", "5 J/m2"], ["0.1 c_r", "5 J/m2"]])"),
            "row 2, position: unknown unit 'c_r' for a length: use m, mm, um or nm");
  EXPECT_EQ(said("[[0.1, 5]]"),
            "expected rows such as [\"0.1 c_r\", \"900 J/m2\"] or [\"10 mm\", \"900 J/m2\"]");
}

TEST(CrackPathPoints, OfASplineGoThroughTheGivenOnesWithoutALoop) {
  const Preset preset = read_preset_text(
      "[crack]\npath_shape = \"spline\"\n"
      "path = [[\"0 mm\", \"20 mm\"], [\"60 mm\", \"20 mm\"], [\"62 mm\", \"25 mm\"], [\"200 mm\", \"20 "
      "mm\"]]\n",
      "x.toml");
  ASSERT_TRUE(preset.issues.empty()) << to_text(preset.issues.front());
  const auto points = path_points_m(preset.scene);
  ASSERT_EQ(points.size(), 3U * 32U + 1U);
  for (const auto& given : not_empty(preset.scene.crack.path.point))
    EXPECT_NE(std::find(points.begin(), points.end(), given), points.end());
  for (std::size_t k = 1; k < points.size(); ++k) EXPECT_GT(points[k][0], points[k - 1][0]) << k;
  for (std::size_t k = 1; k < points.size(); ++k) {  // no piece is much longer than the others of its stretch
    const std::size_t from = (k - 1) / 32 * 32, to = from + 32;
    const auto apart = [&](std::size_t a, std::size_t b) {
      return std::hypot(points[b][0] - points[a][0], points[b][1] - points[a][1]);
    };
    EXPECT_LT(apart(k - 1, k), 3.0 * apart(from, to) / 32.0) << k;
  }
  EXPECT_GT(path_length_m(preset.scene), 0.2);
  EXPECT_LT(path_length_m(preset.scene), 0.21);
}

TEST(CrackPathPoints, OnALineAreOnItHoweverTheyAreJoined) {
  for (const char* shape : {"polyline", "spline"}) {
    const Preset preset = read_preset_text(
        std::string("[crack]\npath = [[0, 0.01], [0.05, 0.015], [0.2, 0.03]]\npath_shape = \"") + shape +
            "\"\n",
        "x.toml");
    ASSERT_TRUE(preset.issues.empty()) << to_text(preset.issues.front());
    for (const auto& [x, y] : not_empty(path_points_m(preset.scene))) EXPECT_NEAR(y, 0.01 + 0.1 * x, 1e-12);
    EXPECT_NEAR(path_length_m(preset.scene), 0.2 * std::sqrt(1.01), 1e-12);
  }
}

}  // namespace
}  // namespace rift::scene

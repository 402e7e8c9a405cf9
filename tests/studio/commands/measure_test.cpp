#include "tests/studio/commands/tiny_plate.hpp"

#include <nlohmann/json.hpp>

#include <algorithm>
#include <regex>

namespace rift::studio {
namespace {

namespace fs = std::filesystem;

Ran measure(const TinyPlate& plate, const std::string& arguments = "") {
  return run_rift("measure '" + plate.out().string() + "' --inner 4 --grid 2 --quiet " + arguments);
}

const std::string two_gauges = R"(--set 'output.gauges=[["20 mm", "9 mm"], ["20 mm", "3 mm"]]')";

TEST(MeasureCommand, LeavesTablesChartsAndAPage) {
  const TinyPlate plate;
  ASSERT_EQ(plate.run(two_gauges).exit_code, 0);
  const Ran ran = measure(plate);
  ASSERT_EQ(ran.exit_code, 0) << ran.err;
  EXPECT_TRUE(contains(ran.out, "K_I [MPa m½]"));
  EXPECT_TRUE(contains(ran.out, "G from K  "));
  const fs::path folder = plate.out() / "measure";
  for (const char* file :
       {"report.html", "summary.json", "charts/grip_force.png", "charts/strain_yy.svg", "charts/vy.svg",
        "charts/stress_intensity.svg", "charts/release_rate.svg", "charts/displacement_y_end.svg"})
    EXPECT_GT(fs::file_size(folder / file), 500U) << file;
  const std::string fields = read_text(folder / "field.csv"),
                    rates = read_text(folder / "stress_intensity.csv");
  EXPECT_TRUE(contains(fields, "time_s,tip_m,x_m,y_m,ux_m"));
  EXPECT_GT(std::count(fields.begin(), fields.end(), '\n'), 4 * 50);
  EXPECT_EQ(std::count(rates.begin(), rates.end(), '\n'), 1 + 4);
  EXPECT_FALSE(fs::exists(folder / "field.csv.part"));
  EXPECT_EQ(measure(plate).exit_code, 0) << "replaced";
}

TEST(MeasureCommand, LaysMeasuredCurvesOverAndSaysHowFarTheyAre) {
  const TinyPlate plate;
  ASSERT_EQ(plate.run(two_gauges).exit_code, 0);
  const fs::path curves = plate.path() / "measured.csv";
  write_text(curves, "time [us];grip_force [N];gauge1_strain_yy\n0;1000;0.05\n10;900;0.05\n");
  const Ran ran = measure(plate, "--json --against '" + curves.string() + "'");
  ASSERT_EQ(ran.exit_code, 0) << ran.err;
  const auto json = nlohmann::json::parse(ran.out);
  ASSERT_EQ(json.at("measured").size(), 2U);
  EXPECT_EQ(json.at("measured")[0].at("name"), "grip_force");
  EXPECT_EQ(json.at("measured")[0].at("points"), 2);
  EXPECT_EQ(json.at("measured")[0].at("span"), 100.0);
  EXPECT_GT(json.at("measured")[0].at("rms").get<double>(), 0.0);
  EXPECT_TRUE(contains(read_text(plate.out() / "measure" / "charts" / "grip_force.csv"), "measured"));
}

// The recorder began 5 ms before the run.
TEST(MeasureCommand, ShiftsTheTimesOfMeasuredCurves) {
  const TinyPlate plate;
  ASSERT_EQ(plate.run(two_gauges).exit_code, 0);
  const fs::path curves = plate.path() / "measured.csv";
  write_text(curves, "time [ms];grip_force [N]\n5;1000\n5.01;900\n");
  const std::string against = "--json --against '" + curves.string() + "'";
  Ran ran = measure(plate, against);
  ASSERT_EQ(ran.exit_code, 0) << ran.err;
  EXPECT_EQ(nlohmann::json::parse(ran.out).at("measured")[0].at("points"), 0);
  ran = measure(plate, against + " --offset '-5 ms'");
  ASSERT_EQ(ran.exit_code, 0) << ran.err;
  EXPECT_EQ(nlohmann::json::parse(ran.out).at("measured")[0].at("points"), 2);
  EXPECT_EQ(nlohmann::json::parse(ran.out).at("offset_s"), -5e-3);
  EXPECT_TRUE(contains(read_text(plate.out() / "measure" / "report.html"), "-5000 µs added to their times"));
  ran = measure(plate, against + " --offset 5");
  EXPECT_EQ(ran.exit_code, 2);
  EXPECT_TRUE(contains(ran.err, "--offset")) << ran.err;
}

TEST(MeasureCommand, LeavesNothingBehindOfBadInput) {
  const TinyPlate plate;
  ASSERT_EQ(plate.run().exit_code, 0);
  write_text(plate.path() / "bad.csv", "time [us];grip_force [N]\n0;1\n0;2\n");
  Ran ran = measure(plate, "--against '" + (plate.path() / "bad.csv").string() + "'");
  EXPECT_EQ(ran.exit_code, 2);
  EXPECT_TRUE(contains(ran.err, "bad.csv:3: time does not grow"));
  ran = measure(plate, "--lane 1");
  EXPECT_EQ(ran.exit_code, 2);
  EXPECT_TRUE(contains(ran.err, "has no lane 1: it has one"));
  ran = measure(plate, "--outer 3");
  EXPECT_EQ(ran.exit_code, 2);
  EXPECT_TRUE(contains(ran.err, "--inner = 4: must lie below --outer = 3"));
  EXPECT_FALSE(fs::exists(plate.out() / "measure"));
  EXPECT_FALSE(fs::exists(plate.out() / "measure_lane1"));
}

TEST(MeasureCommand, NamesWhatIsNoRunAndARunWithoutDisplacements) {
  const TinyPlate plate;
  Ran ran = measure(plate);
  EXPECT_EQ(ran.exit_code, 1);
  EXPECT_TRUE(contains(ran.err, plate.out().string()));
  EXPECT_FALSE(fs::exists(plate.out())) << "a folder that was not there is not made";
  ASSERT_EQ(plate.run("--set output.frames=0").exit_code, 0);
  ran = measure(plate);
  EXPECT_EQ(ran.exit_code, 2);
  EXPECT_TRUE(contains(ran.err, "stores no displacements: set output.frames and output.fields"));
}

// Its E and nu are not the preset's, which says 10 GPa: they are measured.
TEST(MeasureCommand, FitsKOfABulkLatticeByItsOwnConstants) {
  const TinyPlate plate;
  ASSERT_EQ(plate.run("--set material.stiffness=bulk").exit_code, 0);
  const Ran ran = measure(plate, "--json");
  EXPECT_EQ(ran.exit_code, 0) << ran.err;
  const auto seen = nlohmann::json::parse(ran.out);
  EXPECT_GT(seen.at("own_young_modulus_pa").get<double>(), 12e9);
  EXPECT_TRUE(fs::exists(plate.out() / "measure" / "charts" / "stress_intensity.svg"));
}

TEST(MeasureCommand, OfARingThatDoesNotFitNamesOneThatDoes) {
  const TinyPlate plate;
  ASSERT_EQ(plate.run().exit_code, 0);
  const std::string command = "measure '" + plate.out().string() + "' --quiet --outer 40 ";
  const Ran ran = run_rift(command + "--inner 20");
  EXPECT_EQ(ran.exit_code, 2);
  EXPECT_TRUE(fs::exists(plate.out() / "measure" / "field.csv")) << "what was seen is kept";
  std::smatch told;
  ASSERT_TRUE(std::regex_search(ran.err, told,
                                std::regex("'(--inner [0-9.]+ --grid [0-9.]+)' suits this run, "
                                           "specimen.elements = ([0-9]+) another one")))
      << ran.err;
  // The proposal works.
  const Ran again = run_rift(command + told.str(1));
  EXPECT_EQ(again.exit_code, 0) << again.err;
  EXPECT_TRUE(contains(again.out, "G from K "));
}

TEST(MeasureCommand, ReplacesWhatItMeasuredBefore) {
  const TinyPlate plate;
  ASSERT_EQ(plate.run(two_gauges).exit_code, 0);
  ASSERT_EQ(measure(plate).exit_code, 0);
  const fs::path charts = plate.out() / "measure" / "charts";
  ASSERT_TRUE(fs::exists(charts / "stress_intensity.svg"));
  write_text(plate.out() / "measure" / "notes.txt", "mine");
  const Ran ran = measure(plate, "--outer 5");  // no ring
  EXPECT_EQ(ran.exit_code, 2);
  EXPECT_TRUE(contains(ran.err, "rift measure: no stress intensity at any moment: "));
  EXPECT_TRUE(contains(ran.out, "moments without K"));
  EXPECT_FALSE(fs::exists(charts / "stress_intensity.svg")) << "of the former measurement";
  EXPECT_TRUE(fs::exists(charts / "grip_force.svg"));
  EXPECT_TRUE(fs::exists(plate.out() / "measure" / "notes.txt"));
}

TEST(MeasureCommand, SaysWhatToDoWhereTheRingNeverFits) {
  const TinyPlate plate;
  ASSERT_EQ(plate.run().exit_code, 0);
  const std::string hint =
      "the ring fits at no moment: raise specimen.elements, or lower --inner and --outer";
  const Ran wide = run_rift("measure '" + plate.out().string() + "' --inner 20 --outer 40 --grid 2 --quiet");
  EXPECT_EQ(wide.exit_code, 2) << wide.err;
  EXPECT_TRUE(contains(wide.out, hint)) << wide.out;
  EXPECT_TRUE(contains(wide.out, ": the ring is too near to an edge of the plate"));
  EXPECT_FALSE(contains(measure(plate).out, hint));
}

TEST(MeasureCommand, LeavesNoFolderOfARefusedMeasurement) {
  const TinyPlate plate;
  ASSERT_EQ(plate.run().exit_code, 0);
  const fs::path deep = plate.path() / "a" / "b";
  EXPECT_EQ(measure(plate, "--against nowhere.csv --out '" + deep.string() + "'").exit_code, 2);
  EXPECT_FALSE(fs::exists(plate.path() / "a"));
  EXPECT_EQ(measure(plate, "--grid nan").exit_code, 2);
}

TEST(MeasureCommand, NeverWritesOverAnotherFolder) {
  const TinyPlate plate;
  ASSERT_EQ(plate.run().exit_code, 0);
  const std::string out = "--out '" + plate.path().string() + "'";
  const Ran ran = measure(plate, out + " --force");
  EXPECT_EQ(ran.exit_code, 2);
  EXPECT_TRUE(contains(ran.err, "exists and is not empty"));
}

}  // namespace
}  // namespace rift::studio

#include "studio/commands/common.hpp"
#include "tests/studio/run_rift.hpp"

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include <string>

namespace rift::studio {
namespace {

/// A small plate whose crack was measured, every 2 us at about 0.4 c_r.
class MeasuredPlate {
 public:
  MeasuredPlate() {
    write_text(folder_.path() / "small.toml", R"(# A small measured plate
[specimen]
length = "60 mm"
height = "12 mm"
elements = 900
coordination = 5.7
[loading]
displacement = "0.6 mm"
[crack]
history = "measured.csv"
damage_zone_ratio = 2
toughness_window = 6
[output]
samples = 80
frames = 4
)");
    std::string rows = "time [us];position [mm];uncertainty [mm]\n";
    for (int k = 0; k <= 18; ++k)
      rows += std::to_string(2 * k) + ";" + std::to_string(5.0 + 1.76 * k + 0.05 * (k % 3 - 1) * (k > 0)) +
              ";0.06\n";
    write_text(folder_.path() / "measured.csv", rows);
    write_text(folder_.path() / "law.csv", "velocity [c_r];release_rate [kJ/m2]\n0;100\n1;900\n");
  }

  std::filesystem::path path() const { return folder_.path(); }
  Ran experiment(const std::string& arguments) const {
    return run_rift("experiment '" + (path() / "small.toml").string() + "' --out '" +
                    (path() / "out").string() + "' " + arguments);
  }

 private:
  TemporaryFolder folder_;
};

TEST(ExperimentCommand, LeavesWhatWasFoundAsTablesChartsAndALawThatACrackTakes) {
  const MeasuredPlate plate;
  const Ran ran = plate.experiment("--resamples 2 --specimens 2 --quiet --json --against '" +
                                   (plate.path() / "law.csv").string() + "'");
  ASSERT_EQ(ran.exit_code, 0) << ran.err;
  const auto json = nlohmann::json::parse(ran.out);
  EXPECT_EQ(json.at("resamples"), 2);
  EXPECT_EQ(json.at("specimens"), 2);
  EXPECT_LT(json.at("ledger_residual").get<double>(), 1e-10);
  EXPECT_GT(json.at("along").size(), 30U);
  EXPECT_TRUE(json.contains("truth"));
  EXPECT_TRUE(json.contains("application"));
  for (const char* file : {"report.html", "table.csv", "summary.json", "run/summary.json",
                           "charts/rate_velocity.svg", "charts/application.svg", "charts/history.png"})
    EXPECT_TRUE(std::filesystem::exists(plate.path() / "out" / file)) << file;
  for (const char* law : {"toughness_velocity.csv", "toughness_position.csv"}) {
    const Ran taken = run_rift("check quickstart --print-config --set crack.toughness='" +
                               (plate.path() / "out" / law).string() + "'");
    EXPECT_EQ(taken.exit_code, 0) << law << taken.err;
  }
  EXPECT_EQ(plate.experiment("--quiet").exit_code, 2);  // never replaced without --force
}

TEST(ExperimentCommand, ThatWasKilledDoesNotBlockItsFolder) {
  const MeasuredPlate plate;
  const std::string out = (plate.path() / "out").string();
  std::filesystem::create_directories(plate.path() / "out" / "run");
  write_text(plate.path() / "out" / "run" / "journal.rift", "RIFTJRNL");
  const Ran again = plate.experiment("--quiet");
  EXPECT_EQ(again.exit_code, 2);
  EXPECT_TRUE(contains(again.err, "holds an experiment that was interrupted; --force starts it again"));
  const Ran forced = plate.experiment("--quiet --resamples 0 --no-application --force");
  EXPECT_EQ(forced.exit_code, 0) << forced.err;
  EXPECT_TRUE(std::filesystem::exists(plate.path() / "out" / "report.html"));
  write_text(plate.path() / "out" / "charts" / "earlier.svg", "of an earlier report");
  EXPECT_EQ(plate.experiment("--quiet --resamples 0 --no-application --force").exit_code, 0);
  EXPECT_FALSE(std::filesystem::exists(plate.path() / "out" / "charts" / "earlier.svg"));
}

TEST(ExperimentCommand, StoppedByItsBudgetGoesOnByTheSameCommandToTheSameBytes) {
  const MeasuredPlate plate;
  const std::string wishes = "--resamples 2 --specimens 2 --quiet --set solver.dt_fraction=0.1 ";
  ASSERT_EQ(plate.experiment(wishes).exit_code, 0);
  std::filesystem::rename(plate.path() / "out", plate.path() / "whole");
  int stops = 0;
  Ran ran;
  for (double budget = 0.05;
       (ran = plate.experiment(wishes + "--budget '" + std::to_string(budget) + " s'")).exit_code == 4;
       budget *= 1.2) {  // until it bears what cannot be kept: preparation, on the slowest machine too
    ++stops;
    ASSERT_LT(stops, 60) << ran.err;
    EXPECT_TRUE(contains(ran.err, "the same command ")) << ran.err;
  }
  ASSERT_EQ(ran.exit_code, 0) << ran.err;
  EXPECT_GT(stops, 1);
  for (const char* file : {"table.csv", "toughness_velocity.csv", "run/series.csv"})
    EXPECT_EQ(read_text(plate.path() / "whole" / file), read_text(plate.path() / "out" / file)) << file;
  for (const char* kept : {"parts", "experiment.json"})
    EXPECT_FALSE(std::filesystem::exists(plate.path() / "out" / kept)) << kept;
}

TEST(ExperimentCommand, EndsWithTheNumberToPublish) {
  const MeasuredPlate plate;
  const Ran ran = plate.experiment("--resamples 2 --specimens 2 --quiet");
  ASSERT_EQ(ran.exit_code, 0) << ran.err;
  const std::string last = ran.out.substr(ran.out.rfind('\n', ran.out.size() - 2) + 1);
  EXPECT_TRUE(last.starts_with("Publish: G_IDc = ")) << last;
  for (const char* part :
       {" ± ", " kJ/m² (mean over the tip from ", "± is two standard uncertainties: noise ",
        "corrected for the lattice efficiency η = ", ", uncorrected "})
    EXPECT_TRUE(contains(last, part)) << part << last;
  const auto json = nlohmann::json::parse(read_text(plate.path() / "out" / "summary.json"));
  double sum = 0.0;
  for (const auto& point : json.at("along")) sum += point.at("g_idc_corrected_j_m2").get<double>();
  const auto count = static_cast<double>(json.at("along").size());
  const auto& publish = json.at("publish");
  EXPECT_NEAR(publish.at("g_idc_corrected_j_m2").get<double>(), sum / count, 1e-9 * sum);
  EXPECT_NEAR(publish.at("g_idc_j_m2").get<double>() / publish.at("efficiency").get<double>(), sum / count,
              1e-9 * sum);
  EXPECT_GT(publish.at("u_packing_j_m2").get<double>(), 0.0);
  const std::string page = read_text(plate.path() / "out" / "report.html");
  EXPECT_TRUE(contains(page, "Publish: G"));
  EXPECT_TRUE(contains(page, "<span>crack.history</span>"));
  EXPECT_FALSE(contains(page, "<span>crack.velocity</span>")) << "the history has replaced it";
  EXPECT_FALSE(contains(page, "<span>loading.ramp_steps</span>"));
}

TEST(ExperimentCommand, InterruptedSaysWhichOptionsDiffer) {
  const MeasuredPlate plate;
  double budget = 0.2;
  Ran stopped;
  while ((stopped = plate.experiment("--resamples 2 --quiet --set solver.dt_fraction=0.1 --budget '" +
                                     std::to_string(budget) + " s'"))
                 .exit_code == 4 &&
         !std::filesystem::exists(plate.path() / "out"))
    budget *= 1.3;
  ASSERT_EQ(stopped.exit_code, 4) << stopped.err;
  const Ran other =
      plate.experiment("--resamples 3 --set solver.dt_fraction=0.1 --set specimen.seed=7 --quiet");
  EXPECT_EQ(other.exit_code, 2);
  for (const char* part : {"holds an interrupted experiment with other options: ",
                           "resamples was 2, is now 3", "specimen.seed was 1, is now 7", "--force starts it"})
    EXPECT_TRUE(contains(other.err, part)) << part << other.err;
}

TEST(ExperimentCommand, SaysWhatItNeeds) {
  const Ran none = run_rift("experiment quickstart");
  EXPECT_EQ(none.exit_code, 2);
  EXPECT_NE(none.err.find("has no crack.history"), std::string::npos) << none.err;
  const MeasuredPlate plate;
  const Ran gone = plate.experiment("--against '" + (plate.path() / "gone.csv").string() + "'");
  EXPECT_EQ(gone.exit_code, 2);
  EXPECT_NE(gone.err.find("gone.csv: no such file"), std::string::npos) << gone.err;
  write_text(plate.path() / "measured.csv", "time [us];position [mm]\n0;5\n2;4\n");
  const Ran bad = plate.experiment("");
  EXPECT_EQ(bad.exit_code, 2);
  EXPECT_NE(bad.err.find("measured.csv:3: position falls from 5 mm to 4 mm"), std::string::npos) << bad.err;
  EXPECT_FALSE(std::filesystem::exists(plate.path() / "out"));
}

}  // namespace
}  // namespace rift::studio

#include "tests/studio/run_rift.hpp"

#include <nlohmann/json.hpp>

namespace rift::studio {
namespace {

namespace fs = std::filesystem;
using Json = nlohmann::json;

/// Cylinders so small that they take no time.
constexpr const char* small =
    " --set calibration.elements=300 --set calibration.packings=2 --set 'calibration.radius_ratios=[0.2, "
    "0.4, 0.8]'"
    " --set 'calibration.sizes=[200, 300]' ";

class Calibrate : public testing::Test {
 protected:
  Ran calibrate(const std::string& arguments) const { return run_rift("calibrate " + arguments); }
  std::string out() const { return "'" + (folder_.path() / "out").string() + "'"; }
  TemporaryFolder folder_;
};

TEST_F(Calibrate, AnswersWithBeamsTheirScatterAndTheRangeOfNu) {
  const Ran ran = calibrate("--young '3.2 GPa' --poisson 0.25" + std::string(small));
  ASSERT_EQ(ran.exit_code, 0) << ran.err;
  for (const char* part :
       {"E = 3.2 GPa, ν = 0.25", "E_µ", "GPa between packings", "r_µ", "attainable  ν from 0.",
        "Left out: a scan of E_µ", "[material]", "stiffness = \"explicit\"", "micro_radius_ratio = "})
    EXPECT_TRUE(contains(ran.out, part));
}

TEST_F(Calibrate, LeavesAMaterialThatAPresetTakes) {
  const Ran ran = calibrate("--young '3.2 GPa' --poisson 0.25 --out " + out() + small);
  ASSERT_EQ(ran.exit_code, 0) << ran.err;
  const fs::path folder = folder_.path() / "out";
  const Ran check = run_rift("check '" + (folder / "material.toml").string() +
                             "' --set specimen.elements=900 --set specimen.coordination=5.7 --json");
  EXPECT_EQ(check.exit_code, 0) << check.err;
  const Json summary = Json::parse(read_text(folder / "summary.json"));
  EXPECT_NEAR(summary.at("measured_poisson_ratio").at("mean").get<double>(), 0.25, 2e-4);
  for (const char* file :
       {"report.html", "table.csv", "charts/calibration_young.svg", "charts/calibration_core.png"})
    EXPECT_TRUE(fs::exists(folder / file)) << file;
  // The same folder is not overwritten without being asked.
  EXPECT_EQ(calibrate("--young '3.2 GPa' --poisson 0.25 --out " + out() + small).exit_code, 2);
  EXPECT_EQ(calibrate("--young '3.2 GPa' --poisson 0.25 --force --out " + out() + small).exit_code, 0);
}

TEST_F(Calibrate, CutOffWhileItWritesItsReportIsBegunAnewWithForce) {
  const std::string arguments = "--young '3.2 GPa' --poisson 0.25 --out " + out() + small;
  ASSERT_EQ(calibrate(arguments).exit_code, 0);  // all of it is in the cache from now on
  int cut_off = 0;
  for (const int blocks : {4, 6, 8, 12, 24}) {
    fs::remove_all(folder_.path() / "out");
    const Ran cut =
        run_shell("env " + shared_cache_environment() + " sh -c 'ulimit -f " + std::to_string(blocks) +
                  "; exec \"$0\" \"$@\"' '" RIFT_EXE "' calibrate " + arguments);
    if (cut.exit_code == 0) continue;
    cut_off += fs::exists(folder_.path() / "out") ? 1 : 0;
    const Ran again = calibrate(arguments + " --force");
    EXPECT_EQ(again.exit_code, 0) << blocks << ": " << again.err;
  }
  EXPECT_GE(cut_off, 2);
}

TEST_F(Calibrate, PrintsJson) {
  const Ran ran = calibrate("--young '3.2 GPa' --poisson 0.25 --json --quiet" + std::string(small));
  const Json j = Json::parse(ran.out);
  EXPECT_EQ(j.at("young_modulus_pa"), 3.2e9);
  EXPECT_GT(j.at("micro_young_modulus_pa").get<double>(), 3.2e9);
  EXPECT_GT(j.at("attainable_poisson_ratio")[1].get<double>(),
            j.at("attainable_poisson_ratio")[0].get<double>());
}

TEST_F(Calibrate, RefusesANuOutOfReachWithTheRange) {
  const Ran ran = calibrate("--young '3.2 GPa' --poisson 0.49" + std::string(small));
  EXPECT_EQ(ran.exit_code, 2);
  EXPECT_TRUE(contains(
      ran.err, "material.poisson_ratio=0.49: 0.49 is out of reach of these beams: the cylinders show 0."));
}

TEST_F(Calibrate, NamesWhatIsMissing) {
  EXPECT_TRUE(contains(calibrate("").err, "--young: is needed where no preset names the material"));
  EXPECT_TRUE(contains(calibrate("--young '3 GPa'").err, "--poisson: is needed"));
  EXPECT_TRUE(contains(calibrate("--young '3 kg' --poisson 0.3").err, "material.young_modulus=3 kg: "));
  const Ran plate = calibrate("quickstart");
  EXPECT_EQ(plate.exit_code, 2);
  EXPECT_TRUE(contains(plate.err, "must be \"cylinder\", the shape that is compressed"));
}

TEST_F(Calibrate, StopsWhenInterruptedAndKeepsWhatItHas) {
  const Ran ran = run_shell("env XDG_CACHE_HOME='" + folder_.path().string() +
                            "/cache' timeout -s INT 1 '" RIFT_EXE
                            "' calibrate --young '3 GPa' --poisson 0.3 --set calibration.elements=60000");
  EXPECT_EQ(ran.exit_code, 124);  // timeout's own word for it
  EXPECT_TRUE(
      contains(ran.err, "rift calibrate: stopped while packing; the finished parts are in the cache"));
}

TEST(Pack, ShowsHowTheElementsLie) {
  const TemporaryFolder folder;
  const std::string out = (folder.path() / "out").string();
  const Ran ran = run_rift(
      "pack --set specimen.shape=sphere --set 'specimen.length=10 mm' --set specimen.elements=500 "
      "--no-cache --out '" +
      out + "'");
  ASSERT_EQ(ran.exit_code, 0) << ran.err;
  for (const char* part : {"sphere of 500 elements", "coordination    6.0", "solid fraction", "fabric",
                           "deviation from isotropy"})
    EXPECT_TRUE(contains(ran.out, part));
  const Json summary = Json::parse(read_text(out + "/summary.json"));
  EXPECT_EQ(summary.at("elements"), 500);
  EXPECT_EQ(summary.at("pair_correlation").size(), 50u);
  for (const char* file :
       {"/report.html", "/elements.csv", "/charts/coordination.svg", "/charts/pair_correlation.png"})
    EXPECT_TRUE(fs::exists(out + file)) << file;
}

TEST(Pack, RefusesWhatCannotBe) {
  const Ran dense =
      run_rift("pack --no-cache --set specimen.solid_fraction=0.79 --set specimen.elements=500");
  EXPECT_EQ(dense.exit_code, 2);
  EXPECT_TRUE(contains(dense.err, "specimen.solid_fraction=0.79: a solid fraction of 0.79 is out of reach"));
  EXPECT_EQ(run_rift("run fig16_cylinders --no-cache").exit_code, 2);
}

}  // namespace
}  // namespace rift::studio

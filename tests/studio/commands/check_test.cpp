#include "tests/studio/commands/tiny_study.hpp"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <string>

namespace rift::studio {
namespace {

namespace fs = std::filesystem;
using Json = nlohmann::json;

TEST(Check, ShowsWhatFollowsFromAPresetAndWritesNoRun) {
  const TinyPlate plate;
  const Ran ran = plate.check();
  EXPECT_EQ(ran.exit_code, 0) << ran.err;
  EXPECT_EQ(ran.err.find('\x1b'), std::string::npos);  // progress at most, plain
  for (const char* label :
       {"lattice", "900 elements", "material", "waves", "Rayleigh 2200 m/s", "J stored", "crack",
        "of the critical step", "steps", "per beam release", "cost", "MB on disk"})
    EXPECT_TRUE(contains(ran.out, label));
  EXPECT_FALSE(fs::exists(plate.path() / "runs"));
  EXPECT_FALSE(fs::exists(plate.out()));
}

TEST(Check, SaysWhatIsLeftOutAndWhy) {
  const TinyPlate plate;
  const std::string plain = plate.check("--set output.frames=0 --set crack.technique=simple").out;
  for (const char* line :
       {"damping: alpha = 0, no damped beams are built", "numerical damping: beta = 1",
        "damage zone: technique = simple", "ramp: method = static, the pre-stress is one solve",
        "frames: frames = 0, no fields are written"})
    EXPECT_TRUE(contains(plain, line));
  EXPECT_TRUE(contains(plain, "  left out "));
  const std::string full = plate
                               .check(
                                   "--set damping.alpha=0.001 --set damping.region=all --set solver.beta=0.9 "
                                   "--set loading.method=ramp --set solver.kinematics=corotational "
                                   "--set crack.friction=0 "
                                   "--set 'output.gauges=[[\"36 mm\", \"9 mm\"]]'")
                               .out;
  EXPECT_FALSE(contains(full, "left out"));
}

TEST(Check, SaysOfEachLaneWhatItLeavesOut) {
  const TinyPlate plate;
  write_text(plate.preset(), read_text(plate.preset()) +
                                 "[[lanes]]\ndamping_alpha = 0\n[[lanes]]\ndamping_alpha = 0.001\n"
                                 "damping_region = \"surface\"\n[[lanes]]\ntechnique = \"simple\"\n");
  const std::string out = plate.check().out;
  EXPECT_TRUE(contains(out,
                       "damping: lanes 0 and 2 (alpha = 0, no damped beams are built); lane 1 needs it: the "
                       "lanes share a step, which evaluates the damped beams for all of them"));
  EXPECT_TRUE(contains(out, "damage zone: lane 2 (technique = simple); lanes 0 and 1 need it"));
  EXPECT_FALSE(contains(out, "damage zone 0 mm"));
  ASSERT_EQ(plate.run().exit_code, 0);
  const Json lanes = Json::parse(read_text(plate.out() / "summary.json")).at("scenarios");
  const auto leaves_out = [&](int lane, const char* name) {
    const Json& list = lanes.at(lane).at("left_out");
    return std::find(list.begin(), list.end(), name) != list.end();
  };
  EXPECT_TRUE(leaves_out(0, "damping"));
  EXPECT_FALSE(leaves_out(1, "damping"));
  EXPECT_FALSE(leaves_out(0, "damage_zone"));
  EXPECT_TRUE(leaves_out(2, "damage_zone"));
}

TEST(Check, OfAStudyCountsScenariosAndSaysWhatWasMerged) {
  const TinyPlate plate;
  write_text(plate.preset(), read_text(plate.preset()) +
                                 "[study]\ntechnique = [\"simple\", \"progressive\"]\n"
                                 "damage_zone_ratio = [1, 2, 4]\nseed = [1, 2]\n");
  const Ran ran = plate.check();
  ASSERT_EQ(ran.exit_code, 0) << ran.err;
  for (const char* part :
       {"rift study ", "8 scenarios of 12 combinations, 2 specimens",
        "damage_zone_ratio does not count where technique = \"simple\": 3 combinations each are 2 scenarios",
        "technique simple, seed 2", "900 elements", "cost", "MB of memory", "MB on disk",
        "damage zone: 2 of 8 scenarios (technique = simple)"})
    EXPECT_TRUE(contains(ran.out, part)) << part << "\n" << ran.out;
  const Json plan = Json::parse(plate.check("--json").out);
  EXPECT_EQ(plan.at("count"), 8);
  EXPECT_EQ(plan.at("missing"), 8);
  EXPECT_EQ(plan.at("merged").at(0).at("into").size(), 2U);
  EXPECT_GT(plan.at("wall_estimate_s").get<double>(), 0.0);
  EXPECT_FALSE(fs::exists("studies"));
}

TEST(Check, OfAStudyCountsPackingsNotTimeStepsAsSpecimens) {
  const TinyPlate plate;
  write_text(plate.preset(), read_text(plate.preset()) +
                                 "[study]\ndt_fraction = [0.3, 0.4, 0.5]\nseed = [1, 2]\nplane = "
                                 "[\"stress\", \"strain\"]\n");
  const Ran ran = plate.check();
  EXPECT_TRUE(contains(ran.out, "12 scenarios, 2 specimens")) << ran.out;
}

TEST(Check, SaysOfThinPlatesWhatTheyAreBeforeTheyArePacked) {
  const TinyPlate plate;
  const Ran one = plate.check("--set specimen.layers=1.9 --set specimen.coordination=5.5");
  EXPECT_EQ(one.exit_code, 0) << one.err;
  EXPECT_TRUE(contains(one.err, "note: the plate has 1.95 layers of elements (")) << one.err;
  EXPECT_TRUE(contains(one.err, " mm thick, elements ")) << one.err;
  EXPECT_FALSE(contains(one.err, "hardly be made")) << one.err;
  write_text(plate.preset(), read_text(plate.preset()) + "[study]\nlayers = [1, 1.3, 2]\n");
  const Ran study = plate.check();
  EXPECT_TRUE(contains(study.err,
                       "note: 2 of 3 scenarios have fewer than two layers of elements (layers 1 and "
                       "1.3): the thinnest plate has 1.03 layers"))
      << study.err;
  EXPECT_TRUE(contains(study.err, "reach a coordination of about 4.9, 5.7 is asked for")) << study.err;
}

TEST(Check, OfAnExperimentCostsTheMeasuredCrackAsTheDryRunDoes) {
  const TinyPlate plate;
  const std::string set =
      "--set 'crack.history=[[0, 0.006], [4e-6, 0.01], [8e-6, 0.014], [12e-6, 0.018], [16e-6, 0.022], "
      "[20e-6, "
      "0.026], [24e-6, 0.03]]' --set crack.end=28e-3 --json";
  const Ran ran = plate.check(set);
  ASSERT_EQ(ran.exit_code, 0) << ran.err;
  const Json plan = Json::parse(ran.out);
  const Json& crack = plan.at("experiment").at("parts").at(0);
  EXPECT_EQ(crack.at("name"), "measured crack");
  EXPECT_NEAR(crack.at("wall_estimate_s").get<double>(), plan.at("wall_estimate_s").get<double>(),
              1e-6 * plan.at("wall_estimate_s").get<double>());
}

TEST(Check, OfAStudyForeseesWhatIsOnTheDisk) {
  const TinyStudy plate;
  const Json plan = Json::parse(plate.check("--json").out);
  ASSERT_EQ(plate.study().exit_code, 0);
  std::uintmax_t bytes = 0;
  for (const auto& entry : fs::recursive_directory_iterator(plate.out()))
    if (entry.is_regular_file()) bytes += entry.file_size();
  EXPECT_GE(plan.at("disk_estimate_bytes").get<double>(), static_cast<double>(bytes));
  EXPECT_LE(plan.at("disk_estimate_bytes").get<double>(), 5.0 * static_cast<double>(bytes));
}

TEST(Check, OfAMeasuredCrackTellsTheExperimentToo) {
  const TinyPlate plate;
  std::string rows;
  for (int k = 0; k < 12; ++k)
    rows += (k > 0 ? ", [" : "[") + std::to_string(k * 2e-6) + ", " + std::to_string(0.006 + 0.002 * k) + "]";
  const std::string set =
      "--set 'crack.history=[" + rows + "]' --set crack.end=28e-3 --resamples 5 --specimens 2";
  const Ran ran = plate.check(set);
  ASSERT_EQ(ran.exit_code, 0) << ran.err;
  for (const char* part :
       {"of the critical", "rift experiment ", "--resamples 5 --specimens 2", "measured crack",
        "resampled histories         5", "other specimens             1", "20 static solutions"})
    EXPECT_TRUE(contains(ran.out, part)) << part << "\n" << ran.out;
}

TEST(Check, OfACylinderTellsTheCalibration) {
  const Ran ran = run_rift("check fig16_cylinders");
  ASSERT_EQ(ran.exit_code, 0) << ran.err;
  for (const char* part :
       {"rift calibrate fig16_cylinders", "cylinders of all sizes", "periodic boxes", "cost"})
    EXPECT_TRUE(contains(ran.out, part)) << part;
}

TEST(Check, TellsTheErrorOfTheStepWhereItWasMeasured) {
  const TinyPlate plate;
  const auto in_its_folder = [&](const std::string& command) {
    return run_shell("cd '" + plate.path().string() + "' && env " + plate.environment() + " '" RIFT_EXE "' " +
                     command);
  };
  EXPECT_TRUE(contains(in_its_folder("check tiny.toml").out,
                       "the error of the step is not measured: rift accuracy tiny.toml"));
  ASSERT_EQ(
      in_its_folder("accuracy tiny.toml --quick --threads 1 --seeds 1 --elements 1250 --quiet").exit_code, 0);
  const std::string told = Json::parse(in_its_folder("check tiny.toml --json").out).at("step_error");
  const Json lines = Json::parse(read_text(plate.path() / "tiny_accuracy" / "summary.json")).at("lines");
  EXPECT_EQ(lines.at(0).at("knob"), "scene");
  EXPECT_TRUE(contains(
      told, fmt::format("the step adds {:+.4f} to G_ID/G_I0", lines.at(0).at("error").get<double>())))
      << told;
  EXPECT_TRUE(
      contains(in_its_folder("check tiny.toml --set crack.velocity='0.4 c_r'").out, "is not measured"))
      << "another scene";
}

TEST(Check, OfAClaimTellsTheReproduction) {
  const Json all = Json::parse(run_rift("check fig07 --json").out);
  const Json quick = Json::parse(run_rift("check fig07 --quick --json").out);
  EXPECT_EQ(all.at("command"), "rift reproduce fig07");
  EXPECT_GT(all.at("count").get<int>(), 10);
  EXPECT_EQ(all.at("parts").at(0).at("name"), "fig07");
  EXPECT_LT(quick.at("wall_estimate_s").get<double>(), all.at("wall_estimate_s").get<double>());
  EXPECT_EQ(Json::parse(run_rift("check sec4_longer --json").out).at("command"), "rift study sec4_longer");
  EXPECT_EQ(Json::parse(run_rift("check sec4_longer --reproduce --json").out).at("command"),
            "rift reproduce sec4_longer");
  EXPECT_EQ(run_rift("check fig77").exit_code, 2);
}

TEST(Check, TellsWindowAndFirstEchoOfOneTipAndOfTwo) {
  const TinyPlate plate;
  // H = 12 mm: 0.3 of the paper's 11.26 mm at 0.5 c_r   [model.md §9.4]
  EXPECT_TRUE(
      contains(plate.check().out,
               "measuring window 12 to 24 mm; the first boundary reflection reaches the tip at 3.379 mm"));
  EXPECT_TRUE(contains(plate.check("--set 'crack.velocity=0.2 c_r until 20 mm, 0.7 c_r'").out,
                       "the first boundary reflection is not predicted for this crack"));
  const std::string two = plate.check("--set crack.tips=2 --set 'output.window=[0.1, 0.5]'").out;
  EXPECT_TRUE(contains(two, "two tips, half length at 1100 m/s to 30 mm"));
  EXPECT_TRUE(contains(
      two, "measuring window 6 to 30 mm; the first boundary reflection reaches the tip at 3.379 mm"));
}

TEST(Check, JsonAgreesWithTheRunItForesees) {
  const TinyPlate plate;
  const Ran ran = plate.check("--json");
  ASSERT_EQ(ran.exit_code, 0);
  const Json foreseen = Json::parse(ran.out);
  ASSERT_EQ(plate.run().exit_code, 0);
  const Json done = Json::parse(read_text(plate.out() / "summary.json")).at("scenarios")[0];
  for (const char* name : {"elements", "beams", "beams_crossed", "beams_damped", "rattlers", "mean_radius_m",
                           "thickness_m", "density_kg_m3", "rayleigh_speed_m_s", "micro_young_modulus_pa",
                           "g_i0_j_m2", "dt_s", "dt_critical_s", "dt_fraction", "steps", "steps_per_beam"})
    EXPECT_EQ(foreseen.at(name), done.at(name)) << name;
  EXPECT_GT(foreseen.at("wall_estimate_s"), 0.0);
  std::uintmax_t bytes = 0;
  for (const auto& entry : fs::directory_iterator(plate.out())) bytes += entry.file_size();
  EXPECT_GE(foreseen.at("disk_estimate_bytes").get<double>(), static_cast<double>(bytes)) << "'at most'";
}

TEST(Check, PrintsTheEffectivePresetWithoutPacking) {
  const TinyPlate plate(CacheOf::this_test);
  const Ran ran = plate.check("--print-config --set specimen.seed=7");
  EXPECT_EQ(ran.exit_code, 0);
  EXPECT_TRUE(contains(ran.out, "seed = 7"));
  EXPECT_FALSE(fs::exists(plate.path() / "cache"));
}

TEST(Check, KeepsItsPackingForTheRun) {
  const TinyPlate plate(CacheOf::this_test);
  ASSERT_EQ(plate.check().exit_code, 0);
  ASSERT_EQ(plate.run().exit_code, 0);
  const Json done = Json::parse(read_text(plate.out() / "summary.json")).at("scenarios")[0];
  EXPECT_EQ(done.at("packing_from_cache"), true);
  EXPECT_EQ(done.at("prestress_from_cache"), true);
}

TEST(Check, ShowsTheSpecimensOwnConstantsOnceTheyAreKnown) {
  const TinyPlate plate;
  const std::string unseen = "--set specimen.seed=7301";
  Ran ran = plate.check("--no-cache " + unseen);
  ASSERT_EQ(ran.exit_code, 0) << ran.err;
  EXPECT_TRUE(contains(ran.out, "plate's own     not measured: 'rift check --measure'")) << ran.out;
  ASSERT_EQ(plate.check("--measure " + unseen).exit_code, 0);
  ran = plate.check(unseen);
  EXPECT_TRUE(contains(ran.out, "between the grips, Rayleigh ")) << ran.out;
  const Json own = Json::parse(plate.check("--json --quiet " + unseen).out).at("own");
  EXPECT_NEAR(own.at("poisson_ratio").get<double>(), 0.28, 0.1);
}

TEST(Check, MeasuresTheSpecimenItself) {
  const TinyPlate plate;
  const Ran ran = plate.check("--measure --set specimen.elements=2000");
  ASSERT_EQ(ran.exit_code, 0) << ran.err;
  for (const char* part :
       {"Measured on this specimen", "pulled along    E ", "shear ", "ratio", "over mean radius"})
    EXPECT_TRUE(contains(ran.out, part));
  const Json measured =
      Json::parse(plate.check("--measure --json --quiet --set specimen.elements=2000").out).at("measured");
  EXPECT_NEAR(measured.at("measured_shear_speed_m_s").get<double>() /
                  measured.at("nominal_shear_speed_m_s").get<double>(),
              1.0, 0.1);
  EXPECT_FALSE(measured.at("waves").empty());
}

}  // namespace
}  // namespace rift::studio

#include "tests/studio/commands/tiny_plate.hpp"

#include <nlohmann/json.hpp>

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

TEST(Check, MeasuresTheSpecimenItself) {
  const TinyPlate plate;
  const Ran ran = plate.check("--measure --set specimen.elements=2000");
  ASSERT_EQ(ran.exit_code, 0) << ran.err;
  for (const char* part :
       {"Measured on this specimen", "pulled along    E ", "shear ", "of it", "over mean radius"})
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

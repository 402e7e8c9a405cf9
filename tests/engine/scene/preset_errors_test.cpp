#include "engine/scene/preset.hpp"

#include <gtest/gtest.h>

#include <filesystem>
#include <string>
#include <vector>

namespace rift::scene {
namespace {

std::string texts(const Preset& preset) {
  std::string lines;
  for (const Issue& issue : preset.issues) lines += to_text(issue) + '\n';
  return lines;
}

/// All complaints_of_preset about a preset called x.toml.
std::string complaints_of_preset(const char* text, const std::vector<std::string>& overrides = {}) {
  return texts(read_preset_text(text, "x.toml", overrides));
}

TEST(PresetErrors, AreAllReportedAtOnceInTheOrderOfTheFile) {
  EXPECT_EQ(complaints_of_preset(R"(
[specimen]
elements = 0
height = "-3 mm"

[crack]
velocity = "5 c_r"
damge_zone_ratio = 2
damage_zone_ratio = 0

[material]
stiffness = "calibratd"
poisson_ratio = nan
)",
                                 {"solver.beta=1.05"}),
            "x.toml:3: specimen.elements = 0: must lie in [2, 5000000]\n"
            "x.toml:4: specimen.height = \"-3 mm\": must lie in (0, 100] m\n"
            "x.toml:7: crack.velocity = \"5 c_r\": must lie in (0, 2] c_r\n"
            "x.toml:8: unknown key 'damge_zone_ratio', did you mean 'damage_zone_ratio'?\n"
            "x.toml:9: crack.damage_zone_ratio = 0: must lie in (0, 1000]\n"
            "x.toml:12: material.stiffness = \"calibratd\": must be \"in-situ\", \"bulk\", \"calibrated\" or "
            "\"explicit\"\n"
            "x.toml:13: material.poisson_ratio = nan: must be a finite number\n"
            "--set solver.beta=1.05: must lie in (0, 1]\n");
}

TEST(PresetErrors, NameTheExpectedTypeAndTheOneGiven) {
  EXPECT_EQ(
      complaints_of_preset(
          "[specimen]\nlength = true\nelements = \"many\"\nradius_spread = \"0.1\"\nseed = [1]\n"
          "[loading]\nmethod = 3\n[output]\nfields = \"damage\"\nwindow = 0.3\n"
          "[crack]\nvelocity = 0.5\npath = false\nrelaxation = false\n[solver]\ndt = 1979-05-27\n"
          "[damping.alpha]\n"),
      "x.toml:2: specimen.length = true: expected a length such as \"2 mm\" or a number of m, got true or "
      "false\n"
      "x.toml:3: specimen.elements = \"many\": expected a whole number, got text\n"
      "x.toml:4: specimen.radius_spread = \"0.1\": expected a number, got text\n"
      "x.toml:5: specimen.seed = [1]: expected a whole number, got a list\n"
      "x.toml:7: loading.method = 3: expected \"static\" or \"ramp\", got a whole number\n"
      "x.toml:9: output.fields = \"damage\": expected a list of \"displacement\", \"velocity\", "
      "\"damage\", \"energy\" and \"rotation\", "
      "got text\n"
      "x.toml:10: output.window = 0.3: expected two fractions of the length such as [0.2, 0.4], got a "
      "number\n"
      "x.toml:12: crack.velocity = 0.5: needs a speed with its unit, such as \"0.5 c_r\" or \"1100 m/s\"\n"
      "x.toml:13: crack.path = false: expected a height such as \"0.5 H\" or \"20 mm\", got true or false\n"
      "x.toml:14: crack.relaxation = false: expected \"linear\", \"square-root\", \"quadratic\" or a number, "
      "got true or false\n"
      "x.toml:16: solver.dt = (a date): expected a time such as \"0.47 ms\" or a number of s, got a date\n"
      "x.toml:17: damping.alpha = (a table): expected a number, got a table\n");
}

TEST(PresetErrors, NameUnitsThatAreUnknownOrMissing) {
  EXPECT_EQ(
      complaints_of_preset(
          "[material]\nyoung_modulus = \"10 Gpa\"\nrayleigh_speed = \"2200\"\n[crack]\nvelocity = \"1\"\n"),
      "x.toml:2: material.young_modulus = \"10 Gpa\": unknown unit 'Gpa' for a pressure: use GPa, MPa, kPa "
      "or Pa\n"
      "x.toml:3: material.rayleigh_speed = \"2200\": needs a unit: m/s\n"
      "x.toml:5: crack.velocity = \"1\": needs a speed with its unit, such as \"0.5 c_r\" or \"1100 m/s\"\n");
}

TEST(PresetErrors, PointFromUnknownNamesToTheNearestOne) {
  EXPECT_EQ(
      complaints_of_preset(
          "lenght = 3\nspecimen = 4\n[crak]\nx = 1\n[studdy]\n[[lane]]\n[damping]\nbeta = 1\nxyzzy = 2\n"),
      "x.toml:1: unknown key 'lenght', did you mean 'specimen.length'?\n"
      "x.toml:2: specimen = 4: expected a table [specimen], got a whole number\n"
      "x.toml:3: unknown table [crak], did you mean [crack]?\n"
      "x.toml:5: unknown table [studdy], did you mean [study]?\n"
      "x.toml:6: unknown table [lane], did you mean [[lanes]]?\n"
      "x.toml:8: unknown key 'beta', did you mean 'solver.beta'?\n"
      "x.toml:9: unknown key 'xyzzy': [damping] has alpha, region and surface_width\n");
}

TEST(PresetErrors, ListTheTablesWhereNoneIsNear) {
  EXPECT_EQ(complaints_of_preset("[geometry]\n"),
            "x.toml:1: unknown table [geometry]: a preset has specimen, material, loading, crack, fracture, "
            "damping, "
            "solver, output, calibration, film, study and lanes\n");
}

TEST(PresetErrors, OfAFilmsLookNameTheWordsThereAre) {
  const Preset preset =
      read_preset_text("[film]\ncamera = \"top\"\nchart = 1\ntitle = 3\nfeild = \"uy\"\n", "x.toml");
  ASSERT_EQ(preset.issues.size(), 4u);
  EXPECT_EQ(to_text(preset.issues[0]),
            "x.toml:2: film.camera = \"top\": must be \"plate\", \"tip\" or \"side\"");
  EXPECT_EQ(to_text(preset.issues[1]),
            "x.toml:3: film.chart = 1: expected true or false, got a whole number");
  EXPECT_EQ(to_text(preset.issues[2]), "x.toml:4: film.title = 3: expected text, got a whole number");
  EXPECT_EQ(to_text(preset.issues[3]), "x.toml:5: unknown key 'feild', did you mean 'field'?");
}

TEST(PresetErrors, OfSyntaxHaveLineAndColumn) {
  const Preset preset = read_preset_text("[specimen]\nlength = = 3\n", "x.toml");
  ASSERT_EQ(preset.issues.size(), 1u);
  EXPECT_EQ(preset.issues[0].line, 2);
  EXPECT_EQ(preset.issues[0].column, 10);
  EXPECT_TRUE(to_text(preset.issues[0]).starts_with("x.toml:2:10: Error while parsing"))
      << to_text(preset.issues[0]);
}

TEST(PresetErrors, SayThatDecimalsHaveAPoint) {
  EXPECT_EQ(
      complaints_of_preset(
          "[specimen]\nlength = \"60,5 mm\"\n[crack]\nvelocity = \"0,5 c_r\"\npath = \"0,5 H\"\n",
          {"solver.beta=0,5", "material.young_modulus=3,2 GPa"}),
      "x.toml:2: specimen.length = \"60,5 mm\": use a decimal point, as in \"60.5 mm\"\nx.toml:4: "
      "crack.velocity = \"0,5 c_r\": use a decimal point, as in \"0.5 c_r\"\nx.toml:5: crack.path = \"0,5 "
      "H\": use a decimal point, as in \"0.5 H\"\n--set solver.beta=0,5: expected a number, got text: use a "
      "decimal point\n--set material.young_modulus=3,2 GPa: use a decimal point, as in \"3.2 GPa\"\n");
  const std::string bare = complaints_of_preset("[solver]\nbeta = 0,5\n");
  EXPECT_TRUE(bare.ends_with(": use a decimal point\n")) << bare;
}

TEST(PresetErrors, IncludeDuplicateKeys) {
  const Preset preset = read_preset_text("[specimen]\nseed = 1\nseed = 2\n", "x.toml");
  ASSERT_EQ(preset.issues.size(), 1u);
  EXPECT_EQ(preset.issues[0].line, 3);
  EXPECT_NE(preset.issues[0].text.find("seed"), std::string::npos) << preset.issues[0].text;
}

TEST(PresetErrors, OfOverridesAreFoundBesideASyntaxError) {
  const Preset preset = read_preset_text("[", "x.toml", {"specimen.elements=1"});
  ASSERT_EQ(preset.issues.size(), 2u);
  EXPECT_EQ(to_text(preset.issues[1]), "--set specimen.elements=1: must lie in [2, 5000000]");
}

TEST(OverrideErrors, AreWrittenAsTyped) {
  EXPECT_EQ(
      complaints_of_preset("", {"crack.velocity=5", "foo", "crack.velocty=1 c_r", "damage_zone_ratio=3", "=3",
                                "loading.method=\"both\"", "crack.end="}),
      "--set foo: expected key=value\n"
      "--set crack.velocty=1 c_r: unknown key 'crack.velocty', did you mean 'crack.velocity'?\n"
      "--set damage_zone_ratio=3: unknown key 'damage_zone_ratio', did you mean 'crack.damage_zone_ratio'?\n"
      "--set =3: unknown key '': docs/parameters.md lists them all\n"
      "--set crack.velocity=5: needs a speed with its unit, such as \"0.5 c_r\" or \"1100 m/s\"\n"
      "--set loading.method=\"both\": must be \"static\" or \"ramp\"\n"
      "--set crack.end: expected a length such as \"2 mm\"\n");
}

TEST(PresetFile, ThatIsMissingOrNoFileIsAnIssue) {
  const auto folder = std::filesystem::temp_directory_path();
  const auto missing = folder / "rift-no-such-preset.toml";
  EXPECT_EQ(texts(read_preset(missing, {"solver.beta=2"})),
            missing.string() + ": no such file\n--set solver.beta=2: must lie in (0, 1]\n");
  EXPECT_EQ(texts(read_preset(folder)), folder.string() + ": is a directory\n");
  EXPECT_EQ(texts(read_preset("/dev/zero")), "/dev/zero:1:1: larger than 8 MiB: not a preset\n");
}

TEST(PresetFile, ThatCannotBeReadIsAnIssue) {
  // Two ways that hold for root as well: a name which does not open, and a file which opens and then fails.
  const std::string longest(300, 'x');
  EXPECT_EQ(texts(read_preset(longest)), longest + ": cannot be read: File name too long\n");
  EXPECT_EQ(texts(read_preset("/proc/self/mem")), "/proc/self/mem: cannot be read: Input/output error\n");
}

}  // namespace
}  // namespace rift::scene

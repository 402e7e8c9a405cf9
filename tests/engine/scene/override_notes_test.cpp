#include "engine/scene/derived.hpp"
#include "engine/scene/preset.hpp"

#include <gtest/gtest.h>

#include <string>
#include <vector>

namespace rift::scene {
namespace {

std::vector<std::string> notes(const std::string& text, const std::vector<std::string>& overrides) {
  const Preset preset = read_preset_text(text, "x.toml", overrides);
  for (const Issue& issue : preset.issues) ADD_FAILURE() << to_text(issue);
  return preset.notes;
}

constexpr const char* plate =
    "[specimen]\nlength = \"100 mm\"\nheight = \"20 mm\"\nlayers = 2\nelements = 5000\n[loading]\n"
    "displacement = \"1 mm\"\n";

TEST(ThicknessNote, SaysBothNumbersWhereElementsChangeIt) {
  EXPECT_EQ(
      notes(plate, {"specimen.elements=2000"}),
      std::vector<std::string>{
          "specimen.elements = 2000 changes the thickness from 2 mm to 3.162 mm, as layers = 2 stays: --set "
          "specimen.thickness='2 mm' keeps it"});
  EXPECT_TRUE(notes(plate, {}).empty());
  EXPECT_TRUE(notes(plate, {"specimen.elements=5000"}).empty()) << "the same";
}

TEST(ThicknessNote, TakesTheDefaultForWhatThePresetDoesNotSay) {
  EXPECT_EQ(notes("", {"specimen.elements=80000"}).size(), 1U);
  EXPECT_TRUE(notes("", {"specimen.elements=20000"}).empty());
}

TEST(ThicknessNote, DoesNotProposeAThicknessOfLessThanOneElement) {
  const std::vector<std::string> said = notes("", {"specimen.elements=2000"});
  ASSERT_EQ(said.size(), 1U);
  EXPECT_TRUE(said[0].ends_with("from 2 mm to 6.325 mm, as layers = 2 stays")) << said[0];
}

TEST(ThicknessNote, NamesLengthAndHeightToo) {
  const std::vector<std::string> said = notes(plate, {"specimen.length=200 mm", "specimen.elements=20000"});
  ASSERT_EQ(said.size(), 1U);
  EXPECT_TRUE(
      said[0].starts_with("specimen.elements = 20000 and specimen.length = 200 mm change the thickness "
                          "from 2 mm to 1.414 mm"))
      << said[0];
}

TEST(ThicknessNote, IsNotOfAPlateWhoseThicknessIsGiven) {
  const std::string thick = "[specimen]\nthickness = \"2 mm\"\n";
  for (const std::string& note : notes(thick, {"specimen.elements=15000"}))
    EXPECT_EQ(note.find("the thickness from"), std::string::npos) << note;
  for (const std::string& note : notes(plate, {"specimen.elements=2000", "specimen.thickness=2 mm"}))
    EXPECT_EQ(note.find("the thickness from"), std::string::npos) << note;
}

TEST(ThicknessNote, OfAStudySaysBetweenWhichTheyLie) {
  EXPECT_EQ(
      notes(std::string(plate) + "[study]\nelements = [1250, 5000, 20000]\n", {}),
      std::vector<std::string>{"the study's elements change the thickness: 1 mm to 4 mm, as layers stays; "
                               "specimen.thickness in place of layers keeps one"});
  EXPECT_TRUE(notes(std::string(plate) + "[study]\nseed = [1, 2]\n", {}).empty());
}

/// What --set gives replaces its rival in the preset, with a note that names both.
struct Rivals {
  const char* table;  // of the preset, with the rival
  const char* set;
  const char* note;
};

class RivalOfAPreset : public testing::TestWithParam<Rivals> {};

TEST_P(RivalOfAPreset, GivesWayToWhatIsSet) {
  const Preset preset = read_preset_text(GetParam().table, "x.toml", {GetParam().set});
  for (const Issue& issue : preset.issues) ADD_FAILURE() << to_text(issue);
  ASSERT_EQ(preset.notes.size(), 1U);
  EXPECT_EQ(preset.notes[0], GetParam().note);
}

INSTANTIATE_TEST_SUITE_P(
    All, RivalOfAPreset,
    testing::Values(
        Rivals{"[crack]\nvelocity = \"0.5 c_r\"\nsmoothing = \"none\"\n",
               "crack.history=[[0, 0.01], [1e-05, 0.02], [2e-05, 0.03]]",
               "--set crack.history replaces crack.velocity = \"0.5 c_r\" (x.toml:2)"},
        Rivals{
            "[crack]\nhistory = [[0, 0.01], [1e-05, 0.02], [2e-05, 0.03]]\nsmoothing = \"none\"\n",
            "crack.velocity=0.5 c_r",
            "--set crack.velocity replaces crack.history = [[0, 0.01], [1e-05, 0.02], [2e-05, 0.03]] "
            "(x.toml:2)"},
        Rivals{"[crack]\nhistory = [[0, 0.01], [1e-05, 0.02], [2e-05, 0.03]]\nsmoothing = \"none\"\n",
               "crack.toughness=[[\"0.1 c_r\", 100], [\"0.5 c_r\", 200]]",
               "--set crack.toughness replaces crack.history = [[0, 0.01], [1e-05, 0.02], [2e-05, "
               "0.03]] "
               "(x.toml:2)"},
        Rivals{"[specimen]\nlayers = 2\n", "specimen.thickness=2 mm",
               "--set specimen.thickness replaces specimen.layers = 2 (x.toml:2)"},
        Rivals{"[specimen]\nthickness = \"2 mm\"\n", "specimen.layers=3",
               "--set specimen.layers replaces specimen.thickness = \"2 mm\" (x.toml:2)"},
        Rivals{"[loading]\ndisplacement = \"2 mm\"\n", "loading.force=100 kN",
               "--set loading.force replaces loading.displacement = \"2 mm\" (x.toml:2)"},
        Rivals{"[loading]\nforce = \"100 kN\"\n", "loading.displacement=1 mm",
               "--set loading.displacement replaces loading.force = \"100 kN\" (x.toml:2)"},
        Rivals{"[material]\nrayleigh_speed = \"2200 m/s\"\n", "material.density=1200 kg/m3",
               "--set material.density replaces material.rayleigh_speed = \"2200 m/s\" (x.toml:2)"},
        Rivals{
            "[material]\ndensity = \"1200 kg/m3\"\n", "material.rayleigh_speed=1000 m/s",
            "--set material.rayleigh_speed replaces material.density = \"1200 kg/m3\" (x.toml:2)"},
        Rivals{"[solver]\ndt = \"10 ns\"\n", "solver.dt_fraction=0.4",
               "--set solver.dt_fraction replaces solver.dt = \"10 ns\" (x.toml:2)"}));

}  // namespace
}  // namespace rift::scene

#include "engine/scene/parameters.hpp"
#include "engine/scene/preset.hpp"
#include "engine/scene/toml_text.hpp"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <random>
#include <string>

namespace rift::scene {
namespace {

/// Every message is one line of a sane length without control characters.
void expect_civil(const Preset& preset) {
  for (const Issue& issue : preset.issues) {
    const std::string text = to_text(issue);
    EXPECT_LT(text.size(), 600u);
    EXPECT_TRUE(std::none_of(text.begin(), text.end(), [](char c) { return c >= 0 && c < 0x20; })) << text;
  }
}

TEST(HostilePreset, OfRandomBytesIsAnIssue) {
  std::mt19937 random(1);
  for (int round = 0; round < 500; ++round) {
    std::string noise(1 + random() % 300, ' ');
    for (char& c : noise) c = static_cast<char>(random() % 256);
    noise[0] = '\x01';  // no comment, no blank
    Preset preset;
    ASSERT_NO_THROW(preset = read_preset_text(noise, "x.toml"));
    EXPECT_FALSE(preset.issues.empty());
    expect_civil(preset);
  }
}

TEST(HostilePreset, OfDamagedTextNeverThrows) {
  const std::string good = preset_text(default_scene());
  std::mt19937 random(2);
  for (int round = 0; round < 500; ++round) {
    std::string text = good;
    for (int hit = 0; hit < 5; ++hit) text[random() % text.size()] = static_cast<char>(random() % 128);
    Preset preset;
    ASSERT_NO_THROW(preset = read_preset_text(text, "x.toml")) << text;
    expect_civil(preset);
  }
}

TEST(HostilePreset, OfDeepListsIsAnIssue) {
  const Preset preset = read_preset_text("[specimen]\nlength = " + std::string(100000, '['), "x.toml");
  ASSERT_EQ(preset.issues.size(), 1u);
  EXPECT_EQ(preset.issues[0].line, 2);
  expect_civil(preset);
}

TEST(HostilePreset, OfDeepKeysIsAnIssue) {
  std::string key = "a";
  for (int i = 0; i < 200000; ++i) key += ".a";
  for (const std::string& text : {key + " = 1\n", "[" + key + "]\n"}) {
    const Preset preset = read_preset_text(text, "x.toml");
    ASSERT_EQ(preset.issues.size(), 1u);
    EXPECT_EQ(to_text(preset.issues[0]), "x.toml:1:1: the line has too many dots");
  }
}

TEST(HostilePreset, OfDeepKeysInDeepListsNeverThrows) {
  std::string key = "a";
  for (int i = 0; i < 120; ++i) key += ".a";
  std::string text = "[specimen]\nlength = ";
  for (int i = 0; i < 120; ++i) text += "[\n{" + key + " = ";
  text += "1";
  for (int i = 0; i < 120; ++i) text += "}\n]";
  EXPECT_EQ(read_preset_text(text, "x.toml").issues.size(), 1u);
}

TEST(HostilePreset, OfDamagedStudiesNeverThrows) {
  const std::string good =
      "[study]\nseed = [1, 2]\ntechnique = [\"simple\", \"progressive\"]\n[[study.rows]]\nlayers = 1\n"
      "[[lanes]]\nrelaxation = 2\n[[lanes]]\ndamping_alpha = 0\n";
  std::mt19937 random(3);
  for (int round = 0; round < 2000; ++round) {
    std::string text = good;
    for (int hit = 0; hit < 3; ++hit) text[random() % text.size()] = static_cast<char>(random() % 128);
    Preset preset;
    ASSERT_NO_THROW(preset = read_preset_text(text, "x.toml")) << text;
    expect_civil(preset);
  }
}

TEST(HostilePreset, OfAnAstronomicalStudyIsAnIssue) {
  std::string text = "[study]\n";
  for (const char* axis : {"seed", "elements", "samples", "damage_zone_ratio", "length"}) {
    text += fmt::format("{} = [10", axis);
    for (int i = 11; i < 1000; ++i) text += fmt::format(", {}", i);
    text += "]\n";
  }
  const Preset preset = read_preset_text(text, "x.toml");
  EXPECT_FALSE(preset.issues.empty());
  EXPECT_TRUE(preset.study.empty());
  expect_civil(preset);
}

TEST(HostilePreset, MayHaveARulerOfDotsInAComment) {
  EXPECT_TRUE(read_preset_text("# " + std::string(500, '.') + "\n", "x.toml").issues.empty());
}

TEST(HostilePreset, AboveTheSizeLimitIsAnIssue) {
  const Preset preset = read_preset_text(std::string((8 << 20) + 1, '\n'), "x.toml");
  ASSERT_EQ(preset.issues.size(), 1u);
  EXPECT_EQ(to_text(preset.issues[0]), "x.toml:1:1: larger than 8 MiB: not a preset");
}

TEST(HostilePreset, OfTwentyThousandUnknownKeysIsAnsweredInAFewLines) {
  std::string text = "[crack]\n";
  for (int k = 0; k < 20000; ++k) text += fmt::format("velocity_{} = 1\n", k);
  const InputError error(read_preset_text(text, "x.toml").issues);
  const std::string what = error.what();
  EXPECT_EQ(std::count(what.begin(), what.end(), '\n'), 20);
  EXPECT_TRUE(what.ends_with("\nand 19980 more")) << what;
}

TEST(HostilePreset, InAnotherEncodingIsNamedForWhatItIs) {
  EXPECT_EQ(to_text(read_preset_text(std::string("\xFF\xFE[\0a\0", 6), "x.toml").issues.at(0)),
            "x.toml:1:1: the file is UTF-16: save it as UTF-8 (in Excel: \"CSV UTF-8\")");
  EXPECT_EQ(
      to_text(read_preset_text("[crack]\nend = \"4 \xB5m\"\n", "x.toml").issues.at(0)),
      "x.toml:2:1: the byte 0xB5 is no UTF-8, in Windows-1252 'µ': the file is of another encoding, save it "
      "as UTF-8 (in Excel: \"CSV UTF-8\")");
}

TEST(HostilePreset, WithLongNamesAndValuesIsQuotedShort) {
  const std::string lump(100000, 'x');
  const Preset preset = read_preset_text("[specimen]\n" + lump + " = 1\nlength = \"" + lump +
                                             "\"\n[output]\nfields = [\"" + lump + "\"]\n[" + lump + "]\n",
                                         "x.toml", {lump, lump + "=1", "crack.path=" + lump});
  EXPECT_EQ(preset.issues.size(), 7u);
  expect_civil(preset);
}

TEST(HostilePreset, KeepsEscapeCodesFromTheTerminal) {
  const Preset preset = read_preset_text("[crack]\n\"\\u001b[2J\" = 1\npath = \"\\u001b[31m\"\n", "x.toml");
  EXPECT_EQ(preset.issues.size(), 2u);
  expect_civil(preset);
}

TEST(HostileOverride, CannotBringASecondKey) {
  const Value value = value_from_text("1\nother = 2");
  EXPECT_EQ(std::get<std::string>(value.held), "1\nother = 2");
}

}  // namespace
}  // namespace rift::scene

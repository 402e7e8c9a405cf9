#include "tests/studio/run_rift.hpp"

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

namespace rift::studio {
namespace {

std::string presets_at(const std::filesystem::path& folder) {
  return "RIFT_PRESETS='" + folder.string() + "'";
}

TEST(List, ShowsNameCostAndLineInAlignedColumns) {
  const TemporaryFolder folder;
  write_text(folder.path() / "small.toml", "# A small plate\n# Cost: 10 s\n\n# Not this line\n[specimen]\n");
  write_text(folder.path() / "large_plate.toml", "# A large plate\r\n# Cost: an hour on two cores\r\n");
  write_text(folder.path() / "notes.txt", "# No preset\n# Cost: none\n");
  const Ran ran = run_rift("list", presets_at(folder.path()));
  EXPECT_EQ(ran.exit_code, 0);
  EXPECT_EQ(ran.err, "");
  EXPECT_EQ(ran.out,
            "preset       cost                  shows\n"
            "large_plate  an hour on two cores  A large plate\n"
            "small        10 s                  A small plate\n");
}

TEST(List, GivesTheSameAsJson) {
  const TemporaryFolder folder;
  write_text(folder.path() / "small.toml", "# A \"small\" plate\n# Cost: 10 s\n");
  const Ran ran = run_rift("list --json", presets_at(folder.path()));
  ASSERT_EQ(ran.exit_code, 0);
  const auto all = nlohmann::json::parse(ran.out);
  ASSERT_EQ(all.size(), 1u);
  EXPECT_EQ(all.at(0).at("name"), "small");
  EXPECT_EQ(all.at(0).at("path"), (folder.path() / "small.toml").string());
  EXPECT_EQ(all.at(0).at("shows"), "A \"small\" plate");
  EXPECT_EQ(all.at(0).at("cost"), "10 s");
}

TEST(List, LeavesEmptyWhatAPresetDoesNotSay) {
  const TemporaryFolder folder;
  write_text(folder.path() / "mute.toml", "[specimen]\n# Cost: not in the opening\n");
  const auto all = nlohmann::json::parse(run_rift("list --json", presets_at(folder.path())).out);
  EXPECT_EQ(all.at(0).at("shows"), "");
  EXPECT_EQ(all.at(0).at("cost"), "");
}

TEST(List, OfAMissingFolderIsAFailureOfTheWorld) {
  const Ran ran = run_rift("list", "RIFT_PRESETS=/nowhere/presets");
  EXPECT_EQ(ran.exit_code, 1);
  EXPECT_EQ(ran.out, "");
  EXPECT_EQ(ran.err, "rift: cannot list the presets in /nowhere/presets: No such file or directory\n");
}

TEST(List, EveryShippedPresetSaysWhatItShowsAndCosts) {
  const Ran ran = run_rift("list --json", presets_at(RIFT_SOURCE_DIR "/presets"));
  ASSERT_EQ(ran.exit_code, 0) << ran.err;
  const auto all = nlohmann::json::parse(ran.out);
  EXPECT_FALSE(all.empty());
  for (const auto& preset : all) {
    EXPECT_NE(preset.at("shows"), "") << preset.at("name");
    EXPECT_NE(preset.at("cost"), "") << preset.at("name");
  }
}

}  // namespace
}  // namespace rift::studio

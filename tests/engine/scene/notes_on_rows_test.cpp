#include "engine/scene/preset.hpp"
#include "engine/scene/validation.hpp"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <set>
#include <string>

namespace rift::scene {
namespace {

/// The notes on a history of a row every 5 us from 10 mm on, without the rows named.
std::vector<std::string> notes_without(const std::set<int>& missing, int rows = 40) {
  std::string text = "[specimen]\nlength = \"100 mm\"\n[crack]\nsmoothing = \"none\"\nhistory = [";
  for (int k = 0; k < rows; ++k)
    if (!missing.contains(k)) text += fmt::format("[\"{} us\", \"{} mm\"],\n", 5 * k, 10 + k);
  const Preset preset = read_preset_text(text + "]\n", "x.toml");
  EXPECT_TRUE(preset.issues.empty()) << to_text(preset.issues.front());
  return preset.notes;
}

TEST(MissingRows, AreNotedWithTheirTimes) {
  EXPECT_TRUE(notes_without({}).empty());
  EXPECT_EQ(notes_without({7}),
            std::vector<std::string>{"crack.history: 1 row of every 5 us seems to be missing: 1 after 30 us; "
                                     "the smoothed history is interpolated between their neighbours"});
  EXPECT_EQ(
      notes_without({3, 20, 21, 22, 23, 24, 25, 26, 27, 28}),
      std::vector<std::string>{"crack.history: 10 rows of every 5 us seem to be missing: 1 after 10 us, 9 "
                               "after 95 us; the smoothed history is interpolated between their neighbours"});
  EXPECT_TRUE(notes_without({3, 6, 9, 12, 15, 18, 21, 24, 27}, 60).front().find("at 4 more places") !=
              std::string::npos);
}

/// The notes on a smoothed history of rows that scatter by 0.2 mm around 0.3 mm/us.
std::vector<std::string> notes_on_scatter(const std::string& uncertainty) {
  constexpr double position[] = {30.02, 33.45, 36.15, 39.62, 42.39, 45.35, 48.68, 51.17,
                                 53.91, 56.79, 59.53, 61.89, 64.56, 66.73, 69.27, 71.61};
  std::string text = "[crack]\nhistory = [";
  int k = 0;
  for (const double mm : position)
    text += fmt::format("[\"{} us\", \"{} mm\"{}],\n", 10 * k++, mm, uncertainty);
  const Preset preset = read_preset_text(text + "]\n", "x.toml");
  EXPECT_TRUE(preset.issues.empty()) << to_text(preset.issues.front());
  return preset.notes;
}

TEST(RowsWithoutUncertainty, AreNotedWhereTheHistoryFollowsEachOfThem) {
  const std::vector<std::string> notes = notes_on_scatter("");
  ASSERT_EQ(notes.size(), 1U);
  EXPECT_TRUE(
      notes[0].starts_with("crack.history: the smoothed history goes through nearly every one of the 16 "
                           "rows ("))
      << notes[0];
  EXPECT_TRUE(notes_on_scatter(", \"0.2 mm\"").empty());
}

TEST(MissingRows, AreNotSeenInAHistoryOfUnevenTimes) {
  const Preset preset = read_preset_text(
      "[crack]\nhistory = [[0, 0.01], [1e-6, 0.0101], [4e-6, 0.0102], [5e-6, 0.0103], [9e-6, 0.011]]\n",
      "x.toml");
  ASSERT_TRUE(preset.issues.empty()) << to_text(preset.issues.front());
  EXPECT_TRUE(preset.notes.empty()) << preset.notes.front();
}

std::vector<std::string> notes_on_path(const std::string& points, const std::string& more = {}) {
  const Preset preset = read_preset_text("[specimen]\nlength = \"100 mm\"\n[crack]\npath = " + points + "\n" +
                                             more + "[output]\nwindow = [0.1, 0.3]\n",
                                         "x.toml");
  EXPECT_TRUE(preset.issues.empty()) << to_text(preset.issues.front());
  return preset.notes;
}

TEST(PathThatCrossesItself, IsNotedWithThePlaceWhereItDoes) {
  EXPECT_EQ(notes_on_path("[[0, 0.02], [0.06, 0.02], [0.06, 0.03], [0.04, 0.03], [0.04, 0.01]]"),
            std::vector<std::string>{
                "crack.path crosses itself at (40 mm, 20 mm), 40 mm and again 100 mm along it: each beam is "
                "released at the first crossing, and the part inside the loop comes loose"});
  EXPECT_TRUE(notes_on_path("[[0, 0.02], [0.06, 0.02], [0.06, 0.03], [0.04, 0.03], [0.04, 0.021]]").empty());
  EXPECT_TRUE(notes_on_path("[[0, 0.02], [0.05, 0.025], [0.1, 0.02]]", "path_shape = \"spline\"\n").empty());
}

}  // namespace
}  // namespace rift::scene

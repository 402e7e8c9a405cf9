#include "engine/scene/parameters.hpp"

#include "engine/scene/derived.hpp"
#include "engine/scene/preset.hpp"
#include "engine/scene/toml_text.hpp"
#include "tests/expectations.hpp"

#include <gtest/gtest.h>

#include <fstream>
#include <iterator>
#include <limits>
#include <set>
#include <string>

namespace rift::scene {
namespace {

std::string problem_of(const char* key, const char* text) {
  Scene scene = default_scene();
  return assign(scene, *find_parameter(key), value_from_text(text));
}

TEST(ParameterTable, HasEveryKeyOnceInTableOrder) {
  std::set<std::string_view> keys;
  std::set<std::string> opened;
  std::string table;
  for (const Parameter& row : not_empty(parameters())) {
    EXPECT_TRUE(keys.insert(row.key).second) << row.key;
    if (table_of(row) != table) {
      table = table_of(row);
      EXPECT_TRUE(opened.insert(table).second) << row.key;
    }
    EXPECT_FALSE(row.doc.empty()) << row.key;
    EXPECT_EQ(find_parameter(row.key), &row);
  }
  EXPECT_EQ(find_parameter("crack.histories"), nullptr);
}

TEST(ParameterTable, EveryRowHasAMemberOfItsOwn) {
  Scene scene{};
  std::set<const void*> members;
  const auto address = [](auto slot) -> const void* {
    if constexpr (std::is_pointer_v<decltype(slot)>) {
      return slot;
    } else {
      return slot.p;
    }
  };
  for (const Parameter& row : not_empty(parameters())) {
    EXPECT_TRUE(members.insert(std::visit(address, row.slot(scene))).second) << row.key;
  }
}

TEST(ParameterTable, EveryDefaultLiesInItsOwnRange) {
  int tried = 0;
  for (const Parameter& row : not_empty(parameters())) {
    if (row.standard.empty()) continue;
    Scene scene{};
    EXPECT_EQ(assign(scene, row, value_from_text(row.standard)), "") << row.key;
    ++tried;
  }
  EXPECT_GT(tried, 30);
}

// Two layers of elements of 0.49 mm in a plate of 200 x 40 x 2 mm, 667 kg/m3 for 2200 m/s, pulled by 5 %, a
// crack at half the Rayleigh speed in its middle (model.md sections 1 and 5).
TEST(DefaultScene, IsThePlateOfThePaper) {
  const Scene s = default_scene();
  EXPECT_NEAR(s.specimen.length * s.specimen.height * thickness_m(s), 0.2 * 0.04 * 2e-3, 1e-15);
  EXPECT_EQ(s.specimen.length, 5.0 * s.specimen.height);
  EXPECT_NEAR(expected_mean_radius_m(s), 0.487e-3, 0.0005e-3);
  EXPECT_NEAR(density(s), 667, 0.5);
  EXPECT_NEAR(s.loading.displacement / s.specimen.height, 0.05, 1e-12);
  EXPECT_EQ(highest_velocity(s), 0.5);
  EXPECT_EQ(speed_m_s(s.crack.velocity.front().speed, rayleigh_speed(s)), 1100.0);
  const auto points = path_points_m(s);
  EXPECT_EQ(points.front()[1], 0.02);
  EXPECT_EQ(points.back()[1], 0.02);
}

TEST(Assign, WordsNameTheEnumerators) {
  Scene s = default_scene();
  const auto set = [&](const char* key, const char* word) {
    return assign(s, *find_parameter(key), {std::string(word)});
  };
  EXPECT_EQ(set("material.plane", "strain"), "");
  EXPECT_EQ(s.material.plane, theory::Plane::strain);
  EXPECT_EQ(set("material.stiffness", "bulk"), "");
  EXPECT_EQ(s.material.stiffness, StiffnessChoice::bulk);
  EXPECT_EQ(set("material.stiffness", "explicit"), "");
  EXPECT_EQ(s.material.stiffness, StiffnessChoice::explicit_values);
  EXPECT_EQ(set("loading.method", "ramp"), "");
  EXPECT_EQ(s.loading.method, LoadingMethod::ramp);
  EXPECT_EQ(set("crack.technique", "simple"), "");
  EXPECT_EQ(s.crack.technique, fracture::Technique::simple);
  EXPECT_EQ(set("damping.region", "surface"), "");
  EXPECT_EQ(s.damping.region, DampingRegion::surface);
  EXPECT_EQ(set("damping.region", "all"), "");
  EXPECT_EQ(s.damping.region, DampingRegion::all);
}

TEST(Assign, RejectsAboveAndBelowEveryRangeAndKeepsTheScene) {
  int tried = 0;
  for (const Parameter& row : not_empty(parameters())) {
    if (row.range.lower == 0.0 && row.range.upper == 0.0) continue;  // no number
    Scene scene = default_scene();
    const std::string before = toml_value(scene, row);
    for (const double x : {row.range.lower - 1e-3 * (1 + std::abs(row.range.lower)), 2 * row.range.upper + 1,
                           std::numeric_limits<double>::quiet_NaN(), std::numeric_limits<double>::infinity(),
                           -std::numeric_limits<double>::infinity()}) {
      EXPECT_NE(assign(scene, row, {x}), "") << row.key << " " << x;
      EXPECT_EQ(toml_value(scene, row), before) << row.key;
      ++tried;
    }
  }
  EXPECT_GT(tried, 5 * 30) << "more than thirty parameters are numbers";
}

TEST(Assign, ObservesOpenAndClosedEnds) {
  EXPECT_EQ(problem_of("damping.alpha", "0"), "");
  EXPECT_EQ(problem_of("damping.alpha", "1"), "");
  EXPECT_EQ(problem_of("solver.beta", "1"), "");
  EXPECT_EQ(problem_of("solver.beta", "0"), "must lie in (0, 1]");
  EXPECT_EQ(problem_of("specimen.radius_spread", "0"), "");
  EXPECT_EQ(problem_of("specimen.radius_spread", "0.95"), "must lie in [0, 0.95)");
  EXPECT_EQ(problem_of("material.poisson_ratio", "-1"), "must lie in (-1, 0.5)");
  EXPECT_EQ(problem_of("material.poisson_ratio", "0.5"), "must lie in (-1, 0.5)");
  EXPECT_EQ(problem_of("crack.tips", "2"), "");
  EXPECT_EQ(problem_of("crack.tips", "3"), "must lie in [1, 2]");
}

TEST(Assign, TakesWholeNumbersInAnySpelling) {
  Scene scene = default_scene();
  const Parameter& row = *find_parameter("specimen.elements");
  EXPECT_EQ(assign(scene, row, value_from_text("8e4")), "");
  EXPECT_EQ(scene.specimen.elements, 80000);
  EXPECT_EQ(assign(scene, row, value_from_text("5_000")), "");
  EXPECT_EQ(scene.specimen.elements, 5000);
  EXPECT_EQ(assign(scene, row, value_from_text("2.5")), "must be a whole number");
}

TEST(Assign, ChecksLists) {
  EXPECT_EQ(problem_of("output.fields", "[]"), "");
  EXPECT_EQ(problem_of("output.fields", R"(["velocity", "speed"])"),
            "\"speed\" is none of \"displacement\", \"velocity\", \"damage\", \"energy\" and \"rotation\"");
  EXPECT_EQ(problem_of("output.fields", R"(["damage", "damage"])"), "\"damage\" twice");
  EXPECT_EQ(problem_of("output.window", "[0, 1]"), "");
  EXPECT_EQ(problem_of("output.window", "[0.4, 0.2]"), "must rise within [0, 1]");
  EXPECT_EQ(problem_of("output.window", "[0.4, nan]"), "must rise within [0, 1]");
  EXPECT_EQ(problem_of("output.window", "[0.4, 1.1]"), "must rise within [0, 1]");
  EXPECT_EQ(problem_of("output.window", "[0.4]"), "must be two fractions of the length such as [0.2, 0.4]");
  EXPECT_EQ(problem_of("output.window", "[\"a\", 1]"),
            "must be two fractions of the length such as [0.2, 0.4]");
}

TEST(Assign, TakesRelaxationByNameOrNumber) {
  Scene scene = default_scene();
  const Parameter& row = *find_parameter("crack.relaxation");
  EXPECT_EQ(assign(scene, row, value_from_text("quadratic")), "");
  EXPECT_EQ(scene.crack.relaxation, 2.0);
  EXPECT_EQ(assign(scene, row, value_from_text("0.75")), "");
  EXPECT_EQ(toml_value(scene, row), "0.75");
  EXPECT_EQ(assign(scene, row, value_from_text("0")), "must lie in (0, 16]");
  EXPECT_EQ(scene.crack.relaxation, 0.75);
}

TEST(Allowed, ReadsLikeMathematics) {
  EXPECT_EQ(allowed(*find_parameter("specimen.length")), "(0, 100] m");
  EXPECT_EQ(allowed(*find_parameter("material.young_modulus")), "(0, 1e13] Pa");
  EXPECT_EQ(allowed(*find_parameter("loading.method")), "\"static\" or \"ramp\"");
}

TEST(ParametersPage, IsUpToDate) {
  std::ifstream file(RIFT_SOURCE_DIR "/docs/parameters.md");
  const std::string page{std::istreambuf_iterator<char>(file), {}};
  if (page == parameters_markdown()) return;
  const std::string fresh = RIFT_TEST_CACHE "/../parameters.md";
  std::ofstream(fresh) << parameters_markdown();
  FAIL() << "the page is not that of the table: cp '" << fresh
         << "' '" RIFT_SOURCE_DIR "/docs/parameters.md'";
}

TEST(ParametersPage, NamesEveryKey) {
  const std::string page = parameters_markdown();
  for (const Parameter& row : not_empty(parameters())) {
    EXPECT_NE(page.find("| `" + name_of(row) + "` |"), std::string::npos) << row.key;
  }
}

TEST(ParametersPage, ShowsExamplesThatAreGoodPresets) {
  const std::string page = parameters_markdown(), fence = "```toml\n";
  int examples = 0;
  for (auto at = page.find(fence); at != std::string::npos; at = page.find(fence, at + 1), ++examples) {
    const auto start = at + fence.size();
    const Preset preset = read_preset_text(page.substr(start, page.find("```", start) - start), "x.toml");
    for (const Issue& issue : preset.issues) ADD_FAILURE() << to_text(issue);
    EXPECT_EQ(preset.study.size() + preset.lanes.size() + preset.steering.size(), examples == 0 ? 9u : 2u);
  }
  EXPECT_EQ(examples, 3);
}

}  // namespace
}  // namespace rift::scene

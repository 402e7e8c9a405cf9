#include "tests/studio/commands/tiny_study.hpp"

#include <nlohmann/json.hpp>

#include <algorithm>

namespace rift::studio {
namespace {

namespace fs = std::filesystem;
using Json = nlohmann::json;

Ran compare(const std::vector<fs::path>& folders, const std::string& arguments = "") {
  std::string names;
  for (const fs::path& folder : folders) names += " '" + folder.string() + "'";
  return run_rift("compare" + names + " " + arguments);
}

TEST(Compare, PutsTheLanesOfRunsSideBySide) {
  const TinyPlate simple, progressive;
  ASSERT_EQ(simple.run("--set crack.technique=simple").exit_code, 0);
  ASSERT_EQ(progressive.run().exit_code, 0);
  const Ran ran = compare({simple.out(), progressive.out()});
  ASSERT_EQ(ran.exit_code, 0) << ran.err;
  for (const char* part : {"out: simple release", "out: progressive release", "G_ID / G_I0", "balance error"})
    EXPECT_TRUE(contains(ran.out, part)) << part;
  const Json rows = Json::parse(compare({simple.out(), progressive.out()}, "--json").out).at("scenarios");
  ASSERT_EQ(rows.size(), 2U);
  const Json summary = Json::parse(read_text(progressive.out() / "summary.json")).at("scenarios")[0];
  EXPECT_EQ(rows[1].at("ratio"), summary.at("ratio"));
  EXPECT_EQ(rows[1].at("folder"), progressive.out().string());
  const std::string csv = compare({simple.out(), progressive.out()}, "--csv").out;
  EXPECT_TRUE(csv.starts_with("scenario,folder,lane,title,"));
  EXPECT_EQ(std::count(csv.begin(), csv.end(), '\n'), 3);
}

TEST(Compare, TitlesNameDamageZonesThatDiffer) {
  const TinyPlate one, four;
  ASSERT_EQ(one.run().exit_code, 0);
  ASSERT_EQ(four.run("--set crack.damage_zone_ratio=4").exit_code, 0);
  const Ran ran = compare({one.out(), four.out()});
  for (const char* part : {", r_l = 1\n", ", r_l = 4\n", "± along the window", "difference to Broberg"})
    EXPECT_TRUE(contains(ran.out, part)) << part << ran.out;
  EXPECT_FALSE(contains(compare({one.out(), one.out()}).out, "r_l = "));
}

TEST(Compare, LeavesAPageWithChartsWhereItIsTold) {
  const TinyPlate plate;
  ASSERT_EQ(plate.run("--set crack.technique=simple").exit_code, 0);
  const fs::path page = plate.path() / "page";
  const std::string out = "--quiet --out '" + page.string() + "'";
  ASSERT_EQ(compare({plate.out(), plate.out()}, out).exit_code, 0);
  for (const char* file :
       {"report.html", "table.csv", "summary.json", "charts/ratio_tip.svg", "charts/ratio_velocity.png"})
    EXPECT_GT(fs::file_size(page / file), 500U) << file;
  EXPECT_EQ(compare({plate.out()}, out).exit_code, 2) << "is not empty";
  EXPECT_EQ(compare({plate.out()}, out + " --force").exit_code, 0);
}

TEST(Compare, TakesTheScenariosOfAStudy) {
  const TinyStudy plate;
  ASSERT_EQ(plate.study().exit_code, 0);
  const Json rows = Json::parse(compare({plate.out()}, "--json").out).at("scenarios");
  EXPECT_EQ(rows.size(), 8U);
  EXPECT_TRUE(contains(rows[0].at("title").get<std::string>(), "technique simple"));
  const fs::path page = plate.path() / "page";
  ASSERT_EQ(compare({plate.out()}, "--quiet -o '" + page.string() + "'").exit_code, 0);
  EXPECT_TRUE(fs::exists(page / "charts" / "ratio_tip_2.svg")) << "six curves a chart";
}

TEST(Compare, SaysWhatIsNoRun) {
  const TinyPlate plate;
  const Ran none = compare({plate.path()});
  EXPECT_EQ(none.exit_code, 1);
  EXPECT_TRUE(contains(none.err, "it holds no run and no study"));
  EXPECT_EQ(run_rift("compare").exit_code, 2);
}

}  // namespace
}  // namespace rift::studio

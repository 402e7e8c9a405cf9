#include "tests/studio/run_rift.hpp"

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include <string>

namespace rift::studio {
namespace {

TEST(Reproduce, AnUnknownNameIsBadInputAndNamesTheNearest) {
  const TemporaryFolder folder;
  const std::string out = (folder.path() / "out").string();
  const Ran ran = run_rift("reproduce fig7 sec4_longr --out '" + out + "'");
  EXPECT_EQ(ran.exit_code, 2);
  EXPECT_EQ(ran.out, "");
  EXPECT_TRUE(contains(ran.err, "rift reproduce: unknown name 'fig7', did you mean 'fig07'?"));
  EXPECT_TRUE(contains(ran.err, "rift reproduce: unknown name 'sec4_longr', did you mean 'sec4_longer'?"));
  EXPECT_FALSE(std::filesystem::exists(out));
}

TEST(Reproduce, ANameThatResemblesNothingGetsTheList) {
  const Ran ran = run_rift("reproduce nonsense_of_a_name");
  EXPECT_EQ(ran.exit_code, 2);
  EXPECT_TRUE(
      contains(ran.err, "unknown name 'nonsense_of_a_name': the names are all, beyond, readings, fig01, fig02"));
  EXPECT_TRUE(contains(ran.err, "sec5_bending, beyond_map"));
}

TEST(Reproduce, LeavesAFolderOfSomethingElseAlone) {
  const TemporaryFolder folder;
  write_text(folder.path() / "thesis.tex", "precious");
  const Ran ran = run_rift("reproduce fig02 --out '" + folder.path().string() + "'");
  EXPECT_EQ(ran.exit_code, 2);
  EXPECT_EQ(ran.err, "rift reproduce: '" + folder.path().string() +
                         "' exists and holds other files: choose another folder with --out\n");
  EXPECT_FALSE(std::filesystem::exists(folder.path() / "report.html"));
}

TEST(Reproduce, JudgesCylindersAndTellsWhereTheyAreTooSmall) {
  const TemporaryFolder folder;
  const std::filesystem::path out = folder.path() / "out";
  const Ran ran = run_rift("reproduce fig17 --quick --out '" + out.string() + "'");
  EXPECT_EQ(ran.exit_code, 0) << ran.err;
  EXPECT_TRUE(contains(ran.out, "fig17"));
  EXPECT_TRUE(contains(ran.out, "fewer than two sizes of 15,000 elements and more"));
  EXPECT_FALSE(contains(ran.out, "in-situ"));
  EXPECT_FALSE(contains(ran.out, "fig07"));
  EXPECT_TRUE(contains(read_text(out / "reproduction.md"), "## Fig. 17 (fig17)"));
  EXPECT_TRUE(contains(read_text(out / "reproduction.md"), "(charts/fig17_calibration_young.svg)"));
  EXPECT_TRUE(std::filesystem::exists(out / "charts" / "fig17_calibration_core.svg"));
}

TEST(Reproduce, GivesVerdictsAsJson) {
  const TemporaryFolder folder;
  const Ran ran = run_rift("reproduce fig01 --json --out '" + (folder.path() / "out").string() + "'");
  ASSERT_EQ(ran.exit_code, 0) << ran.err;
  const auto report = nlohmann::json::parse(ran.out);
  ASSERT_EQ(report.at("claims").size(), 1u);
  EXPECT_EQ(report.at("claims")[0].at("name"), "fig01");
  EXPECT_EQ(report.at("claims")[0].at("bulk").at("verdict"), "not decidable");
}

TEST(Reproduce, DrawsChartsIntoTheReport) {
  const TemporaryFolder folder;
  const std::filesystem::path out = folder.path() / "out";
  ASSERT_EQ(run_rift("reproduce fig01 --out '" + out.string() + "'").exit_code, 0);
  for (const char* ending : {"svg", "png", "csv", "gp"})
    EXPECT_TRUE(std::filesystem::exists(out / "charts" / (std::string("fig01.") + ending))) << ending;
  EXPECT_TRUE(contains(read_text(out / "report.html"), "<svg"));
  EXPECT_TRUE(contains(read_text(out / "reproduction.md"), "(charts/fig01.svg)"));
  EXPECT_TRUE(contains(read_text(out / "reproduction.md"), ", on 20"));  // the date
}

TEST(Reproduce, DrawsThePaperPicturesOrSaysThatItCannot) {
  const TemporaryFolder folder;
  const std::filesystem::path out = folder.path() / "out";
  const Ran ran = run_rift("reproduce fig02 --quick --out '" + out.string() + "'");
  ASSERT_EQ(ran.exit_code, 0) << ran.err;
  if (!RIFT_WITH_VIZ) {
    EXPECT_TRUE(contains(ran.out, "built without its renderer"));
    return;
  }
  EXPECT_TRUE(contains(ran.out, "drawn"));
  EXPECT_TRUE(std::filesystem::file_size(out / "charts" / "fig02_at_0.00.png") > 10000);
  EXPECT_TRUE(contains(read_text(out / "report.html"), "src=\"data:image/png;base64,iVBORw0KGgo"));
  EXPECT_TRUE(contains(read_text(out / "reproduction.md"), "(charts/fig02_at_0.00.png)"));
}

}  // namespace
}  // namespace rift::studio

#include "tests/studio/run_rift.hpp"

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include <cmath>
#include <sstream>
#include <string>
#include <vector>

namespace rift::studio {
namespace {

std::vector<std::string> split(const std::string& text, char at) {
  std::istringstream stream(text);
  std::vector<std::string> parts;
  for (std::string part; std::getline(stream, part, at);) parts.push_back(part);
  return parts;
}

const std::string header =
    "poisson,plane,v_over_cr,cr_over_cs,cd_over_cs,broberg_k,broberg_g,freund_k,freund_g,strip_g";

TEST(Theory, CsvMatchesTheReferenceTable) {
  // Its rows come as twelve velocities a solid: one call each.
  std::vector<std::string> given = split(read_text(RIFT_SOURCE_DIR "/tests/data/theory.csv"), '\n');
  ASSERT_EQ(given.size(), 49u);
  EXPECT_EQ(given.front() + ",strip_g", header);
  for (int solid = 0; solid < 4; ++solid) {
    const std::vector<std::string> first = split(given[1 + 12 * solid], ',');
    std::string arguments = "theory --csv --poisson " + first[0] + " --plane " + first[1];
    for (int i = 0; i < 12; ++i) arguments += " --v " + split(given[1 + 12 * solid + i], ',')[2];
    const Ran ran = run_rift(arguments);
    ASSERT_EQ(ran.exit_code, 0) << ran.err;
    const std::vector<std::string> lines = split(ran.out, '\n');
    ASSERT_EQ(lines.size(), 13u);
    EXPECT_EQ(lines.front(), header);
    for (int i = 0; i < 12; ++i) {
      const std::vector<std::string> ours = split(lines[1 + i], ','),
                                     theirs = split(given[1 + 12 * solid + i], ',');
      ASSERT_EQ(ours.size(), 10u);
      EXPECT_EQ(ours[1], theirs[1]);
      for (const int column : {0, 2, 3, 4, 5, 6, 7, 8})
        EXPECT_NEAR(std::stod(ours[column]), std::stod(theirs[column]), 1e-8) << lines[1 + i];
      EXPECT_EQ(ours[9], "1");
    }
  }
}

TEST(Theory, TableForPeopleHasTenDigitsAndMore) {
  const Ran ran = run_rift("theory --poisson 0.3 --plane stress --v 0.5 --v 0.9999");
  EXPECT_EQ(ran.exit_code, 0);
  EXPECT_EQ(ran.err, "");
  EXPECT_TRUE(contains(ran.out, "c_R/c_s = 0.9162142619041, c_d/c_s = 1.690308509457"));
  EXPECT_TRUE(contains(ran.out,
                       "0.5                0.657057266210     0.520255380359     0.659913314638     "
                       "0.524788026090     1.00000000000\n"));
  EXPECT_TRUE(contains(ran.out, "0.9999             0.00023673119288"));
}

TEST(Theory, JsonHoldsNumbersAndNullWhereUndefined) {
  const Ran ran = run_rift("theory --poisson 0.25 --plane strain --v 0.5 --v 1 --json");
  ASSERT_EQ(ran.exit_code, 0) << ran.err;
  const auto all = nlohmann::json::parse(ran.out);
  EXPECT_EQ(all.at("poisson"), 0.25);
  EXPECT_EQ(all.at("plane"), "strain");
  EXPECT_NEAR(all.at("cd_over_cs").get<double>(), std::sqrt(3.0), 1e-14);
  ASSERT_EQ(all.at("factors").size(), 2u);
  EXPECT_NEAR(all.at("factors").at(0).at("broberg_g").get<double>(), 0.52041244, 1e-8);
  EXPECT_EQ(all.at("factors").at(0).at("strip_g"), 1.0);
  EXPECT_EQ(all.at("factors").at(1).at("v_over_cr"), 1.0);
  EXPECT_EQ(all.at("factors").at(1).at("freund_g"), 0.0);
  EXPECT_TRUE(all.at("factors").at(1).at("strip_g").is_null());
}

TEST(Theory, SweepCountsBothEnds) {
  const std::vector<std::string> lines =
      split(run_rift("theory --csv --from 0.01 --to 1 --steps 100").out, '\n');
  ASSERT_EQ(lines.size(), 101u);
  EXPECT_EQ(split(lines[1], ',')[2], "0.01");
  EXPECT_EQ(split(lines[50], ',')[2], "0.5");
  EXPECT_EQ(split(lines[100], ',')[2], "1");
  EXPECT_EQ(split(lines[100], ',')[9], "nan");
}

TEST(Theory, NamesOptionValueAndRangeOfAllMistakesAtOnce) {
  const Ran ran = run_rift("theory --poisson nan --v 0 --v -0.5 --v 1.5 --v inf --v nan");
  EXPECT_EQ(ran.exit_code, 2);
  EXPECT_EQ(ran.out, "");
  EXPECT_EQ(ran.err,
            "rift theory: --poisson = nan: must lie in (-1, 0.5]\n"
            "rift theory: --v = 0: must lie in (0, 1], in units of c_R\n"
            "rift theory: --v = -0.5: must lie in (0, 1], in units of c_R\n"
            "rift theory: --v = 1.5: must lie in (0, 1], in units of c_R\n"
            "rift theory: --v = inf: must lie in (0, 1], in units of c_R\n"
            "rift theory: --v = nan: must lie in (0, 1], in units of c_R\n");
}

TEST(Theory, RefusesASweepThatIsNone) {
  EXPECT_EQ(run_rift("theory --from 0 --to 2 --steps 1").err,
            "rift theory: --from = 0: must lie in (0, 1], in units of c_R\n"
            "rift theory: --to = 2: must lie in (0, 1], in units of c_R\n"
            "rift theory: --steps = 1: must lie in [2, 1000000]\n");
  const Ran ran = run_rift("theory --from 0.9 --to 0.2");
  EXPECT_EQ(ran.exit_code, 2);
  EXPECT_EQ(ran.err, "rift theory: --from = 0.9: must lie below --to = 0.2\n");
}

TEST(Theory, RangeOfPoissonsRatioDependsOnThePlane) {
  EXPECT_EQ(run_rift("theory --poisson 0.5 --plane stress").exit_code, 0);
  EXPECT_EQ(run_rift("theory --poisson -0.99 --plane strain").exit_code, 0);
  EXPECT_EQ(run_rift("theory --poisson -1 --plane stress").exit_code, 2);
  const Ran ran = run_rift("theory --poisson 0.5 --plane strain");
  EXPECT_EQ(ran.exit_code, 2);
  EXPECT_EQ(ran.err,
            "rift theory: --poisson = 0.5: must lie in (-1, 0.5) in plane strain (at 0.5 c_d is infinite)\n");
}

TEST(Theory, RefusesWhatIsNoNumberAndOptionsThatContradict) {
  EXPECT_EQ(run_rift("theory --poisson steel").err,
            "rift theory: Could not convert: --poisson = steel\nTry 'rift theory --help'.\n");
  EXPECT_EQ(run_rift("theory --plane foo").err,
            "rift theory: --plane: foo not in {stress,strain}\nTry 'rift theory --help'.\n");
  for (const std::string arguments :
       {"--v '0.5 c_r'", "--steps 2.5", "--json --csv", "--v 0.5 --steps 3", "--v"})
    EXPECT_EQ(run_rift("theory " + arguments).exit_code, 2) << arguments;
}

}  // namespace
}  // namespace rift::studio

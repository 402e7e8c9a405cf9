#include "tests/studio/commands/tiny_plate.hpp"

#include <nlohmann/json.hpp>

#include <algorithm>

namespace rift::studio {
namespace {

namespace fs = std::filesystem;

Ran verify(const TinyPlate& plate, const std::string& options = "") {
  return run_rift("verify '" + plate.out().string() + "' " + options);
}

void damage(const fs::path& path) {
  std::string bytes = read_text(path);
  bytes[bytes.size() / 2] = static_cast<char>(bytes[bytes.size() / 2] ^ 1);
  write_text(path, bytes);
}

TEST(VerifyCommand, FindsARunWholeThenMendsThenSaysWhatIsLost) {
  const TinyPlate plate;
  ASSERT_EQ(plate.run("--quiet").exit_code, 0);
  Ran ran = verify(plate);
  EXPECT_EQ(ran.exit_code, 0) << ran.out << ran.err;
  EXPECT_TRUE(contains(ran.out, "every file of "));
  EXPECT_TRUE(contains(ran.out, "elements (without rattlers)"));
  EXPECT_TRUE(contains(ran.out, "intact"));

  damage(plate.out() / "run.vtkhdf");
  ran = verify(plate, "--check-only --json");
  EXPECT_EQ(ran.exit_code, 1);
  EXPECT_FALSE(nlohmann::json::parse(ran.out).at("whole"));
  ran = verify(plate);
  EXPECT_EQ(ran.exit_code, 0) << ran.out;
  EXPECT_TRUE(contains(ran.out, "rebuilt from the journal"));

  damage(plate.out() / "journal.rift");
  ran = verify(plate);
  EXPECT_EQ(ran.exit_code, 1);
  EXPECT_TRUE(contains(ran.out, "bytes are lost"));
  EXPECT_TRUE(fs::exists(plate.out() / "journal_damaged.rift"));
}

TEST(VerifyCommand, OfNoRunSaysSo) {
  const TinyPlate plate;
  const Ran ran = verify(plate);
  EXPECT_EQ(ran.exit_code, 1);
  EXPECT_TRUE(contains(ran.err, "out"));
  EXPECT_EQ(run_rift("verify").exit_code, 2);
}

/// Some seconds of marching.
const std::string crawling_crack = "--quiet --threads 1 --set crack.velocity='0.01 c_r' ";

// The journal is damaged before what the checkpoint needs: it begins anew, to the same bytes.
TEST(Resume, WithADamagedJournalStartsWhereItIsWhole) {
  const TinyPlate plate, other;
  ASSERT_EQ(other.run(crawling_crack).exit_code, 0);
  plate.run_and_kill("checkpoint.h5", crawling_crack + "--checkpoint '0.05 s'");
  ASSERT_TRUE(fs::exists(plate.out() / "checkpoint.h5"));
  std::string journal = read_text(plate.out() / "journal.rift");
  journal.resize(journal.size() / 3);
  write_text(plate.out() / "journal.rift", journal);
  const Ran ran = run_rift("resume '" + plate.out().string() + "' --plain --threads 1", plate.environment());
  EXPECT_EQ(ran.exit_code, 0) << ran.err;
  EXPECT_TRUE(contains(ran.err, "bytes of the journal, of which"));
  EXPECT_TRUE(read_text(plate.out() / "series.csv") == read_text(other.out() / "series.csv"));
}

// However slow the machine: a budget that preparing the run has used up leaves nothing, and a larger one is
// tried.
TEST(Budget, StopsARunWithACheckpointAndItsOwnCode) {
  const TinyPlate plate;
  ASSERT_EQ(plate.check("--quiet").exit_code, 0);  // packs and pulls, so that the budget is the crack's
  const std::string long_run = "--quiet --threads 1 --set crack.velocity='0.0005 c_r' ";
  for (const char* budget : {"1 s", "3 s", "9 s", "27 s"}) {
    if (fs::exists(plate.out() / "checkpoint.h5")) break;
    const Ran ran = plate.run(long_run + "--budget '" + budget + "'");
    EXPECT_EQ(ran.exit_code, 4) << ran.err;
  }
  ASSERT_TRUE(fs::exists(plate.out() / "checkpoint.h5"));
  const std::string resume = "resume '" + plate.out().string() + "' --quiet";
  EXPECT_EQ(run_rift(resume + " --budget '0.5 s'", plate.environment()).exit_code, 4);
  EXPECT_TRUE(fs::exists(plate.out() / "checkpoint.h5"));
  EXPECT_EQ(plate.run("--force --budget 5").exit_code, 2);
}

TEST(StabilityCommand, EndsWellWhereAllIsAsExpectedAndNamesUnknownFamilies) {
  Ran ran = run_rift("stability --quick --only 'small lattices' --quiet");
  EXPECT_EQ(ran.exit_code, 0) << ran.out;
  EXPECT_TRUE(contains(ran.out, "4 of 4 cases are as expected"));
  ran = run_rift("stability --only nosuch");
  EXPECT_EQ(ran.exit_code, 2);
  EXPECT_TRUE(contains(ran.err, "nosuch"));
}

TEST(StabilityCommand, LeavesAReport) {
  const TemporaryFolder folder;
  const std::string out = (folder.path() / "report").string();
  const Ran ran = run_rift("stability --quick --only density --quiet --json --out '" + out + "'");
  EXPECT_EQ(ran.exit_code, 0) << ran.err;
  const nlohmann::json summary = nlohmann::json::parse(ran.out);
  EXPECT_EQ(summary.at("of"), 2);
  const nlohmann::json& claims = summary.at("cases").at(0).at("double").at("claims");
  const auto ratio = std::find_if(claims.begin(), claims.end(), [](const nlohmann::json& claim) {
    return claim.at("claim") == "ratio over that of x 1";
  });
  ASSERT_NE(ratio, claims.end());
  EXPECT_NEAR(ratio->at("low").get<double>(), 1.0, 1e-11);
  EXPECT_NEAR(ratio->at("seen").get<double>(), 1.0, 1e-11);
  for (const char* file : {"report.html", "table.csv", "claims.csv", "summary.json", "charts/growth.svg",
                           "charts/residuals.png"})
    EXPECT_TRUE(fs::exists(fs::path(out) / file)) << file;
  EXPECT_EQ(run_rift("stability --quick --only density --out '" + out + "'").exit_code, 2);
}

// A plate that still swings after its ramp is refused by the physics; what it leaves can be read.
TEST(DivergedRun, EndsWithItsOwnCodeAndAnArchiveThatIsWhole) {
  const TinyPlate plate;
  const Ran ran =
      plate.run("--quiet --set loading.method=ramp --set loading.ramp_steps=20 --set loading.hold_steps=0");
  EXPECT_EQ(ran.exit_code, 3) << ran.err;
  EXPECT_EQ(verify(plate).exit_code, 0);
}

}  // namespace
}  // namespace rift::studio

#include "tests/studio/run_rift.hpp"

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

namespace rift::studio {
namespace {

using Json = nlohmann::json;

// Speeds themselves are not tested: machines differ, and so do minutes.
TEST(Bench, TellsSpeedPeaksAndThePriceOfSinglePrecision) {
  const TemporaryFolder folder;
  const Ran ran = run_rift("bench --elements 1000 --runs 3 --seconds 0.002 --threads 2 --json --quiet",
                           "XDG_CACHE_HOME='" + folder.path().string() + "'");
  ASSERT_EQ(ran.exit_code, 0) << ran.err;
  const Json j = Json::parse(ran.out);
  EXPECT_GT(j.at("machine").at("memory_bytes_per_s"), 1e8);
  EXPECT_GT(j.at("machine").at("flops_single"), j.at("machine").at("flops_double"));
  const Json& plain = j.at("rows")[0];
  EXPECT_EQ(plain.at("kernel"), "plain");
  EXPECT_EQ(plain.at("ratio"), 1.0);
  for (const Json& row : not_empty(j.at("rows"))) {
    EXPECT_GT(row.at("beam_steps_per_s"), 1e4);
    EXPECT_LE(row.at("beam_steps_per_s_least"), row.at("beam_steps_per_s"));
    EXPECT_LE(row.at("beam_steps_per_s"), row.at("beam_steps_per_s_most"));
    EXPECT_DOUBLE_EQ(row.at("ratio").get<double>(),
                     row.at("beam_steps_per_s").get<double>() / plain.at("beam_steps_per_s").get<double>());
  }
  ASSERT_EQ(j.at("precision").size(), 2U);
  for (const Json& p : j.at("precision")) {
    EXPECT_LT(std::abs(p.at("error_single").get<double>()), 0.002);
    EXPECT_GT(p.at("ledger_residual_single"), p.at("ledger_residual_double").get<double>() * 0.5);
  }
}

TEST(Bench, TellsWhatEachPieceCosts) {
  const Ran ran = run_rift("bench --needs --elements 1000 --runs 1 --seconds 0.002 --quiet");
  ASSERT_EQ(ran.exit_code, 0) << ran.err;
  for (const char* piece : {"bare", "damping, 5 % of the beams", "damping, all beams", "numerical damping",
                            "energies every step", "cohesive law", "corotational beams"})
    EXPECT_TRUE(contains(ran.out, piece)) << piece;
}

TEST(Bench, GuardComparesWithThisProcessorOnly) {
  const TemporaryFolder folder;
  const std::string file = (folder / "ratios.json").string(),
                    guard = "bench --elements 1000 --runs 1 --seconds 0.001 --guard '" + file + "'";
  ASSERT_EQ(run_rift(guard + " --record").exit_code, 0);
  Json recorded = Json::parse(read_text(file));
  const std::string here = recorded.begin().key();
  for (auto& [kernel, ratio] : recorded.at(here).items()) ratio = 1e3 * ratio.get<double>();
  write_text(file, recorded.dump());
  const Ran slower = run_rift(guard);
  EXPECT_EQ(slower.exit_code, 1);
  EXPECT_TRUE(contains(slower.err, "has lost more than a fifth")) << slower.err;
  write_text(file, Json{{"Another processor, AVX2", recorded.at(here)}}.dump());
  const Ran elsewhere = run_rift(guard);
  EXPECT_EQ(elsewhere.exit_code, 0) << elsewhere.err;
  EXPECT_TRUE(contains(elsewhere.out, "nothing is recorded for this processor")) << elsewhere.out;
}

TEST(Bench, RefusesASizeOutOfRange) {
  const Ran ran = run_rift("bench --elements 10");
  EXPECT_EQ(ran.exit_code, 2);
  EXPECT_TRUE(contains(ran.err, "rift bench: --elements: Value 10 not in range")) << ran.err;
}

}  // namespace
}  // namespace rift::studio

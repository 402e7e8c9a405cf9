#include "engine/results/run_folder.hpp"
#include "tests/studio/commands/tiny_plate.hpp"

#include <nlohmann/json.hpp>

#include <csignal>
#include <utility>

namespace rift::studio {
namespace {

namespace fs = std::filesystem;

/// The same run twice over: one goes through, the other is stopped and resumed, as often as asked.
struct Twice {
  TinyPlate plate;
  // A second and more, with sanitizers as well.
  std::string slow = std::string("--quiet --threads 1 --set 'crack.velocity=") +
                     (RIFT_SANITIZED ? "0.03" : "0.001") + " c_r' ";
  fs::path whole() const { return plate.path() / "whole"; }

  Twice() {
    EXPECT_EQ(run_rift("run '" + plate.preset().string() + "' " + slow + "--out '" + whole().string() + "'",
                       plate.environment())
                  .exit_code,
              0);
  }
  void begin_anew() const { fs::remove_all(plate.out()); }
  Ran resume(const std::string& arguments = "--quiet") const {
    return run_rift("resume '" + plate.out().string() + "' --threads 1 " + arguments, plate.environment());
  }
  void expect_same() const {
    EXPECT_EQ(read_text(whole() / "series.csv"), read_text(plate.out() / "series.csv"));
    const auto a = nlohmann::json::parse(read_text(whole() / "summary.json")).at("scenarios")[0];
    const auto b = nlohmann::json::parse(read_text(plate.out() / "summary.json")).at("scenarios")[0];
    for (const auto& [name, value] : not_empty(a).items()) {
      const bool same = name.find("wall") == std::string::npos && name.find("per_s") == std::string::npos &&
                        name.find("cache") == std::string::npos && name != "memory_peak_bytes";
      if (!same) continue;
      EXPECT_EQ(value, b.at(name)) << name;
    }
    // All times are of all calls: no part is longer than the whole.
    EXPECT_GE(b.at("wall_total_s").get<double>(),
              b.at("wall_prestress_s").get<double>() + b.at("wall_fracture_s").get<double>());
  }
};

TEST(Resume, AfterASignalGoesOnToTheSameBytes) {
  const Twice twice;
  for (const auto& [signal, number] :
       {std::pair("INT", SIGINT), std::pair("TERM", SIGTERM), std::pair("HUP", SIGHUP)}) {
    twice.begin_anew();
    EXPECT_EQ(twice.plate.run_and_signal(signal, "journal.rift", twice.slow).exit_code, 128 + number);
    ASSERT_TRUE(fs::exists(twice.plate.out() / "checkpoint.h5")) << signal;
    const Ran ran = twice.resume();
    EXPECT_EQ(ran.exit_code, 0) << ran.err;
    EXPECT_TRUE(contains(ran.out, "G_ID / G_I0"));
    twice.expect_same();
    EXPECT_FALSE(fs::exists(twice.plate.out() / "checkpoint.h5"));
  }
}

TEST(Resume, AfterAKillAtAnyMomentGoesOnToTheSameBytes) {
  const Twice twice;
  int resumed = 0;
  for (const char* moment : {"0.02", "0.1", "0.35", "0.6", "0.9", "2"}) {
    twice.begin_anew();
    twice.plate.run_under(std::string("timeout -s KILL ") + moment, twice.slow + "--checkpoint '0.1 s'");
    // Killed before there was a run, or before it had written what it computes.
    if (results::inspect_run(twice.plate.out()).header_json.empty()) continue;
    const Ran ran = twice.resume();
    EXPECT_EQ(ran.exit_code, 0) << moment << ": " << ran.err;
    twice.expect_same();
    ++resumed;
  }
  EXPECT_GT(resumed, 0);
}

TEST(Resume, OfAJournalWithoutAHeaderSaysHowToBeginAgain) {
  const Twice twice;
  const std::string whole = read_text(twice.whole() / "journal.rift");
  for (const std::size_t bytes : {0, 8, 16, 40}) {
    twice.begin_anew();
    fs::create_directories(twice.plate.out());
    write_text(twice.plate.out() / "journal.rift", whole.substr(0, bytes));
    const Ran ran = twice.resume();
    EXPECT_EQ(ran.exit_code, 1) << bytes;
    EXPECT_TRUE(contains(ran.err, "there is nothing to continue, and 'rift run PRESET --out")) << ran.err;
  }
}

TEST(Resume, StoppedAgainAndAgainItStillComesToTheSameEnd) {
  const Twice twice;
  twice.plate.run_and_signal("INT", "journal.rift", twice.slow);
  for (int k = 0; k < 2; ++k)
    run_shell("env " + twice.plate.environment() + " timeout -s INT 0.4 '" RIFT_EXE "' resume '" +
              twice.plate.out().string() + "' --threads 1 --quiet");
  EXPECT_EQ(twice.resume().exit_code, 0);
  twice.expect_same();
}

TEST(Resume, ADamagedCheckpointIsToldAndTheOneBeforeTaken) {
  const Twice twice;
  twice.plate.run_and_kill("checkpoint_former.h5", twice.slow + "--checkpoint '0.1 s'");
  const fs::path latest = twice.plate.out() / "checkpoint.h5";
  ASSERT_TRUE(fs::exists(latest));
  ASSERT_TRUE(fs::exists(twice.plate.out() / "checkpoint_former.h5"));
  std::string bytes = read_text(latest);
  bytes[bytes.size() / 2] = static_cast<char>(bytes[bytes.size() / 2] ^ 1);
  write_text(latest, bytes);
  const Ran ran = twice.resume("--plain");
  EXPECT_EQ(ran.exit_code, 0);
  EXPECT_TRUE(contains(ran.err, "checkpoint.h5: its checksum does not fit"));
  twice.expect_same();
}

TEST(Resume, MakesTheFilesOfAnEndThatTheDiskDidNotTake) {
  const TinyPlate plate;
  ASSERT_EQ(plate.run("--quiet").exit_code, 0);
  const std::string summary = read_text(plate.out() / "summary.json"),
                    series = read_text(plate.out() / "series.csv");
  fs::remove(plate.out() / "summary.json");
  const Ran ran = run_rift("resume '" + plate.out().string() + "' --quiet", plate.environment());
  EXPECT_EQ(ran.exit_code, 0) << ran.err;
  EXPECT_TRUE(contains(ran.err, "is already finished; its missing files were rebuilt from the journal"));
  EXPECT_EQ(read_text(plate.out() / "summary.json"), summary);
  EXPECT_EQ(read_text(plate.out() / "series.csv"), series);
}

TEST(Resume, WhatCannotBeResumedIsSaid) {
  const TinyPlate plate;
  ASSERT_EQ(plate.run("--quiet").exit_code, 0);
  Ran ran = run_rift("resume '" + plate.out().string() + "'", plate.environment());
  EXPECT_EQ(ran.exit_code, 0);
  EXPECT_TRUE(contains(ran.err, "is already finished; there is nothing to resume"));
  ran = run_rift("resume '" + (plate.path() / "nosuch").string() + "'");
  EXPECT_EQ(ran.exit_code, 1);
  EXPECT_TRUE(contains(ran.err, "nosuch"));
  EXPECT_EQ(run_rift("resume").exit_code, 2);
  ran = plate.run("--checkpoint 5");
  EXPECT_EQ(ran.exit_code, 2);
  EXPECT_TRUE(contains(ran.err, "--checkpoint 5"));
}

TEST(Resume, ARunThatGoesOnIsLeftAlone) {
  const Twice twice;
  const Ran ran = run_shell("cd '" + twice.plate.path().string() + "' && (env " + twice.plate.environment() +
                            " '" RIFT_EXE "' run '" + twice.plate.preset().string() + "' " + twice.slow +
                            " --checkpoint '0.1 s' --out out >/dev/null 2>&1 &) ; for k in $(seq 600); do [ "
                            "-s out/series.csv ] && break; "
                            "sleep 0.05; done; env " +
                            twice.plate.environment() + " '" RIFT_EXE "' resume out --quiet");
  EXPECT_EQ(ran.exit_code, 1);
  EXPECT_TRUE(contains(ran.err, "another process is writing it"));
  for (int k = 0; k < 600 && !fs::exists(twice.plate.out() / "summary.json"); ++k) run_shell("sleep 0.1");
  twice.expect_same();
}

}  // namespace
}  // namespace rift::studio

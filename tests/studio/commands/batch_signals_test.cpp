#include "tests/studio/commands/tiny_plate.hpp"

#include <nlohmann/json.hpp>
#include <sched.h>

#include <csignal>

namespace rift::studio {
namespace {

namespace fs = std::filesystem;

/// `rift run` of the plate in the background of a shell, which sends it signals as soon as its crack runs.
/// @param before  what the shell does first
Ran run_and_signal(const TinyPlate& plate, const std::string& before, const std::string& arguments,
                   const std::string& signals) {
  return run_shell("(" + before + " env " + plate.environment() + " '" RIFT_EXE "' run '" +
                   plate.preset().string() + "' --out '" + plate.out().string() + "' --quiet " + arguments +
                   " >/dev/null & p=$!; for k in $(seq 3000); do [ -s '" +
                   (plate.out() / "series.csv").string() + "' ] && break; sleep 0.02; done; for s in " +
                   signals + "; do kill -$s $p; done; wait $p; exit $?)");
}

const std::string slow_crack = "--set 'crack.velocity=0.002 c_r' --checkpoint '3600 s'";

TEST(BatchSignals, SaveACheckpointAndEndWith128PlusTheirNumber) {
  for (const auto& [name, number] :
       {std::pair("USR1", SIGUSR1), std::pair("USR2", SIGUSR2), std::pair("XCPU", SIGXCPU),
        std::pair("XFSZ", SIGXFSZ), std::pair("TERM", SIGTERM), std::pair("HUP", SIGHUP)}) {
    const TinyPlate plate;
    EXPECT_EQ(run_and_signal(plate, "", slow_crack, name).exit_code, 128 + number) << name;
    EXPECT_TRUE(fs::exists(plate.out() / "checkpoint.h5")) << name;
  }
}

TEST(BatchSignals, AHangUpThatWasIgnoredAtTheStartStaysIgnored) {
  const TinyPlate plate;  // as nohup starts it
  EXPECT_EQ(run_and_signal(plate, "trap '' HUP;", slow_crack, "HUP USR1").exit_code, 128 + SIGUSR1);
}

TEST(BatchSignals, AFileBeyondTheLargestSizeIsAnErrorOfTheDiskInAPlainSentence) {
  const TinyPlate plate;
  ASSERT_EQ(plate.check().exit_code, 0);  // packing and pre-stress are in the cache
  const Ran ran = run_shell("(ulimit -f 100; env " + plate.environment() + " '" RIFT_EXE "' run '" +
                            plate.preset().string() + "' --out '" + plate.out().string() + "' --quiet)");
  EXPECT_EQ(ran.exit_code, 1) << ran.err;
  EXPECT_TRUE(contains(ran.err, "File too large"));
  EXPECT_TRUE(contains(ran.err, (plate.out() / "").string()));
}

TEST(BatchSignals, EveryCommandThatComputesHearsThem) {
  const TinyPlate plate;
  const std::string large =
      "--set specimen.elements=60000 --set specimen.length='500 mm' --set specimen.height='100 mm' --set "
      "crack.end='400 mm'";
  for (const std::string& command : {"pack '" + plate.preset().string() + "' --quiet " + large,
                                     "check '" + plate.preset().string() + "' --quiet " + large,
                                     std::string("bench --quiet --elements 1000 --seconds 2")}) {
    const Ran ran = run_shell("env " + plate.environment() +
                              " timeout --preserve-status -s USR1 1 '" RIFT_EXE "' " + command);
    EXPECT_EQ(ran.exit_code, 128 + SIGUSR1) << command << ran.err;
    EXPECT_TRUE(contains(ran.err, "stopped")) << command;
  }
}

TEST(Threads, AreThoseThatTheProcessMayRunOn) {
  cpu_set_t set;
  ASSERT_EQ(sched_getaffinity(0, sizeof set, &set), 0);
  int cpu = 0;
  while (!CPU_ISSET(cpu, &set)) ++cpu;
  const TinyPlate plate;
  const Ran ran = plate.run_under("taskset -c " + std::to_string(cpu), "--quiet");
  ASSERT_EQ(ran.exit_code, 0) << ran.err;
  const auto summary = nlohmann::json::parse(read_text(plate.out() / "summary.json"));
  EXPECT_EQ(summary.at("scenarios")[0].at("threads"), 1);
}

#ifndef __SANITIZE_ADDRESS__  // whose shadow needs more address space than any limit
TEST(Memory, ThatCheckNamesIsWhatTheProcessMayUse) {
  const TinyPlate plate;
  const Ran ran = run_shell("(ulimit -v 3000000; env " + plate.environment() + " '" RIFT_EXE "' check '" +
                            plate.preset().string() + "' --json --quiet)");
  ASSERT_EQ(ran.exit_code, 0) << ran.err;
  EXPECT_LE(nlohmann::json::parse(ran.out).at("memory_available_bytes").get<double>(), 3'000'000.0 * 1024.0);
}
#endif

TEST(Budget, ThatEndsWhileTheCrackRunsIsGoneOnWithByTheSameCommandToTheSameBytes) {
  const TinyPlate plate;
  const std::string command = "--quiet --set 'crack.velocity=0.004 c_r' ";
  ASSERT_EQ(plate.run(command).exit_code, 0);
  const std::string whole = read_text(plate.out() / "series.csv");
  fs::remove_all(plate.out());
  int stops = 0;
  Ran ran;
  for (double budget = 0.3;
       (ran = plate.run(command + "--budget '" + std::to_string(budget) + " s'")).exit_code == 4;
       budget *= 1.2)
    ASSERT_LT(++stops, 60) << ran.err;
  EXPECT_EQ(ran.exit_code, 0) << ran.err;
  EXPECT_GT(stops, 0);
  EXPECT_EQ(read_text(plate.out() / "series.csv"), whole);
  EXPECT_EQ(plate.run(command + "--budget '1 s'").exit_code, 2);  // a run that has ended is not replaced
}

TEST(Budget, ThatEndsBeforeTheFirstStepSaysThatNothingWasWritten) {
  const TinyPlate plate;
  const Ran ran = plate.run("--plain --budget '0.001 s'");
  EXPECT_EQ(ran.exit_code, 4);
  EXPECT_TRUE(contains(
      ran.err,
      "because the budget ran out: nothing was written; the same command starts from the beginning"));
  EXPECT_FALSE(contains(ran.err, "resume"));
  EXPECT_FALSE(fs::exists(plate.out()));
  EXPECT_EQ(plate.run("--quiet").exit_code, 0);
}

}  // namespace
}  // namespace rift::studio

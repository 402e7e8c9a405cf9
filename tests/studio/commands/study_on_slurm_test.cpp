#include "engine/base/claim.hpp"
#include "engine/base/files.hpp"
#include "engine/ensemble/instruction_set.hpp"
#include "tests/studio/commands/study_table.hpp"
#include "tests/studio/commands/tiny_study.hpp"

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <filesystem>

// Against commands of Slurm's names that do nothing: the real ones are in tests/slurm.

namespace rift::studio {
namespace {

namespace fs = std::filesystem;

/// As a node with this processor names its instruction set.
std::string own_feature() {
  const ensemble::InstructionSet set = ensemble::instruction_set();
  return set == ensemble::InstructionSet::avx512 ? "avx512f"
         : set == ensemble::InstructionSet::avx2 ? "avx2"
                                                 : "sse2";
}

/// Commands that say what they were called with, and give jobs the numbers 11, 12, ...
class NoSlurm {
 public:
  NoSlurm() {
    program("sbatch", "echo \"sbatch $*\" >>calls; echo $((10 + $(grep -c ^sbatch calls)))");
    program("squeue", "cat queue 2>/dev/null");
    program("sacct", "exit 1");
    program("scontrol", "echo JobId=$4 JobState=COMPLETED Reason=None");
    program("sinfo",
            "case \"$*\" in *%R*) echo main;; *nowhere*) ;; *) echo ib," + own_feature() + ";; esac");
  }
  void program(const std::string& name, const std::string& script) const {
    const fs::path file = folder_.path() / name;
    write_text(file, "#!/bin/sh\ncd '" + folder_.path().string() + "'\n" + script + "\n");
    fs::permissions(file, fs::perms::owner_all);
  }
  std::string environment() const { return "PATH='" + folder_.path().string() + "':\"$PATH\""; }
  fs::path path() const { return folder_.path(); }

 private:
  TemporaryFolder folder_;
};

Ran study_with(const NoSlurm& slurm, const TinyStudy& plate, const std::string& arguments) {
  return plate.study_under("env " + slurm.environment(), arguments, plate.out());
}

TEST(StudyOnSlurm, DryRunPrintsTheScriptsAndLeavesNothing) {
  const TinyStudy plate;
  const NoSlurm slurm;
  const Ran ran =
      study_with(slurm, plate,
                 "--slurm --dry-run --tasks 3 --time 02:00:00 --partition long --sbatch '--cpus-per-task=4' "
                 "--set loading.displacement='0.5 mm'");
  EXPECT_EQ(ran.exit_code, 0) << ran.err;
  for (const char* part : {"#SBATCH --array=1-3\n", "#SBATCH --time=02:00:00\n", "#SBATCH --partition=long\n",
                           "#SBATCH --cpus-per-task=4\n", "--set 'loading.displacement=0.5 mm'",
                           " --claim --tasks 3 &", " --prepare &", "--budget \"7110 s\""})
    EXPECT_TRUE(contains(ran.out, part)) << part << "\n" << ran.out;
  EXPECT_FALSE(fs::exists(plate.out()));
  EXPECT_FALSE(fs::exists(slurm.path() / "calls"));
}

TEST(StudyOnSlurm, ComesAsThreeJobsOneAfterTheOther) {
  const TinyStudy plate;
  const NoSlurm slurm;
  const Ran ran = study_with(slurm, plate, "--slurm --tasks 2");
  ASSERT_EQ(ran.exit_code, 0) << ran.err;
  EXPECT_TRUE(contains(
      ran.out, "8 of 8 scenarios are missing: job 11 prepares, 12 computes in 2 tasks, 13 writes the report"))
      << ran.out;
  const std::string calls = read_text(slurm.path() / "calls");
  EXPECT_TRUE(contains(calls, "sbatch --parsable " + (plate.out() / "slurm/prepare.sh").string() + "\n"))
      << calls;
  EXPECT_TRUE(contains(calls, "--dependency=afterok:11 --kill-on-invalid-dep=yes")) << calls;
  EXPECT_TRUE(contains(calls, "--dependency=afterany:12 --kill-on-invalid-dep=yes")) << calls;
  EXPECT_EQ(run_shell("bash -n '" + (plate.out() / "slurm/compute.sh").string() + "'").exit_code, 0);
  write_text(slurm.path() / "queue", "12_1|RUNNING|None\n12_2|PENDING|Resources\n13|PENDING|Dependency\n");
  const Ran again = study_with(slurm, plate, "--slurm");
  EXPECT_EQ(again.exit_code, 0);
  EXPECT_TRUE(contains(again.err, "nothing was submitted")) << again.err;
  EXPECT_EQ(read_text(slurm.path() / "calls"), calls);
  const auto status = nlohmann::json::parse(study_with(slurm, plate, "--status --json").out);
  EXPECT_EQ(status.at("waiting"), 8);
  const nlohmann::json waiting{
      {"stage", "compute"}, {"job", "12"}, {"tasks", 1}, {"state", "PENDING"}, {"reason", "Resources"}};
  const auto jobs = status.at("slurm");
  EXPECT_EQ(jobs.front().at("stage"), "prepare");
  EXPECT_NE(std::find(jobs.begin(), jobs.end(), waiting), jobs.end()) << jobs;
}

// A study computed with more than a node has would be refused there.
TEST(StudyOnSlurm, UsesTheLowestInstructionSetOfTheNodes) {
  const TinyStudy plate;
  const NoSlurm slurm;
  slurm.program("sinfo", "printf 'avx512f\\nib,avx2\\n'");
  const bool is_lower = ensemble::instruction_set() == ensemble::InstructionSet::avx512;
  const std::string lowest(is_lower ? "AVX2" : ensemble::name_of(ensemble::instruction_set()));
  EXPECT_TRUE(
      contains(study_with(slurm, plate, "--slurm --dry-run").out, "export RIFT_SIMD=" + lowest + "\n"));
  slurm.program("sinfo", "printf '(null)\\navx512f\\n'");
  const Ran ran = study_with(slurm, plate, "--slurm --dry-run");
  EXPECT_TRUE(contains(ran.err, "the nodes do not name their instruction sets")) << ran.err;
}

TEST(StudyOnSlurm, WhereNothingIsMissingSubmitsNothing) {
  const TinyStudy plate;
  const NoSlurm slurm;
  ASSERT_EQ(plate.study("--quiet").exit_code, 0);
  const Ran ran = study_with(slurm, plate, "--slurm");
  EXPECT_EQ(ran.exit_code, 0) << ran.err;
  EXPECT_TRUE(contains(ran.err, "nothing is missing; nothing was submitted")) << ran.err;
  EXPECT_FALSE(fs::exists(slurm.path() / "calls"));
}

TEST(StudyOnSlurm, SaysWhatSlurmSays) {
  const TinyStudy plate;
  const NoSlurm slurm;
  slurm.program("sbatch", "echo 'sbatch: error: invalid account' >&2; exit 1");
  const Ran ran = study_with(slurm, plate, "--slurm");
  EXPECT_EQ(ran.exit_code, 1);
  EXPECT_TRUE(contains(ran.err, "sbatch: error: invalid account")) << ran.err;
}

struct SlurmMistake {
  const char* arguments;
  const char* text;
};
class StudyOnSlurmBadInput : public testing::TestWithParam<SlurmMistake> {};

TEST_P(StudyOnSlurmBadInput, IsRefusedWithWhatToDo) {
  const TinyStudy plate;
  const NoSlurm slurm;
  const Ran ran = study_with(slurm, plate, GetParam().arguments);
  EXPECT_EQ(ran.exit_code, 2);
  EXPECT_TRUE(contains(ran.err, GetParam().text)) << ran.err;
  EXPECT_FALSE(fs::exists(plate.out()));
}

INSTANTIATE_TEST_SUITE_P(
    All, StudyOnSlurmBadInput,
    testing::Values(
        SlurmMistake{"--slurm --time 00:01:30", "--time 00:01:30: a job stops"},
        SlurmMistake{"--slurm --time soon", "--time soon: expected a limit as Slurm has it"},
        SlurmMistake{"--slurm --time 1:2:3:4", "--time 1:2:3:4: expected a limit as Slurm has it"},
        SlurmMistake{"--slurm --partition nowhere", "it has main"},
        SlurmMistake{"--slurm --tasks 0", "--tasks"}, SlurmMistake{"--claim --gather", "excludes"},
        SlurmMistake{"--gather", "holds no study yet"}, SlurmMistake{"--status", "holds no study yet"},
        SlurmMistake{"--dry-run", "requires --slurm"}));

TEST(StudyGather, OfAPartSaysWhatIsMissing) {
  const TinyStudy plate;
  ASSERT_EQ(plate.study("--quiet --shard 1/2").exit_code, 0);
  const Ran ran = plate.study("--gather");
  EXPECT_EQ(ran.exit_code, 6);
  EXPECT_TRUE(contains(ran.err, "missing: technique = ")) << ran.err;
  EXPECT_TRUE(contains(ran.err, "4 of 8 scenarios are missing")) << ran.err;
  EXPECT_EQ(table_in(plate.out()).size(), 4U);
  ASSERT_EQ(plate.study("--quiet --claim").exit_code, 0);
  EXPECT_EQ(plate.study("--quiet --gather").exit_code, 0);
  EXPECT_EQ(table_in(plate.out()).size(), 8U);
  EXPECT_FALSE(fs::exists(plate.out() / "cache")) << "of no use any more";
}

TEST(StudyStatusCommand, TellsWhoIsAtWhat) {
  const TinyStudy plate;
  ASSERT_EQ(plate.study("--quiet --shard 1/2").exit_code, 0);
  const Ran none = plate.study("--status");
  EXPECT_EQ(none.exit_code, 0);
  EXPECT_TRUE(contains(none.out, "4 of 8 scenarios done, 4 waiting\n")) << none.out;
}

}  // namespace
}  // namespace rift::studio

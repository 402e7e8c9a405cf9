#include "tests/faults/disk_faults.hpp"

namespace rift::studio::faults {
namespace {

std::string told(const Counts& counts) {
  std::string text;
  for (const std::string& detail : counts.details) text += detail + "\n";
  return text;
}

/// The first, the middle and the last call of a kind.
Counts some_of(Sweep& sweep, const Fault& fault) {
  Counts counts;
  const int calls = sweep.calls(fault.kind);
  EXPECT_GT(calls, 0) << fault.kind;
  for (const int call : {1, calls / 2, calls})
    if (call > 0) counts.add(sweep.disturb(fault, call));
  return counts;
}

TEST(DiskFaults, OfARunAreToldAndItCanBeResumed) {
  Sweep sweep(run_case());
  Counts counts;
  for (const Fault& fault :
       {Fault{"write", ENOSPC, false}, {"write", EDQUOT, true}, {"rename", EACCES, false}})
    counts.add(some_of(sweep, fault));
  EXPECT_EQ(counts.faults(), 0) << told(counts);
  EXPECT_GT(counts.said, 6);
}

TEST(DiskFaults, AtTheEndOfARunLeaveNoWrongArchive) {
  Sweep sweep(run_case());
  Counts counts;
  const int calls = sweep.calls("write");
  for (int call = calls; call > std::max(0, calls - 12); call -= 3)
    counts.add(sweep.disturb({"write", ENOSPC, false}, call));
  EXPECT_EQ(counts.faults(), 0) << told(counts);
  EXPECT_EQ(counts.said, 4);
}

TEST(DiskFaults, WithFilesThatMayNotGrowEndInASentence) {
  Sweep sweep(run_case());
  const Counts counts = sweep.limit_files(sweep.largest_file() / 2);
  EXPECT_EQ(counts.faults(), 0) << told(counts);
  EXPECT_EQ(counts.said, 1);
}

TEST(DiskFaults, OfAStudyAreToldAndTheSameCommandGoesOn) {
  Sweep sweep(study_case());
  const Counts counts = some_of(sweep, {"write", ENOSPC, false});
  EXPECT_EQ(counts.faults(), 0) << told(counts);
  EXPECT_EQ(counts.said, 3);
}

TEST(DiskFaults, NamesThatAreTooLongAreToldInASentence) {
  const TemporaryFolder folder;
  const std::string plate =
      "[specimen]\nlength = \"60 mm\"\nheight = \"12 mm\"\nlayers = 2\nelements = 500\ncoordination = 5.5\n"
      "[loading]\ndisplacement = \"0.6 mm\"\n[crack]\nvelocity = \"0.5 c_r\"\n";
  write_text(folder.path() / "run.toml", plate);
  write_text(folder.path() / "pack.toml", plate);
  write_text(folder.path() / "study.toml", plate + "[study]\nseed = [1, 2]\n");
  for (const std::string command : {"run", "pack", "study"}) {
    const Ran ran = run_rift(fmt::format("{0} '{1}/{0}.toml' --no-cache --quiet --out '{1}/{2}'", command,
                                         folder.path().string(), std::string(300, 'a')));
    EXPECT_EQ(ran.exit_code, 1) << command << ran.err;
    EXPECT_FALSE(is_library_text(ran.err)) << ran.err;
    EXPECT_TRUE(contains(ran.err, "File name too long")) << command;
  }
}

}  // namespace
}  // namespace rift::studio::faults

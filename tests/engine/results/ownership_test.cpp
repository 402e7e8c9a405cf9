#include "engine/base/ownership.hpp"

#include "engine/base/files.hpp"
#include "engine/results/archive.hpp"
#include "engine/results/journal_index.hpp"
#include "engine/results/run_writer.hpp"
#include "tests/engine/results/small_run.hpp"

#include <gtest/gtest.h>
#include <linux/filter.h>
#include <linux/seccomp.h>
#include <nlohmann/json.hpp>
#include <sys/prctl.h>
#include <sys/syscall.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cerrno>
#include <cstddef>
#include <functional>

namespace rift::results {
namespace {

namespace fs = std::filesystem;

/// Makes every flock of this process fail with an error, as on a file system without locks.
bool take_locks_away(int error) {
  sock_filter program[] = {
      BPF_STMT(BPF_LD | BPF_W | BPF_ABS, offsetof(seccomp_data, nr)),
      BPF_JUMP(BPF_JMP | BPF_JEQ | BPF_K, SYS_flock, 0, 1),
      BPF_STMT(BPF_RET | BPF_K, SECCOMP_RET_ERRNO | static_cast<unsigned>(error)),
      BPF_STMT(BPF_RET | BPF_K, SECCOMP_RET_ALLOW),
  };
  const sock_fprog filter{4, program};
  return prctl(PR_SET_NO_NEW_PRIVS, 1, 0, 0, 0) == 0 &&
         prctl(PR_SET_SECCOMP, SECCOMP_MODE_FILTER, &filter) == 0;
}

/// What `holds` says in a process whose locks all fail with this error: 0 true, 1 false, 2 threw, 77 no
/// seccomp.
int without_locks(int error, const std::function<bool()>& holds) {
  const pid_t child = fork();
  if (child == 0) {
    if (!take_locks_away(error)) _exit(77);
    try {
      _exit(holds() ? 0 : 1);
    } catch (const std::exception&) {
      _exit(2);
    }
  }
  int status = 0;
  waitpid(child, &status, 0);
  return WIFEXITED(status) ? WEXITSTATUS(status) : -1;
}

TEST(FolderLock, KeepsOthersOutWhileItLives) {
  const TemporaryFolder scratch;
  {
    const base::FolderLock lock(scratch.path());
    EXPECT_TRUE(lock.is_kept());
    EXPECT_TRUE(is_folder_being_written(scratch.path()));
    try {
      const base::FolderLock other(scratch.path());
      FAIL() << "two owners";
    } catch (const base::WorldError& error) {
      EXPECT_EQ(error.what(),
                "cannot write into " + scratch.path().string() + ": another process is writing it");
    }
    EXPECT_THROW(base::FolderLock(scratch.path(), base::FolderLock::Kind::together), base::WorldError);
  }
  EXPECT_FALSE(is_folder_being_written(scratch.path()));
  const base::FolderLock part(scratch.path(), base::FolderLock::Kind::together);
  const base::FolderLock other_part(scratch.path(), base::FolderLock::Kind::together);
  EXPECT_TRUE(is_folder_being_written(scratch.path()));
  EXPECT_THROW(base::FolderLock(scratch.path()), base::WorldError);
}

class WithoutLocks : public testing::TestWithParam<int> {};

TEST_P(WithoutLocks, NobodyIsTakenForAnotherProcess) {
  const TemporaryFolder scratch;
  write_text(scratch / journal_name, "12");
  const int said = without_locks(GetParam(), [&] {
    const base::OwnedFolder owned(scratch.path());
    base::AppendFile file(scratch / journal_name, 2);
    file.append("3");
    file.close();
    return !owned.has_locks() && !is_folder_being_written(scratch.path());
  });
  if (said == 77) GTEST_SKIP() << "filtering system calls is not allowed here";
  EXPECT_EQ(said, 0);
  EXPECT_EQ(read_text(scratch / journal_name), "123");
}

TEST_P(WithoutLocks, ARunComesToItsEndAllTheSame) {
  const TemporaryFolder scratch;
  const int said = without_locks(GetParam(), [&] {
    RunWriter writer(scratch.path(), {{"lanes", 1}}, small_run::geometry());
    writer.sample(small_run::sample(1, 0, 0.01));
    writer.finish({{"scenarios", nlohmann::ordered_json::array()}}, {});
    return fs::exists(scratch / archive_name) && fs::exists(scratch / summary_name);
  });
  if (said == 77) GTEST_SKIP() << "filtering system calls is not allowed here";
  EXPECT_EQ(said, 0);
}

INSTANTIATE_TEST_SUITE_P(Whatever, WithoutLocks, testing::Values(ENOSYS, ENOLCK, EOPNOTSUPP));

TEST(OwnedFolder, IsGivenBackWhereNothingCameOfIt) {
  const TemporaryFolder scratch;
  { const base::OwnedFolder owned(scratch / "a/b"); }
  EXPECT_FALSE(fs::exists(scratch / "a"));
  base::OwnedFolder(scratch / "a/b").keep();
  EXPECT_TRUE(fs::exists(scratch / "a/b"));
  { const base::OwnedFolder owned(scratch / "a/b"); }
  EXPECT_TRUE(fs::exists(scratch / "a/b")) << "it was there before";
}

TEST(HeldFile, TellsAnotherFileOfItsName) {
  const TemporaryFolder scratch;
  write_text(scratch / "f", "one");
  const base::HeldFile held(scratch / "f");
  EXPECT_TRUE(held.is_still_there());
  EXPECT_EQ(held.size(), 3U);
  fs::remove(scratch / "f");
  EXPECT_FALSE(held.is_still_there());
  write_text(scratch / "f", "other");
  EXPECT_FALSE(held.is_still_there());
}

TEST(JournalIndex, NoticesThatAnotherRunHasTakenItsPlace) {
  const TemporaryFolder scratch;
  const auto write = [&](double tip) {
    JournalWriter writer(scratch / journal_name);
    writer.write(RunHeader{R"({"lanes": 1})"});
    writer.write(small_run::geometry());
    writer.write(small_run::frame(10, 0));
    writer.write(small_run::sample(10, 0, tip));
    writer.flush();
  };
  write(0.01);
  JournalIndex index(scratch / journal_name);
  EXPECT_NO_THROW(index.extend());
  fs::remove(scratch / journal_name);
  EXPECT_THROW(index.extend(), RunReplaced);
  write(0.02);
  EXPECT_THROW(index.extend(), RunReplaced);
  EXPECT_THROW((void)index.frame(index.frames(0).front()), RunReplaced);
}

}  // namespace
}  // namespace rift::results

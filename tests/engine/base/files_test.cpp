#include "engine/base/files.hpp"

#include "engine/base/world_error.hpp"
#include "tests/full_disk.hpp"
#include "tests/temporary_folder.hpp"

#include <gtest/gtest.h>
#include <sys/wait.h>
#include <unistd.h>

#include <chrono>
#include <set>

namespace rift::base {
namespace {

namespace fs = std::filesystem;

std::set<std::string> names_in(const fs::path& folder) {
  std::set<std::string> names;
  for (const auto& entry : fs::directory_iterator(folder)) names.insert(entry.path().filename());
  return names;
}

/// The temporary file of a process that has ended without renaming or removing it.
fs::path left_by_a_killed_process(const fs::path& target) {
  const pid_t child = fork();
  if (child == 0) {
    const PendingFile pending(target);
    write_text(target.parent_path() / "name", pending.temporary().string());
    _exit(0);
  }
  waitpid(child, nullptr, 0);
  const fs::path left = read_text(target.parent_path() / "name");
  fs::remove(target.parent_path() / "name");
  return left;
}

TEST(WholeFile, ReplacesTheFormerOne) {
  const TemporaryFolder scratch;
  write_text(scratch / "f", "old and longer");
  write_whole_file(scratch / "f", "new");
  EXPECT_EQ(read_whole_file(scratch / "f"), "new");
  EXPECT_EQ(names_in(scratch.path()), std::set<std::string>{"f"});
}

TEST(WholeFile, LeavesTheFormerOneWhereTheDiskIsFull) {
  const TemporaryFolder scratch;
  write_text(scratch / "f", "old");
  {
    const FullDisk full(100);
    EXPECT_THROW(write_whole_file(scratch / "f", std::string(1000, 'x')), WorldError);
  }
  EXPECT_EQ(read_text(scratch / "f"), "old");
  EXPECT_EQ(names_in(scratch.path()), std::set<std::string>{"f"});
}

TEST(WholeFile, SaysWhichFileAndWhy) {
  const TemporaryFolder scratch;
  write_text(scratch / "file", "");
  const auto below = scratch / "file" / "f";
  try {
    write_whole_file(below, "x");
    FAIL() << "wrote below a file";
  } catch (const WorldError& error) {
    EXPECT_EQ(error.what(),
              "cannot write " + below.string() + ": " + (scratch / "file").string() + " is no folder");
    EXPECT_EQ(error.path(), below);
  }
  EXPECT_THROW((void)read_whole_file(scratch / "none"), WorldError);
}

TEST(WholeFile, ThatCannotBeReadIsSaidInPlainWords) {
  const TemporaryFolder scratch;
  try {
    (void)read_whole_file(scratch.path());
    FAIL() << "read a folder";
  } catch (const WorldError& error) {
    EXPECT_EQ(error.what(), "cannot read " + scratch.path().string() + ": Is a directory");
  }
}

TEST(PendingText, IsNotThereWhereTheDiskIsFull) {
  const TemporaryFolder scratch;
  {
    const FullDisk full(100);
    PendingText text(scratch / "f");
    text.append(std::string(1000, 'x'));
    EXPECT_THROW(text.commit(), WorldError);
  }
  EXPECT_TRUE(fs::is_empty(scratch.path()));
}

TEST(PlainText, OfTheStandardLibrarysFailuresNamesPathAndReason) {
  const std::string name(300, 'a');
  try {
    (void)fs::exists(name);
    FAIL() << "no such name is possible";
  } catch (const std::exception& error) {
    EXPECT_EQ(plain_text(error), "cannot use " + name + ": File name too long");
  }
}

TEST(AppendFile, FlushesByItselfBeforeMemoryGrows) {
  const TemporaryFolder scratch;
  AppendFile file(scratch / "f");
  file.append("x");
  EXPECT_EQ(fs::file_size(scratch / "f"), 0U);
  for (int i = 0; i < 8; ++i) file.append(std::string(1 << 20, 'y'));
  EXPECT_GE(fs::file_size(scratch / "f"), 4U << 20);
  file.close();
  EXPECT_EQ(fs::file_size(scratch / "f"), (8U << 20) + 1);
}

TEST(AppendFile, WritesWhatIsLeftWhenItGoes) {
  const TemporaryFolder scratch;
  { AppendFile(scratch / "f").append("left"); }
  EXPECT_EQ(read_text(scratch / "f"), "left");
}

TEST(PendingFile, OfTwoWritersNeverIsTheSameFile) {
  const TemporaryFolder scratch;
  PendingFile one(scratch / "f"), other(scratch / "f");
  EXPECT_NE(one.temporary(), other.temporary());
  write_text(one.temporary(), "one");
  write_text(other.temporary(), "other");
  one.commit();
  EXPECT_EQ(read_text(scratch / "f"), "one");
  other.commit();
  EXPECT_EQ(read_text(scratch / "f"), "other");
  EXPECT_EQ(names_in(scratch.path()), std::set<std::string>{"f"});
}

TEST(PendingFile, WhoseFolderIsMissingIsRefusedAtOnce) {
  const TemporaryFolder scratch;
  fs::create_directory(scratch / "folder");
  EXPECT_THROW(PendingFile(scratch / "no/f"), WorldError);
  EXPECT_THROW(PendingFile(scratch / "folder"), WorldError);
  EXPECT_THROW(check_target(scratch / "no/f"), WorldError);
  EXPECT_NO_THROW(check_target(scratch / "f"));
  EXPECT_NO_THROW(check_target("f"));
}

TEST(TemporaryName, FitsHoweverLongTheNameIs) {
  const TemporaryFolder scratch;
  const fs::path longest = scratch / std::string(255, 'n');
  write_whole_file(longest, "text");
  EXPECT_EQ(read_text(longest), "text");
}

TEST(TemporaryName, SaysWhatTheFileWasToBecome) {
  EXPECT_EQ(target_name(temporary_name("folder/run.vtkhdf").filename()), "run.vtkhdf");
  EXPECT_EQ(target_name("run.vtkhdf.part"), "run.vtkhdf");
  EXPECT_EQ(target_name("run.vtkhdf"), "run.vtkhdf");
}

TEST(Leftovers, OfProcessesThatAreGoneAreRemovedAndNoOthers) {
  const TemporaryFolder scratch;
  const fs::path left = left_by_a_killed_process(scratch / "table.csv");
  ASSERT_TRUE(fs::exists(left));
  EXPECT_TRUE(is_leftover(left));
  const PendingFile ours(scratch / "table.csv");
  EXPECT_FALSE(is_leftover(ours.temporary()));
  const fs::path there = scratch / "table.csv.elsewhere-77-0123abcd.part",
                 old = scratch / "a.elsewhere-7-0123abcd.part";
  write_text(there, "");
  write_text(old, "");
  fs::last_write_time(old, fs::file_time_type::clock::now() - std::chrono::hours(25));
  write_text(scratch / "download.part", "somebody's own");
  write_text(scratch / "table.csv", "");
  remove_leftovers(scratch.path());
  EXPECT_EQ(names_in(scratch.path()), (std::set<std::string>{ours.temporary().filename(), there.filename(),
                                                             "download.part", "table.csv"}));
}

// In a container without an init process an ended process keeps its number for ever.
TEST(Leftovers, OfAProcessThatNobodyHasAskedForSinceItEndedAreRemoved) {
  const TemporaryFolder scratch;
  const pid_t child = fork();
  if (child == 0) {
    write_text(temporary_name(scratch / "table.csv"), "");
    _exit(0);
  }
  siginfo_t ended;
  ASSERT_EQ(waitid(P_PID, static_cast<id_t>(child), &ended, WEXITED | WNOWAIT), 0);  // and leave it as it is
  ASSERT_EQ(names_in(scratch.path()).size(), 1U);
  remove_leftovers(scratch.path());
  EXPECT_TRUE(names_in(scratch.path()).empty());
  waitpid(child, nullptr, 0);
}

}  // namespace
}  // namespace rift::base

#include "engine/results/files.hpp"

#include "engine/results/world_error.hpp"
#include "tests/engine/results/full_disk.hpp"
#include "tests/engine/results/small_run.hpp"

#include <gtest/gtest.h>

namespace rift::results {
namespace {

namespace fs = std::filesystem;
using small_run::bytes_of;
using small_run::put_bytes;

TEST(WholeFile, ReplacesTheFormerOne) {
  const small_run::Scratch scratch;
  put_bytes(scratch / "f", "old and longer");
  put_bytes(scratch / "f.part", "left by a kill");
  write_whole_file(scratch / "f", "new");
  EXPECT_EQ(read_whole_file(scratch / "f"), "new");
  EXPECT_FALSE(fs::exists(scratch / "f.part"));
}

TEST(WholeFile, LeavesTheFormerOneWhereTheDiskIsFull) {
  const small_run::Scratch scratch;
  put_bytes(scratch / "f", "old");
  {
    const FullDisk full(100);
    EXPECT_THROW(write_whole_file(scratch / "f", std::string(1000, 'x')), WorldError);
  }
  EXPECT_EQ(bytes_of(scratch / "f"), "old");
  EXPECT_FALSE(fs::exists(scratch / "f.part"));
}

TEST(WholeFile, SaysWhichFileAndWhy) {
  const small_run::Scratch scratch;
  put_bytes(scratch / "file", "");
  const auto below = scratch / "file" / "f";
  try {
    write_whole_file(below, "x");
    FAIL() << "wrote below a file";
  } catch (const WorldError& error) {
    EXPECT_EQ(error.what(), "cannot create " + below.string() + ".part: Not a directory");
    EXPECT_EQ(error.path(), below.string() + ".part");
  }
  EXPECT_THROW((void)read_whole_file(scratch / "none"), WorldError);
}

TEST(AppendFile, FlushesByItselfBeforeMemoryGrows) {
  const small_run::Scratch scratch;
  AppendFile file(scratch / "f");
  file.append("x");
  EXPECT_EQ(fs::file_size(scratch / "f"), 0U);
  for (int i = 0; i < 8; ++i) file.append(std::string(1 << 20, 'y'));
  EXPECT_GE(fs::file_size(scratch / "f"), 4U << 20);
  file.close();
  EXPECT_EQ(fs::file_size(scratch / "f"), (8U << 20) + 1);
}

TEST(AppendFile, WritesWhatIsLeftWhenItGoes) {
  const small_run::Scratch scratch;
  { AppendFile(scratch / "f").append("left"); }
  EXPECT_EQ(bytes_of(scratch / "f"), "left");
}

}  // namespace
}  // namespace rift::results

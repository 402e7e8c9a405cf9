#include "engine/base/cache.hpp"

#include "tests/expectations.hpp"
#include "tests/temporary_folder.hpp"

#include <gtest/gtest.h>

#include <bit>
#include <cstdint>
#include <cstdlib>
#include <limits>

namespace rift::simulation {
namespace {

namespace fs = std::filesystem;

const std::string key = "packing 1 box 0x1p-3";

std::vector<double> numbers() {
  return {0.0,
          -0.0,
          1.0 / 3.0,
          std::numeric_limits<double>::denorm_min(),
          std::numeric_limits<double>::infinity(),
          std::bit_cast<double>(std::uint64_t{0x7ff8000000000123})};  // a nan with something in it
}

std::vector<std::uint64_t> bits(const std::vector<double>& values) {
  std::vector<std::uint64_t> all;
  for (double v : values) all.push_back(std::bit_cast<std::uint64_t>(v));
  return all;
}

TEST(CacheFile, GivesBackTheSameBits) {
  const TemporaryFolder folder;
  base::Cache cache{folder.path() / "not" / "there" / "yet", {}};
  base::remember(cache, "packing", key, numbers());
  const auto found = base::recall(cache, "packing", key);
  ASSERT_TRUE(found);
  EXPECT_EQ(bits(*found), bits(numbers()));
  EXPECT_TRUE(cache.notes.empty());
}

TEST(CacheFile, HoldsAnEmptyListAsWell) {
  const TemporaryFolder folder;
  base::Cache cache{folder.path(), {}};
  base::remember(cache, "packing", key, {});
  const auto found = base::recall(cache, "packing", key);
  ASSERT_TRUE(found);
  EXPECT_TRUE(found->empty());
}

TEST(CacheFile, OfAnotherKeyOrKindIsAbsentWithoutANote) {
  const TemporaryFolder folder;
  base::Cache cache{folder.path(), {}};
  base::remember(cache, "packing", key, numbers());
  EXPECT_FALSE(base::recall(cache, "packing", key + " "));
  EXPECT_FALSE(base::recall(cache, "statics", key));
  EXPECT_TRUE(cache.notes.empty());
}

// Two keys whose names collide, or a file put in another's place.
TEST(CacheFile, WithTheContentOfAnotherKeyIsDamaged) {
  const TemporaryFolder folder;
  base::Cache cache{folder.path(), {}};
  std::string other = key;
  other.back() = '4';
  base::remember(cache, "packing", key, numbers());
  fs::rename(base::cache_file(cache, "packing", key), base::cache_file(cache, "packing", other));
  EXPECT_FALSE(base::recall(cache, "packing", other));
  EXPECT_EQ(cache.notes.size(), 1U);
}

TEST(CacheFile, IsNotUsedWithAnyOneByteChanged) {
  const TemporaryFolder folder;
  base::Cache cache{folder.path(), {}};
  base::remember(cache, "packing", key, numbers());
  const fs::path file = base::cache_file(cache, "packing", key);
  const std::string whole = read_text(file);
  ASSERT_GT(whole.size(), 8 * numbers().size());
  for (std::size_t k = 0; k < whole.size(); ++k)
    for (const int flip : {1, 0x80}) {
      std::string damaged = whole;
      damaged[k] = static_cast<char>(damaged[k] ^ flip);
      write_text(file, damaged);
      cache.notes.clear();
      ASSERT_FALSE(base::recall(cache, "packing", key)) << "byte " << k;
      ASSERT_EQ(cache.notes, std::vector{file.string() + " is damaged: its contents are computed again"})
          << "byte " << k;
    }
}

TEST(CacheFile, IsNotUsedWhenCutShortOrGrown) {
  const TemporaryFolder folder;
  base::Cache cache{folder.path(), {}};
  base::remember(cache, "packing", key, numbers());
  const fs::path file = base::cache_file(cache, "packing", key);
  const std::string whole = read_text(file);
  ASSERT_FALSE(whole.empty());
  for (std::size_t size = 0; size < whole.size(); ++size) {
    write_text(file, whole.substr(0, size));
    ASSERT_FALSE(base::recall(cache, "packing", key)) << "cut to " << size;
  }
  EXPECT_EQ(cache.notes.size(), whole.size());
  for (const std::string& more : {std::string("x"), std::string(8, '\0'), whole}) {
    write_text(file, whole + more);
    EXPECT_FALSE(base::recall(cache, "packing", key));
  }
}

TEST(CacheFile, ThatWasDamagedIsReplaced) {
  const TemporaryFolder folder;
  base::Cache cache{folder.path(), {}};
  write_text(base::cache_file(cache, "packing", key), "nonsense");
  EXPECT_FALSE(base::recall(cache, "packing", key));
  base::remember(cache, "packing", key, numbers());
  EXPECT_TRUE(base::recall(cache, "packing", key));
  EXPECT_EQ(cache.notes.size(), 1U);  // of the damage only
}

// Even root cannot make a folder below a file.
TEST(CacheFile, ThatCannotBeWrittenIsANoteAndNoError) {
  const TemporaryFolder folder;
  write_text(folder.path() / "file", "in the way");
  base::Cache cache{folder.path() / "file" / "rift", {}};
  base::remember(cache, "packing", key, numbers());
  ASSERT_EQ(cache.notes.size(), 1U);
  EXPECT_TRUE(contains(cache.notes[0], base::cache_file(cache, "packing", key).string()));
  EXPECT_TRUE(contains(cache.notes[0], "could not be written, so the next run computes this again"));
  EXPECT_FALSE(base::recall(cache, "packing", key));
}

TEST(CacheFile, LeavesNoTemporaryFileBehind) {
  const TemporaryFolder folder;
  base::Cache cache{folder.path(), {}};
  base::remember(cache, "packing", key, numbers());
  fs::create_directories(base::cache_file(cache, "statics", key) / "in the way");  // the rename fails
  base::remember(cache, "statics", key, numbers());
  EXPECT_EQ(cache.notes.size(), 1U);
  for (const auto& entry : fs::directory_iterator(folder.path()))
    EXPECT_EQ(entry.path().extension(), ".bin") << entry.path();
}

TEST(CacheFile, IsNoneWithoutAFolder) {
  base::Cache none;
  base::remember(none, "packing", key, numbers());
  EXPECT_FALSE(base::recall(none, "packing", key));
  EXPECT_TRUE(none.notes.empty());
}

TEST(UserCache, IsBelowXdgCacheHomeElseBelowHome) {
  ASSERT_EQ(setenv("XDG_CACHE_HOME", "/some/where", 1), 0);
  ASSERT_EQ(setenv("HOME", "/home/me", 1), 0);
  EXPECT_EQ(base::user_cache().folder, "/some/where/rift");
  ASSERT_EQ(setenv("XDG_CACHE_HOME", "relative", 1), 0);  // the XDG specification: to be ignored
  EXPECT_EQ(base::user_cache().folder, "/home/me/.cache/rift");
  ASSERT_EQ(unsetenv("XDG_CACHE_HOME"), 0);
  EXPECT_EQ(base::user_cache().folder, "/home/me/.cache/rift");
  ASSERT_EQ(unsetenv("HOME"), 0);
  EXPECT_TRUE(base::user_cache().folder.empty());
}

}  // namespace
}  // namespace rift::simulation

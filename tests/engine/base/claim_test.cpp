#include "engine/base/claim.hpp"

#include "engine/base/child_process.hpp"
#include "engine/base/files.hpp"
#include "engine/base/process_name.hpp"
#include "tests/temporary_folder.hpp"

#include <fmt/format.h>
#include <gtest/gtest.h>
#include <unistd.h>

#include <atomic>
#include <chrono>
#include <thread>
#include <vector>

namespace rift::base {
namespace {

namespace fs = std::filesystem;
using namespace std::chrono_literals;

/// A claim as another process has left it, which gave its last sign of life so long ago.
void leave_claim(const fs::path& folder, const std::string& name, const std::string& words,
                 std::chrono::seconds silent) {
  make_folder(folder);
  const fs::path file = folder / (name + ".claim");
  write_whole_file(file, words);
  fs::last_write_time(file, fs::file_time_type::clock::now() - silent);
}

/// The number of a process of this node that has ended.
std::string ended_process() {
  ChildProcess child({"sh", "-c", "echo $$"}, {.piped = true});
  std::array<std::uint8_t, 32> said{};
  const std::size_t count = child.read(said);
  child.wait();
  return {said.begin(), said.begin() + count - 1};
}

TEST(Claim, IsHeldByOneAtATime) {
  const TemporaryFolder folder;
  Claims mine(folder.path() / "claims"), others(folder.path() / "claims");
  {
    const auto claim = mine.take("a");
    ASSERT_TRUE(claim);
    EXPECT_FALSE(others.take("a"));
    EXPECT_FALSE(mine.take("a")) << "nor twice by one";
    EXPECT_TRUE(others.take("b"));
  }
  EXPECT_TRUE(others.take("a")) << "it was released";
}

TEST(Claim, LeavesNoFolderWhenAllIsReleased) {
  const TemporaryFolder folder;
  {
    Claims claims(folder.path() / "claims");
    const auto claim = claims.take("a");
    EXPECT_TRUE(fs::exists(folder.path() / "claims" / "a.claim"));
  }
  EXPECT_FALSE(fs::exists(folder.path() / "claims"));
}

// Each of many threads with claims of its own tries all the names: no name is held twice at once.
TEST(Claim, IsNeverHeldTwiceAtOnce) {
  const TemporaryFolder folder;
  std::array<std::atomic<int>, 8> holders{};
  std::atomic<int> taken = 0, twice = 0;
  const auto work = [&] {
    Claims claims(folder.path() / "claims");
    for (int round = 0; round < 50; ++round)
      for (std::size_t k = 0; k < holders.size(); ++k)
        if (const auto claim = claims.take(std::to_string(k))) {
          ++taken;
          if (++holders[k] > 1) ++twice;
          std::this_thread::yield();
          --holders[k];
        }
  };
  {
    std::vector<std::jthread> threads;
    for (int k = 0; k < 4; ++k) threads.emplace_back(work);
  }
  EXPECT_GT(taken, 50);
  EXPECT_EQ(twice, 0);
}

TEST(Claim, OfAProcessOfThisNodeThatHasEndedIsFree) {
  const TemporaryFolder folder;
  leave_claim(folder.path(), "a", fmt::format("{} {} 01234567 12_3\n", host_name(), ended_process()), 0s);
  const auto holders = Claims::holders(folder.path());
  ASSERT_EQ(holders.count("a"), 1u);
  EXPECT_FALSE(holders.at("a").lives);
  EXPECT_EQ(holders.at("a").label, "12_3");
  Claims claims(folder.path());
  EXPECT_TRUE(claims.take("a"));
}

TEST(Claim, OfAnotherNodeIsFreeWhenThatIsSilentForLong) {
  const TemporaryFolder folder;
  leave_claim(folder.path(), "lives", "elsewhere 1 01234567 12_3\n", 100s);
  leave_claim(folder.path(), "dead", "elsewhere 1 89abcdef 12_4\n", 200s);
  leave_claim(folder.path(), "begun", "", 0s);
  leave_claim(folder.path(), "begun_long_ago", "", 200s);
  Claims claims(folder.path());
  EXPECT_FALSE(claims.take("lives"));
  EXPECT_TRUE(claims.take("dead"));
  EXPECT_FALSE(claims.take("begun")) << "its holder writes its words in a moment";
  EXPECT_TRUE(claims.take("begun_long_ago"));
}

// Who was taken for dead and goes on must not take away the claim of who has it now.
TEST(Claim, ThatAnotherHasTakenOverIsNotReleased) {
  const TemporaryFolder folder;
  Claims claims(folder.path());
  {
    const auto claim = claims.take("a");
    ASSERT_TRUE(claim);
    write_whole_file(folder.path() / "a.claim", "elsewhere 1 01234567 \n");
  }
  EXPECT_EQ(read_whole_file(folder.path() / "a.claim"), "elsewhere 1 01234567 \n");
}

TEST(Claim, IsKeptAliveWhileItIsHeld) {
  const TemporaryFolder folder;
  Claims claims(folder.path(), "", 0.05);
  const auto claim = claims.take("a");
  ASSERT_TRUE(claim);
  const fs::path file = folder.path() / "a.claim";
  const auto long_ago = fs::file_time_type::clock::now() - 1h;
  fs::last_write_time(file, long_ago);
  for (int k = 0; k < 400 && fs::last_write_time(file) == long_ago; ++k) std::this_thread::sleep_for(10ms);
  EXPECT_GT(fs::last_write_time(file), long_ago + 59min);
}

TEST(Claim, NeedsAFolderThatCanBeWrittenTo) {
  const TemporaryFolder folder;
  write_whole_file(folder.path() / "file", "");
  EXPECT_THROW(Claims(folder.path() / "file"), WorldError);
}

}  // namespace
}  // namespace rift::base

#include "engine/base/child_process.hpp"

#include "tests/temporary_folder.hpp"

#include <gtest/gtest.h>
#include <signal.h>
#include <unistd.h>

#include <chrono>
#include <csignal>
#include <filesystem>
#include <fstream>
#include <stdexcept>
#include <string>

namespace rift::base {
namespace {

std::span<const std::uint8_t> bytes(const std::string& text) {
  return {reinterpret_cast<const std::uint8_t*>(text.data()), text.size()};
}

TEST(ChildProcess, HearsItsInputAndIsHeard) {
  ChildProcess cat({"cat"}, {.piped = true});
  ASSERT_TRUE(cat.write(bytes("a crack runs")));
  cat.close_input();
  std::vector<std::uint8_t> heard(100);
  const std::size_t count = cat.read(heard);
  EXPECT_EQ(std::string(heard.begin(), heard.begin() + static_cast<std::ptrdiff_t>(count)), "a crack runs");
  EXPECT_EQ(cat.wait().code, 0);
}

TEST(ChildProcess, TellsHowItEndedWithItsLastWords) {
  ChildProcess failing({"sh", "-c", "echo first >&2; echo 'no such codec' >&2; exit 7"});
  EXPECT_EQ(failing.wait().code, 7);
  EXPECT_EQ(failing.wait().text, "ended with code 7: no such codec");
  ChildProcess killed({"sh", "-c", "kill -9 $$"});
  EXPECT_EQ(killed.wait().code, 128 + SIGKILL);
  EXPECT_EQ(killed.wait().text, "was killed by signal 9 (Killed)");
}

TEST(ChildProcess, WritingToOneThatHasEndedIsAnAnswerAndNoSignal) {
  ChildProcess gone({"true"}, {.piped = true});
  std::vector<std::uint8_t> much(1 << 20);
  bool written = true;
  for (int k = 0; k < 10 && written; ++k) written = gone.write(much);
  EXPECT_FALSE(written);
}

TEST(ChildProcess, ThatIsNotThereIsSaid) {
  try {
    ChildProcess none({"rift-no-such-program"});
    FAIL() << "started";
  } catch (const WorldError& error) {
    EXPECT_EQ(std::string(error.what()), "cannot start rift-no-such-program: No such file or directory");
  }
}

TEST(ChildProcess, IsKilledWithTheObject) {
  const auto start = std::chrono::steady_clock::now();
  { const ChildProcess sleeping({"sleep", "100"}, {.idle = true}); }
  EXPECT_LT(std::chrono::steady_clock::now() - start, std::chrono::seconds(10));
}

TEST(ChildProcess, WithoutPipesIsHeardAfterItsEnd) {
  ChildProcess speaks({"sh", "-c", "pwd; echo not well >&2; cat"}, {.folder = "/"});
  EXPECT_EQ(speaks.wait().words, "not well");
  EXPECT_EQ(speaks.said(), "/\nnot well\n");
}

TEST(ChildProcess, InheritsNoDescriptors) {
  const int open_here = dup(STDERR_FILENO);
  ChildProcess lists({"sh", "-c", "ls /proc/$$/fd"});
  lists.wait();
  EXPECT_EQ(lists.said(), "0\n1\n2\n");
  close(open_here);
}

TEST(ChildProcess, ThatOutlivesItsObjectLeavesNoZombie) {
  const TemporaryFolder scratch;
  const std::string file = (scratch / "pid").string();
  {
    const ChildProcess goes_on(
        {"sh", "-c", "sleep 0.2; echo $$ > " + file + ".new; mv " + file + ".new " + file},
        {.outlives = true});
  }
  for (int k = 0; k < 1000 && !std::filesystem::exists(file); ++k) usleep(10'000);
  pid_t pid = 0;
  std::ifstream(file) >> pid;
  ASSERT_GT(pid, 0);
  bool gone = false;
  for (int k = 0; k < 1000 && !gone; ++k, usleep(10'000)) gone = kill(pid, 0) != 0;
  EXPECT_TRUE(gone);
}

TEST(Sandbox, GivesWhatItsWorkReturns) {
  EXPECT_EQ(run_in_sandbox([] { return std::string(200'000, 'x'); }, 10).text, std::string(200'000, 'x'));
}

TEST(Sandbox, WorkThatDiesHangsThrowsOrEatsMemoryIsOutlived) {
  EXPECT_NE(run_in_sandbox(
                []() -> std::string {
                  std::raise(SIGSEGV);
                  return "";
                },
                10)
                .death.find("signal 11"),
            std::string::npos);
  EXPECT_EQ(run_in_sandbox(
                []() -> std::string {
                  for (;;) usleep(1000);
                },
                1)
                .death,
            "it did not end within 1 s");
  EXPECT_EQ(run_in_sandbox([]() -> std::string { throw std::runtime_error("no"); }, 10).death, "no");
  const SandboxResult greedy = run_in_sandbox([] { return std::string(std::size_t{6} << 30, 'x'); }, 20);
  EXPECT_FALSE(greedy.text);
#if defined(__SANITIZE_ADDRESS__) || defined(__SANITIZE_THREAD__)
  EXPECT_FALSE(greedy.death.empty());  // the sanitizer's allocator ends the child by itself
#else
  EXPECT_EQ(greedy.death, "std::bad_alloc");
#endif
}

}  // namespace
}  // namespace rift::base

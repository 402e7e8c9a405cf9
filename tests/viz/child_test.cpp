#include "viz/child.hpp"

#include "engine/base/world_error.hpp"

#include <gtest/gtest.h>
#include <signal.h>

#include <chrono>
#include <string>

namespace rift::viz {
namespace {

std::span<const std::uint8_t> bytes(const std::string& text) {
  return {reinterpret_cast<const std::uint8_t*>(text.data()), text.size()};
}

TEST(Child, HearsItsInputAndIsHeard) {
  Child cat({"cat"});
  ASSERT_TRUE(cat.write(bytes("a crack runs")));
  cat.close_input();
  std::vector<std::uint8_t> heard(100);
  const std::size_t count = cat.read(heard);
  EXPECT_EQ(std::string(heard.begin(), heard.begin() + static_cast<std::ptrdiff_t>(count)), "a crack runs");
  EXPECT_EQ(cat.wait().code, 0);
}

TEST(Child, TellsHowItEndedWithItsLastWords) {
  Child failing({"sh", "-c", "echo first >&2; echo 'no such codec' >&2; exit 7"});
  EXPECT_EQ(failing.wait().code, 7);
  EXPECT_EQ(failing.wait().text, "ended with code 7: no such codec");
  Child killed({"sh", "-c", "kill -9 $$"});
  EXPECT_EQ(killed.wait().code, 128 + SIGKILL);
  EXPECT_EQ(killed.wait().text, "was killed by signal 9 (Killed)");
}

TEST(Child, WritingToOneThatHasEndedIsAnAnswerAndNoSignal) {
  Child gone({"true"});
  std::vector<std::uint8_t> much(1 << 20);
  bool written = true;
  for (int k = 0; k < 10 && written; ++k) written = gone.write(much);
  EXPECT_FALSE(written);
}

TEST(Child, ThatIsNotThereIsSaid) {
  try {
    Child none({"rift-no-such-program"});
    FAIL() << "started";
  } catch (const base::WorldError& error) {
    EXPECT_EQ(std::string(error.what()), "cannot start rift-no-such-program: No such file or directory");
  }
}

TEST(Child, IsKilledWithTheObject) {
  const auto start = std::chrono::steady_clock::now();
  { const Child sleeping({"sleep", "100"}, true); }
  EXPECT_LT(std::chrono::steady_clock::now() - start, std::chrono::seconds(10));
}

}  // namespace
}  // namespace rift::viz

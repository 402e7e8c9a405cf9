#include "studio/graphics/ask.hpp"

#include "tests/studio/graphics/ends.hpp"

#include <gtest/gtest.h>
#include <pthread.h>
#include <signal.h>
#include <termios.h>

#include <thread>

namespace rift::studio {
namespace {

TEST(AskTerminal, WaitsNoLongerThanForTheLastAnswer) {
  const Ends ends;
  Asked asked;
  std::thread screen([&] {
    std::this_thread::sleep_for(std::chrono::milliseconds(30));
    ends.type("x\033_Gi=31;OK\033\\\033[6;18;9t");
    std::this_thread::sleep_for(std::chrono::milliseconds(30));
    ends.type("y\033[?62;4c");
  });
  const double took =
      seconds_of([&] { asked = ask_terminal(ends.terminal, ends.terminal, {}, std::chrono::seconds(20)); });
  screen.join();
  EXPECT_LT(took, 10);
  EXPECT_TRUE(asked.capabilities.kitty);
  EXPECT_EQ(asked.capabilities.cell_height, 18);
  EXPECT_EQ(asked.typed, "xy");
}

TEST(AskTerminal, WaitsOnWhereASignalComesBetween) {
  const Ends ends;
  struct sigaction action {
  }, before{};
  action.sa_handler = [](int) {};
  ASSERT_EQ(sigaction(SIGWINCH, &action, &before), 0);
  const pthread_t asking = pthread_self();
  std::thread screen([&] {
    std::this_thread::sleep_for(std::chrono::milliseconds(50));
    pthread_kill(asking, SIGWINCH);
    std::this_thread::sleep_for(std::chrono::milliseconds(50));
    ends.type("\033_Gi=31;OK\033\\\033[?62;4c");
  });
  const Asked asked = ask_terminal(ends.terminal, ends.terminal, {}, std::chrono::seconds(20));
  screen.join();
  ASSERT_EQ(sigaction(SIGWINCH, &before, nullptr), 0);
  EXPECT_TRUE(asked.capabilities.kitty);
  EXPECT_TRUE(asked.capabilities.sixel);
}

TEST(AskTerminal, ThatAnswersNothingHasNothingAndItsModesAreAsBefore) {
  const Ends ends;
  termios before{}, after{};
  ASSERT_EQ(tcgetattr(ends.terminal, &before), 0);
  const Asked asked = ask_terminal(ends.terminal, ends.terminal, {}, std::chrono::milliseconds(50));
  ASSERT_EQ(tcgetattr(ends.terminal, &after), 0);
  EXPECT_EQ(before.c_lflag, after.c_lflag);
  EXPECT_FALSE(asked.capabilities.answers);
  EXPECT_FALSE(asked.capabilities.kitty || asked.capabilities.sixel);
  EXPECT_EQ(asked.typed, "");
}

TEST(AskTerminal, ThatIsGoneIsNotWaitedFor) {
  Ends ends;
  close(ends.master);
  ends.master = -1;
  const double took =
      seconds_of([&] { (void)ask_terminal(ends.terminal, ends.terminal, {}, std::chrono::seconds(20)); });
  EXPECT_LT(took, 10);
}

}  // namespace
}  // namespace rift::studio

#include "studio/graphics/write_whole.hpp"

#include "tests/studio/graphics/ends.hpp"

#include <gtest/gtest.h>

#include <array>
#include <thread>

namespace rift::studio {
namespace {

const std::string picture(300'000, 'x');

TEST(WriteWhole, ReachesATerminalThatReads) {
  const Ends ends;
  std::size_t taken = 0;
  std::thread screen([&] {
    std::array<char, 4096> buffer{};
    while (taken < picture.size()) {
      const ssize_t count = ::read(ends.master, buffer.data(), buffer.size());
      if (count <= 0) return;
      taken += static_cast<std::size_t>(count);
    }
  });
  EXPECT_TRUE(write_whole(ends.terminal, picture, std::chrono::seconds(20)));
  screen.join();
  EXPECT_EQ(taken, picture.size());
}

TEST(WriteWhole, GivesUpOnATerminalThatTakesNothing) {
  const Ends ends;
  const double took =
      seconds_of([&] { EXPECT_FALSE(write_whole(ends.terminal, picture, std::chrono::milliseconds(100))); });
  EXPECT_LT(took, 10);
}

}  // namespace
}  // namespace rift::studio

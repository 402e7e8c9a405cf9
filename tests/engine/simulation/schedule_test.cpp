#include "engine/simulation/schedule.hpp"

#include "tests/engine/simulation/small_plate.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace rift::simulation {
namespace {

constexpr double dt = 1e-7, end = 0.04002;               // [s], [m]
constexpr std::array<double, 2> window{0.0123, 0.0317};  // [m]

history::CrackHistory history() {
  return history::history_of(-0.001, {{1000.0, 0.02}, {500.0, std::numeric_limits<double>::infinity()}});
}

Schedule schedule_of(const std::vector<std::string>& overrides = {}) {
  return make_schedule(small_preset(overrides).scene, history(), dt, end, window);
}

bool rising(const std::vector<std::int64_t>& steps) {
  return std::adjacent_find(steps.begin(), steps.end(), std::greater_equal<>()) == steps.end();
}

bool has(const std::vector<std::int64_t>& steps, std::int64_t step) {
  return std::binary_search(steps.begin(), steps.end(), step);
}

TEST(Schedule, EndsAtTheFirstStepWithTheTipAtItsEnd) {
  const Schedule s = schedule_of();
  EXPECT_EQ(s.ramp, 0);
  EXPECT_EQ(s.hold, 0);
  EXPECT_EQ(s.crack_start(), 0);
  EXPECT_EQ(s.total(), s.fracture);
  EXPECT_GE(history::tip_at(history(), static_cast<double>(s.fracture) * dt), end - 1e-15);
  EXPECT_LT(history::tip_at(history(), static_cast<double>(s.fracture - 1) * dt), end);
}

TEST(Schedule, HasAsManySamplesAsAskedForAtTheStepsNearestToEvenTimes) {
  const Schedule s = schedule_of({"output.samples=37"});
  EXPECT_TRUE(rising(s.samples));
  EXPECT_EQ(s.samples.front(), 0);
  EXPECT_EQ(s.samples.back(), s.total());
  for (int k = 0; k < 37; ++k) {
    const double wanted = static_cast<double>(s.total()) * k / 36.0;
    EXPECT_TRUE(has(s.samples, std::llround(wanted))) << wanted;
  }
  EXPECT_GE(s.samples.size(), 37U);
  EXPECT_LE(s.samples.size(), 37U + 11U);  // ends and sub-divisions of the window
}

TEST(Schedule, SamplesWhereTheTipIsNearestToTheWindowsEndsAndSubDivisions) {
  const Schedule s = schedule_of({"output.samples=10"});
  for (int k = 0; k <= 10; ++k) {
    const double wanted = window[0] + k * (window[1] - window[0]) / 10.0;
    const auto off = [&](std::int64_t step) {
      return std::abs(history::tip_at(history(), static_cast<double>(step) * dt) - wanted);
    };
    const auto nearest =
        std::min_element(s.samples.begin(), s.samples.end(), [&](auto a, auto b) { return off(a) < off(b); });
    // Half a step's way, at the higher speed at most.
    EXPECT_LE(off(*nearest), 0.5 * dt * 1000.0 * (1.0 + 1e-9)) << "sub-division " << k;
    EXPECT_LE(off(*nearest), off(*nearest + 1) + 1e-12);
    EXPECT_LE(off(*nearest), off(*nearest - 1) + 1e-12);
  }
}

TEST(Schedule, FramesAreEvenWithTheFirstAndLastMomentAmongThem) {
  const Schedule s = schedule_of({"output.frames=5"});
  ASSERT_EQ(s.frames.size(), 5U);
  EXPECT_TRUE(rising(s.frames));
  EXPECT_EQ(s.frames.front(), 0);
  EXPECT_EQ(s.frames.back(), s.total());
  EXPECT_NEAR(static_cast<double>(s.frames[1]), static_cast<double>(s.total()) / 4.0, 0.5);
  EXPECT_TRUE(schedule_of({"output.frames=0"}).frames.empty());
}

TEST(Schedule, HasNoMoreFramesThanSteps) {
  const Schedule s = schedule_of({"output.frames=100000"});
  EXPECT_TRUE(rising(s.frames));
  EXPECT_EQ(s.frames.size(), static_cast<std::size_t>(s.total()) + 1);
}

TEST(Schedule, OfARampSamplesItAndFramesTheCrackOnly) {
  const Schedule s = schedule_of(
      {"loading.method=ramp", "loading.ramp_steps=700", "loading.hold_steps=300", "output.samples=20"});
  EXPECT_EQ(s.ramp, 700);
  EXPECT_EQ(s.hold, 300);
  EXPECT_EQ(s.crack_start(), 1000);
  EXPECT_EQ(s.total(), 1000 + schedule_of().fracture);
  EXPECT_TRUE(rising(s.samples));
  EXPECT_EQ(s.samples.front(), 0);
  EXPECT_TRUE(has(s.samples, 1000));
  EXPECT_EQ(std::count_if(s.samples.begin(), s.samples.end(), [](auto n) { return n < 1000; }),
            19);  // and the twentieth as the crack starts
  EXPECT_EQ(s.samples.back(), s.total());
  EXPECT_EQ(s.frames.front(), 1000);
  EXPECT_EQ(s.frames.back(), s.total());
}

}  // namespace
}  // namespace rift::simulation

#include "engine/accuracy/convergence.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <functional>

namespace rift::accuracy {
namespace {

std::vector<Level> levels_of(const std::function<double(double)>& f) {
  std::vector<Level> levels;
  for (const double h : {0.4, 0.05, 0.2, 0.1}) levels.push_back({h, f(h)});
  return levels;
}

TEST(Convergence, TakesAPowerLawToItsLimit) {
  for (const double p : {1.0, 2.0, 4.0}) {
    const Convergence c = converge(levels_of([&](double h) { return 0.5 - 3.0 * std::pow(h, p); }));
    EXPECT_TRUE(c.clean) << c.text;
    EXPECT_NEAR(c.order, p, 1e-9);
    EXPECT_NEAR(c.limit, 0.5, 1e-12);
  }
}

TEST(Convergence, SaysTheObservedOrder) {
  EXPECT_EQ(converge(levels_of([](double h) { return h * h; })).text, "observed order 2.00");
}

TEST(Convergence, OfAlternatingDifferencesIsNotCleanAndTakesTheFinest) {
  const Convergence c = converge({{0.05, 0.50}, {0.1, 0.51}, {0.2, 0.49}});
  EXPECT_FALSE(c.clean);
  EXPECT_TRUE(std::isnan(c.order));
  EXPECT_EQ(c.limit, 0.50);
  EXPECT_NE(c.text.find("alternate"), std::string::npos) << c.text;
}

TEST(Convergence, WithinTheScatterIsNotClean) {
  const auto with = [](double uncertainty) {
    return converge({{1.0, 0.50, uncertainty}, {2.0, 0.51, uncertainty}, {4.0, 0.55, uncertainty}});
  };
  EXPECT_TRUE(with(0.001).clean);
  EXPECT_FALSE(with(0.01).clean);
  EXPECT_NE(with(0.01).text.find("specimens scatter"), std::string::npos) << with(0.01).text;
}

TEST(Convergence, IsNotCleanWhereTheNextLevelShowsAnotherOrder) {
  // Order 2 at the finest three, then a jump.
  const auto f = [](double h) { return h * h + (h > 0.3 ? 1.0 : 0.0); };
  EXPECT_TRUE(converge({{0.05, f(0.05)}, {0.1, f(0.1)}, {0.2, f(0.2)}}).clean);
  EXPECT_FALSE(converge(levels_of(f)).clean);
}

TEST(Convergence, TakesNoRoundingForAnOrder) {
  EXPECT_FALSE(converge(levels_of([](double h) { return 0.5 + 1e-7 * h * h; })).clean);
}

TEST(Convergence, NeedsACommonFactor) {
  const Convergence c = converge({{0.05, 0.50}, {0.1, 0.51}, {0.3, 0.55}});
  EXPECT_FALSE(c.clean);
  EXPECT_NE(c.text.find("common factor"), std::string::npos) << c.text;
}

TEST(Convergence, LeavesOutLevelsWithoutAValue) {
  EXPECT_EQ(converge({{0.05, NAN}, {0.1, 0.51}}).limit, 0.51);
  EXPECT_TRUE(std::isnan(converge({{0.05, NAN}}).limit));
}

}  // namespace
}  // namespace rift::accuracy

#include "engine/theory/strip_transient.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <fstream>
#include <sstream>
#include <string>

namespace rift::theory {
namespace {

// Each row of the finite-element computation, as it was handed over.
TEST(StripTransient, IsThatOfTheFiniteElementComputation) {
  std::ifstream file(std::string(RIFT_SOURCE_DIR) + "/tests/data/strip_fem.csv");
  std::string line;
  std::getline(file, line);
  int rows = 0;
  for (double v = 0, early = 0, late = 0; std::getline(file, line); ++rows) {
    std::replace(line.begin(), line.end(), ',', ' ');
    std::istringstream(line) >> v >> early >> late;
    EXPECT_NEAR(strip_transient(v)[0].over_g_i0, early, 1e-12) << v;
    EXPECT_NEAR(strip_transient(v)[1].over_g_i0, late, 1e-12) << v;
  }
  EXPECT_EQ(rows, 11);
}

TEST(StripTransient, IsStraightBetweenItsVelocitiesAndUndefinedBeyond) {
  EXPECT_NEAR(strip_transient(0.75)[0].over_g_i0, 0.5 * (0.993 + 1.078), 1e-12);
  EXPECT_EQ(strip_transient(0.02)[1].over_g_i0, strip_transient(0.1)[1].over_g_i0);
  for (double v : {0.0, -0.1, 1.01}) EXPECT_TRUE(std::isnan(strip_transient(v)[0].over_g_i0)) << v;
}

// Each row of the finite differences, which lose less than 0.8 per cent to their grid.
TEST(StripArrival, IsThatOfTheFiniteDifferencesButForTheirLoss) {
  std::ifstream file(std::string(RIFT_SOURCE_DIR) + "/tests/data/strip_arrival.csv");
  std::string line;
  std::getline(file, line);
  int rows = 0;
  for (double v = 0, from = 0, to = 0, value = 0; std::getline(file, line); ++rows) {
    std::replace(line.begin(), line.end(), ',', ' ');
    std::istringstream(line) >> v >> from >> to >> value;
    EXPECT_NEAR(strip_arrival(v, from, to), value, 0.008) << v << " " << from;
  }
  EXPECT_EQ(rows, 36);
}

TEST(StripArrival, HasTheFiniteElementsMeanFromTwoToThreeHeights) {
  for (double v : {0.3, 0.5, 0.7, 0.9})
    EXPECT_NEAR(strip_arrival(v, 2.0, 3.0), strip_transient(v)[1].over_g_i0, 1e-12) << v;
  EXPECT_NEAR(strip_arrival(0.7, 2.0, 3.0),
              0.5 * (strip_arrival(0.7, 2.0, 2.5) + strip_arrival(0.7, 2.5, 3.0)), 1e-12);
  EXPECT_NEAR(strip_arrival(0.7, 2.55, 2.65),
              0.5 * (strip_arrival(0.7, 2.5, 2.6) + strip_arrival(0.7, 2.6, 2.7)), 1e-12);
}

TEST(StripArrival, IsUndefinedWhereItWasNotComputed) {
  EXPECT_TRUE(std::isnan(strip_arrival(0.7, 1.9, 2.5)));
  EXPECT_TRUE(std::isnan(strip_arrival(0.7, 3.0, 3.3)));
  EXPECT_TRUE(std::isnan(strip_arrival(1.2, 2.0, 3.0)));
}

}  // namespace
}  // namespace rift::theory

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

}  // namespace
}  // namespace rift::theory

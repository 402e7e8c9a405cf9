#include "engine/theory/references.hpp"

#include "engine/theory/wave_speeds.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <fstream>
#include <sstream>
#include <string>
#include <vector>

namespace rift::theory {
namespace {

struct Given {
  double nu;
  Plane plane;
  double v;
  double cr, cd, broberg_k, broberg_g, freund_k, freund_g;
};

std::vector<Given> reference_table() {
  std::ifstream file(RIFT_SOURCE_DIR "/tests/data/theory.csv");
  std::vector<Given> rows;
  std::string line;
  std::getline(file, line);
  while (std::getline(file, line)) {
    std::istringstream cells(line);
    std::vector<std::string> texts;
    for (std::string text; std::getline(cells, text, ',');) texts.push_back(text);
    const auto number = [&](int column) { return std::stod(texts.at(column)); };
    rows.push_back({number(0), texts.at(1) == "stress" ? Plane::stress : Plane::strain, number(2), number(3),
                    number(4), number(5), number(6), number(7), number(8)});
  }
  return rows;
}

TEST(References, MatchEveryRowOfTheTable) {
  const std::vector<Given> rows = reference_table();
  ASSERT_EQ(rows.size(), 48u);
  for (const Given& row : rows) {
    SCOPED_TRACE(testing::Message() << row.nu << (row.plane == Plane::stress ? " stress " : " strain ")
                                    << row.v);
    const Factor b = broberg(row.v, row.nu, row.plane), f = freund(row.v, row.nu, row.plane);
    EXPECT_NEAR(rayleigh_over_shear(row.nu, row.plane), row.cr, 1e-10);
    EXPECT_NEAR(dilatational_over_shear(row.nu, row.plane), row.cd, 1e-10);
    EXPECT_NEAR(b.k, row.broberg_k, 1e-8);
    EXPECT_NEAR(b.g, row.broberg_g, 1e-8);
    EXPECT_NEAR(f.k, row.freund_k, 1e-8);
    EXPECT_NEAR(f.g, row.freund_g, 1e-8);
  }
}

// The formulas of model.md §8 as they stand there, in 40 digits and more by mpmath 1.3 (Gauss-Legendre and
// its own tanh-sinh, no algebra in common with ours), from decimal arguments.
const Given mpmath_rows[] = {
    {0.3, Plane::stress, 0.0001, 0.916214261904077593, 1.69030850945703316, 0.999999929730017787,
     0.999999865812405324, 0.999942390138468302, 0.999884789947466558},
    {0.3, Plane::stress, 0.5, 0.916214261904077593, 1.69030850945703316, 0.657057266210219652,
     0.520255380358873283, 0.659913314637536098, 0.524788026089594383},
    {0.3, Plane::stress, 0.9999, 0.916214261904077593, 1.69030850945703316, 0.000236731192880062499,
     0.000138743193762277352, 0.000274302970048155811, 0.000186278072054888551},
    {0.25, Plane::strain, 0.2, 0.919401686761966122, 1.73205080756887729, 0.916396035656420572,
     0.861860791071917728, 0.878051452419480788, 0.791244403719356890},
    {0.0, Plane::stress, 0.7, 0.874032048897642142, 1.41421356237309505, 0.428590059658417181,
     0.295551651091433369, 0.457735284965393100, 0.337114928579907997},
    {0.02, Plane::strain, 0.4, 0.877924168470906885, 1.42886901662352056, 0.743257021768578200,
     0.621344418830468444, 0.731345378917413617, 0.601588330461531291},
    {0.49, Plane::strain, 0.6, 0.954074354139504570, 7.14142842854285000, 0.476142295910191228,
     0.307233826294332038, 0.530753641698689900, 0.381752132315378597},
    {-0.5, Plane::stress, 0.9, 0.688892182534018100, 1.15470053837925153, 0.126667276250638882,
     0.0694333808058467078, 0.152216955777527926, 0.100268729616809052},
    {0.5, Plane::stress, 0.1, 0.932525905931154927, 2.00000000000000000, 0.973829847568767697,
     0.954410905809738637, 0.940214053915542541, 0.889657219892357633},
};

TEST(References, HaveThirteenTrueDigits) {
  for (const Given& row : mpmath_rows) {
    SCOPED_TRACE(testing::Message() << row.nu << ' ' << row.v);
    // A decimal velocity is rounded by up to 5.5e-17, which factors of size 1 - v feel relative to 1 - v.
    const double tolerance = 5e-15 + 4e-17 * 3.0 / (1.0 - row.v);
    const Factor b = broberg(row.v, row.nu, row.plane), f = freund(row.v, row.nu, row.plane);
    EXPECT_NEAR(rayleigh_over_shear(row.nu, row.plane) / row.cr, 1.0, tolerance);
    EXPECT_NEAR(dilatational_over_shear(row.nu, row.plane) / row.cd, 1.0, tolerance);
    EXPECT_NEAR(b.k / row.broberg_k, 1.0, tolerance);
    EXPECT_NEAR(b.g / row.broberg_g, 1.0, tolerance);
    EXPECT_NEAR(f.k / row.freund_k, 1.0, tolerance);
    EXPECT_NEAR(f.g / row.freund_g, 1.0, tolerance);
  }
}

TEST(ReleaseRateFunction, IsOneAtRest) {
  for (const double nu : {-0.5, 0.0, 0.3, 0.49}) {
    EXPECT_NEAR(release_rate_function(0.0, nu, Plane::stress), 1.0, 1e-15);
    EXPECT_NEAR(release_rate_function(1e-9, nu, Plane::strain), 1.0, 1e-15);  // A_I = 1 + O(v^2)
  }
}

TEST(ReleaseRateFunction, IsItsDefinition) {
  // nu of plane strain, directly: A_I = v^2 alpha_d / ((1 - nu) D), c_s = 1
  const double nu = 0.3, v = 0.6 * rayleigh_over_shear(nu, Plane::strain);
  const double cd = dilatational_over_shear(nu, Plane::strain);
  const double alpha_d = std::sqrt(1 - v * v / cd / cd), alpha_s = std::sqrt(1 - v * v);
  const double d = 4 * alpha_d * alpha_s - std::pow(1 + alpha_s * alpha_s, 2);
  EXPECT_NEAR(release_rate_function(0.6, nu, Plane::strain), v * v * alpha_d / ((1 - nu) * d), 1e-13);
}

TEST(Freund, ForwardTimesBackwardUndoesTheReleaseRate) {
  // A_I(v) k(v) k(-v) = 1 exactly; at nu = 0 and near it the arctangent has its layer.   [model.md §8]
  for (const Plane plane : {Plane::stress, Plane::strain})
    for (const double nu : {-0.9, -0.3, -1e-6, 0.0, 1e-3, 0.02, 0.25, 0.3, 0.45, 0.4999})
      for (const double v : {1e-4, 0.1, 0.5, 0.9, 0.99, 0.9999})
        EXPECT_NEAR(release_rate_function(v, nu, plane) * freund_k(v, nu, plane) * freund_k(-v, nu, plane),
                    1.0, 4e-15)
            << nu << ' ' << v;
}

TEST(References, TendToOneAtRest) {
  for (const Factor f : {broberg(1e-9, 0.3, Plane::stress), freund(1e-9, 0.3, Plane::stress)}) {
    EXPECT_NEAR(f.k, 1.0, 2e-9);  // 1 - O(v)
    EXPECT_NEAR(f.g, 1.0, 2e-9);
  }
  for (const Factor f : {broberg(0.0, 0.3, Plane::strain), freund(0.0, 0.3, Plane::strain),
                         strip(0.0, 0.3, Plane::strain), broberg(1e-300, 0.3, Plane::strain)}) {
    EXPECT_EQ(f.k, 1.0);
    EXPECT_EQ(f.g, 1.0);
  }
}

TEST(References, FallToZeroAtTheRayleighSpeedAndEndThere) {
  for (const auto reference : {broberg, freund}) {
    EXPECT_EQ(reference(1.0, 0.3, Plane::stress).k, 0.0);
    EXPECT_EQ(reference(1.0, 0.3, Plane::stress).g, 0.0);
    EXPECT_GT(reference(0.999999, 0.3, Plane::stress).g, 0.0);
    EXPECT_LT(reference(0.999999, 0.3, Plane::stress).g, 3e-6);
    for (const double outside : {1.0000001, 2.0, -0.1, std::nan("")}) {
      EXPECT_TRUE(std::isnan(reference(outside, 0.3, Plane::stress).k)) << outside;
      EXPECT_TRUE(std::isnan(reference(outside, 0.3, Plane::stress).g)) << outside;
    }
  }
}

TEST(References, FallMonotonically) {
  for (const auto reference : {broberg, freund}) {
    double before = 1.0;
    for (int i = 1; i <= 100; ++i) {
      const double g = reference(i / 100.0, 0.3, Plane::stress).g;
      EXPECT_LT(g, before) << i;
      before = g;
    }
  }
}

TEST(Strip, ReceivesAllTheEnergyBelowTheRayleighSpeed) {
  for (const double v : {1e-4, 0.5, 0.9999}) {
    const Factor f = strip(v, 0.3, Plane::stress);
    EXPECT_EQ(f.g, 1.0);
    EXPECT_NEAR(release_rate_function(v, 0.3, Plane::stress) * f.k * f.k, 1.0, 1e-15);
  }
  EXPECT_TRUE(std::isnan(strip(1.0, 0.3, Plane::stress).g));
}

}  // namespace
}  // namespace rift::theory

#include "tests/studio/commands/range_sweep.hpp"

#include <fmt/format.h>

#include <set>

namespace rift::studio {
namespace {

constexpr int limit_s = 20;

std::set<std::string> tables() {
  std::set<std::string> names;
  for (const scene::Parameter& row : scene::parameters()) names.insert(scene::table_of(row));
  return names;
}

void report(const Tally& t) {
  printf("%d runs: %d done, %d refused, %d diverged, %d stopped in time\n", t.runs, t.finished, t.refused,
         t.diverged, t.stopped);
}

class EveryKey : public testing::TestWithParam<std::string> {};

TEST_P(EveryKey, AloneAtTheEndsOfItsRangeIsComputedOrRefused) {
  RangeSweep sweep(limit_s);
  int swept = 0;
  for (const scene::Parameter& row : scene::parameters()) {
    if (scene::table_of(row) != GetParam()) continue;
    for (const std::string& value : scene::ends_of(row)) {
      ++swept;
      EXPECT_EQ(sweep.complaint({{std::string(row.key), value}}), "");
    }
  }
  report(sweep.tally);
  EXPECT_GT(swept, 0);
}

INSTANTIATE_TEST_SUITE_P(OfTable, EveryKey, testing::ValuesIn(tables()),
                         [](const auto& of) { return of.param; });

/// Keys that make one number between them.
const std::vector<std::array<const char*, 2>> pairs{{"specimen.length", "specimen.height"},
                                                    {"specimen.length", "specimen.elements"},
                                                    {"specimen.height", "specimen.thickness"},
                                                    {"specimen.height", "loading.displacement"},
                                                    {"material.young_modulus", "material.rayleigh_speed"},
                                                    {"material.young_modulus", "material.density"},
                                                    {"material.young_modulus", "material.poisson_ratio"},
                                                    {"material.young_modulus", "loading.force"},
                                                    {"material.micro_young_modulus", "material.density"},
                                                    {"crack.velocity", "crack.damage_zone_ratio"},
                                                    {"crack.velocity", "solver.dt_fraction"},
                                                    {"crack.velocity", "material.rayleigh_speed"},
                                                    {"crack.start", "crack.end"},
                                                    {"crack.damage_zone_ratio", "crack.relaxation"},
                                                    {"damping.alpha", "solver.dt_fraction"},
                                                    {"solver.beta", "damping.alpha"},
                                                    {"output.samples", "output.frames"}};

class Pair : public testing::TestWithParam<int> {};

TEST_P(Pair, AtTheEndsOfBothRangesIsComputedOrRefused) {
  RangeSweep sweep(limit_s);
  const auto& [one, other] = pairs[static_cast<std::size_t>(GetParam())];
  const std::vector<std::string> of_one = far_values(*scene::find_parameter(one)),
                                 of_other = far_values(*scene::find_parameter(other));
  ASSERT_FALSE(of_one.empty());
  ASSERT_FALSE(of_other.empty());
  for (const std::string& a : of_one)
    for (const std::string& b : of_other) EXPECT_EQ(sweep.complaint({{one, a}, {other, b}}), "");
  report(sweep.tally);
}

INSTANTIATE_TEST_SUITE_P(OfKeys, Pair, testing::Range(0, static_cast<int>(pairs.size())));

}  // namespace
}  // namespace rift::studio

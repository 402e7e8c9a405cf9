#include "tests/faults/disk_faults.hpp"

#include <cstdlib>

namespace rift::studio::faults {
namespace {

/// At how many moments each command is killed, and at how many it is stopped (RIFT_STOPS).
int moments() {
  const char* value = std::getenv("RIFT_STOPS");
  return value == nullptr ? 20 : std::max(1, std::atoi(value));
}

/// `rift reproduce` of one figure, on specimens small enough to be reproduced again and again.
Case reproduce_case() {
  const std::string command = "rift reproduce fig06 --quick --out {}/out --quiet --threads 1 >/dev/null";
  return {"reproduce",
          "",
          command,
          command,
          "test -s {}/out/report.html",
          {"out/charts/fig06_bulk.csv", "out/charts/fig06_in_situ.csv"},
          false};
}

std::vector<Case> stopped_cases() {
  std::vector<Case> cases = all_cases();
  cases.push_back(reproduce_case());
  return cases;
}

class StopsOf : public testing::TestWithParam<std::size_t> {};

TEST_P(StopsOf, LeaveWhatTheNextCommandGoesOnFrom) {
  const Case tested = stopped_cases()[GetParam()];
  Sweep sweep(tested);
  const double whole = sweep.seconds();
  Counts all;
  for (const char* signal : {"KILL", "TERM"})
    for (int k = 0; k < moments(); ++k) all.add(sweep.stop(signal, whole * (k + 0.5) / moments()));
  fmt::print(
      "{:<12} {:5.1f} s, {} stops: {} ended by it, {} done before, {} wrong, {} ended otherwise, {} hung, {} "
      "half files, {} not resumable\n",
      tested.name, whole, 2 * moments(), all.said, all.unharmed, all.wrong, all.crashed, all.hung,
      all.half_a_file, all.not_resumable);
  for (const std::string& detail : all.details) fmt::print("  {}\n", detail);
  std::fflush(stdout);
  EXPECT_EQ(all.faults(), 0);
  EXPECT_GT(all.said, 0);
}

INSTANTIATE_TEST_SUITE_P(Commands, StopsOf, testing::Range(std::size_t{0}, stopped_cases().size()),
                         [](const auto& tested) {
                           return replaced(stopped_cases()[tested.param].name, " ", "_");
                         });

}  // namespace
}  // namespace rift::studio::faults

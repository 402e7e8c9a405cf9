#include "tests/faults/disk_faults.hpp"

#include <cstdlib>

namespace rift::studio::faults {
namespace {

/// Every how many calls one is disturbed (RIFT_FAULTS_EVERY); 1 is the whole sweep.
int every() {
  const char* value = std::getenv("RIFT_FAULTS_EVERY");
  return value == nullptr ? 1 : std::max(1, std::atoi(value));
}

void print(const std::string& what, const Counts& c) {
  fmt::print(
      "{:<24} {:>5} told, {:>4} unharmed, {} wrong, {} crashed, {} hung, {} other codes, {} library texts, "
      "{} half files, {} not resumable\n",
      what, c.said, c.unharmed, c.wrong, c.crashed, c.hung, c.other_code, c.library_text, c.half_a_file,
      c.not_resumable);
  for (const std::string& detail : c.details) fmt::print("  {}\n", detail);
  std::fflush(stdout);
}

class DiskFaultsOf : public testing::TestWithParam<std::size_t> {};

TEST_P(DiskFaultsOf, EndInASentenceAndCanBeResumed) {
  const Case tested = all_cases()[GetParam()];
  Sweep sweep(tested);
  Counts all;
  for (const Fault& fault : all_faults) {
    Counts counts;
    const int calls = sweep.calls(fault.kind);
    for (int call = 1; call <= calls; call += every()) counts.add(sweep.disturb(fault, call));
    print(fmt::format("{} {} {}{}", tested.name, fault.kind, fault.error, fault.stays ? " stays" : ""),
          counts);
    all.add(counts);
  }
  for (int part = 1; part < 16; ++part) all.add(sweep.limit_files(sweep.largest_file() * part / 16));
  all.details.clear();
  print(tested.name + " in all", all);
  EXPECT_EQ(all.faults(), 0);
}

INSTANTIATE_TEST_SUITE_P(Commands, DiskFaultsOf, testing::Range(std::size_t{0}, all_cases().size()),
                         [](const auto& tested) {
                           return replaced(all_cases()[tested.param].name, " ", "_");
                         });

}  // namespace
}  // namespace rift::studio::faults

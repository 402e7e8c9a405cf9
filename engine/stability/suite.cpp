#include "engine/stability/suite.hpp"

#include <algorithm>
#include <chrono>

namespace rift::stability {
namespace {

Observed timed(const StabilityCase& one, ensemble::Precision precision) {
  const auto start = std::chrono::steady_clock::now();
  Observed seen = one.run(precision);
  if (seen.wall_s == 0.0)
    seen.wall_s = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
  if (one.claims)
    for (Claim& claim : one.claims(seen, precision)) seen.claims.push_back(std::move(claim));
  return seen;
}

}  // namespace

Claim claim_near(std::string what, double seen, double expected, double tolerance) {
  return {std::move(what), expected - tolerance, expected + tolerance, seen};
}

const Observed& CachedRun::of(ensemble::Precision precision) {
  std::optional<Observed>& seen = seen_[precision == ensemble::Precision::single_precision];
  if (!seen) seen = run_(precision);
  return *seen;
}

const char* name_of(CaseEnd ending) {
  switch (ending) {
    case CaseEnd::closes:
      return "closes";
    case CaseEnd::open:
      return "open";
    case CaseEnd::refused:
      return "refused";
    case CaseEnd::diverges:
      return "diverges";
  }
  return "";
}

bool is_as_expected(const StabilityCase& expected, const Observed& seen, ensemble::Precision precision) {
  const bool single = precision == ensemble::Precision::single_precision;
  if (seen.ending != (single ? expected.expected_in_single.value_or(expected.expected) : expected.expected))
    return false;
  if (seen.ending == CaseEnd::refused) return seen.said.find(expected.names) != std::string::npos;
  if (seen.ending == CaseEnd::diverges && seen.caught_within > caught_at_most) return false;
  if (!std::all_of(seen.claims.begin(), seen.claims.end(), [](const Claim& claim) { return claim.holds(); }))
    return false;
  const double tolerance = growth_tolerance * (single ? 10.0 : 1.0);
  return std::isnan(expected.growth) || std::abs(seen.growth - expected.growth) <= tolerance;
}

StabilityRow try_case(const StabilityCase& one) {
  StabilityRow row{one.family, one.name, one.expected, one.growth, {}, {}, false};
  row.in_double = timed(one, ensemble::Precision::double_precision);
  row.in_single = timed(one, ensemble::Precision::single_precision);
  if (std::isfinite(row.in_double.ratio) && row.in_single.ending != CaseEnd::diverges)
    row.in_single.claims.push_back(claim_near(
        "ratio, single less double", row.in_single.ratio - row.in_double.ratio, 0.0, single_ratio_tolerance));
  row.as_expected = is_as_expected(one, row.in_double, ensemble::Precision::double_precision) &&
                    is_as_expected(one, row.in_single, ensemble::Precision::single_precision);
  return row;
}

std::vector<StabilityCase> stability_cases(const SuiteOptions& options) {
  Cases cases;
  add_free_vibration(cases, options);
  add_forced_steps(cases);
  add_damping(cases);
  add_beams(cases);
  add_packings(cases);
  add_cracks(cases, options);
  add_paths(cases);
  add_small_lattices(cases);
  if (!options.only.empty())
    std::erase_if(
        cases, [&](const StabilityCase& one) { return one.family.find(options.only) == std::string::npos; });
  return cases;
}

}  // namespace rift::stability

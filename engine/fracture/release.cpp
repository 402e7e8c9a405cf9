#include "engine/fracture/release.hpp"

#include <algorithm>
#include <cmath>

namespace rift::fracture {

double stiffness_left(const ReleaseLaw& law, double tip, double crossing) {
  if (tip >= crossing) return 0.0;
  const double ahead = crossing - tip;  // l - b
  if (law.technique == Technique::simple || ahead >= law.zone_length) return 1.0;
  return std::pow(ahead / law.zone_length, law.exponent);
}

const ReleaseLaw& law_at(const LaneScenario& scenario, double position) {
  const ReleaseLaw* law = &scenario.law;
  for (const LawBeyond& beyond : scenario.later)
    if (position >= beyond.position) law = &beyond.law;
  return *law;
}

double reach_ahead(const LaneScenario& scenario, double tip) {
  double reach = law_at(scenario, tip).zone_length;
  for (const LawBeyond& beyond : scenario.later)
    if (beyond.position > tip) reach = std::max(reach, beyond.law.zone_length);
  return reach;
}

void change_law(LaneScenario& scenario, const ReleaseLaw& law, double tip) {
  const double from = tip + std::max(reach_ahead(scenario, tip), law.zone_length);
  std::erase_if(scenario.later, [&](const LawBeyond& beyond) { return beyond.position >= from; });
  scenario.later.push_back({from, law});
}

}  // namespace rift::fracture

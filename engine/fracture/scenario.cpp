#include "engine/fracture/scenario.hpp"

#include <algorithm>

namespace rift::fracture {

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

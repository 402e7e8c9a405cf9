#include "engine/ensemble/release.hpp"

#include <algorithm>

namespace rift::ensemble {

void PrescribedTips::set_lane(int lane, const fracture::LaneScenario& scenario) {
  if (lane >= static_cast<int>(lane_.size())) lane_.resize(lane + 1);
  lane_[lane].scenario = scenario;
}

void PrescribedTips::start(int lane, std::int64_t step) {
  lane_[lane].start = step_ = step;
  lane_[lane].first_standing = 0;
}

void PrescribedTips::predict_damage(const State& state, std::int64_t step,
                                    std::vector<DamageIncrement>& increments) {
  step_ = step + 1;
  const std::vector<fracture::DamageableBeam>& beam = state.damageable();
  const int count = static_cast<int>(beam.size());
  for (int k = 0; k < static_cast<int>(lane_.size()); ++k) {
    Lane& lane = lane_[k];
    const double a = tip(k), reach = fracture::reach_ahead(lane.scenario, a);
    int& first = lane.first_standing;
    while (first < count && state.factor(first, k) == 0.0) ++first;
    for (int b = first; b < count && beam[b].position <= a + reach; ++b) {
      const double before = state.factor(b, k);
      const fracture::ReleaseLaw& law = fracture::law_at(lane.scenario, beam[b].position);
      const double after =
          std::min(before, state.rounded(fracture::stiffness_left(law, a, beam[b].position)));
      if (after != before) increments.push_back({.k = b, .lane = k, .before = before, .after = after});
    }
  }
}

void PrescribedTips::save(NamedNumbers& numbers) const {
  for (const Lane& lane : lane_) {
    numbers["crack_start"].push_back(static_cast<double>(lane.start));
    numbers["first_standing"].push_back(lane.first_standing);
  }
}

void PrescribedTips::restore(const State& state, const NamedNumbers& numbers) {
  const std::vector<double>& clock = numbers_of(numbers, "clock", 7);
  step_ = clock[1] != 0.0 ? whole<std::int64_t>(clock[0], "clock") : 0;
  const std::vector<double>&start = numbers_of(numbers, "crack_start", lane_.size()),
        &first = numbers_of(numbers, "first_standing", lane_.size());
  for (std::size_t k = 0; k < lane_.size(); ++k) {
    lane_[k].start = whole<std::int64_t>(start[k], "crack_start");
    const int standing = lane_[k].first_standing = whole<int>(first[k], "first_standing");
    if (standing < 0 || standing > static_cast<int>(state.damageable().size()))
      throw std::invalid_argument("its first_standing is no crossing of this run");
  }
}

}  // namespace rift::ensemble

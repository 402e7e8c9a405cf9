#include "engine/ensemble/breaking_beams.hpp"

#include <algorithm>

namespace rift::ensemble {

void BreakingBeams::set_lane(int lane, const fracture::LaneScenario& scenario) {
  if (lane >= static_cast<int>(lane_.size())) lane_.resize(lane + 1);
  lane_[lane] = {fracture::softening_of(lattice_, scenario.material.value())};
}

void BreakingBeams::start(int lane, std::int64_t) { lane_[lane].harmless.clear(); }

/// The largest opening so far follows from the factor: delta = delta_0 delta_f / (s (delta_f - delta_0) +
/// delta_0).
double BreakingBeams::harmless_square(const Lane& lane, int beam, double factor) const {
  constexpr double less = 1.0 - 1e-6;  // than what single precision rounds
  if (factor == 0.0) return std::numeric_limits<double>::infinity();
  const fracture::Softening& s = lane.beam[beam];
  const double opening = s.first * s.last / (factor * (s.last - s.first) + s.first);
  return less * opening * opening;
}

void BreakingBeams::look_at_factors(const State& state, int lane) {
  Lane& l = lane_[lane];
  l.harmless.clear();
  for (int k = 0; k < static_cast<int>(state.damageable().size()); ++k)
    l.harmless.push_back(harmless_square(l, state.damageable()[k].beam, state.factor(k, lane)));
}

void BreakingBeams::follow_damage(const State& state, std::vector<DamageIncrement>& increments) {
  for (int lane = 0; lane < static_cast<int>(lane_.size()); ++lane) {
    Lane& l = lane_[lane];
    if (l.harmless.empty()) look_at_factors(state, lane);
    for (const State::OpenBeam& open : state.open_beams(lane, l.harmless)) {
      const int beam = state.damageable()[open.k].beam;
      const double before = state.factor(open.k, lane);
      const double after =
          std::min(before, state.rounded(fracture::stiffness_left(l.beam[beam], open.opening)));
      if (after == before) continue;
      increments.push_back({.k = open.k, .lane = lane, .before = before, .after = after});
      increments.back().strain = state.strain_before(beam, lane, dt_);
      l.harmless[open.k] = harmless_square(l, beam, after);
    }
  }
}

void BreakingBeams::restore(const State&, const NamedNumbers&) {
  for (Lane& lane : lane_) lane.harmless.clear();
}

}  // namespace rift::ensemble

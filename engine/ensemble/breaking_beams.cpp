#include "engine/ensemble/breaking_beams.hpp"

#include <algorithm>

namespace rift::ensemble {

void BreakingBeams::set_lane(int lane, const fracture::LaneScenario& scenario) {
  if (lane >= static_cast<int>(lane_.size())) lane_.resize(lane + 1);
  lane_[lane] = {fracture::softening_of(lattice_, scenario.material.value())};
}

void BreakingBeams::start(int lane, std::int64_t) { lane_[lane].known = false; }

void BreakingBeams::find_softened(const State& state, int lane) {
  Lane& l = lane_[lane];
  l.softened.clear();
  for (int k = 0; k < static_cast<int>(state.damageable().size()); ++k)
    if (const double left = state.factor(k, lane); left > 0.0 && left < 1.0) l.softened.push_back(k);
  l.known = true;
}

/// The largest opening so far follows from the factor: delta = delta_0 delta_f / (s (delta_f - delta_0) +
/// delta_0); somewhat less than that, so that what is lost depends on the factors alone, whatever single
/// precision rounds.
double BreakingBeams::harmless(const fracture::Softening& beam, double factor) {
  constexpr double less = 1.0 - 5e-7;
  return less * beam.first * beam.last / (factor * (beam.last - beam.first) + beam.first);
}

void BreakingBeams::follow_damage(const State& state, std::vector<DamageIncrement>& increments) {
  for (int lane = 0; lane < static_cast<int>(lane_.size()); ++lane) {
    Lane& l = lane_[lane];
    if (!l.known) find_softened(state, lane);
    looked_at_ = l.softened;
    state.add_watched(lane, looked_at_);
    std::sort(looked_at_.begin(), looked_at_.end());
    l.softened.clear();
    for (const int k : looked_at_) {
      const int beam = state.damageable()[k].beam;
      const double before = state.factor(k, lane), opening = state.opening(k, lane);
      double after = before;
      if (opening > harmless(l.beam[beam], before))
        after = std::min(before, state.rounded(fracture::stiffness_left(l.beam[beam], opening)));
      if (after > 0.0 && after < 1.0) l.softened.push_back(k);
      if (after == before) continue;
      increments.push_back({.k = k, .lane = lane, .before = before, .after = after});
      increments.back().strain = state.strain_before(beam, lane, dt_);
    }
  }
}

void BreakingBeams::restore(const State&, const NamedNumbers&) {
  for (Lane& lane : lane_) lane.known = false;
}

}  // namespace rift::ensemble

#pragma once

#include "engine/ensemble/release.hpp"
#include "engine/fracture/cohesive_law.hpp"

#include <vector>

namespace rift::ensemble {

/// Beams that break by themselves, wherever they are: what is left of each one's stiffness follows from its
/// own opening, and never rises again   [fracture/cohesive_law.hpp]. All beams but those of a notch are among
/// the damageable ones; linear kinematics. A step looks at the beams that have begun to soften and at those
/// that the walk has noted (State::add_watched()); for all others the walk makes one comparison.
class BreakingBeams : public ReleaseRule {
 public:
  /// @param[in] lattice  which must outlive the rule;  @param[in] dt  step of the ensemble [s]
  BreakingBeams(const lattice::Lattice& lattice, double dt) : lattice_(lattice), dt_(dt) {}

  void set_lane(int lane, const fracture::LaneScenario& scenario) override;
  void start(int lane, std::int64_t step) override;
  void predict_damage(const State&, std::int64_t, std::vector<DamageIncrement>&) override {}
  void follow_damage(const State& state, std::vector<DamageIncrement>& increments) override;
  void save(NamedNumbers&) const override {}  // a factor tells how far its beam was opened
  void restore(const State& state, const NamedNumbers& numbers) override;

 private:
  struct Lane {
    std::vector<fracture::Softening> beam;  // of the lattice
    std::vector<int> softened = {};         // places among the damageable beams, ascending
    bool known = false;                     // whether `softened` is
  };
  /// An opening below which a beam loses nothing [m].
  static double harmless(const fracture::Softening& beam, double factor);
  void find_softened(const State& state, int lane);

  const lattice::Lattice& lattice_;
  double dt_;
  std::vector<Lane> lane_;
  std::vector<int> looked_at_;
};

}  // namespace rift::ensemble

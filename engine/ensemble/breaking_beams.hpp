#pragma once

#include "engine/ensemble/release.hpp"
#include "engine/fracture/cohesive_law.hpp"

#include <limits>
#include <vector>

namespace rift::ensemble {

/// Beams that break by themselves, wherever they are: what is left of each one's stiffness follows from its
/// own opening, and never rises again   [fracture/cohesive_law.hpp]. All beams but those of a notch are among
/// the damageable ones; linear kinematics.
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
    /// Squares of the openings below which a damageable beam loses nothing, somewhat less so that what is
    /// lost depends on the factors alone [m2].
    std::vector<double> harmless = {};
  };
  double harmless_square(const Lane& lane, int beam, double factor) const;
  void look_at_factors(const State& state, int lane);

  const lattice::Lattice& lattice_;
  double dt_;
  std::vector<Lane> lane_;
};

}  // namespace rift::ensemble

#pragma once

#include "engine/ensemble/state.hpp"

#include <cstdint>
#include <vector>

namespace rift::ensemble {

/// A fall of one damageable beam's stiffness in one step.
struct DamageIncrement {
  int k = 0, lane = 0;           // its place among the damageable beams
  double before = 1, after = 1;  // what is left of its stiffness
  // What the ensemble notes before the elements move:
  lattice::BeamStrain strain = {0.0, 0.0, Eigen::Vector3d::Zero(), Eigen::Vector3d::Zero()};
  Eigen::Vector3d gap = Eigen::Vector3d::Zero();  // of its faces, where they may touch [m]
};

/// Says in each step which beams lose stiffness. A rule that follows a criterion reads the strains of the
/// state; whatever factors it chooses, the energy balance is exact in linear kinematics   [docs/model.md
/// §7].
class ReleaseRule {
 public:
  virtual ~ReleaseRule() = default;
  /// Takes a lane's scenario from the next step on.
  virtual void set_lane(int lane, const fracture::LaneScenario& scenario) = 0;
  /// Begins a lane's damage at a step of the ensemble.
  virtual void start(int lane, std::int64_t step) = 0;
  /// Adds the beams whose stiffness falls from one step of the ensemble to the next; called once a step,
  /// before the elements move. Factors must be such as State::rounded() gives.
  virtual void predict_damage(const State& state, std::int64_t step,
                              std::vector<DamageIncrement>& increments) = 0;
  /// Adds the beams whose fall follows from where the elements have just moved, with their strains of the
  /// step before (State::strain_before()); called once a step, after they moved.
  virtual void follow_damage(const State&, std::vector<DamageIncrement>&) {}
  /// What a checkpoint needs of the rule. restore() throws std::invalid_argument where the numbers are no
  /// such rule's.
  virtual void save(NamedNumbers& numbers) const = 0;
  virtual void restore(const State& state, const NamedNumbers& numbers) = 0;
};

/// S-NRT and P-NRT: in each lane a tip moves by a history along a path, and the beams that cross the path
/// lose stiffness as they come into the reach of its damage zone   [paper eqs. (9)-(11)].
class PrescribedTips : public ReleaseRule {
 public:
  /// @param[in] dt  step of the ensemble [s], whose damageable beams must be in ascending order of their
  /// positions
  explicit PrescribedTips(double dt) : dt_(dt) {}

  void set_lane(int lane, const fracture::LaneScenario& scenario) override;
  void start(int lane, std::int64_t step) override;
  void predict_damage(const State& state, std::int64_t step,
                      std::vector<DamageIncrement>& increments) override;
  void save(NamedNumbers& numbers) const override;
  void restore(const State& state, const NamedNumbers& numbers) override;

  // In the lattice's time; before the start a tip is where its history begins.
  double tip(int lane) const {
    return history::tip_at(lane_[lane].scenario.history, time(lane, step_));
  }                               // [m]
  double speed(int lane) const {  // [m/s]
    return history::speed_at(lane_[lane].scenario.history, time(lane, step_));
  }

 private:
  struct Lane {
    fracture::LaneScenario scenario;
    std::int64_t start = 0;  // step of the ensemble
    int first_standing = 0;  // the first damageable beam that is not yet gone
  };
  double time(int lane, std::int64_t step) const {
    return static_cast<double>(step - lane_[lane].start) * dt_;
  }

  double dt_;
  std::int64_t step_ = 0;  // of the ensemble, now
  std::vector<Lane> lane_;
};

}  // namespace rift::ensemble

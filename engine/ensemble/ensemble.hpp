#pragma once

#include "engine/ensemble/balances.hpp"
#include "engine/ensemble/release.hpp"
#include "engine/ensemble/state.hpp"

#include <cstdint>
#include <memory>
#include <optional>
#include <vector>

namespace rift::ensemble {

/// Scenarios that march in lock-step over one lattice with one step; a scenario is a lane, and what it does
/// is bit for bit the same whatever runs beside it and however many threads march. Numbers at this face are
/// doubles, in the units of the lane (set_units()) but where a comment says "of the lattice".
///
/// Between two calls of step() positions are those of step n and velocities those of the middle of the step
/// before it; forces are not kept. Who asks for energies or velocities has the forces of step n evaluated,
/// and with them step n + 1, which step() takes up if nothing was changed in between. The lattice must
/// outlive the ensemble.
class Ensemble {
 public:
  /// @param[in] damageable  beams whose stiffness may fall; every other beam stays intact
  /// @param[in] dt          [s], of the lattice
  /// @param[in] rule        says which of them do; none: none do
  Ensemble(const lattice::Lattice& lattice, std::vector<fracture::DamageableBeam> damageable, double dt,
           const std::vector<fracture::LaneScenario>& scenarios, const EnsembleOptions& options = {},
           std::shared_ptr<ReleaseRule> rule = nullptr);

  /// Puts every lane at rest in an equilibrium of the lattice without the absent beams, and opens the energy
  /// balances. Forces of the base state are taken as balanced, not evaluated again.
  /// @param[in] base  N displacements and rotation vectors [m, rad]
  void start_from(const std::vector<lattice::Vector6>& base);

  /// Forces from outside [N, N m] of N elements for a unit of the lanes' loads (LaneScenario::load), whose
  /// clocks are those of the lanes; before start_from().
  void set_loads(std::vector<lattice::Vector6> forces) { state_.set_outside(std::move(forces)); }

  /// Elements that roll on a face across x, without friction; linear kinematics, before start_from().
  void set_rollers(const std::vector<int>& elements) { state_.set_rollers(elements); }

  /// Puts every lane at rest in any state, for what follows to pull it back.
  void release_from(const std::vector<lattice::Vector6>& moved);

  /// Sets the velocities of a lane that start_from() has put at rest: those of this moment, where nothing is
  /// strained beyond the base state yet. @param[in] velocity  N [m/s, rad/s], of the lattice
  void set_velocities(int lane, const std::vector<lattice::Vector6>& velocity);

  /// Starts every lane's crack now. With it start these beams' viscous damping.
  void start_crack(const std::vector<lattice::DampedBeam>& damped);

  /// Puts a lane back to the base state with another scenario whose crack starts now and whose steps are
  /// counted from now; the others do not notice. The damped beams must be those of start_crack().
  void refill(int lane, const fracture::LaneScenario& scenario);

  /// Changes a lane while its crack runs, from the next step on: where its tip is and what the damage zone
  /// has reached must be as before.
  void steer(int lane, const fracture::LaneScenario& scenario);

  /// Sets the units in which a lane's time, velocities and energies are given; 1 at first.
  void set_units(int lane, const fracture::LaneUnits& units) { units_[lane] = units; }

  /// Damps these beams from the next step on; those that were damped before must be among them.
  void damp(const std::vector<lattice::DampedBeam>& damped);

  /// All that a later step depends on and that the scenarios do not tell, as named numbers; kept by restore()
  /// to the bit.
  NamedNumbers state() const;
  /// Puts the lanes where they were: after start_from(), start_crack() and, for lanes that were steered or
  /// refilled, steer() of the same, by as many lanes of the kernel. Throws std::invalid_argument where the
  /// numbers are not of such an ensemble (it is of no use then).
  void restore(const NamedNumbers& state);

  /// One step of Table 1 of the paper. Cost O(beams x lanes); allocates nothing.
  void step();

  /// Moves the top grip along y at `speed` [m/s] of the lattice from the next step on; 0 holds it.
  void set_grip_speed(double speed);

  /// beta of eq. (2) from the next step on; below 1 damps.
  void set_beta(double beta);

  /// The energy balance of a lane now [J]. Cost: two fifths of a step, for all lanes at once, since the look
  /// at the beams makes the next step as well; corotational beams cost another step's time beside.
  fracture::EnergyBalance balance(int lane);

  /// Force of the top grip along y [N]; below 0 it presses.
  double grip_force(int lane) const { return state_.grip_force(lane) * units_[lane].energy; }

  /// Energy that a beam would have undamaged [J], of the lattice.
  double beam_energy(int beam, int lane) const { return state_.beam_energy(beam, lane); }

  /// Elastic energy of the beams [J], half of each beam's to each of its elements. Cost O(beams).
  std::vector<double> elastic_by_element(int lane) const;

  lattice::Vector6 motion(int element, int lane) const {
    return state_.motion(element, lane);
  }                                                  // as of State
  lattice::Vector6 velocity(int element, int lane);  // of this moment [m/s, rad/s]

  /// Steps since the lane's scenario was put in, and their time [s].
  std::int64_t steps_done(int lane) const { return steps_done_ - first_step_[lane]; }
  double time(int lane) const { return static_cast<double>(steps_done(lane)) * dt_ * units_[lane].time; }

  const std::vector<fracture::DamageableBeam>& damageable() const { return state_.damageable(); }
  /// What is left of a damageable beam's stiffness, and the energy that it has lost by its damage so far [J].
  double factor(int k, int lane) const { return state_.factor(k, lane); }
  double fracture_energy(int k, int lane) const {
    return balances_.fracture_energy(k, lane) * units_[lane].energy;
  }
  /// What the last step has damaged.
  const std::vector<DamageIncrement>& damage() const { return damage_; }
  /// Of the faces of a damageable beam: how far they are apart, and the slip so far [m].
  Eigen::Vector3d gap(int k, int lane) const { return state_.gap(k, lane); }
  Eigen::Vector3d slip(int k, int lane) const { return state_.slip(k, lane); }

  const lattice::Lattice& lattice() const { return state_.lattice(); }
  bool cracking() const { return cracking_; }
  double dt() const { return dt_; }  // of the lattice
  int scenarios() const { return static_cast<int>(first_step_.size()); }
  int lanes() const { return state_.lanes(); }
  int threads() const { return state_.threads(); }

 private:
  StepConstants constants() const { return {dt_, beta_before_, beta_after_, grip_before_, grip_after_}; }
  void predict_damage();
  void follow_damage();
  void apply_damage();
  /// Sets a lane's load to that of this moment. @return what it was
  double follow_load(int lane);
  void evaluate(double* velocities);
  void open_balances(int first, int last);
  void forget_evaluation() { evaluated_at_ = velocities_at_ = -1; }

  double dt_;
  State state_;
  std::shared_ptr<ReleaseRule> rule_;
  Balances balances_;
  std::vector<fracture::LaneUnits> units_;
  std::vector<std::optional<double>> friction_;  // of each lane's faces
  std::vector<lattice::StepLoad> load_;          // of each lane
  std::vector<std::int64_t> first_step_;         // of each lane's scenario
  std::vector<DamageIncrement> damage_;
  AlignedVector<double> velocity_;                       // of this moment, [element][6][lane]
  std::int64_t evaluated_at_ = -1, velocities_at_ = -1;  // steps that the energies and velocity_ are of
  std::int64_t steps_done_ = 0;
  bool cracking_ = false;
  double beta_before_ = 1, beta_after_ = 1, grip_before_ = 0, grip_after_ = 0;
};

}  // namespace rift::ensemble

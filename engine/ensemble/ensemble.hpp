#pragma once

#include "engine/base/thread_pool.hpp"
#include "engine/ensemble/instruction_set.hpp"
#include "engine/ensemble/part_rows.hpp"
#include "engine/fracture/face_contact.hpp"
#include "engine/fracture/release.hpp"
#include "engine/fracture/release_rate.hpp"
#include "engine/results/checkpoint.hpp"

#include <cstdint>
#include <memory>
#include <vector>

namespace rift::ensemble {

using results::NamedNumbers;

/// A change of one crossing beam's stiffness in one step, and its strain before the elements move.
struct Softening {
  int crossing = 0, lane = 0;
  double before = 1, after = 1;
  lattice::BeamStrain strain;
  Eigen::Vector3d gap = Eigen::Vector3d::Zero();  // of its faces, where they may touch
};

/// How an ensemble marches; none of it changes what comes out, but for the kinematics and the last bits.
struct Marching {
  lattice::Kinematics kinematics = lattice::Kinematics::linear;
  int threads = 1;
  InstructionSet instructions = instruction_set();
  int lanes = 0;         // of the kernel; 0 for the fewest that hold the scenarios
  bool contact = false;  // whether any scenario's faces touch, now or later
};

/// Scenarios that march in lock-step over one lattice with one step; a scenario is a lane, and what it does
/// is bit for bit the same whatever runs beside it and however many threads march. `Real` is the precision of
/// the state, which holds changes since the base state (the pre-stress), so that float loses nothing against
/// it; the books are in double.
///
/// Between two calls of step() positions are those of step n and velocities those of the middle of the step
/// before it; forces are not kept. weigh() evaluates them once more and with them all energies of step n. The
/// lattice must outlive the ensemble.
template <class Real>
class Ensemble {
 public:
  Ensemble(const lattice::Lattice& lattice, const fracture::CrackPath& path, double notch_end, double dt,
           std::vector<fracture::LaneScenario> scenarios, const Marching& marching = {});

  /// Puts every lane at rest in an equilibrium of the lattice without the notch's beams, and opens the books.
  /// Forces of the base state are taken as balanced, not evaluated again.
  /// @param[in] base  N displacements and rotation vectors [m, rad]
  void start_from(const std::vector<lattice::Vector6>& base);

  /// Puts every lane at rest in any state, for what follows to pull it back.
  void release_from(const std::vector<lattice::Vector6>& moved);

  /// Throws a lane out of the state at rest that start_from() put it in: the velocities of this moment, where
  /// nothing is strained beyond the base yet. @param[in] velocity  N [m/s, rad/s]
  void throw_lane(int lane, const std::vector<lattice::Vector6>& velocity);

  /// Starts every lane's crack: a(0) of its history is now. With it start these beams' viscous damping.
  void start_crack(const std::vector<lattice::DampedBeam>& damped);

  /// Puts a lane back to the base state with another scenario whose crack starts now and whose steps are
  /// counted from now; the others do not notice. The damped beams must be those of start_crack().
  void refill(int lane, const fracture::LaneScenario& scenario);

  /// Changes a lane while its crack runs, from the next step on: where its tip is and what the damage zone
  /// has reached must be as before.
  void steer(int lane, const fracture::LaneScenario& scenario);

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

  /// Moves the top grip along y at `speed` [m/s] from the next step on; 0 holds it.
  void set_grip_speed(double speed);

  /// beta of eq. (2) from the next step on; below 1 damps.
  void set_beta(double beta);

  /// Energies of a lane now. Cost: two looks at every beam, for all lanes at once.
  fracture::LatticeEnergy energy(int lane);

  /// With which the upper grip pulls along y [N]; below 0 it presses.
  double grip_force(int lane) const;

  /// The books of a lane now; step, time, tip and speed included.
  results::Sample sample(int lane, results::Phase phase);

  /// Of a beam that nothing has softened [J].
  double beam_energy(int beam, int lane) const {
    return lattice::energy_of(lattice_->beam[beam], strain(beam, lane));
  }

  lattice::Vector6 motion(int element, int lane) const;  // since the unloaded lattice; rotation vector
  lattice::Vector6 velocity(int element, int lane);      // of this moment

  /// Steps since the lane's scenario was put in.
  std::int64_t steps_done(int lane) const { return steps_done_ - born_[lane]; }
  double time(int lane) const { return static_cast<double>(steps_done(lane)) * dt_; }
  double tip(int lane) const {
    return history::tip_at(scenario_[lane].history, crack_time(lane, steps_done_));
  }
  double speed(int lane) const {  // [m/s] of the tip
    return history::speed_at(scenario_[lane].history, crack_time(lane, steps_done_));
  }
  double factor(int crossing, int lane) const {
    return static_cast<double>(factor_[at_crossing(crossing, lane)]);
  }
  double booked(int crossing, int lane) const { return booked_[at_crossing(crossing, lane)]; }
  double& booked(int crossing, int lane) { return booked_[at_crossing(crossing, lane)]; }
  /// Of the faces at a crossing: how far they are apart, and the slip so far [m]; their normal, from the
  /// beam's first element to its second.
  Eigen::Vector3d gap(int crossing, int lane) const;
  Eigen::Vector3d slip(int crossing, int lane) const;
  Eigen::Vector3d normal(int crossing) const { return {normal_[crossing].x(), normal_[crossing].y(), 0.0}; }
  double largest_energy(int lane) const { return ledger_[lane].largest; }

  const lattice::Lattice& lattice() const { return *lattice_; }
  const fracture::LaneScenario& scenario(int lane) const { return scenario_[lane]; }
  const std::vector<fracture::Crossing>& met() const { return met_; }     // in the order the crack meets them
  const std::vector<Softening>& softening() const { return softening_; }  // of the last step
  bool cracking() const { return cracking_; }
  double dt() const { return dt_; }
  int scenarios() const { return static_cast<int>(scenario_.size()); }
  int lanes() const { return lanes_; }
  int threads() const { return static_cast<int>(part_.size()); }

 private:
  double crack_time(int lane, std::int64_t step) const {
    return static_cast<double>(step - crack_start_[lane]) * dt_;
  }
  std::size_t at_crossing(int k, int lane) const { return static_cast<std::size_t>(k) * lanes_ + lane; }
  lattice::Pose pose(int element, int lane) const;
  lattice::BeamStrain strain(int beam, int lane) const;
  void find_beams_at_top();
  void put_to_rest(int lane);
  void set_lane_numbers(int lane);
  void build_parts();
  void set_slips();
  std::vector<double> by_element(AlignedVector<Real> PartRows<Real>::*special_rows) const;
  void set_by_element(AlignedVector<Real> PartRows<Real>::*special_rows, const std::vector<double>& rows);
  void add_up_spent();
  void copy_ghosts();
  void foresee_softening();
  void soften();
  void weigh(double* velocities);
  StepConstants constants() const { return {dt_, beta_before_, beta_after_, grip_before_, grip_after_}; }

  const lattice::Lattice* lattice_;
  double dt_;
  Marching marching_;
  int lanes_, numbers_;  // of the kernel; of an element's position
  Kernel<Real> kernel_;
  std::vector<fracture::LaneScenario> scenario_;
  std::vector<fracture::Crossing> met_;
  std::vector<char> notched_;
  std::vector<Eigen::Vector2d> normal_;  // [crossing], empty where no faces touch
  std::vector<lattice::Vector6> base_;
  std::vector<lattice::DampedBeam> damped_;
  struct AtTop {
    int beam, crossing;  // the latter -1 where the path does not cross it
  };
  std::vector<AtTop> at_top_;  // from the top grip to other elements
  double base_pull_ = 0;       // of the lattice on the top grip along y in the base state [N]

  std::vector<int> cut_;
  std::vector<PartRows<Real>> part_;
  std::unique_ptr<base::ThreadPool> crew_;
  AlignedVector<Real> q_, v_, rate_, per_mass_, factor_, alpha_at_surface_, alpha_elsewhere_;
  AlignedVector<Real> touches_, friction_;  // [lane]
  AlignedVector<Real> slip_, slip_after_;   // [crossing][3][lane]; empty where no faces touch
  AlignedVector<double> mass_, base_rows_, velocity_;
  std::vector<std::uint8_t> top_;

  std::int64_t steps_done_ = 0;
  std::int64_t weighed_at_ = -1, velocities_at_ = -1;  // the steps that energy_ and velocity_ are of
  std::vector<std::int64_t> born_, crack_start_;       // of each lane's scenario
  bool cracking_ = false;
  double beta_before_ = 1, beta_after_ = 1, grip_before_ = 0, grip_after_ = 0;
  std::vector<int> first_standing_;  // per lane, the first crossing beam not yet gone
  std::vector<double> booked_;       // [crossing][lane] energy taken by its release so far [J]
  std::vector<Softening> softening_;
  std::vector<fracture::Ledger> ledger_;
  std::vector<fracture::LatticeEnergy> energy_;
  struct Spent {
    double damping = 0, numerical = 0, contact = 0, grip = 0;
  };
  std::vector<Spent> spent_, pending_;  // by steps done; by the step that ends
  std::vector<double> held_;            // [lane] by the faces now [J]
  std::vector<double> inherited_;       // [lane] by the faces from the beams as they softened, so far [J]
};

}  // namespace rift::ensemble

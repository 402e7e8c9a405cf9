#pragma once

#include "engine/base/thread_pool.hpp"
#include "engine/ensemble/part_rows.hpp"
#include "engine/fracture/release.hpp"

#include <functional>
#include <memory>
#include <optional>
#include <vector>

namespace rift::ensemble {

/// Where all lanes are: positions, velocities and what is left of the damageable beams' stiffness. They are
/// stored as changes since the base state (the pre-stress), so that single precision loses nothing against
/// it, and as [element][component][lane], so that the kernels read every beam once for all lanes. Numbers at
/// this face are doubles.
class State {
 public:
  State(const lattice::Lattice& lattice, std::vector<fracture::DamageableBeam> damageable, int scenarios,
        const EnsembleOptions& options);

  /// Puts all lanes at rest in a base state whose forces are taken as balanced. @param[in] base  N [m, rad]
  void set_base(const std::vector<lattice::Vector6>& base);
  /// Damps these beams; those that were damped before must be among them. The accounts begin anew.
  void set_damped(const std::vector<lattice::DampedBeam>& damped);
  /// Takes a lane's damping and friction from its scenario.
  void set_lane(int lane, const fracture::LaneScenario& scenario);
  /// Puts a lane at rest in the base state, nothing of it damaged but what is absent from there on.
  void put_to_rest(int lane);
  /// Moves all lanes. @param[in] moved  N [m, rad], since the unloaded lattice; the base state must be 0
  void set_motion(const std::vector<lattice::Vector6>& moved);
  /// @param[in] velocity  [element][6][lane] [m/s, rad/s]
  void set_velocities(const AlignedVector<double>& velocity);
  /// @param[in] velocity  N [m/s, rad/s]
  void set_velocities(int lane, const std::vector<lattice::Vector6>& velocity);
  void set_top_velocity(double speed);  // along y [m/s]
  /// Forces from outside [N, N m] of N elements for a unit of a lane's load; before set_base().
  void set_outside(std::vector<lattice::Vector6> forces);
  /// Elements that keep their x and do not turn about y and z: they roll on a face across x; before
  /// set_base().
  void set_rollers(const std::vector<int>& elements);
  void set_load(int lane, double size);
  double load(int lane) const { return arrays_.load[lane]; }
  /// What a unit of load has done in the step of `dt` [s] that has just been made [J].
  double work_of_unit_load(int lane, double dt) const;
  void set_factor(int k, int lane, double factor);
  /// Makes room for rates that differ from the velocities, as they do with beta other than 1.
  void keep_rates();

  /// Moves all lanes on by a step, with its accounts where something dissipates or the grip moves; costs
  /// nothing where evaluate_energies() has made this very step already.
  void advance(const StepConstants& constants);
  /// Evaluates the accounts of energies at this moment, and with the same look at the beams the step that
  /// comes. @param[out] velocities  [element][6][lane], may be null
  void evaluate_energies(const StepConstants& constants, double* velocities);
  /// An account of a lane, chunk by chunk added to `sum` [J].
  double add_account(Account account, int lane, double sum = 0.0) const;

  lattice::Vector6 motion(int element, int lane) const;  // since the unloaded lattice; rotation vector
  lattice::BeamStrain strain(int beam, int lane) const;
  /// Before the step of `dt` [s] that has just been made; in linear kinematics.
  lattice::BeamStrain strain_before(int beam, int lane, double dt) const;
  /// Equivalent opening sqrt(2 U / k_a) of a damageable beam in tension, of the energy U that it would have
  /// undamaged [m]; 0 of one that is pressed. In linear kinematics.
  double opening(int k, int lane) const;
  /// Appends, where beams break by themselves, the whole ones that may have been opened by more than half of
  /// what softens them as the last step began, in any order, as places among the damageable beams. None that
  /// was opened by more is missing.
  void add_watched(int lane, std::vector<int>& k) const;
  /// Energy that a beam would have undamaged [J].
  double beam_energy(int beam, int lane) const {
    return lattice::energy_of(lattice_->beam[beam], strain(beam, lane));
  }
  double factor(int k, int lane) const { return arrays_.factor[at(k, lane)]; }
  /// A factor as this precision holds it.
  double rounded(double x) const {
    return options_.precision == Precision::double_precision ? x : static_cast<double>(static_cast<float>(x));
  }
  Eigen::Vector3d gap(int k, int lane) const;   // of the faces of a damageable beam [m]
  Eigen::Vector3d slip(int k, int lane) const;  // along them so far [m]
  /// What the account `elastic` leaves out: the intact beams' energy in the base state and what the top
  /// grip's rise since then does against the base state's pull, both 0 in corotational kinematics [J].
  double base_energy(int lane) const;
  double grip_force(int lane) const;  // of the top grip along y [N]; below 0 it presses
  double base_pull() const {
    return base_pull_;
  }  // of the lattice on the top grip along y in the base state [N]

  const lattice::Lattice& lattice() const { return *lattice_; }
  const EnsembleOptions& options() const { return options_; }
  const std::vector<fracture::DamageableBeam>& damageable() const { return damageable_; }
  int lanes() const { return lanes_; }  // of the kernel
  int threads() const { return static_cast<int>(part_.size()); }

  void save(NamedNumbers& state) const;
  /// Throws std::invalid_argument where the numbers are not of such a state.
  void restore(const NamedNumbers& state);

 private:
  const Numbers& rates() const { return arrays_.rate.empty() ? arrays_.v : arrays_.rate; }
  std::size_t at(int k, int lane) const { return static_cast<std::size_t>(k) * lanes_ + lane; }
  int position_numbers() const { return options_.kinematics == lattice::Kinematics::linear ? 6 : 7; }
  lattice::Pose pose(int element, int lane) const;
  /// A function of a beam and its two ends, be they motions or poses.
  template <class Function>
  auto of_ends(const Function& function, int beam, int lane) const;
  void find_beams_at_top();
  void sum_base_energy();
  void find_base_openings();
  void build_parts();
  bool corotational() const { return options_.kinematics == lattice::Kinematics::corotational; }
  using CopyOfRow = std::function<void(std::size_t from, std::size_t to, std::size_t count)>;
  void copy_ghosts(const CopyOfRow& copy, int numbers);
  void copy_ghosts(Numbers& state, int numbers);
  void prepare_walk(const StepConstants& constants);
  StepConstants with_balance(StepConstants constants) const;
  using Elements = std::vector<std::int32_t> Part::*;
  std::vector<double> by_element(Numbers Part::*rows, Elements elements) const;
  void set_by_element(Numbers Part::*rows, Elements elements, const std::vector<double>& numbers);

  const lattice::Lattice* lattice_;
  EnsembleOptions options_;
  int lanes_;
  std::vector<fracture::DamageableBeam> damageable_;
  std::vector<lattice::Vector6> base_;
  std::vector<lattice::DampedBeam> damped_;
  std::vector<lattice::Vector6> outside_;  // N forces for a unit of load, or none
  std::vector<int> loaded_;                // the elements that have any
  /// What the opening of a damageable beam is made of.
  struct OpeningRow {
    int i, j;
    double axis[3], two_per_length, bending, twist;  // the latter two over k_a: 2 w / k_a, k_t / k_a [m2]
  };
  std::vector<OpeningRow> opening_row_;  // [damageable]
  template <class Real>
  double opening_of(const OpeningRow& beam, int lane) const;
  // Where beams break by themselves, [damageable]:
  std::vector<std::vector<double>> first_opening_;  // of each lane: what softens them [m]
  std::vector<double> base_opening_;                // in the base state [m]
  double watch_above(int k, int lane) const;
  void set_left(int k, int lane);
  struct TopBeam {
    int beam, k;  // the latter -1 where nothing damages it
  };
  std::vector<TopBeam> top_beam_;  // from the top grip to other elements
  double base_pull_ = 0, base_energy_ = 0;
  StateArrays arrays_;
  /// Of the step that evaluate_energies() has made ahead; none where the state has changed since.
  std::optional<StepConstants> ahead_;
  std::vector<int> cut_;  // first elements of the parts, and N
  std::vector<std::unique_ptr<Part>> part_;
  std::unique_ptr<base::ThreadPool> threads_;
};

}  // namespace rift::ensemble

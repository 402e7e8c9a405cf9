#pragma once

#include "engine/ensemble/state.hpp"
#include "engine/fracture/energy_balance.hpp"

#include <vector>

namespace rift::ensemble {

/// The energy balances of all lanes, in the lattice's units   [model.md §7]: every term is summed where the
/// energy goes, in double whatever the state is.
class Balances {
 public:
  /// @param[in] damageable  beams;  @param[in] lanes  of the kernel
  Balances(std::size_t damageable, int lanes, int scenarios);

  /// Forgets what a lane has gained and lost.
  void clear(int lane);
  /// Opens a lane's balance with the energies that were read last.
  void open(int lane);
  /// Takes over the accounts of the steps done, which begin anew then.
  void collect(const State& state);
  /// Reads the energies that the state has evaluated. @param[in] grip_work  of the step that ends, by the
  /// base state's pull [J]
  void read(const State& state, double grip_work);
  /// Adds the work of all lanes' top grips against the base state's pull [J].
  void add_grip_work(double work);
  /// Adds the work that a lane's forces from outside have done [J].
  void add_outside_work(int lane, double work) { lane_[lane].so_far.grip += work; }
  /// Adds the energy that a damaged beam has lost [J]. @param[in] to_faces  given to its faces, of all that
  /// it lost
  void add_fracture(int k, int lane, double energy, double to_faces);

  /// A lane's balance, as it was read last.
  const fracture::EnergyBalance& of(int lane);
  /// Energy that a beam has lost by its damage so far [J].
  double fracture_energy(int k, int lane) const {
    return fracture_energy_[static_cast<std::size_t>(k) * lanes_ + lane];
  }

  void save(NamedNumbers& state) const;
  /// Throws std::invalid_argument where the numbers are not of such balances.
  void restore(const NamedNumbers& state);

 private:
  struct Dissipated {
    double damping = 0, numerical = 0, contact = 0, grip = 0;
  };
  struct Lane {
    fracture::EnergyBalance balance;
    Dissipated so_far, pending;             // by the steps done; by the step that ends
    double contact_energy = 0;              // held by the faces now
    double contact_energy_from_damage = 0;  // given to them by beams as they were damaged, so far
  };
  int lanes_;
  std::vector<Lane> lane_;
  std::vector<double> fracture_energy_;  // [damageable][lane]
};

}  // namespace rift::ensemble

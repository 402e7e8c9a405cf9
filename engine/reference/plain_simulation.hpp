#pragma once

#include "engine/fracture/crack_path.hpp"
#include "engine/fracture/energy_balance.hpp"
#include "engine/fracture/release.hpp"
#include "engine/lattice/forces.hpp"

#include <cstdint>
#include <vector>

/// The method as one reads it: a line of code for each line of Table 1 of the paper.
namespace rift::reference {

/// One scenario, element by element and beam by beam, forces first and energies from the strains: slow, and
/// what the ensemble is held against and its speed is measured against. Linear kinematics, no contact of
/// faces; the lattice must outlive it. Arrays hold 6 numbers an element: displacement [m] and rotation [rad],
/// or their rates, forces [N] and moments [N m].
struct PlainSimulation {
  const lattice::Lattice* lattice;
  double dt;        // [s]
  double beta = 1;  // of eq. (2); below 1 damps
  fracture::LaneScenario scenario;
  std::vector<fracture::DamageableBeam> damageable;
  std::vector<int> intact_beam;
  std::vector<lattice::BeamRow> intact;
  std::vector<double> factor, fracture_energy;  // [damageable] of the stiffness; lost by damage so far [J]
  std::vector<double> mass, per_mass;           // of each of 6 N motions; 0 where gripped
  std::vector<double> q, v, f, rate;            // 6 N
  lattice::ViscousDamping damping;
  std::int64_t steps_done = 0, crack_start = 0;
  bool cracking = false;
  double grip_speed = 0;                                       // [m/s]
  double viscous_work = 0, numerical_work = 0, grip_work = 0;  // so far [J]
  fracture::EnergyBalance balance;                             // as it was evaluated last

  PlainSimulation(const lattice::Lattice& lattice, std::vector<fracture::DamageableBeam> damageable,
                  double dt, const fracture::LaneScenario& scenario);
  /// Starts at rest. @param[in] displacement  N [m, rad]
  void start_from(const std::vector<lattice::Vector6>& displacement);
  void start_crack(std::vector<lattice::DampedBeam> damped);
  /// One step of Table 1 of the paper. Cost O(beams); allocates nothing once some beams were damaged.
  void step();
  void set_grip_speed(double speed);
  const fracture::EnergyBalance& evaluate_balance();
  lattice::Vector6 motion(const std::vector<double>& array, int element) const {
    return Eigen::Map<const lattice::Vector6>(array.data() + 6L * element);
  }

 private:
  struct Damage {
    int k;  // of the damageable beams
    double after;
    lattice::BeamStrain strain;  // before the elements move
  };
  std::vector<Damage> damage_;  // of this step

  lattice::BeamStrain strain(int k) const;
  void predict_damage();
  void move();
  void apply_damage();
  void balance_forces();
  void accelerate();
  void add_grip_work();
};

}  // namespace rift::reference

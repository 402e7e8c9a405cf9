#pragma once

#include "engine/ensemble/ensemble.hpp"
#include "engine/lattice/forces.hpp"

namespace rift::ensemble {

/// One scenario, element by element and beam by beam, forces first and energies from the strains: slow, and
/// what the ensemble is held against. Linear kinematics; the lattice must outlive it.
struct PlainSimulation {
  const lattice::Lattice* lattice;
  double dt;        // [s]
  double beta = 1;  // of eq. (2); below 1 damps
  fracture::LaneScenario scenario;
  std::vector<fracture::Crossing> met;
  std::vector<int> sound_beam;
  std::vector<lattice::BeamRow> sound;
  std::vector<double> factor, booked;           // [crossing]
  std::vector<double> mass, per_mass;           // of each of 6 N motions; 0 where gripped
  std::vector<double> q, v, f, rate, v_before;  // 6 N
  lattice::ViscousDamping damping;
  std::int64_t steps_done = 0, crack_start = 0;
  bool cracking = false;
  double grip_speed = 0;  // [m/s]
  std::vector<Softening> softening;
  fracture::Ledger ledger;
  double viscous_work = 0, numerical_work = 0, grip_work = 0;

  PlainSimulation(const lattice::Lattice& lattice, const fracture::CrackPath& path, double notch_end,
                  double dt, const fracture::LaneScenario& scenario);
  void start_from(const std::vector<lattice::Vector6>& displacement);
  void start_crack(std::vector<lattice::DampedBeam> damped);
  void step();
  void set_grip_speed(double speed);
  fracture::LatticeEnergy energy() const;
  results::Sample sample();
  double crack_time(std::int64_t step) const { return static_cast<double>(step - crack_start) * dt; }
  lattice::Vector6 motion(const std::vector<double>& array, int element) const {
    return Eigen::Map<const lattice::Vector6>(array.data() + 6L * element);
  }

 private:
  lattice::BeamStrain strain(int k) const;
  void foresee_softening();
  void move();
  void soften();
  void balance_forces();
  void accelerate();
  void book_grip_work();
};

}  // namespace rift::ensemble

#pragma once

#include "engine/fracture/crack_history.hpp"
#include "engine/fracture/crack_path.hpp"
#include "engine/fracture/ledger.hpp"
#include "engine/fracture/release.hpp"
#include "engine/mechanics/damping.hpp"
#include "engine/mechanics/forces.hpp"

#include <array>
#include <cstdint>
#include <vector>

namespace rift {

/// What distinguishes one lane from another.
struct LaneScenario {
  CrackHistory history;
  ReleaseLaw law;
  double alpha_at_surface = 0, alpha_elsewhere = 0;  // fractions of critical damping
};

/// A change of one crossing beam's stiffness in one step, and its strain before the elements move.
struct Softening {
  int crossing = 0, lane = 0;
  double before = 1, after = 1;
  BeamStrain strain;
};

/// Scenarios that march in lock-step over one lattice with one step; a scenario is a lane. State is stored
/// [element][6][lane]: displacement u [m], then rotation theta [rad], since the unloaded lattice.
///
/// Plain data: step() moves it on, energy() and sample() look at it. The lattice must outlive it.
template <int Lanes>
struct Simulation {
  const Lattice* lattice = nullptr;
  double dt = 0;    // [s]
  double beta = 1;  // of eq. (2); below 1 damps
  std::array<LaneScenario, Lanes> scenario;

  std::vector<int> sound_beam;                // beams that the path does not cross, and their rows
  std::vector<BeamRow> sound;                 // beams that the path does not cross
  std::vector<BeamRow> crossing;              // beams that it crosses, in the order the crack meets them
  std::vector<Crossing> met;                  // which beams those are, and where
  std::vector<double> factor;                 // [crossing][lane] Y1/Y2
  std::vector<double> booked;                 // [crossing][lane] energy taken by its release so far [J]
  std::array<int, Lanes> first_standing{};    // per lane, the first crossing beam not yet gone
  std::vector<double> per_mass, per_inertia;  // 1/m, 1/I of each element, 0 where gripped
  ViscousDamping<Lanes> damping;

  std::int64_t steps_done = 0;
  std::int64_t crack_start = 0;  // the step at which the crack's clock starts
  bool cracking = false;
  double grip_speed = 0;  // of the top grip along y [m/s]: set_grip_speed()
  std::vector<double> q, v, f;
  std::vector<double> rate, v_before;  // (q_{n+1} - q_n)/dt where damped; v_n where beta < 1
  std::vector<Softening> softening;    // of this step
  std::array<Ledger, Lanes> ledger;
  std::array<double, Lanes> viscous_work{}, numerical_work{}, grip_work{};

  Simulation(const Lattice& lattice, const CrackPath& path, double notch_end, double dt,
             const std::array<LaneScenario, Lanes>& scenarios);

  /// Puts every lane at rest in the given displacements and opens the books.
  void start_from(const std::vector<Vector6>& displacement);

  /// Starts the crack's clock at the present step (a(0) of each lane's history is now) and with it the
  /// viscous damping of these beams.
  void start_crack(std::vector<DampedBeam> damped);

  /// One step of Table 1 of the paper. Cost O(beams x lanes); allocates nothing.
  void step();

  /// Moves the top grip along y at `speed` [m/s] from the next step on; 0 holds it.
  void set_grip_speed(double speed);

  double tip(int lane) const { return tip_at(scenario[lane].history, crack_time(steps_done)); }

  LatticeEnergy energy(int lane) const;

  /// The books of a lane now; step, time, tip and speed included. Cost: one look at every beam.
  results::Sample sample(int lane, results::Phase phase);

  double crack_time(std::int64_t step) const { return static_cast<double>(step - crack_start) * dt; }
  std::size_t at(int element, int component, int lane) const {
    return (6UL * element + component) * Lanes + lane;
  }
  Vector6 motion(const std::vector<double>& array, int element, int lane) const;

 private:
  void foresee_softening();
  void move();
  void soften();
  void balance_forces();
  void accelerate();
  void book_grip_work();
};

}  // namespace rift

#pragma once

#include "engine/ensemble/ensemble.hpp"
#include "engine/simulation/prepare.hpp"

#include <cstdint>
#include <optional>

/// The application phase of the paper: cracks whose velocity follows from the toughness of the material,
/// G_ID(v) = G_c(v).
namespace rift::simulation {

/// A tip that runs by itself and has come to rest, or the last place where it did.
struct Rest {
  std::int64_t since = -1;  // the step at which it stopped; -1 while it runs
  double driving = 0;       // G* then [J/m2]
  double reference = 0;     // strain energy ahead of it once its field has spread; 0: not yet known
  double sum = 0;           // of that energy over the looks since the last comparison
  std::int64_t looks = 0;
  double restarted_m = 0;  // tip position of the last restart; 0: none
};

/// A tip that would be slower, in c_r, stops: its history would have no end.
inline constexpr double slowest_by_itself = 0.01;

/// A lane whose crack runs by itself.
struct OwnCrack {
  const Prepared& prepared;
  const LanePlan& plan;
  const ensemble::Ensemble& ensemble;
  const ensemble::PrescribedTips& tips;
  int lane;
  const Rest& rest;

  double tip() const { return tips.tip(lane); }  // [m]
  /// Length over which the release rate is averaged [m].
  double window() const { return plan.scene.crack.toughness_window * prepared.lattice.mean_radius; }
};

/// Whether it is time for a new velocity: several times over one window.
bool asks_for_velocity(const OwnCrack& crack);

/// The velocity in c_r at which the crack releases what the material withstands; none where it stops. The
/// shortest window that lets it run decides: a dip that a longer one does not show is noise.
std::optional<double> velocity_of(const OwnCrack& crack);

/// G* [J/m2] of a crack that stops, from the longest window that is full.
double driving_at_stop(const OwnCrack& crack);

/// Looks at the beams ahead of a resting tip, where it is time to. @return the velocity in c_r with which it
/// restarts
std::optional<double> restart_of(const OwnCrack& crack, Rest& rest, std::int64_t rested);

}  // namespace rift::simulation

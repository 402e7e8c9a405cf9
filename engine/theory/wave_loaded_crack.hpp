#pragma once

#include "engine/theory/wave_speeds.hpp"

#include <vector>

namespace rift::theory {

/// A half-infinite crack in an infinite plate that two plane waves load at one moment, as tractions on both
/// faces of a plate do, and which runs at a constant release rate G_c (Freund 1990, 2.4 and 6.4). With t'
/// since the waves met in the crack's plane, which they ask to bear twice the traction sigma,
///   K(t')^2 / E' = G_c t' / tau,   tau = pi G_c rho c_d / (16 sigma^2)     stationary crack
///   g(v) t' = tau,   g = A_I k^2                                           running crack
struct WaveLoadedCrack {
  double arrival = 0;   // of the waves in the crack's plane, after the tractions were put on [s]
  double delay = 0;     // tau: from there to the start of the crack [s]
  double rayleigh = 0;  // c_R [m/s]
  /// Advance [m] and time [s] since the tractions were put on, ascending from the crack's start on.
  std::vector<double> advance = {}, time = {};

  double time_of(double advance_m) const;
  double advance_at(double time_s) const;
};

/// @param[in] traction  sigma [Pa] on each face, at once;  @param[in] height  of the plate [m], the crack in
/// its middle. The tables end at 0.95 c_R. Error of the times below 1e-4 of the time since the start.
WaveLoadedCrack wave_loaded_crack(double young_modulus, double poisson_ratio, double density, Plane plane,
                                  double release_rate, double traction, double height);

}  // namespace rift::theory

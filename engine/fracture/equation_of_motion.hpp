#pragma once

#include <array>
#include <vector>

/// How fast a crack runs that nobody tells: as fast as what it releases is what the material withstands,
/// G_ID(v) = G_c(v)   [Freund 1990, section 7.4, "crack tip equation of motion"].
namespace rift::fracture {

/// What the material withstands: G_c [J/m2] against the tip's velocity, in m/s or in c_r, or against its
/// position [m]; straight between the rows, constant beyond them.
struct CriticalRate {
  enum class Against { velocity, velocity_over_cr, position };
  Against against = Against::velocity_over_cr;
  std::vector<std::array<double, 2>> row = {};
  bool operator==(const CriticalRate&) const = default;
};

/// A beam that the tip has released, and how fast it ran there.
struct ReleasedBeam {
  double position = 0;  // [m]
  double energy = 0;    // [J]
  double over_cr = 0;   // v / c_R
};

/// By which a tip's velocity takes at once from what the same tip would release at rest, 1 - v/c_R
/// [Freund 1990, eq. (6.4.24), approximately].
double response_to_velocity(double over_cr);

/// What the tip would release at rest [J/m2]: the released energies, each over the response to its velocity,
/// in a window behind the tip with weights 6 x (1 - x) that are 0 at its ends.
/// @param[in] released   those within the window
/// @param[in] thickness  b [m], of all tips that advance together
double driving_force(const std::vector<ReleasedBeam>& released, double tip, double window, double thickness);

/// How far chance may have moved it [J/m2]: the standard error that the weighted energies would have if each
/// beam's were drawn by itself. It falls with the root of the window's length. Neighbours share what there
/// is, so that the true error is smaller.
double driving_force_error(const std::vector<ReleasedBeam>& released, double tip, double window,
                           double thickness);

/// G_c [J/m2] at a velocity and a position [m].
double critical_rate(const CriticalRate& toughness, double over_cr, double rayleigh_speed, double position);

/// What is withstood in the window behind the tip, with the same weights as what is released there. Only a
/// rate against the position is averaged: one against the velocity is of the velocity that is looked for.
CriticalRate in_window(const CriticalRate& toughness, double tip, double window);

/// v / c_R in [0, fastest] with driving (1 - v/c_R) = G_c(v): of several the highest, for a tip that runs; 0
/// where even at rest it does not suffice, the crack is arrested then.
double velocity_over_cr(double driving, const CriticalRate& toughness, double rayleigh_speed, double position,
                        double fastest);

}  // namespace rift::fracture

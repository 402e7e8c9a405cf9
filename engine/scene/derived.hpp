#pragma once

#include "engine/scene/parameters.hpp"
#include "engine/scene/preset.hpp"
#include "engine/scene/scene.hpp"

#include <array>
#include <optional>
#include <set>
#include <string>
#include <vector>

namespace rift::scene {

// What follows from a scene by itself, without a lattice. All ask for a scene without issues.

/// Whether the specimen is one that `rift run` can crack: a box with grips.
bool can_crack(const Scene& scene);

/// Whether beams break by themselves, wherever they are, and no crack is moved along a path.
bool breaks_freely(const Scene& scene);

/// The space that the packing fills.
packing::Box box_of(const Scene& scene);

packing::PackingRequest request_of(const Scene& scene);

/// Thickness of the plate [m]: as given, or B = 2 mm sqrt(20,000 L H / (N 200 mm 40 mm)) (layers/2)^(3/2)
/// [model.md §1], which keeps `layers` elements through the thickness for any N.
double thickness_m(const Scene& scene);

/// Mean radius [m] to be expected of the packing, from a solid fraction of 0.615 (measured, model.md §1):
/// (4/3) pi <r^3> N = 0.615 V, with <r^3> = R^3 (1 + s^2) for radii uniform in R (1 +- s), R^3 exp(3 s^2) for
/// log-normal ones.
double expected_mean_radius_m(const Scene& scene);

/// Length of the damage zone [m] to be expected, L_CZM = r_l R with that mean radius; 0 for simple release.
double expected_zone_m(const Scene& scene);

/// Density [kg/m3], as given or rho = G / c_s^2 with c_s from the Rayleigh speed   [model.md §5]
double density(const Scene& scene);

/// Rayleigh speed c_r [m/s], as given or from the density   [model.md §5]
double rayleigh_speed(const Scene& scene);

/// A speed in m/s, c_r where it is relative being `rayleigh_speed` [m/s].
double speed_m_s(const Speed& speed, double rayleigh_speed);

/// No crack that runs by itself is faster, in c_r.
inline constexpr double fastest_by_itself = 0.95;

/// The tip's course along its measured history, from crack.start on. Asks for a history whose rows are in
/// order.
history::SmoothedHistory smoothed_history(const Scene& scene);

/// What a load curve's clock shows as the crack starts [s]: a measured history's first time, else 0.
double load_time(const Scene& scene);

/// The load of a curve [m or N], straight between its rows and as at its ends beyond them.
double load_at(const LoadCurve& curve, double time);

/// The pull of the top grip as the crack starts [N], where the scene gives one.
std::optional<double> force_at_start(const Scene& scene);

/// Its displacement then [m], where the scene gives no force.
double displacement_at_start(const Scene& scene);

/// Whether the top grip moves while the crack runs.
bool grip_moves(const Scene& scene);

/// Whether one velocity is prescribed from the start to the end.
bool keeps_its_velocity(const Scene& scene);

/// The highest velocity of the crack's pieces or of its measured course, or that it may take by itself, in
/// c_r.
double highest_velocity(const Scene& scene);

/// Height of the straight crack path [m]; NaN of one through points.
double path_height_m(const Scene& scene);

/// The line of the crack as points (x, y) [m], straight from one to the next.
std::vector<std::array<double, 2>> path_points_m(const Scene& scene);

double path_length_m(const Scene& scene);

/// Window of the plateau in fractions of the length: as given, or 0.2 to 0.4, or 0.4 to 0.6 where the crack
/// is faster than 0.8 c_r   [model.md §7]. With two tips, where it is of half lengths: from five damage
/// zones (simple: five mean radii) past the start, where the zone no longer matters, to the first echo, up to
/// which the plate is as good as infinite   [model.md §9.5]; from the expected mean radius, so that it
/// follows from the scene alone. NaN there where the crack changes its velocity on the way. A measured
/// history and a crack that runs by itself have the whole of their way.
std::array<double, 2> window_over_length(const Scene& scene);

/// The least length [m] of that window: two damage zones, and ten mean radii, so that each of the ten
/// sub-windows holds a beam or two at either tip.
double shortest_window_m(const Scene& scene);

/// How far a tip can run [m]: the length of the path, with two tips half of it.
double tip_path_length_m(const Scene& scene);

/// Where the crack's way ends [m]: as given; or with the measured course, for a crack that runs by itself
/// with the path, else with the window.
double crack_end(const Scene& scene);

/// Tip position at which the first echo of the crack's start is back [m], after theory::echo_free_advance.
/// With two tips it is a half length, and the ends of the plate are L/2 from the middle.
/// NaN where the crack changes its velocity on the way or its path is not straight, infinity where no wave
/// catches up with it.
/// @param[in] faster  speed of the plate's waves over that of the material's, whose beams may be stiffer
double echo_free_tip_m(const Scene& scene, double faster = 1.0);

/// A number that follows from several keys, and the numbers it may be: each key alone may be fine and what
/// follows from all of them too large or too small to be computed with.
struct DerivedNumber {
  std::string name;  // with its article: "a mean radius"
  double value = 0;
  Range range;
  std::string unit;               // empty of a bare number
  std::vector<std::string> keys;  // that it follows from, the one that matters most first
};

/// What is wrong with the number, or nothing where it lies in its range. NaN lies in none. Of its keys the
/// issue points at the one that the user gave and whose value is furthest from its default; the text names
/// the others, the number and its range.
std::optional<Issue> range_issue(const Preset& preset, const Scene& scene, const DerivedNumber& number);

/// The issues of those that are out of their ranges, one for each key that is to blame: what follows from a
/// number that is out of its range is out of its own, too.
std::vector<Issue> range_issues(const Preset& preset, const Scene& scene,
                                const std::vector<DerivedNumber>& numbers);

/// All that follows from the preset's scene without a lattice: thickness, mean radius, elastic moduli,
/// density, wave speeds, strain, damage zone; those but for which a key is among the `invalid`.
std::vector<DerivedNumber> derived_numbers(const Preset& preset, const std::set<std::string>& invalid);

/// Of the Young's modulus of beams [Pa], given or derived.
inline constexpr Range micro_modulus_range{1e-6, 1e18};

/// Of the grip's displacement over the height, whatever its sign: corotational beams know the strain as the
/// difference of two lengths, which rounding ends at 1e-16 of them, and single precision ends at 1e-38.
Range strain_range(const Scene& scene);

}  // namespace rift::scene

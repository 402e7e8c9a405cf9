#pragma once

#include "engine/ensemble/instruction_set.hpp"
#include "engine/fracture/cohesive_law.hpp"
#include "engine/fracture/crack_path.hpp"
#include "engine/fracture/equation_of_motion.hpp"
#include "engine/fracture/release.hpp"
#include "engine/history/crack_history.hpp"
#include "engine/lattice/beam.hpp"
#include "engine/packing/packing.hpp"
#include "engine/theory/wave_speeds.hpp"

#include <array>
#include <optional>
#include <string>
#include <vector>

namespace rift::scene {

enum class StiffnessChoice { in_situ, bulk, calibrated, explicit_values };
enum class LoadingMethod { static_solve, ramp };
enum class DampingRegion { none, surface, all };
enum class ReleaseRateReference { strip, griffith };
enum class GripRotation { held, free };

/// A speed [m/s], or a fraction of the Rayleigh speed c_r where `relative`.
struct Speed {
  double value = 0.0;
  bool relative = false;
  bool operator==(const Speed&) const = default;
};

/// One stretch of the crack's history: `speed` until the tip reaches `until` [m]; the last stretch has no
/// end.
struct VelocityPiece {
  Speed speed;
  std::optional<double> until;
  bool operator==(const VelocityPiece&) const = default;
};

/// The line that the crack follows: straight along x at height `value`, a length [m] or a fraction of the
/// plate's height; or through points (x, y) [m] where there are any.
struct CrackLine {
  double value = 0.5;
  bool relative = true;
  std::vector<std::array<double, 2>> point = {};
  bool operator==(const CrackLine&) const = default;
};

enum class PathShape { polyline, spline };

/// A measured load: displacement [m] or force [N] of the top grip against time [s], straight between the
/// rows.
struct LoadCurve {
  enum class Of { displacement, force };
  Of of = Of::displacement;
  std::vector<std::array<double, 2>> row = {};
  bool operator==(const LoadCurve&) const = default;
};

/// All that a preset says, in SI units: what the run depends on, and how it is shown.
/// Each member is one row of the parameter table (scene/parameters), which holds its key, unit, default,
/// range and doc.
struct Scene {
  struct Specimen {
    packing::Shape shape;
    double length, height;  // [m]; of a cylinder the diameter and the height, of a sphere the diameter
    std::optional<double>
        layers;  // elements through the thickness; fixes the thickness (physics: B ~ (L H / N)^1/2)
    std::optional<double> thickness;  // [m]; excludes layers
    int elements;
    packing::Radii radii;
    double radius_spread;  // uniform: within +- this fraction of the mean; log-normal: deviation of ln r
    double coordination;   // 2 contacts / N, walls not counted
    std::optional<double> solid_fraction;  // in place of the coordination
    double contact_tolerance;
    long seed;
  } specimen{};
  struct Material {
    double young_modulus;  // [Pa]
    double poisson_ratio;
    theory::Plane plane;
    std::optional<double> rayleigh_speed;  // [m/s]
    std::optional<double> density;         // [kg/m3]; excludes rayleigh_speed
    StiffnessChoice stiffness;
    std::optional<double> micro_young_modulus;  // [Pa]; these three with stiffness = "explicit" only
    std::optional<double> micro_poisson_ratio, micro_radius_ratio;
  } material{};
  struct Loading {
    double displacement;             // [m] of the top face along y, in its middle; below 0 it is pressed
    std::optional<double> force;     // [N] of the top grip at the crack's start, in place of the displacement
    LoadCurve curve;                 // in place of both
    std::optional<double> traction;  // [Pa] on top and bottom, in place of the grips; from the start on
    double rise_time;                // [s] in which the traction rises
    bool rollers;                    // on the left and the right face, with a traction
    double shear;                    // of the displacement, along x beside it
    double tilt;                     // of the displacement, more at the right end and less at the left one
    GripRotation grip_rotation;      // whether the elements of the grips may turn
    LoadingMethod method;
    int ramp_steps, hold_steps;
    double ramp_beta;  // numerical damping while ramping and holding, taken out before the crack starts
  } loading{};
  struct Crack {
    std::vector<VelocityPiece> velocity;
    std::vector<history::HistoryPoint> history;  // measured, in place of the velocity
    history::Smoothing smoothing;
    double history_gap;                // longest time between two rows, in times of the median
    fracture::CriticalRate toughness;  // where it has rows the crack runs by itself
    double toughness_window;           // [mean radii] over which its release rate is smoothed
    CrackLine path;
    PathShape path_shape;
    double start;               // [m]; of the tip, with two tips the half length
    std::optional<double> end;  // [m]; the end of the window where absent
    int tips;
    fracture::Technique technique;
    fracture::ReleaseOrder release_order;
    double relaxation;               // the exponent p of Y1/Y2 = (1 - b/l)^p
    double damage_zone_ratio;        // r_l = L_CZM / R_mean
    std::optional<double> friction;  // mu of the faces; without it they do not touch
  } crack{};
  /// What breaks the beams.
  struct Fracture {
    fracture::FractureLaw law;
    std::optional<double> release_rate;  // G_c [J/m2]
    std::optional<double> strength;      // sigma_t [Pa]
    double kappa;                        // energy of breaking a beam over G_c times its area
    std::optional<double> duration;      // [s] of a run whose crack nobody moves
  } breaking{};
  struct Damping {
    double alpha;  // fraction of critical
    DampingRegion region;
    double surface_width;  // [mean radii]
  } damping{};
  struct Solver {
    lattice::Kinematics kinematics;
    ensemble::Precision precision;
    std::optional<double> dt;           // [s]; excludes dt_fraction
    std::optional<double> dt_fraction;  // of the undamped critical step
    double beta;
  } solver{};
  struct Output {
    int samples, frames;
    std::vector<std::string> fields;              // of "displacement", "velocity", "damage", "energy"
    std::optional<std::array<double, 2>> window;  // fractions of the length
    ReleaseRateReference g_i0_reference;
    std::vector<std::array<double, 2>> gauges;  // (x, y) [m]
    double gauge_length;                        // [mean radii], its diameter
  } output{};
  /// What `rift calibrate` does with cylinders of this specimen's proportions.
  struct Calibration {
    std::vector<double> sizes;          // elements of the cylinders whose E and nu are to converge
    int packings;                       // of each size
    int elements;                       // of the cylinders that scan the beams
    std::vector<double> radius_ratios;  // r_mu of the scan
  } calibration{};
  /// How a film of the run is to look; no number of the run depends on it.
  struct Film {
    std::string title;
    std::string field, colours, camera, beams;  // names of the renderer's (viz/)
    double magnification;
    double close_up;  // [m]
    bool chart, boundaries;
  } film{};
};

}  // namespace rift::scene

#pragma once

#include "engine/base/cache.hpp"
#include "engine/scene/preset.hpp"
#include "engine/simulation/march.hpp"
#include "engine/simulation/record.hpp"

#include <filesystem>
#include <functional>
#include <string_view>
#include <vector>

/// Which critical release rate a material showed along a measured crack history (the generation phase), and
/// whether a crack that is given it runs as the measured one did (the application phase).
namespace rift::experiment {

struct ExperimentOptions {
  int resamples = 12;  // histories drawn anew from their noise
  int specimens = 3;   // packings, the preset's among them
  bool application = true;
  int threads = 0;
};

/// What is known of G_IDc where the tip was at one position. Uncertainties are standard ones; that of packing
/// is the standard deviation of the specimens, widened by Student's factor for their small number.
struct CriticalPoint {
  double position = 0, time = 0, over_cr = 0;  // [m], [s] of the measurement, v / c_R
  /// G_I0(a), of a slow crack under the same grips, mean of the specimens; its uncertainty, of packing and of
  /// the window [J/m2].
  double quasi_static = 0, quasi_static_uncertainty = 0;
  double as_paper = 0;  // what the lattice's zone takes, mean of the specimens [J/m2]
  double of_noise = 0, of_packing = 0, of_window = 0, uncertainty = 0;  // of as_paper [J/m2]
  double efficiency = 1;                                                // of the lattice at this velocity
  double corrected = 0, corrected_uncertainty = 0;                      // as_paper / efficiency [J/m2]
};

/// G_IDc over the whole of the measured crack, the mean of its points. Uncertainties are standard ones of
/// that mean: how far whole curves of other resamples, specimens and windows lie from it.
struct CriticalMean {
  double from = 0, to = 0;                                              // tip positions [m]
  double slowest = 0, fastest = 0;                                      // v / c_R
  double as_paper = 0, corrected = 0, efficiency = 1;                   // [J/m2], [J/m2], their ratio
  double of_noise = 0, of_packing = 0, of_window = 0, uncertainty = 0;  // of as_paper [J/m2]
  double of_efficiency = 0, corrected_uncertainty = 0;                  // of corrected [J/m2]
  double deviation_along = 0;  // standard deviation of the corrected points along the crack [J/m2]
};

/// The share of what arrives at the tip that the damage zone takes, at one velocity   [model.md §9.5].
struct EfficiencyPoint {
  double over_cr = 0, efficiency = 0, scatter = 0;
};

/// How a crack ran that was given what was found.
struct Application {
  struct Point {
    double position = 0, over_cr = 0, measured_over_cr = 0,
           lag = 0;              // lag [m]: how far behind the measured tip
    double rate = 0, given = 0;  // what it released, and was given [J/m2]
  };
  std::vector<Point> along;
  double arrested_m = 0;  // NaN where it ran to the end
  double worst_lag = 0;   // largest |lag| [m]
  double velocity_expected =
      0;  // that error as the uncertainties of the law make it, u_v = u / (dG_c/dv + G / (1 - v))
  double velocity_error = 0;  // root of the mean square of v - measured v, over the measured mean
  double rate_error = 0;      // of rate over given, likewise
};

struct Experiment {
  history::SmoothedHistory course;
  std::vector<double> drawn_speed;  // [m/s] standard deviation of the courses' speeds at each point
  double width = 0;                 // over which release rates are read [m]
  double thickness = 0, rayleigh_speed = 0, mean_radius = 0;
  /// Of the preset's specimen, by static pulls: E [Pa], nu, and c_R of long waves [m/s]. NaN where it cannot
  /// be pulled. The velocities above are over the nominal c_R.
  double own_young_modulus = 0, own_poisson_ratio = 0, own_rayleigh_speed = 0;
  std::vector<CriticalPoint> along;  // by position
  CriticalMean mean;
  /// What the material withstands against v / c_R: as_paper [J/m2] averaged over stretches of the velocity,
  /// made to rise by pooling what does not (isotonic regression; Barlow et al. 1972), and its uncertainty;
  /// beyond the measured velocities with its mean slope.
  std::vector<std::array<double, 3>> law;
  std::vector<EfficiencyPoint> efficiency;
  Application application;           // empty where it was not wished
  int resamples = 0, specimens = 0;  // that came to their end
  int resamples_asked = 0;
  double worst_residual = 0;  // the largest balance error of all runs
  simulation::Outcome outcome = simulation::Outcome::finished;
};

/// @param done  of the stage, 0 to 1; answers false to stop (Interrupted is thrown)
using ExperimentProgress = std::function<bool(std::string_view stage, double done)>;

/// Runs it all. The measured crack itself is recorded in folder/run, as `rift run` would; it and all other
/// marches are kept in the folder until forget_parts(), so that a call that was stopped or killed is gone on
/// with by the same one, to the same bits (kept_parts.hpp). Throws Interrupted, InputError and WorldError.
/// @param[in] preset  without issues, with crack.history
Experiment run_experiment(const scene::Preset& preset, const ExperimentOptions& options,
                          const std::filesystem::path& folder, base::Cache& cache,
                          const simulation::BuildInfo& build, const ExperimentProgress& progress);

}  // namespace rift::experiment

#pragma once

#include "engine/scene/preset.hpp"
#include "engine/simulation/prepare.hpp"

#include <Eigen/Core>

#include <array>
#include <string>
#include <vector>

/// Problems with exact solutions or published answers, computed with beams that break by themselves and
/// judged by rules that were fixed before any run.
namespace rift::validation {

/// One packing, as it is or mirrored: the notch then comes from its right face. x counts from the face with
/// the notch.
struct Realisation {
  long seed = 0;
  bool mirrored = false;
  int elements = 0;
};

/// What --set would say of a notched plate to make it this realisation, with enough samples of its energies.
/// @param[in] scene  with a straight notch at half the height
std::vector<std::string> overrides_of(const scene::Scene& scene, const Realisation& realisation);

/// A beam that is gone: when [s], and where its middle was, x from the face with the notch [m].
struct GoneBeam {
  double time = 0;
  Eigen::Vector2d at = Eigen::Vector2d::Zero();
};

/// What a free crack did in one realisation.
struct FreeCrack {
  Realisation realisation;
  double length = 0, height = 0, thickness = 0, notch = 0, mean_radius = 0;  // [m]
  double strength = 0, kappa = 0;               // sigma_t that the lattice resolves [Pa]
  double young_modulus = 0, poisson_ratio = 0;  // the specimen's own, or the material's where not asked for
  std::vector<GoneBeam> gone;                   // in the order of time
  std::vector<std::array<double, 2>> fracture;  // time [s], energy that the beams have lost [J]; ascending
  double balance_error = 0;                     // the worst, of the largest energy
  std::string diverged;                         // why it did; empty where it is finished
};

/// Prepares a realisation and marches its lanes side by side. @param[in] preset  without issues, as
/// overrides_of() makes it
/// @param[in] lanes  scenes that differ in what breaks their beams, or the preset's own alone
/// @param[in] with_constants  measures E and nu of the specimen by two static pulls
/// Throws InputError, PackingError, StaticsError; Interrupted where progress says stop.
std::vector<FreeCrack> run_free_cracks(const scene::Preset& preset, const std::vector<scene::Scene>& lanes,
                                       const Realisation& realisation, bool with_constants,
                                       base::Cache& cache, const simulation::StageProgress& progress,
                                       int threads);

/// Time [s] and position x [m] of the tip each time that it advances: the largest x of a gone beam that has
/// two others within two mean radii.
std::vector<std::array<double, 2>> tip_history(const FreeCrack& crack);

/// Of rows that ascend in both numbers: the first time at which the second is reached, by lines between the
/// rows or, with `at_rows`, of the first row there; NaN where it never is.
double time_reached(const std::vector<std::array<double, 2>>& rows, double value, bool at_rows = false);

/// Of rows of time and value: the value at a time, by lines between the rows; as at their ends beyond them.
double value_at(const std::vector<std::array<double, 2>>& rows, double time);

}  // namespace rift::validation

#pragma once

#include "engine/validation/problems.hpp"

#include <array>
#include <functional>
#include <string>
#include <vector>

namespace rift::validation {

/// The calibration of kappa, the one constant of the cohesive law   [model.md §6]: the energy of breaking a
/// beam is kappa G_c times the area it stands for. It belongs to the lattice and to how finely a crack's zone
/// is resolved, so it is calibrated on a free crack, in Freund's plate that two waves load, and checked at
/// another of each.

/// Values of kappa that each realisation is marched with.
inline constexpr std::array kappas{0.6, 0.7, 0.8, 0.9};

/// What a realisation showed with one kappa; NaN where its tip did not get so far.
struct ToughnessRow {
  double kappa = 0;
  double energy = 0;                                  // lost from 5 to 15 mm, over G_c and the area
  std::array<double, std::size(advances)> late = {};  // time_errors() at `advances`
};

/// Realisations of one number of elements and one resolution.
struct ToughnessGroup {
  int elements = 0, packings = 0;
  double resolved = 0;  // n: mean radii per length of the zone, as of fracture::resolved_radii
  double mean_radius = 0;
  std::vector<std::vector<ToughnessRow>> realisation =
      {};  // of each its kappas; a packing, then its mirror image
};

/// The groups, without results: the one that calibrates, then another n, then another size of elements.
std::vector<ToughnessGroup> planned_toughness(const scene::Scene& scene);

/// Seconds that the groups take with an empty cache, roughly.
double estimated_seconds(const std::vector<ToughnessGroup>& groups);

/// Computes a group, or recalls its realisations from the cache. @param[in] read  the preset with further
/// overrides, as
/// --set has them
void compute_toughness(ToughnessGroup& group,
                       const std::function<scene::Preset(const std::vector<std::string>&)>& read,
                       base::Cache& cache, const simulation::StageProgress& progress, int threads);

/// A value with its standard error.
struct Fitted {
  double value = 0, error = 0;
};

/// The kappa at which the mean energy lost per area is G_c, on the line of least squares through the means at
/// those kappas at which every realisation arrives; its error by leaving out one packing, with its mirror
/// image, at a time. NaN where the energy does not rise with kappa, or fewer than two kappas let all arrive.
Fitted fitted_kappa(const ToughnessGroup& group);

/// The mean of a quantity at a kappa, by lines between those computed, with the standard error of the mean.
/// @param[in] of  ToughnessRow -> double
Fitted mean_at(const ToughnessGroup& group, double kappa,
               const std::function<double(const ToughnessRow&)>& of);

}  // namespace rift::validation

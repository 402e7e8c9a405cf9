#pragma once

#include "engine/validation/free_crack.hpp"

#include <span>
#include <string>
#include <vector>

namespace rift::validation {

enum class Verdict {
  holds,
  does_not_hold,
  reported,   // a figure without a rule
  not_judged  // the rule asks for smaller elements
};
const char* name_of(Verdict verdict);

/// A rule with what it found.
struct Finding {
  std::string rule, measured;
  Verdict verdict = Verdict::reported;
};

/// A problem, computed with elements of several sizes, a few realisations each.
struct Problem {
  enum class Kind { wave_loaded, branching };
  std::string name = {};  // of its preset
  std::string title = {}, source = {}, statement = {};
  Kind kind = Kind::branching;
  int elements = 0;  // with mean radii of at most 0.5 mm, as the rules ask
  long first_seed = 21;
  int packings = 3;
  bool mirrored = false;        // whether each packing is computed mirrored, too
  std::vector<int> finer = {};  // numbers of elements of further sizes
  // Of branching plates:
  double start = 0, start_within = 0;  // of the first beam gone [s]
};

/// All of them, in the order of application.md's list: an exact solution, then the benchmarks of others.
const std::vector<Problem>& problems();

/// The realisations of one number of elements.
std::vector<Realisation> realisations_of(const Problem& problem, int elements);

/// Judges the realisations of one size by the problem's rules, which are fixed here and were before any run.
/// @param[in] scene  of the problem, for its material and load;  @param[in] cracks  at least one
std::vector<Finding> judge(const Problem& problem, const scene::Scene& scene,
                           const std::vector<FreeCrack>& cracks);

// What the rules and the charts of the wave-loaded crack are made of.

/// Advances at which its times are compared [m].
inline constexpr double advances[] = {3e-3, 5e-3, 8e-3, 10e-3, 12e-3, 15e-3};

/// A mean, the standard deviation of one value, and how many there were; NaN values are left out.
struct Spread {
  double mean = 0, deviation = 0;
  int count = 0;
  double error() const;  // of the mean
};
Spread spread_of(const std::vector<double>& values);

/// (t - t_0) / (T - t_0) - 1 of each realisation, by advance: t its time of the advance and T that of the
/// exact solution with the specimen's own constants; NaN where it is not reached. With `by_energy` the time
/// at which the energy lost is that of the advance, in place of the tip's.   @param[in] at  advances [m]
std::vector<std::vector<double>> time_errors(const scene::Scene& scene, const std::vector<FreeCrack>& cracks,
                                             std::span<const double> at, bool by_energy);

/// Energy lost while the tip runs from 5 to 15 mm, over G_c and the area; NaN where it does not get there.
double energy_per_area(const scene::Scene& scene, const FreeCrack& crack);

}  // namespace rift::validation

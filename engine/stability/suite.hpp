#pragma once

#include "engine/scene/scene.hpp"

#include <cmath>
#include <cstdint>
#include <functional>
#include <limits>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace rift::stability {

// The suite of stiff and extreme cases: what each must come to, and what it came to.

/// What a case comes to: its energy balance closes; it does not, though nothing blew up; it is refused before
/// its first step; it diverges and is caught.
enum class CaseEnd { closes, open, refused, diverges };
const char* name_of(CaseEnd ending);

/// What a case must show beside its ending: a number that physics bounds, and what it was.
struct Claim {
  std::string what;          // with its unit, "stored energy over that of nu_mu = 0.3"
  double low = 0, high = 0;  // both allowed
  double seen = std::numeric_limits<double>::quiet_NaN();
  bool holds() const { return seen >= low && seen <= high; }
};

/// @param[in] tolerance  on either side of what is expected
Claim claim_near(std::string what, double seen, double expected, double tolerance);

/// What was seen of a case in one precision.
struct Observed {
  CaseEnd ending = CaseEnd::open;
  double residual = std::numeric_limits<double>::quiet_NaN();  // largest, relative
  double limit = 0;                                            // of the residual
  double growth = std::numeric_limits<double>::quiet_NaN();    // of an amplitude: ln of its factor per step
  double ratio =
      std::numeric_limits<double>::quiet_NaN();  // G_ID / G_I0 with damping, where there is a plateau
  std::int64_t steps = 0;
  std::int64_t caught_within = -1;  // steps from the last good look to the divergence; -1 where none
  std::string said;                 // the refusal, or where it diverged
  double stored = std::numeric_limits<double>::quiet_NaN();  // elastic energy as the crack starts [J]
  double damped = std::numeric_limits<double>::quiet_NaN();  // share of it that viscous damping has taken
  double time_s = std::numeric_limits<double>::quiet_NaN();  // that the crack took
  std::vector<Claim> claims = {};
  double wall_s = 0;
};

/// A case that is computed once in each precision, so that others can be compared with it.
class CachedRun {
 public:
  explicit CachedRun(std::function<Observed(ensemble::Precision)> run) : run_(std::move(run)) {}
  const Observed& of(ensemble::Precision precision);

 private:
  std::function<Observed(ensemble::Precision)> run_;
  std::optional<Observed> seen_[2];
};

struct StabilityCase {
  std::string family, name;
  CaseEnd expected = CaseEnd::closes;
  double growth =
      std::numeric_limits<double>::quiet_NaN();  // that theory expects; NaN where it is not measured
  std::string names = {};                        // what a refusal must say
  std::function<Observed(ensemble::Precision)> run;
  std::optional<CaseEnd> expected_in_single = {};  // where it is another
  /// What it must show beside: of what was seen of it in a precision.
  std::function<std::vector<Claim>(const Observed&, ensemble::Precision)> claims = {};
};

struct StabilityRow {
  std::string family, name;
  CaseEnd expected = CaseEnd::closes;
  double growth = std::numeric_limits<double>::quiet_NaN();
  Observed in_double, in_single;
  bool as_expected = false;
};

/// A divergence must be caught within so many steps of its first sign.
inline constexpr std::int64_t caught_at_most = 200;

/// Growth rates seen are those of theory within this, in double; ten times it in single precision.
inline constexpr double growth_tolerance = 1e-4;

/// The ratio in single precision is that in double within this: its balance may be open by 1e-5 of the energy
/// (measured; 1e-3 is their limit), and the window releases a tenth of it or more.
inline constexpr double single_ratio_tolerance = 1e-3;

/// Whether what was seen is what the case expects of this precision, and all its claims hold.
bool is_as_expected(const StabilityCase& expected, const Observed& seen, ensemble::Precision precision);

/// Runs it in both precisions.
StabilityRow try_case(const StabilityCase& one);

/// How a suite is run.
struct SuiteOptions {
  bool quick = false;  // the drift over 10,000 steps in place of a million, velocities from 0.01 c_r on
  std::string only;    // families whose name contains it; all where empty
};

/// All cases, in the order of their families. Nothing is computed yet.
std::vector<StabilityCase> stability_cases(const SuiteOptions& options);

/// Growth of the highest mode of a lattice over its step, seen and expected: where explicit integration ends.
struct GrowthCurve {
  double element_bound = 0;            // of the step, over the true critical one
  double iterated = 0;                 // the critical step that Lanczos iteration gives, over the true one
  std::vector<double> step;            // over the true critical step
  std::vector<double> seen, expected;  // per step
};
GrowthCurve growth_around_the_limit();

// The families of the suite, each adding its cases.

using Cases = std::vector<StabilityCase>;

void add_free_vibration(Cases& cases, const SuiteOptions& options);  // step, beta, drift
void add_small_lattices(Cases& cases);                       // one beam, chain, cut in two, rattlers only
void add_paths(Cases& cases);                                // along a row of beams, leaving, crossing itself
void add_forced_steps(Cases& cases);                         // refused at the limit, caught beyond it
void add_beams(Cases& cases);                                // E_mu, nu_mu, r_mu, density, an inclusion
void add_packings(Cases& cases);                             // ratio of the radii
void add_damping(Cases& cases);                              // alpha and its shrunken limit
void add_cracks(Cases& cases, const SuiteOptions& options);  // damage zone, velocity, pre-strain

}  // namespace rift::stability

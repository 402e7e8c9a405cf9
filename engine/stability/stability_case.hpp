#pragma once

#include "engine/scene/scene.hpp"

#include <cmath>
#include <cstdint>
#include <functional>
#include <limits>
#include <optional>
#include <string>

/// The suite of stiff and extreme cases: what each must come to, and what it came to.
namespace rift {

/// What a case comes to: its books close; they do not, though nothing blew up; it is refused before its first
/// step; it diverges and is caught.
enum class Ending { closes, open, refused, diverges };
const char* name_of(Ending ending);

/// What was seen of a case in one precision.
struct Seen {
  Ending ending = Ending::open;
  double residual = std::numeric_limits<double>::quiet_NaN();  // largest, relative
  double limit = 0;                                            // of the residual
  double growth = std::numeric_limits<double>::quiet_NaN();    // of an amplitude: ln of its factor per step
  double ratio =
      std::numeric_limits<double>::quiet_NaN();  // G_ID / G_I0 with damping, where there is a plateau
  std::int64_t steps = 0;
  std::int64_t caught_within = -1;  // steps from the last sound look to the divergence; -1 where none
  std::string said;                 // the refusal, or where it diverged
  double wall_s = 0;
};

struct StabilityCase {
  std::string family, name;
  Ending expected = Ending::closes;
  double growth =
      std::numeric_limits<double>::quiet_NaN();  // that theory expects; NaN where it is not measured
  std::string names = {};                        // what a refusal must say
  std::function<Seen(Precision)> run;
  std::optional<Ending> expected_in_single = {};  // where it is another
};

struct StabilityRow {
  std::string family, name;
  Ending expected = Ending::closes;
  double growth = std::numeric_limits<double>::quiet_NaN();
  Seen in_double, in_single;
  bool as_expected = false;
};

/// A divergence must be caught within so many steps of its first sign.
inline constexpr std::int64_t caught_at_most = 200;

/// Growth rates seen are those of theory within this, in double; ten times it in single precision.
inline constexpr double growth_tolerance = 1e-4;

/// Whether what was seen is what the case expects of this precision.
bool is_as_expected(const StabilityCase& expected, const Seen& seen, Precision precision);

/// Runs it in both precisions.
StabilityRow try_case(const StabilityCase& one);

}  // namespace rift

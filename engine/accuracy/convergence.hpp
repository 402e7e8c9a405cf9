#pragma once

#include <string>
#include <vector>

namespace rift::accuracy {

// The limit to which a number tends as its resolution is refined, where it can be told.

/// A number at a resolution.
struct Level {
  double h = 0;            // step, size of an element, ...: 0 is the limit; in any unit
  double value = 0;        // [-]
  double uncertainty = 0;  // standard error of the value, 0 where it is exact but for rounding
};

/// Richardson's extrapolation from the three finest levels, where these show one order:
///   f(h) = f_0 + C h^p,  p = ln((f_3 - f_2) / (f_2 - f_1)) / ln r,  f_0 = f_1 - (f_2 - f_1) / (r^p - 1)
struct Convergence {
  bool clean = false;
  double order = 0;  // p; NaN where it is not clean
  double limit = 0;  // f_0; the finest value where it is not clean, NaN of no levels
  std::string text;  // "observed order 1.98", "no clean order: ..."
};

/// Levels in any order. The order counts as clean where the three finest are a factor r = h_2/h_1 = h_3/h_2
/// apart, both differences exceed twice their uncertainty and 1e-6, 0.5 <= p <= 4.5, and the next coarser
/// level, where it is there at the same factor, shows p within 0.5.
Convergence converge(std::vector<Level> levels);

}  // namespace rift::accuracy

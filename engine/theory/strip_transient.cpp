#include "engine/theory/strip_transient.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace rift::theory {
namespace {

struct Row {
  double v_over_cr, early, late;  // G/G_I0 over 0.2 to 0.4 and 0.4 to 0.6 of the length
};

constexpr std::array table{Row{0.1, 1.000, 0.999}, Row{0.2, 0.999, 0.999}, Row{0.3, 0.999, 0.999},
                           Row{0.4, 0.997, 0.998}, Row{0.5, 1.003, 0.999}, Row{0.6, 0.996, 0.993},
                           Row{0.7, 0.993, 1.015}, Row{0.8, 1.078, 0.960}, Row{0.9, 0.956, 1.106},
                           Row{0.95, 0.615, 0.927}, Row{1.0, 0.04, 0.04}};

}  // namespace

std::array<TransientStretch, 2> strip_transient(double v_over_cr) {
  std::array<TransientStretch, 2> stretch{TransientStretch{0.2, 0.4}, TransientStretch{0.4, 0.6}};
  constexpr double nan = std::numeric_limits<double>::quiet_NaN();
  stretch[0].over_g_i0 = stretch[1].over_g_i0 = nan;
  if (!(v_over_cr > 0.0 && v_over_cr <= table.back().v_over_cr)) return stretch;
  const double v = std::max(v_over_cr, table.front().v_over_cr);
  const auto above = std::find_if(table.begin() + 1, table.end() - 1,
                                  [v](const Row& row) { return v <= row.v_over_cr; });
  const Row &a = *(above - 1), &b = *above;
  const double part = (v - a.v_over_cr) / (b.v_over_cr - a.v_over_cr);
  stretch[0].over_g_i0 = std::lerp(a.early, b.early, part);
  stretch[1].over_g_i0 = std::lerp(a.late, b.late, part);
  return stretch;
}

}  // namespace rift::theory

#pragma once

#include "studio/report/chart.hpp"

namespace rift::studio {

/// Points on curves against tip position where the first echo of the crack's start is back at the tip: up to
/// there a plate of any size would show the same.
ChartSeries echo_marks();

/// Adds the point of a curve (x ascending) at `echo`, in units of its x; none where it is NaN or the curve is
/// elsewhere.
void mark_echo(ChartSeries& marks, const ChartSeries& curve, double echo);

}  // namespace rift::studio

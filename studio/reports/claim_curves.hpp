#pragma once

#include "engine/claims/claims.hpp"
#include "engine/theory/references.hpp"
#include "studio/charts/chart.hpp"

#include <string>
#include <vector>

namespace rift::studio {

/// Dots on curves against tip position where the first boundary reflection reaches the tip: up to there a
/// plate of any size would show the same.
ChartSeries echo_marks();

/// Adds the point of a curve (x ascending) at `echo`, in units of its x; none where it is NaN or the curve is
/// elsewhere.
void mark_echo(ChartSeries& marks, const ChartSeries& curve, double echo);

/// Release rate against tip position, a curve per velocity: the mean over 0.04 of the length and over the
/// specimens, without which a lattice ten elements to 0.01 of the length shows its noise; marked where a
/// boundary's first echo is back. False where there is nothing to draw.
bool draw_ratio_against_position(Chart& chart, const claims::Evidence& evidence, claims::Selection selection);

/// Fracture energy against tip position, of the first specimen.
bool draw_fracture_against_position(Chart& chart, const claims::Evidence& evidence,
                                    claims::Selection selection);

/// Broberg's, Freund's and the strip's release rate over G_I0 against velocity, from rest to c_R.
std::vector<ChartSeries> theory_curves(double poisson_ratio, theory::Plane plane);

/// Mean of the specimens' values with their standard deviation; no bar of a single one.
ChartPoint mean_point(double x, const std::vector<double>& values);

/// A chart of release rates against velocity with Broberg, Freund and the strip limit in it, and nothing else
/// yet.
Chart chart_of_references(const std::string& title);

}  // namespace rift::studio

#pragma once

#include "studio/charts/chart.hpp"
#include "studio/reports/study_families.hpp"
#include "studio/text/table.hpp"

#include <string>
#include <vector>

namespace rift::studio {

// What accuracy costs, of any study: error against run time, and which schemes are efficient.

/// Seconds that a scheme takes for a scenario: a property of the scheme, whoever marched beside it.
double run_time(const study::SummaryRow& row);

/// Fills `error_converged` of the rows that have none and of which the study holds the converged reference:
/// the scenario that is the same in all axes but those of accuracy (elements, dt_fraction, precision,
/// samples) and has the best value of each of these that the study varies. A reference itself keeps none.
study::StudyRows with_converged_errors(study::StudyRows rows);

/// A scheme (all axes but the problem's and the seed) at a problem (crack velocity, path, plate), over its
/// specimens.
struct WorkPoint {
  int scheme = 0, problem = 0;  // places in WorkPrecision
  double run_time_s = 0, ratio = 0;
  double error = 0;    // mean over the specimens, with its sign
  double scatter = 0;  // standard deviation between specimens, NaN of one
  int specimens = 0;
  bool reference = false;  // others are compared with it, so that its own error is not known
  bool efficient = false;  // no other scheme at this problem is both faster and nearer
};

struct WorkPrecision {
  bool converged = false;  // errors against converged references; else differences to Broberg
  std::vector<study::AxisTexts> schemes, problems;
  std::vector<WorkPoint> points;
};

/// @param rows  with their converged errors
WorkPrecision work_precision(const study::StudyRows& rows);

/// Error against run time with the efficient front, a panel for each problem; points bear the numbers of
/// the table. None where nothing can be drawn.
std::vector<NamedChart> work_precision_charts(const WorkPrecision& work);

/// A row for each point, numbered by its scheme as in the charts.
Table work_precision_table(const WorkPrecision& work);

/// What the error is, or how to get one where the study holds no reference.
std::string work_precision_text(const WorkPrecision& work);

}  // namespace rift::studio

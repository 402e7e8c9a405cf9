#pragma once

#include "engine/accuracy/cases.hpp"
#include "engine/accuracy/convergence.hpp"

#include <string>
#include <vector>

/// Errors of tried cases, one kind a factor; the distance to the theory is kept apart from them.
namespace rift::accuracy {

/// All that was found of a case, over its seeds where it has several. Ratios are ratio.
struct AccuracyLine {
  Factor factor = Factor::scene;
  std::string label, cannot_be;
  std::vector<int> results;  // its scenarios, positions in AccuracyRun::results
  int specimens = 0;         // of them with a ratio
  double value = 0;          // what the factor varies: fraction of critical, elements, samples; NaN for words
  double ratio = 0;          // mean over its specimens
  double scatter = 0;        // standard deviation over them, NaN for one
  double error = 0;          // against what its factor is compared with
  double uncertainty = 0;  // standard error of that difference over specimens; 0 on one and the same specimen
  double step_error = 0;   // against the converged step on the scene's own lattice; NaN on another one
  double converged = 0;    // error against the converged reference, all parts together; NaN for another model
  double converged_uncertainty = 0;
  double error_broberg = 0;  // of the ratio; NaN where the theory has no value
  bool reference = false;    // whether the others of its factor are compared with it
  double wall_s = 0;         // marching the crack, and the ramp where there is one; mean over its specimens
  /// True where the error is more than the difference of a few specimens drawn at random.
  bool resolved() const;
};

/// The reference of the lines of a factor.
struct FactorReference {
  Factor factor = Factor::scene;
  std::string text;         // "0.05 of critical, double, same lattice"
  double value = 0;         // a ratio; NaN where each line has its own
  Convergence convergence;  // of time step and elements; its text is empty for the others
};

/// What was found of all cases. A recommendation is -1 where no line is within the goal.
struct Accuracy {
  std::vector<AccuracyLine> lines;         // in the order of the plan
  std::vector<FactorReference> reference;  // of each factor that was tried
  double specimen_scatter = 0;  // standard deviation of the ratio over the finest specimens, NaN of one
  double lattice_error = 0;     // of the scene's number of elements against the finest; NaN where it is that
  double lattice_uncertainty = 0;
  std::vector<int> front;  // lines on the scene's lattice without a cheaper and better one, cheapest first
  int recommended = -1;    // the cheapest of them whose |step_error| is within the goal
  int recommended_whole = -1;  // the cheapest line within it with the lattice's error and uncertainty
};

/// Judges what was tried:
///   time step, scene, together  ratio - R_0, R_0 the limit of the steps in double on the same specimen
///   precision                   ratio - ratio in double at the same step
///   elements                    mean - the limit of the means, with the standard error of their difference
///   kinematics                  ratio - ratio with linear beams: a difference of models
///   pre-stress, samples         ratio - ratio by the static solve, with the most samples
/// `converged` is ratio - R_0 of the scene's lattice plus the error of that lattice against the finest; a
/// line of another number of elements has the scene's error of the step. So the deviation of one specimen
/// from its kind, which is scatter and no error, is in none of them.
/// @param[in] goal  largest error of the recommendations
Accuracy judge_accuracy(const std::vector<CaseResult>& results, double goal);

/// "time step: against ...", one line for each factor.
std::vector<std::string> reference_texts(const Accuracy& accuracy);

}  // namespace rift::accuracy

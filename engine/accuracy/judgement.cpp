#include "engine/accuracy/judgement.hpp"

#include "engine/base/numbers.hpp"
#include "engine/base/student.hpp"
#include "engine/base/text.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>

namespace rift::accuracy {
namespace {

constexpr double nan = std::numeric_limits<double>::quiet_NaN();

/// The value of the varied property, as a number.
double value_of(const Case& v) {
  switch (v.factor) {
    case Factor::time_step:
    case Factor::precision:
    case Factor::together:
      return v.scene.solver.dt_fraction.value_or(nan);
    case Factor::elements:
      return v.scene.specimen.elements;
    case Factor::samples:
      return v.scene.output.samples;
    default:
      return nan;
  }
}

struct Judging {
  const std::vector<CaseResult>& results;
  Accuracy out = {};

  std::vector<AccuracyLine*> of(Factor factor) {
    std::vector<AccuracyLine*> found;
    for (AccuracyLine& line : out.lines)
      if (line.factor == factor) found.push_back(&line);
    return found;
  }
  const Case& setup(const AccuracyLine& line) const { return results[line.results.front()].setup; }
  AccuracyLine& scene() { return out.lines.front(); }
  void refer(Factor factor, std::string text, double value, Convergence convergence = {}) {
    out.reference.push_back({factor, std::move(text), value, std::move(convergence)});
  }
};

/// The scene's own step and precision are part of what it is called.
std::string label_of(const CaseResult& result) {
  const std::string& label = result.setup.label;
  if (result.setup.factor != Factor::scene || !result.row) return label;
  return fmt::format("{}: {:.3g} of critical, {}", label, result.row->dt_fraction, result.row->precision);
}

/// Cases of one factor and label side by side.
void gather_lines(Judging& j) {
  for (std::size_t k = 0; k < j.results.size(); ++k) {
    const Case& v = j.results[k].setup;
    const std::string label = label_of(j.results[k]);
    const bool same =
        !j.out.lines.empty() && j.out.lines.back().factor == v.factor && j.out.lines.back().label == label;
    if (!same)
      j.out.lines.push_back(
          {.factor = v.factor, .label = label, .cannot_be = {}, .results = {}, .value = value_of(v)});
    AccuracyLine& line = j.out.lines.back();
    line.results.push_back(static_cast<int>(k));
    if (line.cannot_be.empty()) line.cannot_be = v.cannot_be;
  }
}

void measure(Judging& j, AccuracyLine& line) {
  std::vector<double> ratios, broberg, wall;
  for (const int k : line.results) {
    const std::optional<SummaryRow>& row = j.results[static_cast<std::size_t>(k)].row;
    if (!row || row->outcome != "finished" || !std::isfinite(row->ratio)) continue;
    ratios.push_back(row->ratio);
    broberg.push_back(row->error_broberg);
    wall.push_back(study::marching_time(*row));
  }
  line.ratio = base::mean_of(ratios);
  line.specimens = static_cast<int>(ratios.size());
  line.scatter = base::deviation_of(ratios);
  line.error_broberg = base::mean_of(broberg);
  line.wall_s = base::mean_of(wall);
  line.error = line.step_error = line.converged = nan;
  if (line.cannot_be.empty() && ratios.empty()) line.cannot_be = "not computed";
}

/// Standard error of a line's mean, widened for few specimens; 0 for one specimen, of which it is not known.
double standard_error(const AccuracyLine& line) {
  if (!std::isfinite(line.scatter)) return 0.0;
  return base::student_factor(static_cast<std::size_t>(line.specimens)) * line.scatter /
         std::sqrt(static_cast<double>(line.specimens));
}

/// R_0, the time step's own error on the specimen, and the lines that it is the error of.
void judge_steps(Judging& j) {
  std::vector<Level> levels;
  for (const AccuracyLine* line : j.of(Factor::time_step)) levels.push_back({line->value, line->ratio});
  const Convergence steps = converge(levels);
  for (AccuracyLine* line : j.of(Factor::time_step))
    line->reference = !steps.clean && line->ratio == steps.limit;
  for (AccuracyLine& line : j.out.lines)
    if (line.factor != Factor::elements && line.factor != Factor::kinematics)
      line.step_error = line.ratio - steps.limit;
  for (const Factor factor : {Factor::scene, Factor::time_step, Factor::together})
    for (AccuracyLine* line : j.of(factor)) line->error = line->step_error;
  j.refer(Factor::time_step, "the same specimen in double precision as the step tends to 0", steps.limit,
          steps);
}

/// Each line of a factor against another one of it.
void judge_against(Judging& j, Factor factor, const char* text,
                   const std::function<bool(const Case&)>& is_reference) {
  const std::vector<AccuracyLine*> lines = j.of(factor);
  const auto found = std::find_if(lines.begin(), lines.end(),
                                  [&](const AccuracyLine* line) { return is_reference(j.setup(*line)); });
  if (found == lines.end()) return;
  (*found)->reference = true;
  for (AccuracyLine* line : lines) line->error = line->ratio - (*found)->ratio;
  j.refer(factor, text, (*found)->ratio);
}

void judge_precision(Judging& j) {
  const std::vector<AccuracyLine*> in_double = j.of(Factor::time_step);
  for (AccuracyLine* line : j.of(Factor::precision))
    for (const AccuracyLine* other : in_double)
      if (other->value == line->value) line->error = line->ratio - other->ratio;
  if (!j.of(Factor::precision).empty())
    j.refer(Factor::precision, "the same specimen and step in double precision", nan);
}

void judge_elements(Judging& j) {
  const std::vector<AccuracyLine*> lines = j.of(Factor::elements);
  std::vector<Level> levels;
  const AccuracyLine* finest = nullptr;
  for (const AccuracyLine* line : lines) {
    levels.push_back({1.0 / std::sqrt(line->value), line->ratio, standard_error(*line)});
    if (std::isfinite(line->ratio) && (finest == nullptr || line->value > finest->value)) finest = line;
  }
  if (finest == nullptr) return;
  const Convergence limit = converge(levels);
  for (AccuracyLine* line : lines) {
    if (!std::isfinite(line->ratio)) continue;
    line->error = line->ratio - limit.limit;
    line->reference = line == finest && !limit.clean;
    line->uncertainty = line->reference ? 0.0 : std::hypot(standard_error(*line), standard_error(*finest));
  }
  j.out.specimen_scatter = finest->scatter;
  j.refer(Factor::elements,
          fmt::format("the mean of {} of {}", base::counted(finest->specimens, "specimen"), finest->label),
          limit.limit, limit);
}

/// The parts of the error together, against the finest lattice at the converged step.
void judge_whole(Judging& j) {
  const scene::Scene& scene = j.setup(j.scene()).scene;
  double lattice = 0.0, uncertainty = 0.0;
  for (const AccuracyLine* line : j.of(Factor::elements))
    if (j.setup(*line).scene.specimen.elements == scene.specimen.elements && std::isfinite(line->error)) {
      lattice = line->error, uncertainty = line->uncertainty;
      j.out.lattice_error = line->reference ? nan : lattice, j.out.lattice_uncertainty = uncertainty;
    }
  for (AccuracyLine& line : j.out.lines) {
    if (line.factor == Factor::elements) {
      line.converged = line.error + j.scene().step_error;
      line.converged_uncertainty = line.uncertainty;
    } else if (line.factor != Factor::kinematics) {
      line.converged = line.step_error + lattice;
      line.converged_uncertainty = uncertainty;
    }
  }
}

void choose(Judging& j, double goal) {
  const auto& lines = j.out.lines;
  std::vector<int> order;
  for (std::size_t k = 0; k < lines.size(); ++k)
    if (lines[k].cannot_be.empty() && std::isfinite(lines[k].wall_s)) order.push_back(static_cast<int>(k));
  std::stable_sort(order.begin(), order.end(),
                   [&](int a, int b) { return lines[a].wall_s < lines[b].wall_s; });
  double best = std::numeric_limits<double>::infinity();
  for (const int k : order) {
    const double error = std::abs(lines[k].step_error);  // NaN, and thus in no comparison, on another lattice
    if (error < best) j.out.front.push_back(k), best = error;
    if (j.out.recommended < 0 && error <= goal) j.out.recommended = k;
    const double whole = std::abs(lines[k].converged) + lines[k].converged_uncertainty;
    if (j.out.recommended_whole < 0 && whole <= goal) j.out.recommended_whole = k;
  }
}

}  // namespace

bool AccuracyLine::resolved() const { return std::abs(error) > 2.0 * uncertainty; }

Accuracy judge_accuracy(const std::vector<CaseResult>& results, double goal) {
  Judging j{.results = results};
  j.out.specimen_scatter = j.out.lattice_error = nan;
  gather_lines(j);
  if (j.out.lines.empty()) return {};
  for (AccuracyLine& line : j.out.lines) measure(j, line);
  judge_steps(j);
  judge_precision(j);
  judge_elements(j);
  judge_against(j, Factor::kinematics, "linear beams, a difference of models",
                [](const Case& v) { return v.scene.solver.kinematics == lattice::Kinematics::linear; });
  judge_against(j, Factor::prestress, "the static solve",
                [](const Case& v) { return v.scene.loading.method == scene::LoadingMethod::static_solve; });
  int most = 0;
  for (const AccuracyLine* line : j.of(Factor::samples)) most = std::max(most, static_cast<int>(line->value));
  judge_against(j, Factor::samples, "the most samples",
                [&](const Case& v) { return v.scene.output.samples == most; });
  judge_whole(j);
  choose(j, goal);
  return std::move(j.out);
}

std::vector<std::string> reference_texts(const Accuracy& accuracy) {
  std::vector<std::string> texts;
  for (const FactorReference& r : accuracy.reference) {
    std::string text = fmt::format("{}: compared with {}", name_of(r.factor), r.text);
    if (std::isfinite(r.value)) text += fmt::format(", {:.5f}", r.value);
    if (!r.convergence.text.empty()) {
      text += "; " + r.convergence.text;
      text += r.convergence.clean ? "; the reference is Richardson's extrapolation"
                                  : "; the reference is the finest value";
    }
    texts.push_back(std::move(text));
  }
  return texts;
}

}  // namespace rift::accuracy

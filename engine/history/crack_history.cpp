#include "engine/history/crack_history.hpp"

#include <Eigen/Dense>

#include <algorithm>
#include <cassert>
#include <cmath>
#include <limits>

namespace rift::history {
namespace {

const CrackStretch& stretch_at(const CrackHistory& history, double time) {
  const auto after = std::upper_bound(history.stretch.begin() + 1, history.stretch.end(), time,
                                      [](double t, const CrackStretch& s) { return t < s.time; });
  return *(after - 1);
}

/// How long a stretch takes for a distance that is not negative [s].
double time_for(const CrackStretch& s, double distance) {
  if (distance <= 0.0) return 0.0;
  if (s.acceleration == 0.0) return distance / s.speed;  // infinity for a tip at rest
  const double square = s.speed * s.speed + 2.0 * s.acceleration * distance;
  if (square < 0.0) return std::numeric_limits<double>::infinity();
  return 2.0 * distance / (s.speed + std::sqrt(square));
}

}  // namespace

CrackHistory history_of(double start, const std::vector<SpeedUntil>& pieces) {
  assert(!pieces.empty());
  CrackHistory history;
  double time = 0.0, position = start;
  for (const auto& [speed, until] : pieces) {
    history.stretch.push_back({time, position, speed});
    if (until > position) {
      time += (until - position) / speed;
      position = until;
    }
  }
  return history;
}

void turn_to(CrackHistory& history, double time, double speed) {
  const double position = tip_at(history, time);
  std::erase_if(history.stretch, [&](const CrackStretch& s) { return s.time >= time; });
  history.stretch.push_back({time, position, speed});
}

double tip_at(const CrackHistory& history, double time) {
  const CrackStretch& s = stretch_at(history, time);
  const double passed = time - s.time;
  return s.position + (s.speed + 0.5 * s.acceleration * passed) * passed;
}

double speed_at(const CrackHistory& history, double time) {
  const CrackStretch& s = stretch_at(history, time);
  return s.speed + s.acceleration * (time - s.time);
}

double highest_speed(const CrackHistory& history) {
  double highest = history.stretch.back().speed;
  for (std::size_t k = 0; k + 1 < history.stretch.size(); ++k) {
    const CrackStretch& s = history.stretch[k];
    highest = std::max({highest, s.speed, s.speed + s.acceleration * (history.stretch[k + 1].time - s.time)});
  }
  return highest;
}

double time_of_arrival(const CrackHistory& history, double position) {
  std::size_t k = 0;
  while (k + 1 < history.stretch.size() && history.stretch[k + 1].position < position) ++k;
  const CrackStretch& s = history.stretch[k];
  const double time = s.time + time_for(s, position - s.position);
  return k + 1 < history.stretch.size() ? std::min(time, history.stretch[k + 1].time) : time;
}

namespace {

constexpr int fewest_knots = 6, most_knots = 60;
constexpr double least_lambda = 1e-9, largest_lambda = 1e6;  // of the problem without dimensions
constexpr int steps_of_lambda = 46;                          // three a decade

/// The fit in units of its own: times from 0 to 1, distances in the whole advance, weights 1 / u^2. Unknown
/// are the speeds v at evenly spaced knots; the misfit is v^T data v - 2 pull v + rest.
struct Problem {
  Eigen::MatrixXd data;  // [knot][knot]
  Eigen::VectorXd pull;  // [knot]
  double rest = 0;
  Eigen::MatrixXd roughness;  // [knot][knot]: of the integral of (dv/dt)^2
  double rows = 0, duration = 1, advance = 1;

  int knots() const { return static_cast<int>(pull.size()); }
  Eigen::MatrixXd normal(double lambda) const { return data + lambda * roughness; }
};

/// Integral from 0 to t of the hat function of a knot, knots `apart` from each other.
double integral_of_hat(int knot, int knots, double apart, double t) {
  const auto rising = [&](double x) {  // of a ramp from 0 to 1 that stays there
    const double s = std::clamp(x / apart, 0.0, 1.0);
    return apart * 0.5 * s * s + std::max(0.0, x - apart);
  };
  const double from = (knot - 1) * apart;
  double integral = rising(t - from) - rising(t - from - apart);
  if (knot == 0) integral -= rising(-from) - rising(-from - apart);  // what lies before 0
  if (knot == knots - 1) integral = rising(t - from);                // nothing falls behind the last
  return integral;
}

Problem problem_of(const std::vector<HistoryPoint>& rows, double start) {
  const int knots = std::clamp(static_cast<int>(rows.size()), fewest_knots, most_knots);
  const double apart = 1.0 / (knots - 1);
  Problem p;
  p.duration = rows.back().time - rows.front().time;
  p.advance = std::max(rows.back().position - start, 1e-300);
  p.rows = static_cast<double>(rows.size());
  p.data = p.roughness = Eigen::MatrixXd::Zero(knots, knots);
  p.pull = Eigen::VectorXd::Zero(knots);
  Eigen::VectorXd integrals(knots);
  for (const HistoryPoint& row : rows) {
    const double t = (row.time - rows.front().time) / p.duration;
    for (int k = 0; k < knots; ++k) integrals[k] = integral_of_hat(k, knots, apart, t);
    const double measured = (row.position - start) / p.advance;
    const double weight = row.uncertainty > 0.0 ? std::pow(p.advance / row.uncertainty, 2.0) : 1.0;
    p.data += weight * integrals * integrals.transpose();
    p.pull += weight * measured * integrals;
    p.rest += weight * measured * measured;
  }
  for (int k = 0; k + 1 < knots; ++k) {
    p.roughness(k, k) += 1.0 / apart, p.roughness(k + 1, k + 1) += 1.0 / apart;
    p.roughness(k, k + 1) -= 1.0 / apart, p.roughness(k + 1, k) -= 1.0 / apart;
  }
  return p;
}

/// The speeds that are not negative: knots whose speed would be are held at 0, and let go where the sum would
/// fall with it (a primal-dual active set; Hintermueller, Ito and Kunisch 2003).
Eigen::VectorXd speeds_of(const Problem& p, double lambda) {
  const Eigen::MatrixXd a = p.normal(lambda);
  const double least_gain = 1e-12 * p.pull.cwiseAbs().maxCoeff();
  std::vector<char> held(static_cast<std::size_t>(p.knots()), 0);
  Eigen::VectorXd v = Eigen::VectorXd::Zero(p.knots());
  for (int round = 0; round < 4 * p.knots(); ++round) {
    std::vector<int> open;
    for (int k = 0; k < p.knots(); ++k)
      if (!held[static_cast<std::size_t>(k)]) open.push_back(k);
    v.setZero();
    const Eigen::MatrixXd of_open = a(open, open);
    const Eigen::VectorXd pull = p.pull(open), solution = of_open.ldlt().solve(pull);
    v(open) = solution;
    const Eigen::VectorXd gain = p.pull - a * v;
    bool settled = true;
    for (int k = 0; k < p.knots(); ++k) {
      char& is_held = held[static_cast<std::size_t>(k)];
      const bool hold = is_held ? gain[k] <= least_gain : v[k] < 0.0;
      settled = settled && hold == static_cast<bool>(is_held);
      is_held = hold;
    }
    if (settled) break;
  }
  return v.cwiseMax(0.0);
}

struct Fit {
  Eigen::VectorXd speed;
  double misfit = 0;              // sum of weighted squares
  double degrees_of_freedom = 0;  // trace of the hat matrix, without the bound at 0
};

Fit fit_of(const Problem& p, double lambda) {
  Fit fit;
  fit.speed = speeds_of(p, lambda);
  fit.misfit = std::max(0.0, fit.speed.dot(p.data * fit.speed - 2.0 * p.pull) + p.rest);
  fit.degrees_of_freedom = p.normal(lambda).ldlt().solve(p.data).trace();
  return fit;
}

Fit best_fit(const Problem& p, bool known) {
  const double scale = p.data.trace() / p.roughness.trace();
  Fit best;
  double least = std::numeric_limits<double>::infinity();
  for (int step = 0; step < steps_of_lambda; ++step) {  // from stiff to soft
    const double lambda =
        scale * largest_lambda * std::pow(least_lambda / largest_lambda, step / (steps_of_lambda - 1.0));
    Fit fit = fit_of(p, lambda);
    if (known) {
      best = std::move(fit);
      if (best.misfit <= p.rows) break;
      continue;
    }
    const double left = std::max(1e-3, p.rows - fit.degrees_of_freedom);
    const double validation = fit.misfit / (left * left);
    if (validation < least) least = validation, best = std::move(fit);
  }
  return best;
}

SmoothedHistory smooth_course(const std::vector<HistoryPoint>& rows, double start) {
  const bool known = rows.front().uncertainty > 0.0;
  const Problem p = problem_of(rows, start);
  const Fit fit = best_fit(p, known);
  SmoothedHistory course;
  const double apart = p.duration / (p.knots() - 1), unit = p.advance / p.duration;
  double position = start;
  for (int k = 0; k < p.knots(); ++k) {
    const double speed = unit * fit.speed[k];
    const bool last = k + 1 == p.knots();
    const double next = last ? speed : unit * fit.speed[k + 1];
    course.history.stretch.push_back({k * apart, position, speed, last ? 0.0 : (next - speed) / apart});
    if (!last) position += 0.5 * (speed + next) * apart;
  }
  course.end = position;
  course.chi2 = known ? fit.misfit / p.rows : 0.0;
  course.degrees_of_freedom = fit.degrees_of_freedom;
  return course;
}

SmoothedHistory straight_course(const std::vector<HistoryPoint>& rows, double start) {
  SmoothedHistory course;
  double position = start;
  for (std::size_t i = 0; i + 1 < rows.size(); ++i) {
    const double from = rows[i].time, to = rows[i + 1].time, next = rows[i + 1].position;
    course.history.stretch.push_back(
        {from - rows.front().time, position, (next - position) / (to - from), 0.0});
    position = next;
  }
  const CrackStretch& last = course.history.stretch.back();
  course.history.stretch.push_back({rows.back().time - rows.front().time, position, last.speed, 0.0});
  course.end = position;
  course.degrees_of_freedom = static_cast<double>(rows.size());
  return course;
}

}  // namespace

SmoothedHistory smoothed_history(const std::vector<HistoryPoint>& rows, double start, Smoothing smoothing) {
  assert(rows.size() >= 2);
  SmoothedHistory course =
      smoothing == Smoothing::none ? straight_course(rows, start) : smooth_course(rows, start);
  course.first_time = rows.front().time;
  double squares = 0.0;
  const std::vector<double> fitted = positions_at_rows(course, rows);
  for (std::size_t i = 0; i < rows.size(); ++i) squares += std::pow(fitted[i] - rows[i].position, 2.0);
  const double left = static_cast<double>(rows.size()) - course.degrees_of_freedom;
  course.scatter = left > 0.5 ? std::sqrt(squares / left) : 0.0;
  return course;
}

std::vector<double> positions_at_rows(const SmoothedHistory& course, const std::vector<HistoryPoint>& rows) {
  std::vector<double> positions;
  positions.reserve(rows.size());
  for (const HistoryPoint& row : rows)
    positions.push_back(tip_at(course.history, row.time - course.first_time));
  return positions;
}

}  // namespace rift::history

#include "engine/experiment/application.hpp"

#include "engine/base/numbers.hpp"
#include "engine/fracture/equation_of_motion.hpp"
#include "engine/scene/derived.hpp"
#include "engine/simulation/summary.hpp"

#include <algorithm>
#include <cmath>

namespace rift::experiment {
namespace {

constexpr double stretch = 0.02;     // of the velocity that is averaged over [c_R]
constexpr double least_rate = 0.05;  // of the lowest rate, at rest: nothing breaks for nothing

using Law = std::vector<std::array<double, 3>>;

/// Points that are averaged.
struct Pool {
  double over_cr = 0, rate = 0, uncertainty = 0, count = 0;  // sums

  void take(const Pool& other) {
    over_cr += other.over_cr, rate += other.rate, uncertainty += other.uncertainty, count += other.count;
  }
  double mean() const { return rate / count; }
};

std::vector<Pool> by_velocity(std::vector<CriticalPoint> along) {
  std::stable_sort(along.begin(), along.end(),
                   [](const CriticalPoint& a, const CriticalPoint& b) { return a.over_cr < b.over_cr; });
  std::vector<Pool> pools;
  double from = 0.0;
  for (const CriticalPoint& p : along) {
    if (pools.empty() || p.over_cr > from + stretch) pools.emplace_back(), from = p.over_cr;
    pools.back().take({p.over_cr, p.as_paper, p.uncertainty, 1.0});
  }
  return pools;
}

/// Neighbours that fall become one, until nothing falls (pool adjacent violators).
void make_rise(std::vector<Pool>& pools) {
  for (std::size_t k = 1; k < pools.size();) {
    if (pools[k].mean() >= pools[k - 1].mean()) {
      ++k;
      continue;
    }
    pools[k - 1].take(pools[k]);
    pools.erase(pools.begin() + static_cast<std::ptrdiff_t>(k));
    k = std::max<std::size_t>(1, k - 1);
  }
}

/// With the mean slope down to rest and up to c_R.
void go_on_beyond(Law& law) {
  const auto [slow, low, of_low] = law.front();
  const auto [fast, high, of_high] = law.back();
  const double slope = fast > slow ? (high - low) / (fast - slow) : 0.0;
  if (slow > 0.0) law.insert(law.begin(), {0.0, std::max(least_rate * low, low - slope * slow), of_low});
  if (fast < 1.0) law.push_back({1.0, high + slope * (1.0 - fast), of_high});
}

}  // namespace

Law law_of(const std::vector<CriticalPoint>& along) {
  std::vector<Pool> pools = by_velocity(along);
  make_rise(pools);
  Law law;
  law.reserve(pools.size() + 2);
  for (const Pool& p : pools) law.push_back({p.over_cr / p.count, p.mean(), p.uncertainty / p.count});
  go_on_beyond(law);
  return law;
}

namespace {

using results::Sample;

fracture::CriticalRate given_law(const Experiment& found) {
  fracture::CriticalRate law{.against = fracture::CriticalRate::Against::velocity_over_cr};
  for (const auto& [over_cr, rate, uncertainty] : found.law) law.row.push_back({over_cr, rate});
  return law;
}

scene::Scene by_itself(const scene::Preset& preset, const Experiment& found) {
  scene::Scene scene = preset.scene;
  const history::CrackHistory& course = found.course.history;
  const double start = scene.crack.start;
  const double began = found.width / (history::time_of_arrival(course, start + found.width) -
                                      history::time_of_arrival(course, start));
  // A load curve goes by the clock of the run, whose tip comes from a damage zone behind the start.
  const double zone = scene.crack.technique == fracture::Technique::progressive
                          ? scene.crack.damage_zone_ratio * found.mean_radius
                          : 0.0;
  for (std::array<double, 2>& row : scene.loading.curve.row) row[0] += zone / began - scene::load_time(scene);
  scene.crack.history.clear();
  scene.crack.velocity = {{{began, false}, {}}};
  scene.crack.end = found.along.back().position + 0.5 * found.width;
  scene.crack.toughness = given_law(found);
  return scene;
}

/// What the law's uncertainty makes of the velocity, over its mean: rms over the points.
double expected_error(const Experiment& found) {
  const auto& [slow, low, of_low] = found.law.front();
  const auto& [fast, high, of_high] = found.law.back();
  const double slope = fast > slow ? (high - low) / (fast - slow) : 0.0;
  double squares = 0.0, mean = 0.0;
  for (const CriticalPoint& p : found.along) {
    squares +=
        std::pow(p.uncertainty / (slope + p.as_paper / fracture::response_to_velocity(p.over_cr)), 2.0);
    mean += p.over_cr;
  }
  const auto count = static_cast<double>(found.along.size());
  return std::sqrt(squares / count) / (mean / count);
}

/// When the tip of the run was at a position, between two rows [s].
double time_at(const std::vector<Sample>& rows, double position) {
  const std::size_t k = base::interval_at(rows, position, &Sample::tip_m).k;
  const Sample &a = rows[k - 1], &b = rows[k];
  return a.time_s + (b.time_s - a.time_s) * (position - a.tip_m) / (b.tip_m - a.tip_m);
}

/// Clocks are set alike where both cracks are at the first point.
std::vector<Application::Point> compared(const Experiment& found, const std::vector<Sample>& rows,
                                         const fracture::RateScale& scale) {
  const history::CrackHistory& course = found.course.history;
  std::vector<Application::Point> along;
  const double first = found.along.front().position, half = 0.5 * found.width;
  const double own_zero = time_at(rows, first), measured_zero = history::time_of_arrival(course, first);
  for (const CriticalPoint& point : found.along) {
    if (point.position + half > rows.back().tip_m) break;
    Application::Point p{.position = point.position, .measured_over_cr = point.over_cr};
    const double passed = time_at(rows, point.position) - own_zero;
    p.lag = history::tip_at(course, measured_zero + passed) - point.position;
    p.over_cr = found.width / (time_at(rows, point.position + half) - time_at(rows, point.position - half)) /
                found.rayleigh_speed;
    p.given = fracture::critical_rate(given_law(found), p.over_cr, found.rayleigh_speed, point.position);
    p.rate = fracture::rate_around(rows, point.position, found.width, scale).ratio *
             fracture::mean_g_i0(scale, point.position - half, point.position + half);
    along.push_back(p);
  }
  return along;
}

}  // namespace

Application apply(const scene::Preset& preset, const Experiment& found, base::Cache& cache,
                  const Parts& parts, const ExperimentProgress& progress) {
  scene::Preset own = preset;
  own.scene = by_itself(preset, found);
  const simulation::Prepared prepared = simulation::prepare(
      own, cache, [&](std::string_view, double) { return progress("forward check", 0.0); });
  const simulation::RunResult run =
      parts.march("application", prepared, [&](double done) { return progress("forward check", done); });
  Application a;
  a.arrested_m = run.lane[0].arrested_m;
  std::vector<Sample> rows;
  for (const Sample& row : run.lane[0].samples)
    if (row.phase == results::Phase::fracture) rows.push_back(row);
  if (rows.size() < 2) return a;
  a.along = compared(found, rows, simulation::scale_of(prepared, prepared.lane[0]));
  double velocity = 0.0, rate = 0.0, mean = 0.0;
  for (const Application::Point& p : a.along) {
    a.worst_lag = std::max(a.worst_lag, std::abs(p.lag));
    velocity += std::pow(p.over_cr - p.measured_over_cr, 2.0), mean += p.measured_over_cr;
    rate += std::pow(p.rate / p.given - 1.0, 2.0);
  }
  const auto count = static_cast<double>(a.along.size());
  a.velocity_error = std::sqrt(velocity / count) / (mean / count);
  a.velocity_expected = expected_error(found);
  a.rate_error = std::sqrt(rate / count);
  return a;
}

}  // namespace rift::experiment

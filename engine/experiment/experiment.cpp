#include "engine/experiment/experiment.hpp"

#include "engine/base/interrupted.hpp"
#include "engine/base/numbers.hpp"
#include "engine/base/student.hpp"
#include "engine/experiment/application.hpp"
#include "engine/experiment/efficiency.hpp"
#include "engine/experiment/kept_parts.hpp"
#include "engine/experiment/plan.hpp"
#include "engine/measurement/specimen_properties.hpp"
#include "engine/results/run_folder.hpp"
#include "engine/scene/derived.hpp"
#include "engine/simulation/record.hpp"
#include "engine/simulation/summary.hpp"
#include "engine/theory/wave_speeds.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>
#include <string>

namespace rift::experiment {
namespace {

using results::Sample;

std::vector<Sample> crack_rows(const simulation::LaneResult& lane) {
  std::vector<Sample> rows;
  for (const Sample& row : lane.samples)
    if (row.phase == results::Phase::fracture) rows.push_back(row);
  return rows;
}

/// What one lane shows at the points, in J/m2.
std::vector<double> rates_at(const simulation::Prepared& p, const simulation::RunResult& run, int lane,
                             const std::vector<CriticalPoint>& along, double width) {
  const std::vector<Sample> rows = crack_rows(run.lane[lane]);
  const fracture::RateScale scale = simulation::scale_of(p, p.lane[lane]);
  std::vector<double> rates;
  rates.reserve(along.size());
  for (const CriticalPoint& point : along)
    rates.push_back(fracture::rate_around(rows, point.position, width, scale).ratio *
                    fracture::mean_g_i0(scale, point.position - 0.5 * width, point.position + 0.5 * width));
  return rates;
}

class Laboratory {
 public:
  Laboratory(const scene::Preset& preset, const ExperimentOptions& options,
             const std::filesystem::path& folder, base::Cache& cache, const simulation::BuildInfo& build,
             const ExperimentProgress& progress)
      : preset_(preset),
        options_(options),
        run_folder_(folder / "run"),
        cache_(cache),
        build_(build),
        progress_(progress),
        parts_(folder, experiment_identity(preset, options, build), {.threads = options.threads}) {}

  Experiment run() {
    measure();
    draw_histories();
    draw_specimens();
    e_.efficiency = efficiency_of(preset_, pulled_, slowest(), fastest(), cache_, parts_, progress_);
    conclude();
    if (options_.application) e_.application = apply(preset_, e_, cache_, parts_, progress_);
    return std::move(e_);
  }

 private:
  simulation::StageProgress preparing(const std::string& stage) {
    return [this, stage](std::string_view part, double done) {
      return progress_(stage + ": " + std::string(part), done);
    };
  }
  simulation::RunResult march_part(const std::string& name, const std::string& stage,
                                   const simulation::Prepared& p) {
    simulation::RunResult run = parts_.march(name, p, [&](double done) { return progress_(stage, done); });
    take(run);
    return run;
  }
  void take(const simulation::RunResult& run) {
    e_.outcome = std::max(e_.outcome, run.outcome);
    for (const simulation::LaneResult& lane : run.lane)
      e_.worst_residual = std::max(e_.worst_residual, lane.worst_residual);
  }

  double slowest() const { return std::min_element(e_.along.begin(), e_.along.end(), by_velocity)->over_cr; }
  double fastest() const { return std::max_element(e_.along.begin(), e_.along.end(), by_velocity)->over_cr; }
  static bool by_velocity(const CriticalPoint& a, const CriticalPoint& b) { return a.over_cr < b.over_cr; }

  /// The measured crack itself, on the preset's specimen, and the points of the result.
  void measure() {
    const simulation::Prepared p = simulation::prepare(preset_, cache_, preparing("specimen 1"));
    e_.course = scene::smoothed_history(preset_.scene);
    e_.width = preset_.scene.crack.toughness_window * p.lattice.mean_radius;
    pulled_ = p.pulled;
    e_.thickness = p.scale.thickness, e_.rayleigh_speed = p.rayleigh_speed,
    e_.mean_radius = p.lattice.mean_radius;
    read_own_constants(p);
    lay_points(p);
    const simulation::RunResult run = measured_crack(p);
    take(run);
    const double width = e_.width;
    specimens_.push_back(rates_at(p, run, 0, e_.along, width));
    for (const double other : {0.5 * width, 2.0 * width})
      widths_.push_back(rates_at(p, run, 0, e_.along, other));
    read_statics(p);
    e_.specimens = 1;
  }

  void read_own_constants(const simulation::Prepared& p) {
    e_.own_young_modulus = e_.own_poisson_ratio = e_.own_rayleigh_speed =
        std::numeric_limits<double>::quiet_NaN();
    try {
      const simulation::OwnConstants own = measurement::pulled_constants(
          p, p.lane.front(), cache_, [this](double done) { return progress_("static pulls", done); },
          options_.threads);
      e_.own_young_modulus = own.young_modulus(), e_.own_poisson_ratio = own.poisson_ratio();
      e_.own_rayleigh_speed =
          theory::wave_speeds(own.young_modulus(), own.poisson_ratio(), p.density, theory::Plane::stress)
              .rayleigh;
    } catch (const base::Interrupted&) {
      throw;
    } catch (const std::runtime_error&) {  // of statics, or too few elements at an end: it stays unknown
    }
  }

  /// Recorded as a run; by an earlier call, as far as that came.
  simulation::RunResult measured_crack(const simulation::Prepared& p) {
    const simulation::Observer marching{.go_on = [this](const simulation::Progress& done) {
      return progress_("measured crack", static_cast<double>(done.step) / static_cast<double>(done.total));
    }};
    if (results::inspect_run(run_folder_).header_json.empty()) {
      results::ClaimedFolder run(run_folder_, true);
      run.keep();
      return checked(simulation::record_run(p, run_folder_, build_, marching, parts_.options()).result);
    }
    if (simulation::has_ended(run_folder_)) return simulation::result_of_run(run_folder_);
    std::string ignored;  // a checkpoint that is damaged costs time, nothing else
    return checked(
        simulation::resume_run(p, run_folder_, build_, marching, ignored, parts_.options()).result);
  }
  static simulation::RunResult checked(simulation::RunResult run) {
    if (run.outcome == simulation::Outcome::stopped) throw base::Interrupted("marching the measured crack");
    return run;
  }

  void lay_points(const simulation::Prepared& p) {
    e_.along = points_of(preset_.scene, e_.course, p.lane[0].scenario.law.zone_length, p.lattice.mean_radius);
    if (e_.along.empty())
      throw scene::InputError({scene::issue_at(
          preset_, "crack.toughness_window",
          "must be shorter than the history, because the release rate is averaged over it")});
  }

  /// The same crack along histories that might as well have been measured, as lanes.
  void draw_histories() {
    const auto histories = resampled(preset_.scene, e_.course, options_.resamples,
                                     static_cast<std::uint64_t>(preset_.scene.specimen.seed));
    std::vector<scene::Scene> scenes;
    for (const auto& rows : histories) {
      scenes.push_back(preset_.scene);
      scenes.back().crack.history = rows, scenes.back().output.frames = 0;
      // A drawn history may end before the measured one, or be too fast to be a crack's.
      if (scene::highest_velocity(scenes.back()) > 2.0)
        scenes.pop_back();
      else
        scenes.back().crack.end =
            std::min(scene::crack_end(preset_.scene), scene::smoothed_history(scenes.back()).end);
    }
    std::vector<std::vector<double>> speeds;
    for (const scene::Scene& scene : scenes) {
      const history::CrackHistory course = scene::smoothed_history(scene).history;
      speeds.emplace_back();
      for (const CriticalPoint& point : e_.along)
        speeds.back().push_back(history::speed_at(course, history::time_of_arrival(course, point.position)));
    }
    for (std::size_t k = 0; k < e_.along.size(); ++k) e_.drawn_speed.push_back(at(speeds, k).deviation);
    // Each reaches its first row at another time, by which a load curve moves the grip.
    const std::size_t most = scene::grip_moves(preset_.scene) ? 1 : scenes.size();
    for (std::size_t first = 0; first < scenes.size(); first += most)
      run_drawn({scenes.begin() + static_cast<std::ptrdiff_t>(first),
                 scenes.begin() + static_cast<std::ptrdiff_t>(std::min(first + most, scenes.size()))});
    e_.resamples = static_cast<int>(drawn_.size()), e_.resamples_asked = options_.resamples;
  }

  void run_drawn(const std::vector<scene::Scene>& scenes) {
    const simulation::Prepared p =
        simulation::prepare(preset_, scenes, cache_, preparing("resampled histories"));
    const simulation::RunResult run =
        march_part(fmt::format("resampled_{}", drawn_marches_++), "resampled histories", p);
    for (int lane = 0; lane < static_cast<int>(scenes.size()); ++lane)
      if (run.lane[lane].outcome == simulation::Outcome::finished)
        drawn_.push_back(rates_at(p, run, lane, e_.along, e_.width));
  }

  /// The same crack through other packings.
  void draw_specimens() {
    for (int k = 1; k < options_.specimens; ++k) {
      const std::string stage = "specimen " + std::to_string(k + 1);
      scene::Preset other = preset_;
      other.scene.specimen.seed += k, other.scene.output.frames = 0;
      const simulation::Prepared p = simulation::prepare(other, cache_, preparing(stage));
      const simulation::RunResult run = march_part(fmt::format("specimen_{}", k + 1), stage, p);
      if (run.outcome != simulation::Outcome::finished) continue;
      specimens_.push_back(rates_at(p, run, 0, e_.along, e_.width));
      read_statics(p);
      ++e_.specimens;
    }
  }

  /// By how much more a grip that moves on has the plate store, and a slow crack release.
  double square_of_pull(double time) const {
    return scene::grip_moves(preset_.scene)
               ? std::pow(scene::load_at(preset_.scene.loading.curve, time) / pulled_, 2.0)
               : 1.0;
  }

  /// What a crack that is slow enough for no waves would release through a specimen, between a few positions.
  void read_statics(const simulation::Prepared& p) {
    std::vector<double> at;
    const double from = e_.along.front().position, to = e_.along.back().position;
    for (int k = 0; k <= static_parts; ++k) at.push_back(from + k * (to - from) / static_parts);
    const std::vector<double> part_rates = measurement::quasi_static_rates(
        p, at, [this](double done) { return progress_("quasi-static", done); });
    std::vector<double> rates;
    // Over two parts each: the few beams between two positions scatter.
    for (int k = 1; k < static_parts; ++k) rates.push_back(0.5 * (part_rates[k - 1] + part_rates[k]));
    statics_.push_back(static_curve(rates, 1.0));
    if (static_windows_.empty()) static_windows_ = {statics_.front(), static_curve(part_rates, 0.5)};
  }

  /// At the points, straight between the rates and on beyond them; the first one is of `first` parts from the
  /// first point.
  std::vector<double> static_curve(const std::vector<double>& rates, double first) const {
    const double from = e_.along.front().position, to = e_.along.back().position;
    std::vector<double> curve;
    for (const CriticalPoint& point : e_.along) {
      const double place = (point.position - from) / (to - from) * static_parts - first;
      const int low = std::clamp(static_cast<int>(std::floor(place)), 0, static_cast<int>(rates.size()) - 2);
      curve.push_back(std::lerp(rates[low], rates[low + 1], place - low) * square_of_pull(point.time));
    }
    return curve;
  }

  /// Of the curves that have a number there; NaN and 0 of none, 0 of a single one. `widened`: the deviation
  /// by Student's factor.
  struct Spread {
    double mean, deviation, widened;
  };
  static Spread at(const std::vector<std::vector<double>>& curves, std::size_t k) {
    double sum = 0.0, squares = 0.0, count = 0.0;
    for (const std::vector<double>& curve : curves)
      if (const double v = curve[k]; std::isfinite(v)) sum += v, squares += v * v, count += 1.0;
    const double mean = sum / count;
    if (!(count > 1.0)) return {mean, 0.0, 0.0};
    const double deviation = std::sqrt(std::max(0.0, squares - count * mean * mean) / (count - 1.0));
    return {mean, deviation, deviation * base::student_factor(static_cast<std::size_t>(count))};
  }

  void conclude() {
    for (std::size_t k = 0; k < e_.along.size(); ++k) {
      CriticalPoint& point = e_.along[k];
      const Spread packing = at(specimens_, k);
      point.as_paper = packing.mean, point.of_packing = packing.widened;
      const Spread slow = at(statics_, k);
      point.quasi_static = slow.mean;
      point.quasi_static_uncertainty =
          std::hypot(slow.widened, 0.5 * (static_windows_[0][k] - static_windows_[1][k]));
      point.of_noise = drawn_.empty() ? 0.0 : at(drawn_, k).deviation;
      std::vector<double> by_width{specimens_.front()[k]};
      for (const auto& curve : widths_)
        if (std::isfinite(curve[k])) by_width.push_back(curve[k]);
      const auto [least, most] = std::minmax_element(by_width.begin(), by_width.end());
      point.of_window = 0.5 * (*most - *least);
      point.uncertainty = std::hypot(point.of_noise, point.of_packing, point.of_window);
      const EfficiencyPoint at_velocity = efficiency_at(e_.efficiency, point.over_cr);
      point.efficiency = at_velocity.efficiency;
      point.corrected = point.as_paper / point.efficiency;
      // A plateau is the mean of sub-windows, whose scatter is known.
      const double of_efficiency =
          at_velocity.scatter / std::sqrt(static_cast<double>(fracture::sub_windows));
      point.corrected_uncertainty =
          std::hypot(point.uncertainty, point.corrected * of_efficiency) / point.efficiency;
    }
    e_.mean = mean_of_points();
    std::erase_if(e_.along, [](const CriticalPoint& point) { return !std::isfinite(point.as_paper); });
    e_.law = law_of(e_.along);
  }

  /// How far a curve lies from the result, on average over the points that both have.
  double offset_of(const std::vector<double>& curve) const {
    std::vector<double> offsets;
    for (std::size_t k = 0; k < curve.size(); ++k)
      if (const double offset = curve[k] - e_.along[k].as_paper; std::isfinite(offset))
        offsets.push_back(offset);
    return base::mean_of(offsets);
  }
  std::vector<double> offsets_of(const std::vector<std::vector<double>>& curves) const {
    std::vector<double> offsets;
    for (const std::vector<double>& curve : curves) offsets.push_back(offset_of(curve));
    return offsets;
  }

  CriticalMean mean_of_points() const {
    CriticalMean m;
    m.slowest = slowest(), m.fastest = fastest();
    std::vector<double> as_paper, corrected, relative;
    for (const CriticalPoint& point : e_.along) {
      if (!std::isfinite(point.as_paper)) continue;
      m.from = as_paper.empty() ? point.position : m.from, m.to = point.position;
      as_paper.push_back(point.as_paper), corrected.push_back(point.corrected);
      const EfficiencyPoint of_lattice = efficiency_at(e_.efficiency, point.over_cr);
      relative.push_back(of_lattice.scatter / of_lattice.efficiency);
    }
    m.as_paper = base::mean_of(as_paper), m.corrected = base::mean_of(corrected);
    m.efficiency = m.as_paper / m.corrected;
    const auto deviation = [](const std::vector<double>& numbers) {
      return numbers.size() > 1 ? base::deviation_of(numbers) : 0.0;
    };
    m.deviation_along = deviation(corrected);
    m.of_noise = deviation(offsets_of(drawn_)), m.of_packing = deviation(offsets_of(specimens_));
    if (specimens_.size() > 1) m.of_packing *= base::student_factor(specimens_.size());
    std::vector<double> by_width = offsets_of(widths_);
    by_width.push_back(offset_of(specimens_.front()));
    const auto [least, most] = std::minmax_element(by_width.begin(), by_width.end());
    m.of_window = 0.5 * (*most - *least);
    m.uncertainty = std::hypot(m.of_noise, m.of_packing, m.of_window);
    m.of_efficiency =
        m.corrected * base::mean_of(relative) / std::sqrt(static_cast<double>(fracture::sub_windows));
    m.corrected_uncertainty = std::hypot(m.uncertainty / m.efficiency, m.of_efficiency);
    return m;
  }

  const scene::Preset& preset_;
  const ExperimentOptions& options_;
  const std::filesystem::path run_folder_;
  base::Cache& cache_;
  const simulation::BuildInfo& build_;
  const ExperimentProgress& progress_;
  const Parts parts_;
  Experiment e_;
  int drawn_marches_ = 0;
  double pulled_ = 0;  // the first specimen's grip as the crack starts [m]
  std::vector<std::vector<double>> specimens_, drawn_, widths_;  // rates at the points
  std::vector<std::vector<double>> statics_,
      static_windows_;  // of a slow crack; of one specimen by two windows
};

}  // namespace

Experiment run_experiment(const scene::Preset& preset, const ExperimentOptions& options,
                          const std::filesystem::path& folder, base::Cache& cache,
                          const simulation::BuildInfo& build, const ExperimentProgress& progress) {
  begin_experiment(folder, experiment_identity(preset, options, build));
  return Laboratory(preset, options, folder, cache, build, progress).run();
}

}  // namespace rift::experiment

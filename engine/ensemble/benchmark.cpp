#include "engine/ensemble/benchmark.hpp"

#include "engine/ensemble/ensemble.hpp"
#include "engine/packing/neighbours.hpp"
#include "engine/reference/plain_simulation.hpp"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <ctime>
#include <random>

namespace rift::ensemble {
namespace {

using Clock = std::chrono::steady_clock;

double seconds_since(Clock::time_point start) {
  return std::chrono::duration<double>(Clock::now() - start).count();
}

/// Seconds on a clock that only differences mean something of.
double now_s(bool processor_time) {
  return processor_time ? static_cast<double>(std::clock()) / CLOCKS_PER_SEC
                        : std::chrono::duration<double>(Clock::now().time_since_epoch()).count();
}

constexpr double time_step = 1e-8;  // [s]

/// Arithmetic of one beam and one lane, counted in engine/ensemble/forms.hpp (a fused multiply-add counts
/// two), and of the integration of an element.
constexpr double linear_flops = 101, corotational_flops = 306;
constexpr double linear_drift_flops = 30, corotational_drift_flops = 75;

template <class Beam>
double bytes_of_beam(const BenchCase& c, double beams_per_element) {
  const double row = c.scenarios == 1 ? sizeof(BeamGroup<Beam>) / 4.0 : sizeof(IntactRow<Beam>);
  const double numbers = 6 + Beam::position_numbers;  // velocity and position, each read and written
  return row / c.scenarios + 2.0 * numbers * sizeof(typename Beam::Number) / beams_per_element;
}

double bytes_of_beam(const BenchCase& c, double beams_per_element) {
  const bool single = c.precision == Precision::single_precision;
  if (c.kinematics == lattice::Kinematics::linear)
    return single ? bytes_of_beam<LinearBeam<float>>(c, beams_per_element)
                  : bytes_of_beam<LinearBeam<double>>(c, beams_per_element);
  return single ? bytes_of_beam<CorotationalBeam<float>>(c, beams_per_element)
                : bytes_of_beam<CorotationalBeam<double>>(c, beams_per_element);
}

/// Steps per second in each of the runs, ascending.
template <class Step>
std::vector<double> rates_of_runs(const Step& step, int runs, double seconds, bool processor_time) {
  for (int n = 0; n < 3; ++n) step();
  std::vector<double> rates;
  for (int run = 0; run < runs; ++run) {
    const double start = now_s(processor_time);
    int steps = 0;
    double passed = 0.0;
    while (passed < seconds) {
      for (int n = 0; n < 4; ++n) step();
      steps += 4;
      passed = now_s(processor_time) - start;
    }
    rates.push_back(steps / passed);
  }
  std::sort(rates.begin(), rates.end());
  return rates;
}

/// A shape that moves every element, so that no kernel meets a zero; small, since it is not the point.
std::vector<lattice::Vector6> waves(const lattice::Lattice& lattice) {
  std::vector<lattice::Vector6> q;
  for (const Eigen::Vector3d& x : lattice.centre) {
    const double phase = 300.0 * x.x() + 500.0 * x.y() + 100.0 * x.z();
    lattice::Vector6 m;
    m << std::sin(phase), std::cos(phase), std::sin(2 * phase), std::cos(2 * phase), std::sin(3 * phase), 1.0;
    q.push_back(1e-7 * m);
  }
  return q;
}

std::vector<fracture::DamageableBeam> beams_in_the_middle(const lattice::Lattice& lattice) {
  return fracture::damageable_beams(fracture::straight_path(lattice.box.length, 0.5 * lattice.box.height),
                                    lattice, 0.0);
}

std::vector<double> ensemble_rates(const BenchCase& c, const lattice::Lattice& lattice, int runs,
                                   double seconds) {
  Ensemble ensemble(lattice, beams_in_the_middle(lattice), time_step,
                    std::vector<fracture::LaneScenario>(c.scenarios),
                    {.kinematics = c.kinematics,
                     .precision = c.precision,
                     .threads = c.threads,
                     .instructions = c.instructions});
  ensemble.release_from(waves(lattice));
  if (c.beta != 1.0) ensemble.set_beta(c.beta);
  std::vector<lattice::DampedBeam> damped;
  for (int b = 0; b < static_cast<int>(c.damped * static_cast<double>(lattice.beam.size())); ++b)
    damped.push_back(lattice::damped_beam(lattice, b, -1, false));
  ensemble.start_crack(damped);
  return rates_of_runs(
      [&] {
        ensemble.step();
        if (c.balanced) ensemble.balance(0);
      },
      runs, seconds, c.processor_time);
}

/// The readable step; linear, double, one lane, one thread.
std::vector<double> plain_rates(const lattice::Lattice& lattice, int runs, double seconds) {
  reference::PlainSimulation plain(lattice, beams_in_the_middle(lattice), time_step, {});
  plain.start_from(waves(lattice));
  return rates_of_runs([&] { plain.step(); }, runs, seconds, false);
}

}  // namespace

lattice::Lattice bench_lattice(int elements) {
  // Two close-packed layers, B over the hollows of A; columns along y.
  const int columns =
      std::max(2, static_cast<int>(std::lround(std::sqrt(elements / 2.0 * 5.0 / (std::sqrt(3.0) / 2.0)))));
  const int rows = std::max(2, elements / 2 / columns);
  const double d = 0.2 / columns / (std::sqrt(3.0) / 2.0);
  packing::Specimen s;
  s.box = {0.2, rows * d, 2.0 * d};
  std::vector<double> reach;
  for (int c = 0; c < columns; ++c)
    for (int r = 0; r < rows; ++r)
      for (int layer = 0; layer < 2; ++layer) {
        s.centre.emplace_back(d * (c + (layer ? 2.0 / 3.0 : 0.0)) * std::sqrt(3.0) / 2.0,
                              d * (r + (c % 2 ? 0.5 : 0.0)), layer * d * std::sqrt(2.0 / 3.0));
        s.radius.push_back(0.5 * d);
        reach.push_back(0.51 * d);
        s.grip.push_back(r == 0          ? packing::Grip::bottom
                         : r == rows - 1 ? packing::Grip::top
                                         : packing::Grip::none);
      }
  std::vector<std::array<int, 2>> pairs = packing::pairs_within_reach(s.centre, reach);
  std::mt19937_64 random(7);
  const double keep = 3.0 * static_cast<double>(s.centre.size()) / static_cast<double>(pairs.size());
  std::erase_if(pairs, [&](const auto&) { return static_cast<double>(random() >> 11) * 0x1.0p-53 > keep; });
  s.beam = pairs;
  s.packing.mean_radius = 0.5 * d;
  return lattice::make_lattice(s, {219e9, 0.3, 0.3}, 667.0);
}

MachinePeaks machine_peaks(InstructionSet instructions, int threads) {
  base::ThreadPool pool(threads, threads);
  MachinePeaks peaks;
  const std::size_t share = (std::size_t{1} << 24);  // doubles a thread and array: 128 MB
  std::vector<std::vector<double>> a(threads), b(threads), c(threads);
  pool.run(threads,
           [&](int t) { a[t].assign(share, 0.0), b[t].assign(share, 1.0), c[t].assign(share, 2.0); });
  const auto best_of = [&](const auto& work) {  // seconds
    double best = 1e9;
    for (int n = 0; n < 5; ++n) {
      const auto start = Clock::now();
      pool.run(threads, work);
      best = std::min(best, seconds_since(start));
    }
    return best;
  };
  const double triad = best_of([&](int t) {
    for (std::size_t k = 0; k < share; ++k) a[t][k] = b[t][k] + 3.0 * c[t][k];
  });
  peaks.memory_bytes_per_s =
      32.0 * static_cast<double>(share) * threads / triad;  // a is read before it is written
  constexpr long rounds = 4'000'000;
  std::vector<double> done(threads);
  const double in_double = best_of([&](int t) { done[t] = multiply_and_add<double>(instructions, rounds); });
  peaks.flops_double = done[0] * threads / in_double;
  const double in_single = best_of([&](int t) { done[t] = multiply_and_add<float>(instructions, rounds); });
  peaks.flops_single = done[0] * threads / in_single;
  return peaks;
}

BenchResult time_case(const BenchCase& bench, int runs, double seconds) {
  const lattice::Lattice lattice = bench_lattice(bench.elements);
  BenchResult result;
  result.of = bench;
  result.beams = lattice.beam.size();
  result.beam_steps_per_s =
      bench.plain ? plain_rates(lattice, runs, seconds) : ensemble_rates(bench, lattice, runs, seconds);
  const double lanes = bench.scenarios, beams = static_cast<double>(result.beams);
  result.step_s = 1.0 / result.median();
  result.element_steps_per_s = result.median() * lanes * static_cast<double>(lattice.mass.size());
  for (double& rate : result.beam_steps_per_s) rate *= beams * lanes;
  const double per_element = beams / static_cast<double>(lattice.mass.size());
  const bool linear = bench.kinematics == lattice::Kinematics::linear;
  result.bytes_per_beam = bytes_of_beam(bench, per_element);
  result.flops_per_beam = (linear ? linear_flops : corotational_flops) +
                          (linear ? linear_drift_flops : corotational_drift_flops) / per_element;
  return result;
}

}  // namespace rift::ensemble

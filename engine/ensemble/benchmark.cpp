#include "engine/ensemble/benchmark.hpp"

#include "engine/ensemble/breaking_beams.hpp"
#include "engine/ensemble/ensemble.hpp"
#include "engine/packing/neighbours.hpp"
#include "engine/reference/plain_simulation.hpp"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <ctime>
#include <functional>
#include <memory>
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
/// two), and of the integration of an element. A step looks at corotational beams twice: 306 for the means,
/// 424 with the strains of the moment in the directions of the mean.
constexpr double linear_flops = 101, corotational_flops = 306 + 424;
constexpr double linear_drift_flops = 30, corotational_drift_flops = 2 * 75, damper_flops = 54;

template <class Beam>
double bytes_of_beam(const BenchCase& c, double beams_per_element) {
  const double row =
      c.scenarios == 1 ? BeamGroup::rows * sizeof(std::int32_t) + sizeof(Beam) : sizeof(IntactRow<Beam>);
  using Real = typename Beam::Number;
  // Velocity, position and, where damped, the dampers' forces of the step before: each read and written.
  const double numbers = 6 + Beam::position_numbers + (c.damped > 0.0 ? 6 : 0);
  const double of_law = c.law ? (c.scenarios == 1 ? 1 : 2) * sizeof(Real) : 0.0;  // threshold; what is left
  return (row + c.damped * sizeof(Dampers<Real>)) / c.scenarios + of_law +
         2.0 * numbers * sizeof(Real) / beams_per_element;
}

double bytes_of_beam(const BenchCase& c, double beams_per_element) {
  const bool single = c.precision == Precision::single_precision;
  if (c.kinematics == lattice::Kinematics::linear)
    return single ? bytes_of_beam<LinearBeam<float>>(c, beams_per_element)
                  : bytes_of_beam<LinearBeam<double>>(c, beams_per_element);
  return single ? bytes_of_beam<CorotationalBeam<float>>(c, beams_per_element)
                : bytes_of_beam<CorotationalBeam<double>>(c, beams_per_element);
}

/// Steps per second, over `seconds` at least.
double rate_of(const std::function<void()>& step, double seconds, bool processor_time) {
  const double start = now_s(processor_time);
  int steps = 0;
  double passed = 0.0;
  while (passed < seconds) {
    for (int n = 0; n < 4; ++n) step();
    steps += 4;
    passed = now_s(processor_time) - start;
  }
  return steps / passed;
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

/// Of a law by which every beam may break, at many times the openings of waves().
constexpr fracture::CohesiveMaterial strong{
    .release_rate = 1e6, .strength = 1e9, .young_modulus = 1e10, .kappa = 1.0};

std::function<void()> ensemble_step(const BenchCase& c, const lattice::Lattice& lattice) {
  std::vector<fracture::LaneScenario> scenarios(c.scenarios);
  for (fracture::LaneScenario& scenario : scenarios)
    if (c.law) scenario.material = strong;
  const fracture::CrackPath path = fracture::straight_path(lattice.box.length, 0.5 * lattice.box.height);
  const auto ensemble = std::make_shared<Ensemble>(
      lattice,
      c.law ? fracture::breakable_beams(path, lattice, 0.0) : fracture::damageable_beams(path, lattice, 0.0),
      time_step, scenarios,
      EnsembleOptions{.kinematics = c.kinematics,
                      .precision = c.precision,
                      .threads = c.threads,
                      .instructions = c.instructions},
      c.law ? std::make_shared<BreakingBeams>(lattice, time_step) : nullptr);
  ensemble->release_from(waves(lattice));
  if (c.beta != 1.0) ensemble->set_beta(c.beta);
  std::vector<int> crossing(lattice.beam.size(), -1);
  for (int k = 0; k < static_cast<int>(ensemble->damageable().size()); ++k)
    crossing[ensemble->damageable()[k].beam] = k;
  std::vector<lattice::DampedBeam> damped;
  for (int b = 0; b < static_cast<int>(c.damped * static_cast<double>(lattice.beam.size())); ++b)
    damped.push_back(lattice::damped_beam(lattice, b, crossing[b], false));
  ensemble->start_crack(damped);
  return [ensemble, balanced = c.balanced] {
    ensemble->step();
    if (balanced) ensemble->balance(0);
  };
}

/// The readable step; linear, double, one lane, one thread.
std::function<void()> plain_step(const lattice::Lattice& lattice) {
  const auto plain = std::make_shared<reference::PlainSimulation>(lattice, beams_in_the_middle(lattice),
                                                                  time_step, fracture::LaneScenario{});
  plain->start_from(waves(lattice));
  return [plain] { plain->step(); };
}

/// One step of the case, done a few times already.
std::function<void()> step_of(const BenchCase& c, const lattice::Lattice& lattice) {
  std::function<void()> step = c.plain ? plain_step(lattice) : ensemble_step(c, lattice);
  for (int n = 0; n < 3; ++n) step();
  return step;
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
  const std::function<void()> step = step_of(bench, lattice);
  for (int run = 0; run < runs; ++run)
    result.beam_steps_per_s.push_back(rate_of(step, seconds, bench.processor_time));
  std::sort(result.beam_steps_per_s.begin(), result.beam_steps_per_s.end());
  const double lanes = bench.scenarios, beams = static_cast<double>(result.beams);
  result.step_s = 1.0 / result.median();
  result.element_steps_per_s = result.median() * lanes * static_cast<double>(lattice.mass.size());
  for (double& rate : result.beam_steps_per_s) rate *= beams * lanes;
  const double per_element = beams / static_cast<double>(lattice.mass.size());
  const bool linear = bench.kinematics == lattice::Kinematics::linear;
  result.bytes_per_beam = bytes_of_beam(bench, per_element);
  result.flops_per_beam = (linear ? linear_flops : corotational_flops) + bench.damped * damper_flops +
                          (linear ? linear_drift_flops : corotational_drift_flops) / per_element;
  return result;
}

std::vector<std::vector<double>> ratios_to_first(const std::vector<BenchCase>& cases, int rounds,
                                                 double seconds) {
  const lattice::Lattice lattice = bench_lattice(cases.front().elements);
  std::vector<std::function<void()>> steps;
  for (const BenchCase& c : cases) steps.push_back(step_of(c, lattice));
  std::vector<std::vector<double>> ratios(cases.size());
  for (int round = 0; round < rounds; ++round) {
    double first = 0.0;
    for (std::size_t k = 0; k < cases.size(); ++k) {
      const double rate = cases[k].scenarios * rate_of(steps[k], seconds, cases[k].processor_time);
      if (k == 0) first = rate;
      ratios[k].push_back(rate / first);
    }
  }
  for (std::vector<double>& of_case : ratios) std::sort(of_case.begin(), of_case.end());
  return ratios;
}

}  // namespace rift::ensemble

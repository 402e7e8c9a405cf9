#include "engine/measurement/waves.hpp"

#include "engine/base/interrupted.hpp"
#include "engine/base/process_limits.hpp"
#include "engine/ensemble/ensemble.hpp"

#include <Eigen/Dense>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <span>

namespace rift::measurement {
namespace {

using std::numbers::pi;

/// A wave to throw, and what is expected of it.
struct Throw {
  Wave wave;
  double frequency = 0;                    // omega expected [rad/s]
  std::vector<lattice::Vector6> velocity;  // N [m/s, rad/s]
};

/// How far from the middle, as a share of the length, a plate is watched.
constexpr double watched = 0.125;

double expected_speed(WaveKind kind, const theory::WaveSpeeds& speeds) {
  return kind == WaveKind::dilatational ? speeds.dilatational
         : kind == WaveKind::shear      ? speeds.shear
                                        : speeds.rayleigh;
}

/// v along one axis of cos(k y), turning as the continuum does.
lattice::Vector6 across(WaveKind kind, double k, double y) {
  lattice::Vector6 v = lattice::Vector6::Zero();
  if (kind == WaveKind::dilatational) {
    v[1] = std::cos(k * y);
  } else {
    v[0] = std::cos(k * y);
    v[5] = 0.5 * k * std::sin(k * y);  // (dv_y/dx - dv_x/dy) / 2
  }
  return v;
}

/// The standing Rayleigh wave at a depth below the edge: a p-part that decays with q, an s-part with s.
lattice::Vector6 along_edge(const theory::WaveSpeeds& c, double k, double x, double depth) {
  const double q = k * std::sqrt(1.0 - std::pow(c.rayleigh / c.dilatational, 2.0));
  const double s = k * std::sqrt(1.0 - std::pow(c.rayleigh / c.shear, 2.0));
  const double p_part = std::exp(-q * depth), s_part = std::exp(-s * depth), mean = k * k + s * s;
  lattice::Vector6 v = lattice::Vector6::Zero();
  v[0] = (p_part - 2.0 * q * s / mean * s_part) * std::sin(k * x);
  v[1] = -q / k * (p_part - 2.0 * k * k / mean * s_part) * std::cos(k * x);
  // The s-part alone turns: omega_z = (dv_y/dx - dv_x/dy) / 2, d/dy = -d/ddepth
  v[5] = -(q / mean) * (k * k - s * s) * s_part * std::sin(k * x);
  return v;
}

Throw make_throw(const lattice::Lattice& plate, WaveKind kind, double wavelength,
                 const theory::WaveSpeeds& speeds) {
  const double k = 2.0 * pi / wavelength;
  Throw t{{kind, wavelength, 0.0}, k * expected_speed(kind, speeds), {}};
  for (const Eigen::Vector3d& p : plate.centre)
    t.velocity.push_back(kind == WaveKind::rayleigh ? along_edge(speeds, k, p.x(), plate.box.height - p.y())
                                                    : across(kind, k, p.y()));
  return t;
}

double time_to_echo(const lattice::Lattice& plate, const theory::WaveSpeeds& speeds) {
  return (0.5 - watched) * plate.box.length / speeds.dilatational;
}

std::vector<Throw> all_throws(const lattice::Lattice& plate, const theory::WaveSpeeds& speeds) {
  constexpr double shortest = 8.0, periods = 0.75;
  const double height = plate.box.height;
  std::vector<Throw> throws;
  for (const WaveKind kind : {WaveKind::dilatational, WaveKind::shear, WaveKind::rayleigh})
    for (const int n : {2, 3, 4, 6, 8, 12, 16, 20}) {
      // Across the height n half waves fit; the edge takes none longer than 0.6 of the height, which it would
      // feel the other edge of.
      const double wavelength = kind == WaveKind::rayleigh ? 1.2 * height / n : 2.0 * height / n;
      const double period = wavelength / expected_speed(kind, speeds);
      if (wavelength < shortest * plate.mean_radius || time_to_echo(plate, speeds) < periods * period)
        continue;
      throws.push_back(make_throw(plate, kind, wavelength, speeds));
    }
  return throws;
}

/// A projection against time.
struct Swing {
  std::vector<double> time, value;
};

double square_of(const Swing& swing) {
  double square = 0.0;
  for (double v : swing.value) square += v * v;
  return square;
}

/// What sin(omega t) (a + b t) leaves of a swing's square.
double residual(const Swing& swing, double omega) {
  Eigen::Matrix2d normal = Eigen::Matrix2d::Zero();
  Eigen::Vector2d right = Eigen::Vector2d::Zero();
  const double end = swing.time.back();
  for (std::size_t k = 0; k < swing.time.size(); ++k) {
    const double s = std::sin(omega * swing.time[k]);
    const Eigen::Vector2d basis(s, s * swing.time[k] / end);
    normal += basis * basis.transpose();
    right += basis * swing.value[k];
  }
  return square_of(swing) - right.dot(normal.ldlt().solve(right));
}

/// The frequency with the least residual, from 0.6 to 1.4 of the expected one: a search on a grid, then
/// golden sections.
double frequency_of(const Swing& swing, double expected) {
  constexpr int grid = 200;
  double best = expected, least = std::numeric_limits<double>::infinity();
  const double step = 0.8 / grid * expected;
  for (int k = 0; k <= grid; ++k)
    if (const double r = residual(swing, 0.6 * expected + k * step); r < least)
      least = r, best = 0.6 * expected + k * step;
  double low = best - step, high = best + step;
  while (high - low > 1e-7 * expected) {
    const double a = high - (high - low) / std::numbers::phi, b = low + (high - low) / std::numbers::phi;
    (residual(swing, a) < residual(swing, b) ? high : low) = residual(swing, a) < residual(swing, b) ? b : a;
  }
  return 0.5 * (low + high);
}

/// Throws some waves, each in a lane, and watches them.
std::vector<Swing> watch(const lattice::Lattice& plate, double dt, double duration,
                         std::span<const Throw> throws, int threads,
                         const std::function<bool(double)>& go_on) {
  constexpr int stride = 4;
  ensemble::Ensemble ensemble(plate, {}, dt, std::vector<fracture::LaneScenario>(throws.size()),
                              {.threads = base::threads_or_all_cpus(threads)});
  ensemble.start_from(std::vector<lattice::Vector6>(plate.centre.size(), lattice::Vector6::Zero()));
  for (std::size_t k = 0; k < throws.size(); ++k)
    ensemble.set_velocities(static_cast<int>(k), throws[k].velocity);
  std::vector<int> middle;
  for (int i = 0; i < static_cast<int>(plate.centre.size()); ++i)
    if (std::abs(plate.centre[i].x() / plate.box.length - 0.5) < watched) middle.push_back(i);
  std::vector<Swing> swings(throws.size());
  const int steps = static_cast<int>(duration / dt);
  for (int n = 1; n <= steps; ++n) {
    ensemble.step();
    if (n % stride != 0) continue;
    for (std::size_t k = 0; k < throws.size(); ++k) {
      double sum = 0.0;
      for (int i : middle)
        sum += plate.mass[i] *
               ensemble.motion(i, static_cast<int>(k)).head<2>().dot(throws[k].velocity[i].head<2>());
      swings[k].time.push_back(n * dt), swings[k].value.push_back(sum);
    }
    if (!go_on(static_cast<double>(n) / steps)) throw base::Interrupted("measuring waves");
  }
  return swings;
}

}  // namespace

std::vector<Wave> measured_waves(const lattice::Lattice& plate, double dt, const theory::WaveSpeeds& expected,
                                 int threads, const base::ProgressCallback& progress) {
  constexpr std::size_t lanes = 8;
  constexpr double largest_misfit = 0.1;
  lattice::Lattice free = plate;
  std::fill(free.grip.begin(), free.grip.end(), packing::Grip::none);
  const std::vector<Throw> throws = all_throws(free, expected);
  std::vector<Wave> waves;
  for (std::size_t first = 0; first < throws.size(); first += lanes) {
    const std::span<const Throw> some =
        std::span(throws).subspan(first, std::min(lanes, throws.size() - first));
    const auto swings = watch(free, dt, time_to_echo(free, expected), some, threads, [&](double done) {
      const double all = static_cast<double>(throws.size());
      return !progress ||
             progress((static_cast<double>(first) + done * static_cast<double>(some.size())) / all);
    });
    for (std::size_t k = 0; k < some.size(); ++k) {
      Wave wave = some[k].wave;
      const double omega = frequency_of(swings[k], some[k].frequency);
      wave.speed = omega * wave.wavelength / (2.0 * pi);
      wave.misfit = residual(swings[k], omega) / square_of(swings[k]);
      if (wave.misfit <= largest_misfit) waves.push_back(wave);
    }
  }
  return waves;
}

}  // namespace rift::measurement

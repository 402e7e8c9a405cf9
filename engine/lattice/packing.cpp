#include "engine/lattice/packing.hpp"

#include "engine/interrupted.hpp"
#include "engine/lattice/neighbours.hpp"
#include "engine/lattice/pile.hpp"
#include "engine/lattice/settle.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <numeric>
#include <random>

namespace rift {
namespace {

constexpr double largest_mean_overlap = 0.04;

/// The same reals from the same seed with any standard library.
struct UniformReal {
  std::mt19937_64 engine;
  double operator()() { return static_cast<double>(engine() >> 11) * 0x1.0p-53; }
};

/// Every patch of the box (a few radii wide) gets its share of spheres, at
/// random places in it: random in the small, but without the long waves of
/// density that a free random start has and that take most of the time to
/// relax.
Pile loose_start(const PackingRequest& request, double unit, double scale) {
  constexpr double patch = 4.0;
  UniformReal uniform{std::mt19937_64(request.seed)};
  const Eigen::Vector3d box =
      Eigen::Vector3d(request.box.length, request.box.height, request.box.thickness) / unit;
  const Eigen::Array3d count = (box.array() / patch).round().max(1.0);
  const Eigen::Array3d size = box.array() / count;
  std::vector<Pile::Sphere> spheres;
  for (int i = 0; i < request.elements; ++i) {
    const double shape = 1.0 + request.radius_spread * (2.0 * uniform() - 1.0);
    const double nth = std::floor(count.prod() * (i + uniform()) / request.elements);
    const Eigen::Array3d at(std::floor(nth / (count[1] * count[2])),
                            std::floor(std::fmod(nth / count[2], count[1])), std::fmod(nth, count[2]));
    Eigen::Array3d within;
    for (int c = 0; c < 3; ++c) within[c] = uniform();
    const Eigen::Array3d p = (at + within) * size;
    spheres.push_back({p[0], p[1], p[2], shape});
  }
  return make_pile(box, scale, spheres);
}

/// Counts the rounds and guesses how much of the work is done: the unbalance
/// falls by a steady factor a round.
struct Watch {
  const Pile& pile;
  const PackingProgress& progress;
  double grown = 0.0;  // share of the growth done
  int rounds = 0;
  double done = 0.0;

  void operator()(int more) {
    constexpr double growth = 0.25, search = 0.6,
                     rest = 0.15;        // shares of the time
    constexpr int most_rounds = 40'000;  // twenty times what a plate takes
    rounds += more;
    double now = growth * grown;
    if (grown >= 1.0 && pile.unbalance() > 0.0) {
      const double digits = -std::log10(pile.unbalance());
      now += search * std::clamp(digits / 3.0, 0.0, 1.0) + rest * std::clamp((digits - 3.0) / 3.0, 0.0, 1.0);
    }
    done = std::max(done, now);
    if (progress && !progress(done)) throw Interrupted("packing");
    if (rounds > most_rounds)
      throw PackingError(
          fmt::format("{} elements find no rest: after {} rounds the net forces are {:.1g} "
                      "of the "
                      "contact forces, at a coordination of {:.4g}",
                      pile.size(), rounds, pile.unbalance(), pile.coordination()));
  }
};

/// Soft enough for the pile to find a good place, hard enough to come to rest:
/// 1e-3 takes 1,400 rounds.
constexpr double damping = 0.01;
constexpr double rough = 1e-3;       // an unbalance from which Newton's method gets on
constexpr double closeness = 0.015;  // how far above the target the coordination may lie

/// Grows in small strides, each relaxed for a moment only: converging below the
/// jamming density is slow and of no use.
void grow_roughly(Pile& pile, Crew& crew, double scale, Watch& watch) {
  constexpr int strides = 12, rounds_each = 20;
  constexpr double strong_damping = 0.2;
  const double stride = std::pow(scale / pile.scale, 1.0 / strides);
  for (int k = 0; k < strides; ++k) {
    pile.scale *= stride;
    evaluate_forces(pile, crew);
    relax(pile, crew, 0.0, strong_damping, rounds_each, std::ref(watch));
    watch.grown = (k + 1.0) / strides;
  }
}

/// dz / d(ln scale): coordination rises with the root of the overlap, from its
/// value at jamming.
double slope_of(const Pile& pile) {
  constexpr double loose = 1e-3;
  return 0.5 / std::max(loose, pile.mean_overlap());
}

/// Lets the pile calm down and nudges the scale on the way, so that it comes to
/// rest near the coordination.
void approach(Pile& pile, Crew& crew, double coordination, Watch& watch) {
  constexpr double calm = 0.05, loose = 1e-3, gain = 0.3, largest_nudge = 1e-3;
  constexpr int most_bursts = 80, hot_bursts = 30, rounds_each = 25;
  for (int k = 0; k < most_bursts && pile.mean_overlap() <= largest_mean_overlap; ++k) {
    if (relax(pile, crew, rough, damping, rounds_each, std::ref(watch))) return;
    const bool too_early = k < hot_bursts && pile.unbalance() > calm && pile.mean_overlap() > loose;
    const double missing = coordination + 0.5 * closeness - pile.coordination();
    if (too_early || std::abs(missing) < 0.25 * closeness) continue;
    pile.scale *= 1.0 + std::clamp(gain * missing / slope_of(pile), -largest_nudge, largest_nudge);
  }
}

/// Moves the scale until the coordination at a minimum is the one asked for, or
/// little above.
void grow_to(Pile& pile, Crew& crew, double coordination, Watch& watch) {
  constexpr double tight = 1e-6, largest_stride = 0.005;
  constexpr int most_trials = 60, most_rounds = 4000;
  double caution = 1.0, last_missing = 0.0;
  approach(pile, crew, coordination, watch);
  for (int trial = 0; trial < most_trials && pile.mean_overlap() <= largest_mean_overlap; ++trial) {
    relax(pile, crew, rough, damping, most_rounds, std::ref(watch));
    settle(pile, crew, tight, damping, std::ref(watch));
    const double excess = pile.coordination() - coordination, missing = 0.5 * closeness - excess;
    if (excess >= 0.0 && excess < closeness && pile.mean_overlap() <= largest_mean_overlap) return;
    caution = std::max(1.0, caution * (missing * last_missing < 0.0 ? 1.5 : 0.8));
    last_missing = missing;
    pile.scale *= 1.0 + std::clamp(missing / (caution * slope_of(pile)), -largest_stride, largest_stride);
    evaluate_forces(pile, crew);
  }
  throw PackingError(fmt::format(
      "a coordination of {:.4g} is out of reach: "
      "{:.4g} takes a mean overlap of {:.1f} % of "
      "r_i + r_j (limit {:.0f} %)",
      coordination, pile.coordination(), 100.0 * pile.mean_overlap(), 100.0 * largest_mean_overlap));
}

}  // namespace

Packing pack_box(const PackingRequest& request, const PackingProgress& progress, int threads) {
  constexpr double expected_fraction = 0.615, start_fraction = 0.5, start_of_search = 0.994;
  const double sphere = 4.0 / 3.0 * std::numbers::pi;
  const double unit = std::cbrt(request.box.volume() * expected_fraction / (request.elements * sphere));
  Pile pile = loose_start(request, unit, std::cbrt(start_fraction / expected_fraction));
  Crew crew(threads, pile.chunks());
  Watch watch{pile, progress};
  grow_roughly(pile, crew, start_of_search, watch);
  grow_to(pile, crew, request.coordination, watch);
  std::vector<Eigen::Vector3d> centre;
  for (const auto& s : pile.sphere) centre.emplace_back(s.x, s.y, s.z);
  Packing packing;
  for (int k : column_order(centre, 2.0 * pile.scale)) {
    packing.centre.push_back(centre[k] * unit);
    packing.radius.push_back(pile.sphere[k].shape * pile.scale * unit);
  }
  return packing;
}

std::vector<std::array<int, 2>> contacts(const Packing& packing, double tolerance) {
  std::vector<double> reach(packing.radius);
  for (double& r : reach) r *= tolerance;
  return pairs_within_reach(packing.centre, reach);
}

PackingStatistics statistics(const Packing& packing, const Box& box) {
  PackingStatistics s;
  const auto touching = contacts(packing, 1.0);
  const double n = static_cast<double>(packing.radius.size());
  for (const auto& [i, j] : touching)
    s.mean_overlap +=
        1.0 - (packing.centre[i] - packing.centre[j]).norm() / (packing.radius[i] + packing.radius[j]);
  if (!touching.empty()) s.mean_overlap /= static_cast<double>(touching.size());
  s.coordination = 2.0 * static_cast<double>(touching.size()) / n;
  for (double r : packing.radius) {
    s.mean_radius += r / n;
    s.solid_fraction += 4.0 / 3.0 * std::numbers::pi * r * r * r / box.volume();
  }
  return s;
}

}  // namespace rift

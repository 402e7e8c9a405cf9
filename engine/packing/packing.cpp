#include "engine/packing/packing.hpp"

#include "engine/packing/minimise.hpp"
#include "engine/packing/neighbours.hpp"
#include "engine/packing/sphere_packing.hpp"

#include <fmt/core.h>
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <numeric>
#include <random>

namespace rift::packing {
namespace {

constexpr double largest_mean_overlap = 0.04;

/// The same reals from the same seed with any standard library.
struct UniformReal {
  std::mt19937_64 engine;
  double operator()() { return static_cast<double>(engine() >> 11) * 0x1.0p-53; }
};

/// Radii around a mean of 1.
class Shapes {
 public:
  Shapes(const PackingRequest& request, UniformReal& uniform) : request_(request), uniform_(uniform) {}
  double operator()() {
    const double spread = request_.radius_spread;
    if (request_.radii == Radii::uniform) return 1.0 + spread * (2.0 * uniform_() - 1.0);
    const double distance = std::sqrt(-2.0 * std::log(1.0 - uniform_()));  // Box and Muller 1958
    const double normal = distance * std::cos(2.0 * std::numbers::pi * uniform_());
    return std::exp(spread * (normal - 0.5 * spread));
  }

 private:
  const PackingRequest& request_;
  UniformReal& uniform_;
};

Box in_units(Box box, double unit) {
  box.length /= unit, box.height /= unit, box.thickness /= unit;
  return box;
}

/// Every patch of the box (a few radii wide) gets its share of `places`, at random in it: random in the
/// small, but without the long waves of density that a free random start has and that take most of the time
/// to relax.
class Places {
 public:
  Places(const Box& box, int places, UniformReal& uniform) : places_(places), uniform_(uniform) {
    constexpr double patch = 4.0;
    count_ = (box.size().array() / patch).round().max(1.0);
    size_ = box.size().array() / count_;
  }
  Eigen::Vector3d operator()(int i) {
    const double nth = std::floor(count_.prod() * (i + uniform_()) / places_);
    const Eigen::Array3d at(std::floor(nth / (count_[1] * count_[2])),
                            std::floor(std::fmod(nth / count_[2], count_[1])), std::fmod(nth, count_[2]));
    Eigen::Array3d within;
    for (int c = 0; c < 3; ++c) within[c] = uniform_();
    return (at + within) * size_;
  }

 private:
  int places_;
  UniformReal& uniform_;
  Eigen::Array3d count_, size_;
};

/// In a box each sphere has its place. Round walls cut patches: more places than spheres are then drawn over
/// the box around, what lies outside is dropped, and of the others some at random.
SpherePacking loose_start(const PackingRequest& request, double unit, double scale) {
  UniformReal uniform{std::mt19937_64(request.seed)};
  Shapes shape(request, uniform);
  const Box box = in_units(request.box, unit);
  std::vector<SpherePacking::Sphere> spheres;
  if (box.is_cuboid() || box.shape == Shape::periodic) {
    Places place(box, request.elements, uniform);
    for (int i = 0; i < request.elements; ++i) {
      const double s = shape();
      const Eigen::Vector3d p = place(i);
      spheres.push_back({p[0], p[1], p[2], s});
    }
    return make_sphere_packing(box, scale, spheres);
  }
  std::vector<Eigen::Vector3d> inside;
  const double in_box = request.elements * box.size().prod() / box.volume();
  for (double more = 1.02; static_cast<int>(inside.size()) < request.elements; more *= 1.1) {
    inside.clear();
    const int places = static_cast<int>(more * in_box) + 10;
    Places place(box, places, uniform);
    for (int i = 0; i < places; ++i)
      if (const Eigen::Vector3d p = place(i); contains(box, p)) inside.push_back(p);
  }
  for (int left = request.elements, k = 0; left > 0; ++k)  // each as likely as any other, in their order
    if (uniform() * (static_cast<double>(inside.size()) - k) < left) {
      spheres.push_back({inside[k][0], inside[k][1], inside[k][2], shape()});
      --left;
    }
  return make_sphere_packing(box, scale, spheres);
}

/// Counts the rounds and tells how much of the work is done. How many trials it takes to hit the coordination
/// is not known beforehand: the first is taken for three quarters of what follows the growth, and each
/// further one, which starts near a rest, for three quarters of what is left then. Within a trial the
/// unbalance falls by a steady factor a round.
struct Watch {
  const SpherePacking& spheres;
  const base::ProgressCallback& progress;
  double grown = 0.0;  // share of the growth done
  double goal = 1e-6;  // the unbalance at which a trial ends
  int trial = 0;
  int rounds = 0, untold = 0;
  double done = 0.0;

  void operator()(int more) {
    constexpr long worth_telling = 20'000;  // elements moved: about a millisecond
    constexpr double growth = 0.12;         // of the rounds of a plate that needs one trial
    constexpr double after_trial = 0.25;
    constexpr int most_rounds = 40'000;  // twenty times what a plate takes
    rounds += more, untold += more;
    if (long{untold} * spheres.size() < worth_telling) return;
    untold = 0;
    double now = growth * grown;
    if (grown >= 1.0 && spheres.unbalance() > 0.0) {
      const double in_trial = std::clamp(std::log(spheres.unbalance()) / std::log(goal), 0.0, 1.0);
      const double left = (1.0 - growth) * std::pow(after_trial, trial);
      now = 1.0 - left + left * (1.0 - after_trial) * in_trial;
    }
    done = std::max(done, now);
    if (progress && !progress(done)) throw base::Interrupted("packing");
    if (rounds > most_rounds)
      throw PackingError(
          fmt::format("the packing of {} elements did not reach equilibrium: after {} iterations the net "
                      "forces are {:.1g} of the contact forces, at a coordination of {:.4g}",
                      spheres.size(), rounds, spheres.unbalance(), spheres.coordination()));
  }
};

/// Soft enough for the packing to find a good place, hard enough to come to rest:
/// 1e-3 takes 1,400 rounds.
constexpr double damping = 0.01;
constexpr double release_damping = 0.1;  // of a packing that is pressed too hard and may hurry
constexpr double rough = 1e-3;           // an unbalance from which Newton's method gets on
constexpr double closeness = 0.015;      // how far above the target the coordination may lie

/// Grows in small strides, each relaxed for a moment only: converging below the jamming density is slow and
/// of no use.
void grow_roughly(SpherePacking& spheres, base::ThreadPool& pool, double scale, Watch& watch) {
  constexpr int strides = 12, rounds_each = 20;
  constexpr double strong_damping = 0.2;
  const double stride = std::pow(scale / spheres.scale, 1.0 / strides);
  for (int k = 0; k < strides; ++k) {
    spheres.scale *= stride;
    evaluate_forces(spheres, pool);
    damped_relaxation(spheres, pool, 0.0, strong_damping, rounds_each, std::ref(watch));
    watch.grown = (k + 1.0) / strides;
  }
}

[[noreturn]] void refuse_coordination(const SpherePacking& spheres, double coordination) {
  throw PackingError(
      fmt::format("a coordination of {:.4g} is out of reach: at a mean overlap of {:.1f} % of r_i + r_j, of "
                  "which {:.0f} % is the limit, it is {:.4g}",
                  coordination, 100.0 * spheres.mean_overlap(), 100.0 * largest_mean_overlap,
                  spheres.coordination()),
      spheres.coordination());
}

/// dz / d(ln scale): coordination rises with the root of the overlap, from its value at jamming.
double slope_of(const SpherePacking& spheres) {
  constexpr double loose = 1e-3;
  return 0.5 / std::max(loose, spheres.mean_overlap());
}

/// Lets the packing calm down and nudges the scale on the way, so that it comes to
/// rest near the coordination.
void approach(SpherePacking& spheres, base::ThreadPool& pool, double coordination, Watch& watch) {
  constexpr double calm = 0.05, loose = 1e-3, gain = 0.3, largest_nudge = 1e-3;
  constexpr int most_bursts = 80, hot_bursts = 30, rounds_each = 25;
  for (int k = 0; k < most_bursts && spheres.mean_overlap() <= largest_mean_overlap; ++k) {
    if (damped_relaxation(spheres, pool, rough, damping, rounds_each, std::ref(watch))) return;
    const bool too_early = k < hot_bursts && spheres.unbalance() > calm && spheres.mean_overlap() > loose;
    const double missing = coordination + 0.5 * closeness - spheres.coordination();
    if (too_early || std::abs(missing) < 0.25 * closeness) continue;
    spheres.scale *= 1.0 + std::clamp(gain * missing / slope_of(spheres), -largest_nudge, largest_nudge);
  }
}

/// Spheres of very unequal radii fill a box at a smaller scale than equal ones: shrinks them until they no
/// longer press each other too hard.
void loosen(SpherePacking& spheres, base::ThreadPool& pool, Watch& watch) {
  constexpr int rounds_each = 100;
  constexpr double stride = 0.99;
  while (spheres.mean_overlap() > 0.5 * largest_mean_overlap) {
    spheres.scale *= stride;
    evaluate_forces(spheres, pool);
    damped_relaxation(spheres, pool, rough, release_damping, rounds_each, std::ref(watch));
  }
}

/// Moves the scale until the coordination at a minimum is the one asked for, or little above.
void grow_to(SpherePacking& spheres, base::ThreadPool& pool, double coordination, Watch& watch) {
  constexpr double tight = 1e-6, largest_stride = 0.005;
  constexpr int most_trials = 60, most_rounds = 4000;
  double caution = 1.0, last_missing = 0.0;
  approach(spheres, pool, coordination, watch);
  for (int trial = 0; trial < most_trials && spheres.mean_overlap() <= largest_mean_overlap; ++trial) {
    damped_relaxation(spheres, pool, rough, damping, most_rounds, std::ref(watch));
    minimise_newton(spheres, pool, tight, damping, std::ref(watch));
    ++watch.trial;
    const double excess = spheres.coordination() - coordination, missing = 0.5 * closeness - excess;
    if (excess >= 0.0 && excess < closeness && spheres.mean_overlap() <= largest_mean_overlap) return;
    caution = std::max(1.0, caution * (missing * last_missing < 0.0 ? 1.5 : 0.8));
    last_missing = missing;
    spheres.scale *=
        1.0 + std::clamp(missing / (caution * slope_of(spheres)), -largest_stride, largest_stride);
    evaluate_forces(spheres, pool);
  }
  refuse_coordination(spheres, coordination);
}

/// How the scale must change for the coordination to rise by `missing`: z is linear in the root of the mean
/// overlap (O'Hern et al. 2003), which grows as ln(scale) does.
double stride_for(const SpherePacking& spheres, double missing) {
  constexpr double slope = 14.0, least = 0.7, most = 1.2;  // dz / d root; root over root before
  const double root = std::sqrt(spheres.mean_overlap());
  const double wanted = std::clamp(root + missing / slope, least * root, most * root);
  return wanted * wanted - root * root;
}

/// Relaxes until the net forces are what shifts of 5e-5 radii make: near jamming contact forces are small,
/// and a millionth of them would be out of proportion.
void bring_to_rest(SpherePacking& spheres, base::ThreadPool& pool, Watch& watch) {
  constexpr double shift = 5e-5;
  constexpr int rounds_each = 25;
  watch.goal = std::min(0.1, shift / spheres.mean_contact_force());
  while (!damped_relaxation(spheres, pool, shift / spheres.mean_contact_force(), release_damping, rounds_each,
                            std::ref(watch))) {
  }
}

/// Brings a packing that presses too hard down to the coordination: a compressed packing finds a rest quickly
/// and stays near one while it is released, where one that grows towards jamming wanders. First with the
/// packing still moving, then from rest to rest.
void release_to(SpherePacking& spheres, base::ThreadPool& pool, double coordination, Watch& watch) {
  constexpr double still_moving = 0.03;
  constexpr double yet_to_come = 0.03;  // what the coordination of such a packing gains on its way to rest
  constexpr int most_trials = 40, most_rounds = 2000;
  const auto missing = [&] { return coordination + 0.5 * closeness - spheres.coordination(); };
  const auto stride = [&](double more) {
    spheres.scale *= 1.0 + stride_for(spheres, more);
    evaluate_forces(spheres, pool);
  };
  for (int trial = 0; trial < most_trials; ++trial) {
    damped_relaxation(spheres, pool, still_moving, release_damping, most_rounds, std::ref(watch));
    if (missing() - yet_to_come >= -closeness) break;
    stride(missing() - yet_to_come);
  }
  for (int trial = 0; trial < most_trials && spheres.mean_overlap() <= largest_mean_overlap; ++trial) {
    bring_to_rest(spheres, pool, watch);
    ++watch.trial;
    const double excess = spheres.coordination() - coordination;
    if (excess >= 0.0 && excess < closeness) return;
    stride(missing());
  }
  refuse_coordination(spheres, coordination);
}

double volume_of(const SpherePacking& spheres) {
  double cubes = 0.0;
  for (const SpherePacking::Sphere& s : spheres.sphere) cubes += s.shape * s.shape * s.shape;
  return 4.0 / 3.0 * std::numbers::pi * cubes * spheres.scale * spheres.scale * spheres.scale;
}

/// Lets the packing come to rest at the scale that gives the solid fraction.
void grow_to_fraction(SpherePacking& spheres, base::ThreadPool& pool, double solid_fraction, Watch& watch) {
  constexpr double loose = 2e-4;
  constexpr int rounds = 1000;
  spheres.scale *= std::cbrt(solid_fraction * spheres.box.volume() / volume_of(spheres));
  evaluate_forces(spheres, pool);
  damped_relaxation(spheres, pool, rough, release_damping, rounds, std::ref(watch));
  if (spheres.mean_overlap() <= loose)
    throw PackingError(
        fmt::format("a solid fraction of {:.4g} is too low: elements carry load only where they are in "
                    "contact, from about 0.63 on",
                    solid_fraction));
  bring_to_rest(spheres, pool, watch);
  if (spheres.mean_overlap() > largest_mean_overlap)
    throw PackingError(
        fmt::format("a solid fraction of {:.4g} is out of reach: it takes a mean overlap of "
                    "{:.1f} % of r_i + r_j (limit {:.0f} %)",
                    solid_fraction, 100.0 * spheres.mean_overlap(), 100.0 * largest_mean_overlap));
}

/// Whether walls hold so much of the packing that it presses hard at any coordination: fewer than six
/// elements between two of them. What is thicker has a coordination of 6 near jamming.
bool is_thin(const Box& box, double mean_radius) {
  return box.is_cuboid() && box.size().minCoeff() < 12.0 * mean_radius;
}

}  // namespace

Packing pack(const PackingRequest& request, const base::ProgressCallback& progress, int threads) {
  constexpr double expected_fraction = 0.615, start_fraction = 0.5;
  constexpr double below_target = 0.994, above_target = 1.02;  // where the search starts
  base::tell_or_stop(progress, 0.0, "packing");
  const double sphere = 4.0 / 3.0 * std::numbers::pi;
  const double unit = std::cbrt(request.box.volume() * expected_fraction / (request.elements * sphere));
  SpherePacking spheres = loose_start(request, unit, std::cbrt(start_fraction / expected_fraction));
  base::ThreadPool pool(threads, spheres.chunks());
  Watch watch{spheres, progress};
  const bool thin = is_thin(request.box, unit);
  grow_roughly(spheres, pool, thin ? below_target : above_target, watch);
  if (request.solid_fraction > 0.0) {
    grow_to_fraction(spheres, pool, request.solid_fraction, watch);
  } else if (thin) {
    if (spheres.mean_overlap() > largest_mean_overlap) loosen(spheres, pool, watch);
    grow_to(spheres, pool, request.coordination, watch);
  } else {
    release_to(spheres, pool, request.coordination, watch);
  }
  if (request.box.shape == Shape::periodic) wrap(spheres);
  std::vector<Eigen::Vector3d> centre;
  for (const auto& s : spheres.sphere) centre.emplace_back(s.x, s.y, s.z);
  Packing packing;
  for (int k : column_order(centre, 2.0 * spheres.scale)) {
    packing.centre.push_back(centre[k] * unit);
    packing.radius.push_back(spheres.sphere[k].shape * spheres.scale * unit);
  }
  return packing;
}

std::vector<std::array<int, 2>> contacts(const Packing& packing, const Box& box, double tolerance) {
  std::vector<double> reach(packing.radius);
  for (double& r : reach) r *= tolerance;
  return box.shape == Shape::periodic ? pairs_through_faces(packing.centre, reach, box.size())
                                      : pairs_within_reach(packing.centre, reach);
}

PackingStatistics statistics(const Packing& packing, const Box& box) {
  PackingStatistics s;
  const auto touching = contacts(packing, box, 1.0);
  const double n = static_cast<double>(packing.radius.size());
  for (const auto& [i, j] : touching)
    s.mean_overlap += 1.0 - minimum_image(box, packing.centre[i], packing.centre[j]).norm() /
                                (packing.radius[i] + packing.radius[j]);
  if (!touching.empty()) s.mean_overlap /= static_cast<double>(touching.size());
  s.coordination = 2.0 * static_cast<double>(touching.size()) / n;
  for (double r : packing.radius) {
    s.mean_radius += r / n;
    s.solid_fraction += 4.0 / 3.0 * std::numbers::pi * r * r * r / box.volume();
  }
  return s;
}

std::string key_of(const PackingRequest& r) {
  constexpr int version = 3;  // rises whenever pack() gives other packings for the same request
  constexpr const char* shape[] = {"", "", " cylinder", " sphere", " periodic"};  // plates are thin blocks
  std::string key = fmt::format(
      "packing {} box {:a} {:a} {:a} elements {} spread {:a} coordination {:a} seed {}", version,
      r.box.length, r.box.height, r.box.thickness, r.elements, r.radius_spread, r.coordination, r.seed);
  key += shape[static_cast<int>(r.box.shape)];
  if (r.radii == Radii::log_normal) key += " log-normal";
  if (r.solid_fraction > 0.0) key += fmt::format(" solid fraction {:a}", r.solid_fraction);
  return key;
}

Packing cached_packing(const PackingRequest& request, base::Cache& cache, bool& from_cache,
                       const base::ProgressCallback& progress, int threads) {
  Packing packing;
  const std::string key = key_of(request);
  if (const auto numbers = base::recall(cache, "packing", key);
      numbers && numbers->size() == 4UL * request.elements) {
    from_cache = true;
    for (std::size_t k = 0; k < numbers->size(); k += 4) {
      packing.centre.emplace_back((*numbers)[k], (*numbers)[k + 1], (*numbers)[k + 2]);
      packing.radius.push_back((*numbers)[k + 3]);
    }
    return packing;
  }
  packing = pack(request, progress, threads);
  std::vector<double> numbers;
  for (std::size_t i = 0; i < packing.radius.size(); ++i)
    numbers.insert(numbers.end(),
                   {packing.centre[i].x(), packing.centre[i].y(), packing.centre[i].z(), packing.radius[i]});
  base::remember(cache, "packing", key, numbers);
  return packing;
}

}  // namespace rift::packing

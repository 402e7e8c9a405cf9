#include "engine/lattice/packing.hpp"

#include "engine/interrupted.hpp"
#include "engine/lattice/neighbours.hpp"

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

/// Spheres in units of their expected mean radius, with unit contact stiffness and unit mass.
struct Pile {
  Eigen::Vector3d box;
  std::vector<double> shape;  // radius at scale 1
  std::vector<Eigen::Vector3d> position, velocity, force;
  double scale = 1.0;

  std::vector<std::array<int, 2>> candidates;  // pairs that may touch
  std::vector<Eigen::Vector3d> position_then;  // when they were listed
  double scale_then = 0.0;

  int contacts = 0;
  double contact_force_sum = 0.0;  // of element contacts

  int size() const { return static_cast<int>(shape.size()); }
};

constexpr double skin = 0.25;  // how much further than touching the candidates reach, in mean radii

void list_candidates(Pile& pile) {
  std::vector<double> reach(pile.shape.size());
  for (int i = 0; i < pile.size(); ++i) reach[i] = pile.scale * pile.shape[i] + 0.5 * skin;
  pile.candidates = pairs_within_reach(pile.position, reach);
  pile.position_then = pile.position;
  pile.scale_then = pile.scale;
}

bool candidates_are_stale(const Pile& pile) {
  const double growth =
      (pile.scale - pile.scale_then) * *std::max_element(pile.shape.begin(), pile.shape.end());
  const double allowed = 0.5 * skin - growth;
  if (allowed <= 0.0 || pile.position_then.empty()) return true;
  for (int i = 0; i < pile.size(); ++i)
    if ((pile.position[i] - pile.position_then[i]).squaredNorm() > allowed * allowed) return true;
  return false;
}

/// Forces f = -dU/dx of the overlaps; a wall pushes as the sphere's mirror image behind it would.
///  counts the contacts and sums their forces on the way.
void evaluate_forces(Pile& pile) {
  if (candidates_are_stale(pile)) list_candidates(pile);
  for (int i = 0; i < pile.size(); ++i) {
    const double r = pile.scale * pile.shape[i];
    const Eigen::Vector3d& p = pile.position[i];
    for (int c = 0; c < 3; ++c)
      pile.force[i][c] = 2.0 * (std::max(0.0, r - p[c]) - std::max(0.0, r - (pile.box[c] - p[c])));
  }
  pile.contacts = 0;
  pile.contact_force_sum = 0.0;
  for (const auto& [i, j] : pile.candidates) {
    const Eigen::Vector3d d = pile.position[j] - pile.position[i];
    const double touching = pile.scale * (pile.shape[i] + pile.shape[j]);
    const double squared = d.squaredNorm();
    if (squared >= touching * touching) continue;
    const double distance = std::sqrt(squared);
    const double overlap = touching - distance;
    const Eigen::Vector3d f =
        (distance > 0.0) ? Eigen::Vector3d(d * (overlap / distance)) : Eigen::Vector3d(overlap, 0.0, 0.0);
    pile.force[i] -= f;
    pile.force[j] += f;
    ++pile.contacts;
    pile.contact_force_sum += overlap;
  }
}

/// In units of the mean radius, r_i + r_j is 2 scale on average to first order in the spread.
double mean_overlap_of(const Pile& pile) {
  return pile.contacts ? pile.contact_force_sum / pile.contacts / (2.0 * pile.scale) : 0.0;
}

double coordination_of(const Pile& pile) { return 2.0 * pile.contacts / pile.size(); }

struct Motion {
  double power = 0.0, speed2 = 0.0, force2 = 0.0;  // sums of f.v, v.v, f.f
};

Motion motion_of(const Pile& pile) {
  Motion m;
  for (int i = 0; i < pile.size(); ++i) {
    m.power += pile.force[i].dot(pile.velocity[i]);
    m.speed2 += pile.velocity[i].squaredNorm();
    m.force2 += pile.force[i].squaredNorm();
  }
  return m;
}

/// Whether the root mean square of the net forces is below `tolerance` mean contact forces; so where nothing
/// touches.
bool balanced(const Pile& pile, const Motion& motion, double tolerance) {
  if (pile.contacts == 0) return tolerance > 0.0;
  return std::sqrt(motion.force2 / pile.size()) < tolerance * pile.contact_force_sum / pile.contacts;
}

/// FIRE: inertia that turns towards the force, and stops where it would climb (Bitzek et al. 2006).
void minimise(Pile& pile, double tolerance, int most_rounds, const std::function<void()>& breathe) {
  // Stability of the explicit step: omega^2 <= 2 z k / m with about a dozen contacts at most.
  constexpr double dt_max = 0.4, dt_min = 0.02, dt_start = 0.1, alpha_start = 0.1;
  constexpr int patience = 5;
  double dt = dt_start, alpha = alpha_start;
  int downhill = 0;
  for (auto& v : pile.velocity) v.setZero();
  evaluate_forces(pile);
  for (int round = 0; round < most_rounds; ++round) {
    const Motion motion = motion_of(pile);
    if (balanced(pile, motion, tolerance)) return;
    double keep = 1.0, turn = 0.0;
    if (motion.power > 0.0) {
      keep = 1.0 - alpha;
      turn = alpha * std::sqrt(motion.speed2 / motion.force2);
      if (++downhill > patience) dt = std::min(1.1 * dt, dt_max), alpha *= 0.99;
    } else {
      keep = 0.0;
      for (int i = 0; i < pile.size(); ++i)
        pile.position[i] -= 0.5 * dt * pile.velocity[i];  // half of the climb
      dt = std::max(0.5 * dt, dt_min), alpha = alpha_start, downhill = 0;
    }
    for (int i = 0; i < pile.size(); ++i) {
      pile.velocity[i] = keep * pile.velocity[i] + (turn + dt) * pile.force[i];
      pile.position[i] += dt * pile.velocity[i];
    }
    evaluate_forces(pile);
    if (round % 50 == 0) breathe();
  }
}

/// Every patch of the box (a few radii wide) gets its share of spheres, at random places in it: random in the
/// small, but without the long waves of density that a free random start has and that take most of the time
/// to relax.
Pile loose_start(const PackingRequest& request, double unit) {
  constexpr double patch = 4.0;
  UniformReal uniform{std::mt19937_64(request.seed)};
  Pile pile;
  pile.box = Eigen::Vector3d(request.box.length, request.box.height, request.box.thickness) / unit;
  const Eigen::Array3d count = (pile.box.array() / patch).round().max(1.0);
  const Eigen::Array3d size = pile.box.array() / count;
  for (int i = 0; i < request.elements; ++i) {
    pile.shape.push_back(1.0 + request.radius_spread * (2.0 * uniform() - 1.0));
    const double nth = std::floor(count.prod() * (i + uniform()) / request.elements);
    const Eigen::Array3d at(std::floor(nth / (count[1] * count[2])),
                            std::floor(std::fmod(nth / count[2], count[1])), std::fmod(nth, count[2]));
    Eigen::Array3d within;
    for (int c = 0; c < 3; ++c) within[c] = uniform();
    pile.position.push_back(((at + within) * size).matrix());
  }
  pile.velocity.assign(pile.position.size(), Eigen::Vector3d::Zero());
  pile.force = pile.velocity;
  return pile;
}

/// Grows in small strides, each relaxed for a moment only: converging below the jamming density is slow and
/// of no use.
void grow_roughly(Pile& pile, double scale, const std::function<void()>& breathe) {
  constexpr int strides = 12, rounds_each = 40;
  const double stride = std::pow(scale / pile.scale, 1.0 / strides);
  for (int k = 0; k < strides; ++k) {
    pile.scale *= stride;
    minimise(pile, 0.0, rounds_each, breathe);
  }
}

/// Moves the scale by secants until the coordination at a minimum is the one asked for, or little above.
void grow_to(Pile& pile, double coordination, const std::function<void(double)>& report) {
  constexpr double rough = 1e-3, tight = 1e-6, closeness = 0.015, largest_stride = 0.01;
  constexpr int most_rounds = 100'000, most_trials = 60;
  double slope = 40.0;  // dz / d(ln scale) near z = 6, for the first secant only
  double done = 0.1, last_z = 0.0, last_scale = 0.0;
  const auto breathe = [&] { report(done); };
  const auto reached = [&] {
    const double excess = coordination_of(pile) - coordination;
    return excess >= 0.0 && excess < closeness;
  };
  for (int trial = 0; trial < most_trials; ++trial) {
    minimise(pile, rough, most_rounds, breathe);
    if (reached()) {
      done = 0.7;
      minimise(pile, tight, most_rounds, breathe);
      if (reached()) return;
    }
    if (mean_overlap_of(pile) > largest_mean_overlap) break;
    const double z = coordination_of(pile);
    if (trial > 0 && pile.scale != last_scale)
      slope = std::clamp((z - last_z) / std::log(pile.scale / last_scale), 15.0, 200.0);
    last_z = z, last_scale = pile.scale;
    pile.scale *=
        1.0 + std::clamp((coordination + 0.5 * closeness - z) / slope, -largest_stride, largest_stride);
    done = std::max(done, 0.6 - std::min(0.4, std::abs(coordination - z)));
  }
  throw PackingError(fmt::format(
      "a coordination of {:.4g} is out of reach: {:.4g} takes a mean overlap of {:.1f} % of "
      "r_i + r_j (limit {:.0f} %)",
      coordination, coordination_of(pile), 100.0 * mean_overlap_of(pile), 100.0 * largest_mean_overlap));
}

}  // namespace

Packing pack_box(const PackingRequest& request, const PackingProgress& progress) {
  constexpr double expected_fraction = 0.615, start_fraction = 0.5, start_of_search = 0.994;
  const double sphere = 4.0 / 3.0 * std::numbers::pi;
  const double unit = std::cbrt(request.box.volume() * expected_fraction / (request.elements * sphere));
  Pile pile = loose_start(request, unit);
  pile.scale = std::cbrt(start_fraction / expected_fraction);
  const auto report = [&](double done) {
    if (progress && !progress(done)) throw Interrupted("packing");
  };
  grow_roughly(pile, start_of_search, [&] { report(0.05); });
  grow_to(pile, request.coordination, report);

  Packing packing;
  for (int k : column_order(pile.position, 2.0 * pile.scale)) {
    packing.centre.push_back(pile.position[k] * unit);
    packing.radius.push_back(pile.shape[k] * pile.scale * unit);
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

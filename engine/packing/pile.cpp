#include "engine/packing/pile.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numeric>

namespace rift::packing {
namespace {

/// Elements sorted into cells at least as wide as candidates reach.
struct Cells {
  std::array<int, 3> count;
  std::array<double, 3> per_unit;
  std::vector<int> first, member;

  int at(double p, int axis) const {
    return std::clamp(static_cast<int>(p * per_unit[axis]), 0, count[axis] - 1);
  }
  int index(int x, int y, int z) const { return (x * count[1] + y) * count[2] + z; }

  /// The lowest of the cells beside `at` along an axis, and how many there are; those beyond a face of a
  /// periodic box are those at its other end, none twice.
  std::array<int, 2> beside(int at, int axis, bool periodic) const {
    if (periodic && count[axis] >= 3) return {at - 1, 3};
    const int lowest = std::max(0, at - 1);
    return {lowest, std::min(count[axis] - 1, at + 1) - lowest + 1};
  }
  int wrapped(int at, int axis) const { return (at + count[axis]) % count[axis]; }
};

/// Cells at least `width` wide, and no more than a few per element however thin
/// the box.
Cells sort_into_cells(const Pile& pile, double width) {
  Cells cells;
  const Eigen::Vector3d box = pile.box.size();
  for (double total = std::numeric_limits<double>::infinity(); total > 8.0 * (pile.size() + 1);
       width *= 1.5) {
    total = 1.0;
    for (int c = 0; c < 3; ++c) total *= std::max(1.0, std::floor(box[c] / width));
    for (int c = 0; c < 3; ++c) cells.per_unit[c] = std::max(1.0, std::floor(box[c] / width)) / box[c];
  }
  for (int c = 0; c < 3; ++c) cells.count[c] = static_cast<int>(std::lround(cells.per_unit[c] * box[c]));
  std::vector<int> cell(pile.sphere.size());
  cells.first.assign(cells.count[0] * cells.count[1] * cells.count[2] + 1, 0);
  for (int i = 0; i < pile.size(); ++i) {
    const Pile::Sphere& s = pile.sphere[i];
    cell[i] = cells.index(cells.at(s.x, 0), cells.at(s.y, 1), cells.at(s.z, 2));
    ++cells.first[cell[i] + 1];
  }
  std::partial_sum(cells.first.begin(), cells.first.end(), cells.first.begin());
  std::vector<int> next(cells.first.begin(), cells.first.end() - 1);
  cells.member.resize(pile.sphere.size());
  for (int i = 0; i < pile.size(); ++i) cells.member[next[cell[i]]++] = i;
  return cells;
}

template <bool periodic>
void list_candidates_of(const Pile& pile, const Cells& cells, Pile::Chunk& chunk) {
  chunk.first.assign(1, 0);
  chunk.candidate.clear();
  const auto consider = [&](int i, int cell, int last) {
    const Pile::Sphere& s = pile.sphere[i];
    for (int k = cells.first[cell]; k < cells.first[last + 1]; ++k) {
      const int j = cells.member[k];
      if (j <= i && (j == i || chunk.owns(j))) continue;
      const Pile::Sphere& o = pile.sphere[j];
      const Pile::Vector d = way<periodic>(pile.box, s, o);
      const double limit = pile.scale * (s.shape + o.shape) + pile.skin;
      if (d.x * d.x + d.y * d.y + d.z * d.z <= limit * limit) chunk.candidate.push_back(j);
    }
  };
  for (int i = chunk.begin; i < chunk.end; ++i) {
    const Pile::Sphere& s = pile.sphere[i];
    const auto [x0, nx] = cells.beside(cells.at(s.x, 0), 0, periodic);
    const auto [y0, ny] = cells.beside(cells.at(s.y, 1), 1, periodic);
    const auto [z0, nz] = cells.beside(cells.at(s.z, 2), 2, periodic);
    for (int x = x0; x < x0 + nx; ++x)
      for (int y = y0; y < y0 + ny; ++y) {
        if constexpr (periodic) {
          for (int z = z0; z < z0 + nz; ++z) {
            const int cell = cells.index(cells.wrapped(x, 0), cells.wrapped(y, 1), cells.wrapped(z, 2));
            consider(i, cell, cell);
          }
        } else {
          consider(i, cells.index(x, y, z0), cells.index(x, y, z0 + nz - 1));
        }
      }
    chunk.first.push_back(static_cast<int>(chunk.candidate.size()));
  }
}

bool candidates_are_stale(const Pile& pile) {
  const double allowed = 0.5 * pile.skin - (pile.scale - pile.scale_then) * pile.largest_shape;
  return allowed <= 0.0 || std::any_of(pile.chunk.begin(), pile.chunk.end(), [&](const Pile::Chunk& chunk) {
           return chunk.sums.farthest2 > allowed * allowed;
         });
}

/// Lists them, with a skin that fits the pace of the flow: a wide one lasts
/// longer and costs more each round.
void list_candidates(Pile& pile, base::ThreadPool& crew) {
  constexpr int soon = 8, late = 40;
  constexpr double narrowest = 0.12, widest = 0.6;
  if (pile.rounds_listed < soon) pile.skin = std::min(1.3 * pile.skin, widest);
  if (pile.rounds_listed > late) pile.skin = std::max(0.7 * pile.skin, narrowest);
  pile.rounds_listed = 0;
  const bool periodic = pile.box.shape == Shape::periodic;
  if (periodic) wrap(pile);
  const Cells cells = sort_into_cells(pile, 2.0 * pile.scale * pile.largest_shape + pile.skin);
  crew.run(pile.chunks(), [&](int c) {
    periodic ? list_candidates_of<true>(pile, cells, pile.chunk[c])
             : list_candidates_of<false>(pile, cells, pile.chunk[c]);
    pile.chunk[c].sums.farthest2 = 0.0;
  });
  pile.sphere_then = pile.sphere;
  pile.scale_then = pile.scale;
}

template <bool periodic>
void evaluate_forces_of(Pile& pile, Pile::Chunk& chunk) {
  Pile::Sums sums{.farthest2 = chunk.sums.farthest2};
  for (int i = chunk.begin; i < chunk.end; ++i) {
    const Pile::Sphere& s = pile.sphere[i];
    const Eigen::Vector3d push = wall_push(pile.box, {s.x, s.y, s.z}, pile.scale * s.shape);
    pile.force[i] = {push.x(), push.y(), push.z()};
  }
  for (int i = chunk.begin; i < chunk.end; ++i) {
    const Pile::Sphere s = pile.sphere[i];
    Pile::Vector f = pile.force[i];
    for (int k = chunk.first[i - chunk.begin]; k < chunk.first[i - chunk.begin + 1]; ++k) {
      const int j = chunk.candidate[k];
      const Pile::Sphere& o = pile.sphere[j];
      const Pile::Vector d = way<periodic>(pile.box, s, o);
      const double squared = d.x * d.x + d.y * d.y + d.z * d.z, touching = pile.scale * (s.shape + o.shape);
      if (squared >= touching * touching) continue;
      const double distance = std::sqrt(std::max(squared, std::numeric_limits<double>::min()));
      const double overlap = touching - distance, push = overlap / distance;
      f.x -= d.x * push, f.y -= d.y * push, f.z -= d.z * push;
      if (chunk.owns(j)) {
        Pile::Vector& g = pile.force[j];
        g.x += d.x * push, g.y += d.y * push, g.z += d.z * push;
        sums.half_contacts += 2, sums.contact_force += 2.0 * overlap;
      } else {
        sums.half_contacts += 1, sums.contact_force += overlap;
      }
    }
    pile.force[i] = f;
    sums.force2 += f.x * f.x + f.y * f.y + f.z * f.z;
  }
  chunk.sums = sums;
}

}  // namespace

void wrap(Pile& pile) {
  const auto within = [](double p, double edge) { return p - edge * std::floor(p / edge); };
  for (Pile::Sphere& s : pile.sphere) {
    s.x = within(s.x, pile.box.length);
    s.y = within(s.y, pile.box.height);
    s.z = within(s.z, pile.box.thickness);
  }
}

double Pile::mean_contact_force() const {
  return sums.half_contacts ? sums.contact_force / static_cast<double>(sums.half_contacts) : 0.0;
}

double Pile::unbalance() const {
  return sums.half_contacts ? std::sqrt(sums.force2 / size()) / mean_contact_force() : 0.0;
}

Pile make_pile(const Box& box, double scale, const std::vector<Pile::Sphere>& spheres) {
  Pile pile;
  pile.box = box;
  pile.scale = scale;
  pile.sphere = pile.sphere_then = spheres;
  pile.velocity.resize(spheres.size());
  pile.force.resize(spheres.size());
  for (const auto& s : spheres) pile.largest_shape = std::max(pile.largest_shape, s.shape);
  constexpr int most_chunks = 32, least_size = 256;
  const int size = std::max(least_size, (pile.size() + most_chunks - 1) / most_chunks);
  for (int begin = 0; begin < pile.size(); begin += size) {
    pile.chunk.emplace_back();
    pile.chunk.back().begin = begin;
    pile.chunk.back().end = std::min(begin + size, pile.size());
    pile.chunk.back().sums.farthest2 = std::numeric_limits<double>::infinity();  // nothing listed yet
  }
  return pile;
}

void evaluate_forces(Pile& pile, base::ThreadPool& crew) {
  if (candidates_are_stale(pile)) list_candidates(pile, crew);
  ++pile.rounds_listed;
  const bool periodic = pile.box.shape == Shape::periodic;
  crew.run(pile.chunks(), [&](int c) {
    periodic ? evaluate_forces_of<true>(pile, pile.chunk[c]) : evaluate_forces_of<false>(pile, pile.chunk[c]);
  });
  pile.sums = {};
  for (const auto& chunk : pile.chunk) {
    pile.sums.half_contacts += chunk.sums.half_contacts;
    pile.sums.contact_force += chunk.sums.contact_force;
    pile.sums.force2 += chunk.sums.force2;
  }
}

}  // namespace rift::packing

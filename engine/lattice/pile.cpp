#include "engine/lattice/pile.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numeric>

namespace rift {
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
};

/// Cells at least `width` wide, and no more than a few per element however thin
/// the box.
Cells sort_into_cells(const Pile& pile, double width) {
  Cells cells;
  for (double total = std::numeric_limits<double>::infinity(); total > 8.0 * (pile.size() + 1);
       width *= 1.5) {
    total = 1.0;
    for (int c = 0; c < 3; ++c) total *= std::max(1.0, std::floor(pile.box[c] / width));
    for (int c = 0; c < 3; ++c)
      cells.per_unit[c] = std::max(1.0, std::floor(pile.box[c] / width)) / pile.box[c];
  }
  for (int c = 0; c < 3; ++c) cells.count[c] = static_cast<int>(std::lround(cells.per_unit[c] * pile.box[c]));
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

void list_candidates_of(const Pile& pile, const Cells& cells, Pile::Chunk& chunk) {
  chunk.first.assign(1, 0);
  chunk.candidate.clear();
  for (int i = chunk.begin; i < chunk.end; ++i) {
    const Pile::Sphere& s = pile.sphere[i];
    const int cx = cells.at(s.x, 0), cy = cells.at(s.y, 1), cz = cells.at(s.z, 2);
    const int below = std::max(0, cz - 1), above = std::min(cells.count[2] - 1, cz + 1);
    for (int x = std::max(0, cx - 1); x <= std::min(cells.count[0] - 1, cx + 1); ++x)
      for (int y = std::max(0, cy - 1); y <= std::min(cells.count[1] - 1, cy + 1); ++y)
        for (int k = cells.first[cells.index(x, y, below)]; k < cells.first[cells.index(x, y, above) + 1];
             ++k) {
          const int j = cells.member[k];
          if (j <= i && chunk.owns(j)) continue;
          const Pile::Sphere& o = pile.sphere[j];
          const double dx = o.x - s.x, dy = o.y - s.y, dz = o.z - s.z;
          const double limit = pile.scale * (s.shape + o.shape) + pile.skin;
          if (dx * dx + dy * dy + dz * dz <= limit * limit) chunk.candidate.push_back(j);
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
void list_candidates(Pile& pile, Crew& crew) {
  constexpr int soon = 8, late = 40;
  constexpr double narrowest = 0.12, widest = 0.6;
  if (pile.rounds_listed < soon) pile.skin = std::min(1.3 * pile.skin, widest);
  if (pile.rounds_listed > late) pile.skin = std::max(0.7 * pile.skin, narrowest);
  pile.rounds_listed = 0;
  const Cells cells = sort_into_cells(pile, 2.0 * pile.scale * pile.largest_shape + pile.skin);
  crew.run(pile.chunks(), [&](int c) {
    list_candidates_of(pile, cells, pile.chunk[c]);
    pile.chunk[c].sums.farthest2 = 0.0;
  });
  pile.sphere_then = pile.sphere;
  pile.scale_then = pile.scale;
}

double wall_force(double r, double p, double length) {
  return 2.0 * (std::max(0.0, r - p) - std::max(0.0, r - (length - p)));
}

void evaluate_forces_of(Pile& pile, Pile::Chunk& chunk) {
  Pile::Sums sums{.farthest2 = chunk.sums.farthest2};
  for (int i = chunk.begin; i < chunk.end; ++i) {
    const Pile::Sphere& s = pile.sphere[i];
    const double r = pile.scale * s.shape;
    pile.force[i] = {wall_force(r, s.x, pile.box[0]), wall_force(r, s.y, pile.box[1]),
                     wall_force(r, s.z, pile.box[2])};
  }
  for (int i = chunk.begin; i < chunk.end; ++i) {
    const Pile::Sphere s = pile.sphere[i];
    Pile::Vector f = pile.force[i];
    for (int k = chunk.first[i - chunk.begin]; k < chunk.first[i - chunk.begin + 1]; ++k) {
      const int j = chunk.candidate[k];
      const Pile::Sphere& o = pile.sphere[j];
      const double dx = o.x - s.x, dy = o.y - s.y, dz = o.z - s.z;
      const double squared = dx * dx + dy * dy + dz * dz, touching = pile.scale * (s.shape + o.shape);
      if (squared >= touching * touching) continue;
      const double distance = std::sqrt(std::max(squared, std::numeric_limits<double>::min()));
      const double overlap = touching - distance, push = overlap / distance;
      f.x -= dx * push, f.y -= dy * push, f.z -= dz * push;
      if (chunk.owns(j)) {
        Pile::Vector& g = pile.force[j];
        g.x += dx * push, g.y += dy * push, g.z += dz * push;
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

double Pile::mean_contact_force() const {
  return sums.half_contacts ? sums.contact_force / static_cast<double>(sums.half_contacts) : 0.0;
}

double Pile::unbalance() const {
  return sums.half_contacts ? std::sqrt(sums.force2 / size()) / mean_contact_force() : 0.0;
}

Pile make_pile(const Eigen::Vector3d& box, double scale, const std::vector<Pile::Sphere>& spheres) {
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

void evaluate_forces(Pile& pile, Crew& crew) {
  if (candidates_are_stale(pile)) list_candidates(pile, crew);
  ++pile.rounds_listed;
  crew.run(pile.chunks(), [&](int c) { evaluate_forces_of(pile, pile.chunk[c]); });
  pile.sums = {};
  for (const auto& chunk : pile.chunk) {
    pile.sums.half_contacts += chunk.sums.half_contacts;
    pile.sums.contact_force += chunk.sums.contact_force;
    pile.sums.force2 += chunk.sums.force2;
  }
}

}  // namespace rift

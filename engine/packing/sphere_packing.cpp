#include "engine/packing/sphere_packing.hpp"

#include "engine/packing/neighbours.hpp"
#include "engine/packing/pair_kernels.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <span>

namespace rift::packing {
namespace {

/// The spheres in the order of their cells.
struct Sorted {
  Cells cells;
  std::vector<SpherePacking::Sphere> sphere;
};

Sorted sorted(const SpherePacking& spheres) {
  Sorted sorted{
      Cells(spheres.box.size(), 2.0 * spheres.scale * spheres.largest_shape + spheres.skin, spheres.size(),
            [&](int i) {
              const SpherePacking::Sphere& s = spheres.sphere[i];
              return Eigen::Vector3d(s.x, s.y, s.z);
            }),
      {}};
  sorted.sphere.reserve(spheres.sphere.size());
  for (const int i : sorted.cells.members()) sorted.sphere.push_back(spheres.sphere[i]);
  return sorted;
}

template <bool periodic>
void list_candidates_of(const SpherePacking& spheres, const Sorted& sorted, SpherePacking::Chunk& chunk) {
  std::vector<SpherePacking::Pair>& found = chunk.candidate;
  std::size_t pairs = 0;
  PairGroup group;
  for (int i = chunk.begin; i < chunk.end; ++i) {
    const SpherePacking::Sphere s = spheres.sphere[i];
    const auto look_at = [&](int first, int count) {
      for (int k = 0; k < count; ++k) {
        const SpherePacking::Sphere& o = sorted.sphere[first + k];
        const SpherePacking::Vector d = minimum_image<periodic>(spheres.box, s, o);
        group.x[k] = d.x, group.y[k] = d.y, group.z[k] = d.z;
        group.reach[k] = spheres.scale * (s.shape + o.shape) + spheres.skin;
      }
      find_gaps(group, count);
      if (found.size() < pairs + count) found.resize(2 * (pairs + count));
      for (int k = 0; k < count; ++k) {
        const int j = sorted.cells.members()[first + k];
        found[pairs] = {i, j};
        pairs += (group.gap[k] <= 0.0) & ((j > i) | !chunk.owns(j));
      }
    };
    sorted.cells.visit_near<periodic>(s.x, s.y, s.z, [&](int first, int last) {
      for (; first < last; first += PairGroup::room) look_at(first, std::min(last - first, PairGroup::room));
    });
  }
  found.resize(pairs);
}

bool candidates_are_stale(const SpherePacking& spheres) {
  const double allowed = 0.5 * spheres.skin - (spheres.scale - spheres.scale_then) * spheres.largest_shape;
  return allowed <= 0.0 ||
         std::any_of(spheres.chunk.begin(), spheres.chunk.end(), [&](const SpherePacking::Chunk& chunk) {
           return chunk.sums.farthest2 > allowed * allowed;
         });
}

/// Lists them, with a skin that fits the pace of the flow: a wide one lasts longer and costs more each round.
void list_candidates(SpherePacking& spheres, base::ThreadPool& pool) {
  constexpr int soon = 8, late = 40;
  constexpr double narrowest = 0.12, widest = 0.6;
  if (spheres.rounds_listed < soon) spheres.skin = std::min(1.3 * spheres.skin, widest);
  if (spheres.rounds_listed > late) spheres.skin = std::max(0.7 * spheres.skin, narrowest);
  spheres.rounds_listed = 0;
  const bool periodic = spheres.box.shape == Shape::periodic;
  if (periodic) wrap(spheres);
  const Sorted in_cells = sorted(spheres);
  pool.run(spheres.chunks(), [&](int c) {
    periodic ? list_candidates_of<true>(spheres, in_cells, spheres.chunk[c])
             : list_candidates_of<false>(spheres, in_cells, spheres.chunk[c]);
    spheres.chunk[c].sums.farthest2 = 0.0;
  });
  spheres.sphere_then = spheres.sphere;
  spheres.scale_then = spheres.scale;
}

/// Those of the pairs that touch, in their order. Answers how many.
template <bool periodic>
int contacts_among(std::span<const SpherePacking::Pair> pairs, const SpherePacking& spheres,
                   ContactGroup& contacts) {
  PairGroup group;
  const int count = static_cast<int>(pairs.size());
  for (int k = 0; k < count; ++k) {
    const SpherePacking::Sphere &s = spheres.sphere[pairs[k].i], &o = spheres.sphere[pairs[k].j];
    const SpherePacking::Vector d = minimum_image<periodic>(spheres.box, s, o);
    group.x[k] = d.x, group.y[k] = d.y, group.z[k] = d.z;
    group.reach[k] = spheres.scale * (s.shape + o.shape);
  }
  find_gaps(group, count);
  int touching = 0;
  for (int k = 0; k < count; ++k) {  // a third of them do: nothing that a processor could foresee
    contacts.pair[touching] = k;
    touching += !(group.gap[k] >= 0.0);
  }
  for (int n = 0; n < touching; ++n) {
    const int k = contacts.pair[n];
    contacts.x[n] = group.x[k], contacts.y[n] = group.y[k], contacts.z[n] = group.z[k];
    contacts.reach[n] = group.reach[k], contacts.squared[n] = group.squared[k];
  }
  return touching;
}

template <bool periodic>
void evaluate_forces_of(SpherePacking& spheres, SpherePacking::Chunk& chunk) {
  SpherePacking::Sums sums{.farthest2 = chunk.sums.farthest2};
  if (spheres.box.is_cuboid()) {
    find_flat_pushes(spheres.box, spheres.scale, &spheres.sphere[chunk.begin], chunk.end - chunk.begin,
                     &spheres.force[chunk.begin]);
  } else {
    for (int i = chunk.begin; i < chunk.end; ++i) {
      const SpherePacking::Sphere& s = spheres.sphere[i];
      const Eigen::Vector3d push = wall_push(spheres.box, {s.x, s.y, s.z}, spheres.scale * s.shape);
      spheres.force[i] = {push.x(), push.y(), push.z()};
    }
  }
  ContactGroup contacts;
  const std::span<const SpherePacking::Pair> candidates(chunk.candidate);
  for (std::size_t from = 0; from < candidates.size(); from += PairGroup::room) {
    const auto pairs =
        candidates.subspan(from, std::min<std::size_t>(PairGroup::room, candidates.size() - from));
    const int count = contacts_among<periodic>(pairs, spheres, contacts);
    find_forces(contacts, count);
    for (int n = 0; n < count; ++n) {
      const auto [i, j] = pairs[contacts.pair[n]];
      SpherePacking::Vector& f = spheres.force[i];
      f.x -= contacts.x[n], f.y -= contacts.y[n], f.z -= contacts.z[n];
      if (chunk.owns(j)) {
        SpherePacking::Vector& g = spheres.force[j];
        g.x += contacts.x[n], g.y += contacts.y[n], g.z += contacts.z[n];
        sums.half_contacts += 2, sums.contact_force += 2.0 * contacts.overlap[n];
      } else {
        sums.half_contacts += 1, sums.contact_force += contacts.overlap[n];
      }
    }
  }
  for (int i = chunk.begin; i < chunk.end; ++i) {
    const SpherePacking::Vector& f = spheres.force[i];
    sums.force2 += f.x * f.x + f.y * f.y + f.z * f.z;
  }
  chunk.sums = sums;
}

}  // namespace

void wrap(SpherePacking& spheres) {
  const auto within = [](double p, double edge) { return p - edge * std::floor(p / edge); };
  for (SpherePacking::Sphere& s : spheres.sphere) {
    s.x = within(s.x, spheres.box.length);
    s.y = within(s.y, spheres.box.height);
    s.z = within(s.z, spheres.box.thickness);
  }
}

double SpherePacking::mean_contact_force() const {
  return sums.half_contacts ? sums.contact_force / static_cast<double>(sums.half_contacts) : 0.0;
}

double SpherePacking::unbalance() const {
  return sums.half_contacts ? std::sqrt(sums.force2 / size()) / mean_contact_force() : 0.0;
}

SpherePacking make_sphere_packing(const Box& box, double scale,
                                  const std::vector<SpherePacking::Sphere>& sphere) {
  SpherePacking spheres;
  spheres.box = box;
  spheres.scale = scale;
  spheres.sphere = spheres.sphere_then = sphere;
  spheres.velocity.resize(sphere.size());
  spheres.force.resize(sphere.size());
  for (const auto& s : sphere) spheres.largest_shape = std::max(spheres.largest_shape, s.shape);
  constexpr int most_chunks = 32, least_size = 256;
  const int size = std::max(least_size, (spheres.size() + most_chunks - 1) / most_chunks);
  for (int begin = 0; begin < spheres.size(); begin += size) {
    spheres.chunk.emplace_back();
    spheres.chunk.back().begin = begin;
    spheres.chunk.back().end = std::min(begin + size, spheres.size());
    spheres.chunk.back().sums.farthest2 = std::numeric_limits<double>::infinity();  // nothing listed yet
  }
  return spheres;
}

void evaluate_forces(SpherePacking& spheres, base::ThreadPool& pool) {
  if (candidates_are_stale(spheres)) list_candidates(spheres, pool);
  ++spheres.rounds_listed;
  const bool periodic = spheres.box.shape == Shape::periodic;
  pool.run(spheres.chunks(), [&](int c) {
    periodic ? evaluate_forces_of<true>(spheres, spheres.chunk[c])
             : evaluate_forces_of<false>(spheres, spheres.chunk[c]);
  });
  spheres.sums = {};
  for (const auto& chunk : spheres.chunk) {
    spheres.sums.half_contacts += chunk.sums.half_contacts;
    spheres.sums.contact_force += chunk.sums.contact_force;
    spheres.sums.force2 += chunk.sums.force2;
  }
}

}  // namespace rift::packing

#include "engine/packing/sphere_packing.hpp"

#include "engine/packing/neighbours.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace rift::packing {
namespace {

template <bool periodic>
void list_candidates_of(const SpherePacking& spheres, const Cells& cells, SpherePacking::Chunk& chunk) {
  chunk.first.assign(1, 0);
  chunk.candidate.clear();
  for (int i = chunk.begin; i < chunk.end; ++i) {
    const SpherePacking::Sphere& s = spheres.sphere[i];
    cells.visit_near<periodic>(s.x, s.y, s.z, [&](int j) {
      if (j <= i && (j == i || chunk.owns(j))) return;
      const SpherePacking::Sphere& o = spheres.sphere[j];
      const SpherePacking::Vector d = minimum_image<periodic>(spheres.box, s, o);
      const double limit = spheres.scale * (s.shape + o.shape) + spheres.skin;
      if (d.x * d.x + d.y * d.y + d.z * d.z <= limit * limit) chunk.candidate.push_back(j);
    });
    chunk.first.push_back(static_cast<int>(chunk.candidate.size()));
  }
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
  const Cells cells(
      spheres.box.size(), 2.0 * spheres.scale * spheres.largest_shape + spheres.skin, spheres.size(),
      [&](int i) { return Eigen::Vector3d(spheres.sphere[i].x, spheres.sphere[i].y, spheres.sphere[i].z); });
  pool.run(spheres.chunks(), [&](int c) {
    periodic ? list_candidates_of<true>(spheres, cells, spheres.chunk[c])
             : list_candidates_of<false>(spheres, cells, spheres.chunk[c]);
    spheres.chunk[c].sums.farthest2 = 0.0;
  });
  spheres.sphere_then = spheres.sphere;
  spheres.scale_then = spheres.scale;
}

template <bool periodic>
void evaluate_forces_of(SpherePacking& spheres, SpherePacking::Chunk& chunk) {
  SpherePacking::Sums sums{.farthest2 = chunk.sums.farthest2};
  for (int i = chunk.begin; i < chunk.end; ++i) {
    const SpherePacking::Sphere& s = spheres.sphere[i];
    const Eigen::Vector3d push = wall_push(spheres.box, {s.x, s.y, s.z}, spheres.scale * s.shape);
    spheres.force[i] = {push.x(), push.y(), push.z()};
  }
  for (int i = chunk.begin; i < chunk.end; ++i) {
    const SpherePacking::Sphere s = spheres.sphere[i];
    SpherePacking::Vector f = spheres.force[i];
    for (int k = chunk.first[i - chunk.begin]; k < chunk.first[i - chunk.begin + 1]; ++k) {
      const int j = chunk.candidate[k];
      const SpherePacking::Sphere& o = spheres.sphere[j];
      const SpherePacking::Vector d = minimum_image<periodic>(spheres.box, s, o);
      const double squared = d.x * d.x + d.y * d.y + d.z * d.z,
                   touching = spheres.scale * (s.shape + o.shape);
      if (squared >= touching * touching) continue;
      const double distance = std::sqrt(std::max(squared, std::numeric_limits<double>::min()));
      const double overlap = touching - distance, push = overlap / distance;
      f.x -= d.x * push, f.y -= d.y * push, f.z -= d.z * push;
      if (chunk.owns(j)) {
        SpherePacking::Vector& g = spheres.force[j];
        g.x += d.x * push, g.y += d.y * push, g.z += d.z * push;
        sums.half_contacts += 2, sums.contact_force += 2.0 * overlap;
      } else {
        sums.half_contacts += 1, sums.contact_force += overlap;
      }
    }
    spheres.force[i] = f;
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

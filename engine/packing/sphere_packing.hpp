#pragma once

#include "engine/base/thread_pool.hpp"
#include "engine/packing/geometry.hpp"

#include <Eigen/Core>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <vector>

namespace rift::packing {

/// Overlapping spheres within walls, in units of their expected mean radius, with unit contact stiffness and
/// unit mass; a wall pushes as the sphere's mirror image behind it would.
struct SpherePacking {
  struct Vector {
    double x = 0, y = 0, z = 0;
  };
  struct Sphere {
    double x, y, z;  // centre
    double shape;    // radius at scale 1
  };
  struct Sums {
    std::int64_t half_contacts = 0;  // a contact of two elements counts twice
    double contact_force = 0;        // likewise
    double force2 = 0;               // of the squared net forces
    double farthest2 = 0;            // largest squared distance moved since the candidates were listed
  };
  struct Pair {
    int i, j;
  };
  /// Elements [begin, end) and the pairs of them that may touch: pairs within the chunk once, pairs that
  /// leave it in both chunks. So a chunk writes to its own elements only, and every element adds up its
  /// contacts in an order that knows nothing of threads.
  struct Chunk {
    int begin = 0, end = 0;
    std::vector<Pair> candidate;  // ordered by i, which is in the chunk; j > i or j outside the chunk
    Sums sums;
    bool owns(int i) const { return i >= begin && i < end; }
  };

  Box box;
  double scale = 1.0, largest_shape = 1.0;
  std::vector<Sphere> sphere;
  std::vector<Vector> velocity, force;
  std::vector<Chunk> chunk;
  Sums sums;
  std::vector<Sphere> sphere_then;  // when the candidates were listed
  double scale_then = 0.0;
  double skin = 0.25;     // how much further than touching the candidates reach;
                          // wide while the packing flows
  int rounds_listed = 0;  // since then

  int size() const { return static_cast<int>(sphere.size()); }
  int chunks() const { return static_cast<int>(chunk.size()); }
  double coordination() const { return static_cast<double>(sums.half_contacts) / size(); }
  double mean_contact_force() const;
  /// As a share of r_i + r_j, which is 2 scale on average to first order in the spread.
  double mean_overlap() const { return mean_contact_force() / (2.0 * scale); }
  /// Root mean square of the net forces over the mean contact force; 0 where nothing touches.
  double unbalance() const;
};

/// Cut into chunks by the number of spheres alone; without velocities or forces yet.
SpherePacking make_sphere_packing(const Box& box, double scale,
                                  const std::vector<SpherePacking::Sphere>& sphere);

/// From a to b, in a periodic box to its nearest image.
template <bool periodic>
SpherePacking::Vector minimum_image(const Box& box, const SpherePacking::Sphere& a,
                                    const SpherePacking::Sphere& b) {
  SpherePacking::Vector d{b.x - a.x, b.y - a.y, b.z - a.z};
  if constexpr (periodic) {
    d.x -= box.length * std::nearbyint(d.x / box.length);
    d.y -= box.height * std::nearbyint(d.y / box.height);
    d.z -= box.thickness * std::nearbyint(d.z / box.thickness);
  }
  return d;
}

/// Forces f = -dU/dx of the overlaps and the sums that go with them; lists the candidates anew where the old
/// list may miss a contact. Cost O(N).
void evaluate_forces(SpherePacking& spheres, base::ThreadPool& pool);

/// Brings the centres of a periodic box back into it; the candidates are stale then.
void wrap(SpherePacking& spheres);

/// Moves the centres by move(i), and keeps account of how far they went since the candidates were listed.
template <class Move>
void move_spheres(SpherePacking& spheres, base::ThreadPool& pool, const Move& move) {
  pool.run(spheres.chunks(), [&](int c) {
    double farthest2 = 0.0;
    for (int i = spheres.chunk[c].begin; i < spheres.chunk[c].end; ++i) {
      SpherePacking::Sphere& s = spheres.sphere[i];
      const SpherePacking::Sphere& then = spheres.sphere_then[i];
      const SpherePacking::Vector d = move(i);
      s.x += d.x, s.y += d.y, s.z += d.z;
      const double x = s.x - then.x, y = s.y - then.y, z = s.z - then.z;
      farthest2 = std::max(farthest2, x * x + y * y + z * z);
    }
    spheres.chunk[c].sums.farthest2 = farthest2;
  });
}

}  // namespace rift::packing

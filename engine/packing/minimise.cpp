#include "engine/packing/minimise.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace rift::packing {
namespace {

using Vectors = std::vector<SpherePacking::Vector>;

double dot(const SpherePacking::Vector& a, const SpherePacking::Vector& b) {
  return a.x * b.x + a.y * b.y + a.z * b.z;
}

/// The packing's stiffness H = d2U/dx2 at its present contacts, in chunks like its
/// candidates.
class Stiffness {
 public:
  Stiffness(const SpherePacking& spheres, base::ThreadPool& pool);
  /// Hp for the elements of chunk c; answers their share of p.Hp.
  double apply(int c, const Vectors& p, Vectors& hp) const;

 private:
  struct Contact {
    int other;
    double x, y, z;  // unit vector to the other
    double press;    // overlap / distance: how the contact force softens a
                     // sideways move
  };
  struct Wall {
    int element;
    Eigen::Matrix3d k;
  };
  struct Part {
    std::vector<int> first;
    std::vector<Contact> contact;
    std::vector<Wall> wall;
  };
  template <bool periodic>
  void build(int c);
  const SpherePacking& spheres_;
  std::vector<Part> part_;
};

Stiffness::Stiffness(const SpherePacking& spheres, base::ThreadPool& pool)
    : spheres_(spheres), part_(spheres.chunk.size()) {
  const bool periodic = spheres.box.shape == Shape::periodic;
  pool.run(spheres.chunks(), [&](int c) { periodic ? build<true>(c) : build<false>(c); });
}

template <bool periodic>
void Stiffness::build(int c) {
  const SpherePacking::Chunk& chunk = spheres_.chunk[c];
  Part& part = part_[c];
  part.first.push_back(0);
  auto pair = chunk.candidate.begin();
  for (int i = chunk.begin; i < chunk.end; ++i) {
    const SpherePacking::Sphere& s = spheres_.sphere[i];
    const Eigen::Matrix3d k_wall = wall_stiffness(spheres_.box, {s.x, s.y, s.z}, spheres_.scale * s.shape);
    if (!k_wall.isZero(0.0)) part.wall.push_back({i, k_wall});
    for (; pair != chunk.candidate.end() && pair->i == i; ++pair) {
      const SpherePacking::Sphere& o = spheres_.sphere[pair->j];
      const SpherePacking::Vector d = minimum_image<periodic>(spheres_.box, s, o);
      const double squared = dot(d, d), touching = spheres_.scale * (s.shape + o.shape);
      if (squared >= touching * touching || squared == 0.0) continue;
      const double distance = std::sqrt(squared);
      part.contact.push_back(
          {pair->j, d.x / distance, d.y / distance, d.z / distance, touching / distance - 1.0});
    }
    part.first.push_back(static_cast<int>(part.contact.size()));
  }
}

double Stiffness::apply(int c, const Vectors& p, Vectors& hp) const {
  const SpherePacking::Chunk& chunk = spheres_.chunk[c];
  const Part& part = part_[c];
  std::fill(hp.begin() + chunk.begin, hp.begin() + chunk.end, SpherePacking::Vector{});
  for (const Wall& wall : part.wall) {
    const Eigen::Vector3d push =
        wall.k * Eigen::Vector3d(p[wall.element].x, p[wall.element].y, p[wall.element].z);
    hp[wall.element] = {push.x(), push.y(), push.z()};
  }
  double sum = 0.0;
  for (int i = chunk.begin; i < chunk.end; ++i) {
    const SpherePacking::Vector own = p[i];
    SpherePacking::Vector h = hp[i];
    for (int k = part.first[i - chunk.begin]; k < part.first[i - chunk.begin + 1]; ++k) {
      const Contact& n = part.contact[k];
      const SpherePacking::Vector& other = p[n.other];
      const SpherePacking::Vector d{other.x - own.x, other.y - own.y, other.z - own.z};
      const double along = (1.0 + n.press) * (d.x * n.x + d.y * n.y + d.z * n.z);
      const SpherePacking::Vector g{along * n.x - n.press * d.x, along * n.y - n.press * d.y,
                                    along * n.z - n.press * d.z};
      h.x -= g.x, h.y -= g.y, h.z -= g.z;
      if (chunk.owns(n.other)) {
        SpherePacking::Vector& o = hp[n.other];
        o.x += g.x, o.y += g.y, o.z += g.z;
      }
    }
    hp[i] = h;
    sum += dot(h, own);
  }
  return sum;
}

/// Sum of share(c) over the chunks c, added up in their order.
template <class Share>
double sum_over_chunks(const SpherePacking& spheres, base::ThreadPool& pool, const Share& share) {
  std::vector<double> sum(spheres.chunk.size());
  pool.run(spheres.chunks(), [&](int c) { sum[c] = share(c); });
  return std::accumulate(sum.begin(), sum.end(), 0.0);
}

/// Conjugate gradients, with room for its vectors.
struct Solver {
  Vectors d, r, p, hp;

  /// H d = f to a residual of `reduction` of f; ends early at a saddle, with what it has so far.
  void solve(const SpherePacking& spheres, base::ThreadPool& pool, double reduction,
             const RoundsSpent& spent) {
    constexpr int most_rounds = 1000;
    const Stiffness stiffness(spheres, pool);
    r = p = spheres.force;
    d.assign(r.size(), {});
    hp.resize(r.size());
    double residual2 = spheres.sums.force2;
    const double goal = reduction * reduction * residual2;
    for (int round = 1; round <= most_rounds; ++round) {
      const double curvature =
          sum_over_chunks(spheres, pool, [&](int c) { return stiffness.apply(c, p, hp); });
      if (!(curvature > 0.0)) return;
      const double step = residual2 / curvature, before = residual2;
      residual2 = sum_over_chunks(spheres, pool, [&](int c) { return advance(spheres.chunk[c], step); });
      if (residual2 <= goal) return;
      pool.run(spheres.chunks(), [&](int c) { turn(spheres.chunk[c], residual2 / before); });
      spent(1);
    }
  }

 private:
  double advance(const SpherePacking::Chunk& chunk, double step) {
    double residual2 = 0.0;
    for (int i = chunk.begin; i < chunk.end; ++i) {
      d[i].x += step * p[i].x, d[i].y += step * p[i].y, d[i].z += step * p[i].z;
      r[i].x -= step * hp[i].x, r[i].y -= step * hp[i].y, r[i].z -= step * hp[i].z;
      residual2 += dot(r[i], r[i]);
    }
    return residual2;
  }
  void turn(const SpherePacking::Chunk& chunk, double keep) {
    for (int i = chunk.begin; i < chunk.end; ++i)
      p[i] = {r[i].x + keep * p[i].x, r[i].y + keep * p[i].y, r[i].z + keep * p[i].z};
  }
};

}  // namespace

bool damped_relaxation(SpherePacking& spheres, base::ThreadPool& pool, double tolerance, double damping,
                       int rounds, const RoundsSpent& spent) {
  // Explicit steps are stable below 2 / omega, omega^2 <= about 6 (a sphere in
  // a crowd of unit springs).
  constexpr double dt = 0.5;
  for (int round = 1; round <= rounds; ++round) {
    move_spheres(spheres, pool, [&](int i) -> SpherePacking::Vector {
      SpherePacking::Vector& v = spheres.velocity[i];
      const SpherePacking::Vector& f = spheres.force[i];
      if (f.x == 0.0 && f.y == 0.0 && f.z == 0.0) return v = {};  // what nothing pushes does not drift
      v.x = (1.0 - damping) * v.x + dt * f.x;
      v.y = (1.0 - damping) * v.y + dt * f.y;
      v.z = (1.0 - damping) * v.z + dt * f.z;
      return {dt * v.x, dt * v.y, dt * v.z};
    });
    evaluate_forces(spheres, pool);
    spent(1);
    if (spheres.unbalance() < tolerance) return true;
  }
  return false;
}

void minimise_newton(SpherePacking& spheres, base::ThreadPool& pool, double tolerance, double damping,
                     const RoundsSpent& spent) {
  constexpr double reduction = 0.1, farthest = 0.1, helpful = 0.5;
  constexpr int rounds_between = 100;
  Solver solver;
  while (spheres.unbalance() >= tolerance) {
    const double before = spheres.unbalance();
    solver.solve(spheres, pool, std::max(reduction, 0.5 * tolerance / before), spent);
    const auto step = [&](double sign) {
      move_spheres(spheres, pool, [&](int i) -> SpherePacking::Vector {
        const SpherePacking::Vector& d = solver.d[i];
        const double part = sign * farthest / std::max(farthest, std::sqrt(dot(d, d)));
        return {part * d.x, part * d.y, part * d.z};
      });
      evaluate_forces(spheres, pool);
    };
    step(1.0);
    spent(1);
    if (spheres.unbalance() <= helpful * before) {
      std::fill(spheres.velocity.begin(), spheres.velocity.end(), SpherePacking::Vector{});
    } else {
      if (spheres.unbalance() > before) step(-1.0);
      damped_relaxation(spheres, pool, tolerance, damping, rounds_between, spent);
    }
  }
}

}  // namespace rift::packing

#include "engine/packing/settle.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace rift::packing {
namespace {

using Vectors = std::vector<Pile::Vector>;

double dot(const Pile::Vector& a, const Pile::Vector& b) { return a.x * b.x + a.y * b.y + a.z * b.z; }

/// The pile's stiffness H = d2U/dx2 at its present contacts, in chunks like its
/// candidates.
class Stiffness {
 public:
  Stiffness(const Pile& pile, base::ThreadPool& crew);
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
  const Pile& pile_;
  std::vector<Part> part_;
};

Stiffness::Stiffness(const Pile& pile, base::ThreadPool& crew) : pile_(pile), part_(pile.chunk.size()) {
  const bool periodic = pile.box.shape == Shape::periodic;
  crew.run(pile.chunks(), [&](int c) { periodic ? build<true>(c) : build<false>(c); });
}

template <bool periodic>
void Stiffness::build(int c) {
  const Pile::Chunk& chunk = pile_.chunk[c];
  Part& part = part_[c];
  part.first.push_back(0);
  for (int i = chunk.begin; i < chunk.end; ++i) {
    const Pile::Sphere& s = pile_.sphere[i];
    const Eigen::Matrix3d k_wall = wall_stiffness(pile_.box, {s.x, s.y, s.z}, pile_.scale * s.shape);
    if (!k_wall.isZero(0.0)) part.wall.push_back({i, k_wall});
    for (int k = chunk.first[i - chunk.begin]; k < chunk.first[i - chunk.begin + 1]; ++k) {
      const Pile::Sphere& o = pile_.sphere[chunk.candidate[k]];
      const Pile::Vector d = way<periodic>(pile_.box, s, o);
      const double squared = dot(d, d), touching = pile_.scale * (s.shape + o.shape);
      if (squared >= touching * touching || squared == 0.0) continue;
      const double distance = std::sqrt(squared);
      part.contact.push_back(
          {chunk.candidate[k], d.x / distance, d.y / distance, d.z / distance, touching / distance - 1.0});
    }
    part.first.push_back(static_cast<int>(part.contact.size()));
  }
}

double Stiffness::apply(int c, const Vectors& p, Vectors& hp) const {
  const Pile::Chunk& chunk = pile_.chunk[c];
  const Part& part = part_[c];
  std::fill(hp.begin() + chunk.begin, hp.begin() + chunk.end, Pile::Vector{});
  for (const Wall& wall : part.wall) {
    const Eigen::Vector3d push =
        wall.k * Eigen::Vector3d(p[wall.element].x, p[wall.element].y, p[wall.element].z);
    hp[wall.element] = {push.x(), push.y(), push.z()};
  }
  double sum = 0.0;
  for (int i = chunk.begin; i < chunk.end; ++i) {
    const Pile::Vector own = p[i];
    Pile::Vector h = hp[i];
    for (int k = part.first[i - chunk.begin]; k < part.first[i - chunk.begin + 1]; ++k) {
      const Contact& n = part.contact[k];
      const Pile::Vector& other = p[n.other];
      const Pile::Vector d{other.x - own.x, other.y - own.y, other.z - own.z};
      const double along = (1.0 + n.press) * (d.x * n.x + d.y * n.y + d.z * n.z);
      const Pile::Vector g{along * n.x - n.press * d.x, along * n.y - n.press * d.y,
                           along * n.z - n.press * d.z};
      h.x -= g.x, h.y -= g.y, h.z -= g.z;
      if (chunk.owns(n.other)) {
        Pile::Vector& o = hp[n.other];
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
double sum_over_chunks(const Pile& pile, base::ThreadPool& crew, const Share& share) {
  std::vector<double> sum(pile.chunk.size());
  crew.run(pile.chunks(), [&](int c) { sum[c] = share(c); });
  return std::accumulate(sum.begin(), sum.end(), 0.0);
}

/// Conjugate gradients, with room for its vectors.
struct Solver {
  Vectors d, r, p, hp;

  /// H d = f to a residual of `reduction` of f; ends early at a saddle, with
  /// the way so far.
  void solve(const Pile& pile, base::ThreadPool& crew, double reduction, const RoundsSpent& spent) {
    constexpr int most_rounds = 1000;
    const Stiffness stiffness(pile, crew);
    r = p = pile.force;
    d.assign(r.size(), {});
    hp.resize(r.size());
    double residual2 = pile.sums.force2;
    const double goal = reduction * reduction * residual2;
    for (int round = 1; round <= most_rounds; ++round) {
      const double curvature = sum_over_chunks(pile, crew, [&](int c) { return stiffness.apply(c, p, hp); });
      if (!(curvature > 0.0)) return;
      const double step = residual2 / curvature, before = residual2;
      residual2 = sum_over_chunks(pile, crew, [&](int c) { return advance(pile.chunk[c], step); });
      if (residual2 <= goal) return;
      crew.run(pile.chunks(), [&](int c) { turn(pile.chunk[c], residual2 / before); });
      spent(1);
    }
  }

 private:
  double advance(const Pile::Chunk& chunk, double step) {
    double residual2 = 0.0;
    for (int i = chunk.begin; i < chunk.end; ++i) {
      d[i].x += step * p[i].x, d[i].y += step * p[i].y, d[i].z += step * p[i].z;
      r[i].x -= step * hp[i].x, r[i].y -= step * hp[i].y, r[i].z -= step * hp[i].z;
      residual2 += dot(r[i], r[i]);
    }
    return residual2;
  }
  void turn(const Pile::Chunk& chunk, double keep) {
    for (int i = chunk.begin; i < chunk.end; ++i)
      p[i] = {r[i].x + keep * p[i].x, r[i].y + keep * p[i].y, r[i].z + keep * p[i].z};
  }
};

}  // namespace

bool relax(Pile& pile, base::ThreadPool& crew, double tolerance, double damping, int rounds,
           const RoundsSpent& spent) {
  // Explicit steps are stable below 2 / omega, omega^2 <= about 6 (a sphere in
  // a crowd of unit springs).
  constexpr double dt = 0.5;
  for (int round = 1; round <= rounds; ++round) {
    move_spheres(pile, crew, [&](int i) -> Pile::Vector {
      Pile::Vector& v = pile.velocity[i];
      const Pile::Vector& f = pile.force[i];
      if (f.x == 0.0 && f.y == 0.0 && f.z == 0.0) return v = {};  // what nothing pushes does not drift
      v.x = (1.0 - damping) * v.x + dt * f.x;
      v.y = (1.0 - damping) * v.y + dt * f.y;
      v.z = (1.0 - damping) * v.z + dt * f.z;
      return {dt * v.x, dt * v.y, dt * v.z};
    });
    evaluate_forces(pile, crew);
    spent(1);
    if (pile.unbalance() < tolerance) return true;
  }
  return false;
}

void settle(Pile& pile, base::ThreadPool& crew, double tolerance, double damping, const RoundsSpent& spent) {
  constexpr double reduction = 0.1, farthest = 0.1, helpful = 0.5;
  constexpr int rounds_between = 100;
  Solver solver;
  while (pile.unbalance() >= tolerance) {
    const double before = pile.unbalance();
    solver.solve(pile, crew, std::max(reduction, 0.5 * tolerance / before), spent);
    const auto step = [&](double way) {
      move_spheres(pile, crew, [&](int i) -> Pile::Vector {
        const Pile::Vector& d = solver.d[i];
        const double part = way * farthest / std::max(farthest, std::sqrt(dot(d, d)));
        return {part * d.x, part * d.y, part * d.z};
      });
      evaluate_forces(pile, crew);
    };
    step(1.0);
    spent(1);
    if (pile.unbalance() <= helpful * before) {
      std::fill(pile.velocity.begin(), pile.velocity.end(), Pile::Vector{});
    } else {
      if (pile.unbalance() > before) step(-1.0);
      relax(pile, crew, tolerance, damping, rounds_between, spent);
    }
  }
}

}  // namespace rift::packing

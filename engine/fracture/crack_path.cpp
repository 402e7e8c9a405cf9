#include "engine/fracture/crack_path.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <tuple>

namespace rift::fracture {
namespace {

/// Twice the area of the triangle (a, b, p): positive where p lies to the left of a -> b.
double side(const Eigen::Vector2d& a, const Eigen::Vector2d& b, const Eigen::Vector2d& p) {
  return (b.x() - a.x()) * (p.y() - a.y()) - (b.y() - a.y()) * (p.x() - a.x());
}

/// The point of a path that is nearest to another: its arc length and how far it is away [m].
struct Foot {
  double arc = 0, distance = std::numeric_limits<double>::infinity();
};

Foot foot_of(const CrackPath& path, const Eigen::Vector2d& p) {
  Foot nearest;
  double behind = 0.0;
  for (std::size_t k = 0; k + 1 < path.point.size(); ++k) {
    const Eigen::Vector2d along = path.point[k + 1] - path.point[k];
    const double t = std::clamp((p - path.point[k]).dot(along) / along.squaredNorm(), 0.0, 1.0);
    const double distance = (p - path.point[k] - t * along).norm();
    if (distance < nearest.distance) nearest = {behind + t * along.norm(), distance};
    behind += along.norm();
  }
  return nearest;
}

/// Where the tip is when it releases a beam from a to b that the path crosses at `crossing`, as arc length
/// or, with two tips, as distance from the middle of the path [m].
double release_position(const CrackPath& path, double crossing, const Eigen::Vector2d& a,
                        const Eigen::Vector2d& b) {
  const double middle = 0.5 * length_of(path);
  const auto of_tip = [&](double arc) { return path.tips == 2 ? std::abs(arc - middle) : arc; };
  const auto beside = [&](const Eigen::Vector2d& p) { return of_tip(nearest_arc(path, p)); };
  if (path.order == ReleaseOrder::middle) return beside(0.5 * (a + b));
  if (path.order == ReleaseOrder::node) return std::min(beside(a), beside(b));
  return of_tip(crossing);
}

}  // namespace

Eigen::Vector2d point_on(const CrackPath& path, double arc) {
  std::size_t k = 0;
  for (; k + 2 < path.point.size(); ++k) {
    const double piece = (path.point[k + 1] - path.point[k]).norm();
    if (arc <= piece) break;
    arc -= piece;
  }
  return path.point[k] + arc * (path.point[k + 1] - path.point[k]).normalized();
}

double length_of(const CrackPath& path) {
  double length = 0.0;
  for (std::size_t k = 0; k + 1 < path.point.size(); ++k)
    length += (path.point[k + 1] - path.point[k]).norm();
  return length;
}

CrackPath straight_path(double length, double height, int tips) {
  return {{{0.0, height}, {length, height}}, tips};
}

std::optional<double> first_crossing(const CrackPath& path, const Eigen::Vector2d& a,
                                     const Eigen::Vector2d& b) {
  // One order of the ends for all: a corner of the path on the line of a beam then lies on the same side of
  // it either way.
  if (std::tie(b.x(), b.y()) < std::tie(a.x(), a.y())) return first_crossing(path, b, a);
  double behind = 0.0;
  for (std::size_t k = 0; k + 1 < path.point.size(); ++k) {
    const Eigen::Vector2d &p = path.point[k], &q = path.point[k + 1];
    const double length = (q - p).norm();
    const bool parted = (side(p, q, a) >= 0.0) != (side(p, q, b) >= 0.0);
    const double from = side(a, b, p), to = side(a, b, q);
    if (parted && (from >= 0.0) != (to >= 0.0)) return behind + length * from / (from - to);
    behind += length;
  }
  return std::nullopt;
}

Eigen::Vector2d normal_between(const CrackPath& path, const Eigen::Vector2d& a, const Eigen::Vector2d& b) {
  double arc = first_crossing(path, a, b).value();
  std::size_t k = 0;
  for (; k + 2 < path.point.size(); ++k) {
    const double piece = (path.point[k + 1] - path.point[k]).norm();
    if (arc <= piece) break;
    arc -= piece;
  }
  const Eigen::Vector2d along = (path.point[k + 1] - path.point[k]).normalized();
  const Eigen::Vector2d normal(-along.y(), along.x());
  return normal.dot(b - a) < 0.0 ? Eigen::Vector2d(-normal) : normal;
}

double nearest_arc(const CrackPath& path, const Eigen::Vector2d& p) { return foot_of(path, p).arc; }

double distance_to(const CrackPath& path, const Eigen::Vector2d& p) { return foot_of(path, p).distance; }

std::vector<Crossing> crossings(const CrackPath& path, const lattice::Lattice& lattice) {
  std::vector<Crossing> found;
  for (int b = 0; b < static_cast<int>(lattice.ends.size()); ++b) {
    const auto& [i, j] = lattice.ends[b];
    const Eigen::Vector2d from = lattice.centre[i].head<2>(), to = lattice.centre[j].head<2>();
    if (const auto s = first_crossing(path, from, to))
      found.push_back({b, release_position(path, *s, from, to)});
  }
  std::sort(found.begin(), found.end(), [](const Crossing& a, const Crossing& b) {
    return std::tie(a.position, a.beam) < std::tie(b.position, b.beam);
  });
  return found;
}

std::vector<DamageableBeam> damageable_beams(const CrackPath& path, const lattice::Lattice& lattice,
                                             double notch_end) {
  std::vector<DamageableBeam> beams;
  for (const Crossing& c : crossings(path, lattice)) {
    const auto& [i, j] = lattice.ends[c.beam];
    beams.push_back({c.beam, c.position, in_notch(c, notch_end),
                     normal_between(path, lattice.centre[i].head<2>(), lattice.centre[j].head<2>())});
  }
  return beams;
}

std::vector<DamageableBeam> breakable_beams(const CrackPath& path, const lattice::Lattice& lattice,
                                            double notch_end) {
  std::vector<DamageableBeam> beams;
  for (int b = 0; b < static_cast<int>(lattice.beam.size()); ++b) {
    const auto& [i, j] = lattice.ends[b];
    beams.push_back({.beam = b, .position = 0.5 * (lattice.centre[i].x() + lattice.centre[j].x())});
  }
  for (const Crossing& c : crossings(path, lattice)) beams[c.beam].absent = in_notch(c, notch_end);
  return beams;
}

}  // namespace rift::fracture

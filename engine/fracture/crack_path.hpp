#pragma once

#include "engine/lattice/lattice.hpp"

#include <optional>
#include <vector>

namespace rift::fracture {

/// When the tip releases a beam that its path crosses: at the crossing; at the point of the path nearest to
/// the beam's middle; or as it comes by the first of the beam's two elements, so that all beams which hold an
/// element across the path go together.
enum class ReleaseOrder { crossing, middle, node };

/// The line that the crack follows in the x-y plane, extruded along z: a polyline [m]. One tip runs from its
/// first point to its last; two run from its middle to both ends, at one velocity.
struct CrackPath {
  std::vector<Eigen::Vector2d> point;
  int tips = 1;
  ReleaseOrder order = ReleaseOrder::crossing;
};

/// The point at an arc length [m], on the lines beyond the ends too.
Eigen::Vector2d point_on(const CrackPath& path, double arc);

double length_of(const CrackPath& path);  // [m]

/// The straight path y = height from x = 0 to x = length [m].
CrackPath straight_path(double length, double height, int tips = 1);

/// Where the path first crosses the segment from a to b, as arc length [m]; nothing where it does not.
/// Half-open: a point on the path counts to its left side, so that two beams meeting on the path never both
/// count.
std::optional<double> first_crossing(const CrackPath& path, const Eigen::Vector2d& a,
                                     const Eigen::Vector2d& b);

/// The unit normal of the path where it first crosses the segment from a to b, on the side of b; it must
/// cross it.
Eigen::Vector2d normal_between(const CrackPath& path, const Eigen::Vector2d& a, const Eigen::Vector2d& b);

/// Arc length of the point of the path that is nearest to p [m].
double nearest_arc(const CrackPath& path, const Eigen::Vector2d& p);

/// Distance of a point from the path [m].
double distance_to(const CrackPath& path, const Eigen::Vector2d& p);

/// A beam that the crack will release when a tip is at `position` = s_b [m]: the arc length of the crossing,
/// or of what the path's ReleaseOrder puts in its place; with two tips its distance from the middle of the
/// path, so that a tip's position is the half length a.
struct Crossing {
  int beam = 0;
  double position = 0;
};

/// The beams whose x-y segment the path crosses, in the order the crack meets them   [model.md §6].
std::vector<Crossing> crossings(const CrackPath& path, const lattice::Lattice& lattice);

/// A beam whose stiffness may fall while the lattice moves.
struct DamageableBeam {
  int beam = 0;
  double position = 0;  // where a release rule is about a path: that of Crossing [m]
  bool absent = false;  // from the base state on, cut by a notch
  Eigen::Vector2d normal = Eigen::Vector2d::Zero();  // of its faces, from its first element to its second
};

/// The beams that a crack along the path may damage, in the order it meets them; those that a notch up to
/// `notch_end` [m] cuts are absent.
std::vector<DamageableBeam> damageable_beams(const CrackPath& path, const lattice::Lattice& lattice,
                                             double notch_end);

/// All beams, ascending, of which any may break by itself; those that a notch along the path cuts are absent.
/// Their positions are the x of their middles [m].
std::vector<DamageableBeam> breakable_beams(const CrackPath& path, const lattice::Lattice& lattice,
                                            double notch_end);

/// Whether a notch that ends at `notch_end` [m] has cut a beam from the beginning: one that is crossed at its
/// end, too. A notch without length cuts nothing; a beam that is crossed at exactly 0 is the crack's then.
inline bool in_notch(const Crossing& crossing, double notch_end) {
  return notch_end > 0.0 && crossing.position <= notch_end;
}

}  // namespace rift::fracture

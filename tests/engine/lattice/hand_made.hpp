#pragma once

#include "engine/lattice/forces.hpp"
#include "engine/reference/plain_simulation.hpp"

#include <Eigen/Geometry>

#include <numbers>
#include <random>
#include <vector>

/// Lattices small enough to check by hand or by dense algebra, and a plain velocity Verlet to march them.
/// Lengths, masses and moduli are of order one, so that a tolerance reads as a number of roundings.
namespace rift::lattice::hand_made {

/// The same reals with any standard library.
struct Draw {
  std::mt19937_64 engine;
  explicit Draw(unsigned seed) : engine(seed) {}

  double between(double low, double high) {
    return low + (high - low) * (static_cast<double>(engine() >> 11) * 0x1.0p-53);
  }
  Eigen::Vector3d vector() {
    const double x = between(-1, 1), y = between(-1, 1), z = between(-1, 1);
    return {x, y, z};
  }
  Vector6 motion() {
    Vector6 q;
    q << vector(), vector();
    return q;
  }
  Eigen::VectorXd state(std::size_t elements) {
    Eigen::VectorXd q(6 * static_cast<long>(elements));
    for (double& c : q) c = between(-1, 1);
    return q;
  }
};

/// Section and material of a round bar of density 1.
struct Rod {
  double radius = 0.2, young = 3.0, poisson = 0.25;
  double area() const { return std::numbers::pi * radius * radius; }
  double second_moment() const { return 0.25 * std::numbers::pi * radius * radius * radius * radius; }
  double shear() const { return young / (2.0 * (1.0 + poisson)); }
  Beam between(const Eigen::Vector3d& a, const Eigen::Vector3d& b) const {
    return make_beam(b - a, radius, young, poisson);
  }
};

/// Collinear beams from the origin on, element k at k x span; mass and polar inertia of the bar's own.
inline Lattice chain(int elements, const Eigen::Vector3d& span, const Rod& rod) {
  Lattice lattice;
  const double volume = rod.area() * span.norm();
  for (int k = 0; k < elements; ++k) {
    lattice.centre.emplace_back(k * span);
    lattice.mass.push_back(volume);
    lattice.inertia.push_back(0.5 * volume * rod.radius * rod.radius);
    if (k == 0) continue;
    lattice.ends.push_back({k - 1, k});
    lattice.beam.push_back(rod.between(lattice.centre[k - 1], lattice.centre[k]));
  }
  lattice.grip.assign(lattice.centre.size(), packing::Grip::none);
  lattice.mean_radius = 0.5 * span.norm();
  lattice.box = {.length = elements * span.norm(), .height = elements * span.norm(), .thickness = 1.0};
  return lattice;
}

/// A jittered cubic block of edge^3 elements, joined to all nearer than 1.5 spacings by beams of all sorts.
inline Lattice jumble(int edge, unsigned seed, bool gripped) {
  Draw draw(seed);
  Lattice lattice;
  for (int k = 0; k < edge * edge * edge; ++k) {
    const Eigen::Vector3d site(k / (edge * edge), k / edge % edge, k % edge);
    lattice.centre.emplace_back(site + 0.2 * draw.vector());
    lattice.mass.push_back(draw.between(0.5, 2.0));
    lattice.inertia.push_back(draw.between(0.05, 0.2));
    packing::Grip grip = packing::Grip::none;
    if (gripped && site.y() == 0) grip = packing::Grip::bottom;
    if (gripped && site.y() == edge - 1) grip = packing::Grip::top;
    lattice.grip.push_back(grip);
  }
  const int n = static_cast<int>(lattice.centre.size());
  for (int i = 0; i < n; ++i)
    for (int j = i + 1; j < n; ++j) {
      if ((lattice.centre[j] - lattice.centre[i]).norm() > 1.5) continue;
      const Rod rod{.radius = draw.between(0.1, 0.4),
                    .young = draw.between(1.0, 3.0),
                    .poisson = draw.between(0.0, 0.45)};
      lattice.ends.push_back({i, j});
      lattice.beam.push_back(rod.between(lattice.centre[i], lattice.centre[j]));
    }
  lattice.mean_radius = 0.5;
  lattice.box = {.length = 1.0 * edge, .height = 1.0 * edge, .thickness = 1.0 * edge};
  return lattice;
}

/// Rigid motion by a translation and a small rotation about `pivot`.
inline Vector6 rigid(const Eigen::Vector3d& at, const Eigen::Vector3d& shift, const Eigen::Vector3d& turn,
                     const Eigen::Vector3d& pivot) {
  Vector6 q;
  q << shift + turn.cross(at - pivot), turn;
  return q;
}

/// 1 / mass of each degree of freedom, 0 where gripped.
inline Eigen::VectorXd mobility(const Lattice& lattice) {
  Eigen::VectorXd per_mass = Eigen::VectorXd::Zero(6 * static_cast<long>(lattice.centre.size()));
  for (std::size_t i = 0; i < lattice.centre.size(); ++i) {
    if (lattice.grip[i] != packing::Grip::none) continue;
    per_mass.segment<3>(6 * static_cast<long>(i)).setConstant(1.0 / lattice.mass[i]);
    per_mass.segment<3>(6 * static_cast<long>(i) + 3).setConstant(1.0 / lattice.inertia[i]);
  }
  return per_mass;
}

inline std::vector<BeamRow> rows_of(const Lattice& lattice) {
  std::vector<BeamRow> rows;
  for (int b = 0; b < static_cast<int>(lattice.beam.size()); ++b) rows.push_back(row_of(lattice, b));
  return rows;
}

/// What the beams do to all elements at displacements q, by the kernel of the hot loop.
inline Eigen::VectorXd loads_on(const Lattice& lattice, const Eigen::VectorXd& q) {
  Eigen::VectorXd f = Eigen::VectorXd::Zero(q.size());
  add_beam_forces(rows_of(lattice), q.data(), f.data());
  return f;
}

/// Sum of the forces, then of the moments about `pivot`.
inline Vector6 resultant(const Lattice& lattice, const Eigen::VectorXd& f, const Eigen::Vector3d& pivot) {
  Vector6 sum = Vector6::Zero();
  for (std::size_t i = 0; i < lattice.centre.size(); ++i) {
    const Eigen::Vector3d force = f.segment<3>(6 * static_cast<long>(i));
    sum.head<3>() += force;
    sum.tail<3>() += (lattice.centre[i] - pivot).cross(force) + f.segment<3>(6 * static_cast<long>(i) + 3);
  }
  return sum;
}

inline std::vector<DampedBeam> all_damped(const Lattice& lattice) {
  std::vector<DampedBeam> damped;
  for (int b = 0; b < static_cast<int>(lattice.beam.size()); ++b)
    damped.push_back(damped_beam(lattice, b, -1, false));
  return damped;
}

inline ViscousDamping damped_everywhere(const Lattice& lattice, double alpha) {
  ViscousDamping damping(all_damped(lattice));
  damping.alpha_elsewhere = alpha;
  return damping;
}

/// The readable step from a start at rest, nothing of the lattice damageable. @param[in] start  [element][6]
inline reference::PlainSimulation released(const Lattice& lattice, ViscousDamping damping, double dt,
                                           const Eigen::VectorXd& start) {
  reference::PlainSimulation march(lattice, {}, dt, {});
  std::vector<Vector6> moved;
  for (long k = 0; k < start.size(); k += 6) moved.emplace_back(start.segment<6>(k));
  march.start_from(moved);
  march.damping = std::move(damping);
  return march;
}

inline double largest_of(const std::vector<double>& numbers) {
  return Eigen::Map<const Eigen::VectorXd>(numbers.data(), static_cast<long>(numbers.size()))
      .cwiseAbs()
      .maxCoeff();
}

}  // namespace rift::lattice::hand_made

#include "engine/fracture/cohesive_law.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace rift::fracture {
namespace {

/// u_c / k_a of a beam [m2].
double energy_over_stiffness(const lattice::Beam& beam, const CohesiveMaterial& material, double area) {
  return material.kappa * material.release_rate * area / beam.axial;
}

}  // namespace

double stiffness_left(const Softening& beam, double opening) {
  if (opening <= beam.first) return 1.0;
  if (opening >= beam.last) return 0.0;
  return beam.first / opening * ((beam.last - opening) / (beam.last - beam.first));
}

double area_of_beam(const lattice::Lattice& lattice) {
  double across_x = 0.0, across_y = 0.0;
  for (const lattice::Beam& beam : lattice.beam) {
    across_x += beam.length * std::abs(beam.axis.x());
    across_y += beam.length * std::abs(beam.axis.y());
  }
  return lattice.box.volume() / (0.5 * (across_x + across_y));
}

std::vector<Softening> softening_of(const lattice::Lattice& lattice, const CohesiveMaterial& material) {
  const double area = area_of_beam(lattice);
  std::vector<Softening> softening;
  softening.reserve(lattice.beam.size());
  for (const lattice::Beam& beam : lattice.beam) {
    const double of_energy = energy_over_stiffness(beam, material, area);
    const double first = material.law == FractureLaw::snap
                             ? std::sqrt(2.0 * of_energy)
                             : beam.length * material.strength / material.young_modulus;
    softening.push_back({first, material.law == FractureLaw::snap ? first : 2.0 * of_energy / first});
  }
  return softening;
}

double resolved_strength(const lattice::Lattice& lattice, const CohesiveMaterial& material) {
  const double area = area_of_beam(lattice);
  double strength = std::sqrt(9.0 * std::numbers::pi / 32.0 * material.young_modulus * material.release_rate /
                              (resolved_radii * lattice.mean_radius));
  for (const lattice::Beam& beam : lattice.beam)
    strength = std::min(strength, material.young_modulus / beam.length *
                                      std::sqrt(2.0 * energy_over_stiffness(beam, material, area)));
  return strength;
}

void BrokenBeams::add(const Eigen::Vector2d& middle) {
  Broken added{middle, 1};
  for (Broken& other : broken_) {
    if ((other.middle - middle).norm() > reach_) continue;
    ++added.near, ++other.near;
    look_at(other);
  }
  broken_.push_back(added);
  look_at(added);
}

void BrokenBeams::look_at(const Broken& beam) {
  constexpr int enough = 3;
  if (beam.near >= enough) leading_ = std::max(leading_.value_or(beam.middle.x()), beam.middle.x());
}

}  // namespace rift::fracture

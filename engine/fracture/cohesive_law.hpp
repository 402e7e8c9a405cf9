#pragma once

#include "engine/lattice/lattice.hpp"

#include <Eigen/Core>

#include <cstdint>
#include <optional>
#include <vector>

namespace rift::fracture {

/// What decides which beams break: a tip that follows its history, or each beam by its own opening, which
/// softens it or breaks it at once.
enum class FractureLaw : std::uint8_t { prescribed, cohesive, snap };

/// The constants of a law by which beams break by themselves.
struct CohesiveMaterial {
  FractureLaw law = FractureLaw::cohesive;
  double release_rate = 0;   // G_c [J/m2]
  double strength = 0;       // sigma_t [Pa]; of no meaning to a law that snaps
  double young_modulus = 0;  // E of the material [Pa]
  double kappa = 1;          // energy of breaking a beam over G_c times the area it stands for
};

/// The openings [m] at which a beam begins to soften and is gone, delta_0 and delta_f; one and the same where
/// it snaps.
struct Softening {
  double first = 0, last = 0;
};

/// What is left of the stiffness of a beam whose largest opening so far is `opening` [m]: its force falls in
/// proportion to the opening beyond the first one,
///   s = 1 up to delta_0,   (delta_0 / delta) (delta_f - delta) / (delta_f - delta_0),   0 from delta_f on.
double stiffness_left(const Softening& beam, double opening);

/// Area [m2] that a beam stands for on a plane across x or y: 1 / (beams that cross a unit of area) =
/// V / sum |l.n|, the mean of the two directions.
double area_of_beam(const lattice::Lattice& lattice);

/// The softening of each beam: u_c = kappa G_c A = 1/2 k_a delta_0 delta_f is the energy that breaking it
/// takes, and delta_0 = l sigma_t / E (where it snaps delta_0 = delta_f).
/// The strength must be such that delta_0 <= delta_f, as resolved_strength() sees to.
std::vector<Softening> softening_of(const lattice::Lattice& lattice, const CohesiveMaterial& material);

/// Mean radii per length of the zone in which a crack's stress falls from the strength to nothing, in units
/// of its estimate (9 pi / 32) E G_c / sigma_t^2, that a lattice needs to let a crack run without radiating
/// its energy.
inline constexpr double resolved_radii = 16.0;

/// The largest strength [Pa] that the lattice resolves: sqrt((9 pi / 32) E G_c / (16 R)), and no more than
/// what lets each beam soften at all (delta_0 <= delta_f). Of the material's strength nothing is used.
double resolved_strength(const lattice::Lattice& lattice, const CohesiveMaterial& material);

/// The beams that broke by themselves, as the crack that they make; whatever the order in which they are
/// added.
class BrokenBeams {
 public:
  /// @param[in] reach  [m] within which other broken beams count as near
  explicit BrokenBeams(double reach) : reach_(reach) {}

  /// @param[in] middle  of the beam [m]
  void add(const Eigen::Vector2d& middle);
  int count() const { return static_cast<int>(broken_.size()); }

  /// The largest x of a broken beam that has two others near it [m]: one alone may break anywhere.
  std::optional<double> leading() const { return leading_; }

 private:
  struct Broken {
    Eigen::Vector2d middle;
    int near;  // broken beams, itself among them
  };
  void look_at(const Broken& beam);

  double reach_;
  std::vector<Broken> broken_;
  std::optional<double> leading_;
};

}  // namespace rift::fracture

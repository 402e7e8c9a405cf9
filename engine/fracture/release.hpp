#pragma once

#include "engine/fracture/cohesive_law.hpp"
#include "engine/history/crack_history.hpp"
#include "engine/lattice/loads.hpp"

#include <cmath>
#include <optional>
#include <vector>

namespace rift::fracture {

enum class Technique { simple, progressive };

/// How the beams at the tip lose their stiffness.
struct ReleaseLaw {
  Technique technique = Technique::progressive;
  double exponent =
      1.0;  // p of Y1/Y2 = (1 - b/l)^p: 1 linear (eq. 9), 1/2 square root (eq. 10), 2 quadratic (eq. 11)
  double zone_length = 0.0;  // l = L_CZM = r_l R_mean [m]; 0 for simple release
};

/// Y1/Y2 of a beam that the path crosses at s_b when the tip is at a, both arc lengths [m]   [paper eqs.
/// (9)-(11)]:
///   b = a + L_CZM - s_b clipped to [0, L_CZM], gone at b = L_CZM;   simple release: gone as soon as a >=
///   s_b.
double stiffness_left(const ReleaseLaw& law, double tip, double crossing);

/// A law of the beams that cross the path at `position` [m] or beyond.
struct LawBeyond {
  double position = 0;
  ReleaseLaw law;
};

/// What distinguishes one lane of an ensemble from another.
struct LaneScenario {
  history::CrackHistory history = {};
  ReleaseLaw law = {};
  std::vector<LawBeyond> later = {};                 // by position: laws that took over while the crack ran
  double alpha_at_surface = 0, alpha_elsewhere = 0;  // fractions of critical damping
  std::optional<double> friction = {};               // mu of the faces; without it they do not touch
  std::optional<CohesiveMaterial> material = {};     // of beams that break by themselves, without a history
  lattice::StepLoad load = {};                       // on the forces of Ensemble::set_loads()
};

/// Units of a lane: all stiffnesses of a lattice go with E_mu, so that another E_mu changes nothing but time
/// and energy. One lattice serves scenarios of any E_mu; a factor turns what the lattice shows into what the
/// scenario does [model.md §5].
struct LaneUnits {
  double time = 1, energy = 1;
};

/// Units of a scenario whose E_mu is `stiffer` times that of the lattice.
inline LaneUnits units_of(double stiffer) { return {1.0 / std::sqrt(stiffer), stiffer}; }

/// The law of the beams that cross the path at `position`.
const ReleaseLaw& law_at(const LaneScenario& scenario, double position);

/// The longest damage zone of the laws that still matter to a tip at `tip` [m].
double reach_ahead(const LaneScenario& scenario, double tip);

/// Gives the beams that neither the damage zone nor the new law's has reached a law of their own: nothing
/// that is being released changes, and nothing is damaged in one jump.
void change_law(LaneScenario& scenario, const ReleaseLaw& law, double tip);

}  // namespace rift::fracture

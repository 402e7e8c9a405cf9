#pragma once

#include "engine/fracture/release.hpp"
#include "engine/history/crack_history.hpp"

#include <optional>
#include <vector>

namespace rift::fracture {

/// A law of the beams that cross the path at `position` [m] or beyond.
struct LawBeyond {
  double position = 0;
  ReleaseLaw law;
};

/// What distinguishes one lane of an ensemble from another.
struct LaneScenario {
  history::CrackHistory history;
  ReleaseLaw law;
  std::vector<LawBeyond> later = {};                 // by position: laws that took over while the crack ran
  double alpha_at_surface = 0, alpha_elsewhere = 0;  // fractions of critical damping
  std::optional<double> friction = {};               // mu of the faces; without it they do not touch
};

/// The law of the beams that cross the path at `position`.
const ReleaseLaw& law_at(const LaneScenario& scenario, double position);

/// The longest damage zone of the laws that still matter to a tip at `tip` [m].
double reach_ahead(const LaneScenario& scenario, double tip);

/// Gives the beams that neither the damage zone nor the new law's has reached a law of their own: nothing
/// that is being released changes, and nothing is damaged in one jump.
void change_law(LaneScenario& scenario, const ReleaseLaw& law, double tip);

}  // namespace rift::fracture

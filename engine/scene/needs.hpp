#pragma once

#include "engine/scene/preset.hpp"
#include "engine/scene/scene.hpp"

#include <array>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace rift::scene {

/// What the scene asks of the engine beyond the bare lattice; the rest is not even compiled into its loop.
struct Needs {
  bool damping = false;            // viscous, on beams (alpha > 0)
  bool numerical_damping = false;  // beta < 1 while the crack runs
  bool damage_zone = false;        // P-NRT
  bool ramp = false;               // pre-stress marched in time
  bool moving_grip = false;        // while the crack runs
  bool corotation = false;         // beam axes that turn with the elements
  bool contact = false;            // of the crack's faces
  bool step_energies = false;      // energy is added up at every step: damping of either kind, a moving grip
  bool frames = false;             // fields are written
  bool gauges = false;
};

Needs needs_of(const Scene& scene);

/// Whether [calibration] says anything: of cylinders, and of beams calibrated to the material.
bool needs_calibration(const Scene& scene);

/// Whether anything that is computed of the scene depends on its value of a parameter: the velocity of a
/// crack that follows a measured history is not used.
bool is_used(const Scene& scene, std::string_view key);

/// A thing that a scene may leave out.
struct OptionalPart {
  std::string_view name;  // as summary.json's left_out has it: "numerical_damping"
  /// How many times as long a step takes with it: one scenario in double, eight in single precision
  /// [rift bench --needs --elements 20000, docs/performance.md]. NaN where that is not measured, 1 being
  /// none.
  std::array<double, 2> step_factor;
};

/// All of them, in the order in which they are listed.
std::vector<OptionalPart> optional_parts();

/// The part of a name, or null.
const OptionalPart* find_optional_part(std::string_view name);

/// Names of what this scene leaves out: THE decision, of one scenario or of one lane.
std::vector<std::string> left_out(const Scene& scene);

/// A line for each thing that some of these lanes leave out: which of them, and why; and what the step that
/// they share computes all the same, where others need it.
std::vector<std::string> left_out_by_lanes(std::span<const Scene> lanes);

/// The same for scenarios of a study, which are counted: "damping: 6 of 30 scenarios (alpha = 0)".
std::vector<std::string> left_out_by_scenarios(std::span<const Scene> scenarios);

/// The same for whatever the preset holds, as `rift check` and the form print it.
std::vector<std::string> left_out_lines(const Preset& preset);

}  // namespace rift::scene

#pragma once

#include "engine/scene/scene.hpp"

#include <string>
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

/// One line for each thing that is left out, and why, as `rift check` prints it.
std::vector<std::string> left_out(const Scene& scene);

}  // namespace rift::scene

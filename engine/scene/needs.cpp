#include "engine/scene/needs.hpp"

#include "engine/scene/derived.hpp"

namespace rift::scene {

Needs needs_of(const Scene& scene) {
  Needs needs;
  needs.damping = scene.damping.alpha > 0 && scene.damping.region != DampingRegion::none;
  needs.numerical_damping = scene.solver.beta < 1;
  needs.damage_zone = scene.crack.technique == fracture::Technique::progressive;
  needs.ramp = scene.loading.method == LoadingMethod::ramp;
  needs.moving_grip = grip_moves(scene);
  needs.corotation = scene.solver.kinematics == lattice::Kinematics::corotational;
  needs.contact = scene.crack.friction.has_value();
  needs.step_energies =
      needs.damping || needs.numerical_damping || needs.ramp || needs.moving_grip || needs.contact;
  needs.frames = scene.output.frames > 0 && !scene.output.fields.empty();
  needs.gauges = !scene.output.gauges.empty();
  return needs;
}

bool needs_calibration(const Scene& scene) {
  return scene.specimen.shape == packing::Shape::cylinder ||
         scene.material.stiffness == StiffnessChoice::calibrated;
}

std::vector<std::string> left_out(const Scene& scene) {
  const Needs needs = needs_of(scene);
  std::vector<std::string> lines;
  if (!needs.damping) {
    const bool no_alpha = scene.damping.alpha == 0;
    lines.emplace_back(no_alpha ? "damping: alpha = 0, no damped beams are built"
                                : "damping: region = none, no damped beams are built");
  }
  if (!needs.numerical_damping) lines.emplace_back("numerical damping: beta = 1");
  if (!needs.damage_zone) lines.emplace_back("damage zone: technique = simple");
  if (!needs.ramp) lines.emplace_back("ramp: method = static, the pre-stress is one solve");
  if (!needs.moving_grip && !needs.ramp)
    lines.emplace_back("moving grip: no loading.curve, the grips stand still while the crack runs");
  if (!needs.corotation) lines.emplace_back("corotation: kinematics = linear, the beam axes stay fixed");
  if (!needs.contact) lines.emplace_back("contact: no friction, the crack's faces do not touch");
  if (!needs.step_energies)
    lines.emplace_back(
        "energy balance of every step: no dissipation and no external work, energies are computed at samples "
        "only");
  if (!needs.frames) {
    lines.emplace_back(scene.output.frames == 0 ? "frames: frames = 0, no fields are written"
                                                : "frames: fields = [], no fields are written");
  }
  if (!needs.gauges) lines.emplace_back("gauges: output.gauges has no points");
  return lines;
}

}  // namespace rift::scene

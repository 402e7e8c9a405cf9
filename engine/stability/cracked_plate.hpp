#pragma once

#include "engine/simulation/march.hpp"
#include "engine/stability/suite.hpp"

#include <functional>
#include <memory>
#include <string>
#include <vector>

namespace rift::stability {

/// The suite's plate: 300 elements, 24 x 12 mm and two layers, pulled by 5 %, cracked at 0.5 c_r to 12 mm.
/// Packs in 0.1 s, a step takes 0.1 ms.
scene::Preset plate_preset(const std::vector<std::string>& overrides = {});

/// What a case changes of a scene that a preset could not say (its ranges guard against slips of units), and
/// of what is prepared from it.
using SceneChange = std::function<void(scene::Scene&)>;
using PlateChange = std::function<void(simulation::Prepared&)>;

/// Prepares and marches it; what refuses it is what was seen. Claims that every beam which the tip has passed
/// was released, once.
Observed crack(const std::vector<std::string>& overrides, const SceneChange& scene, const PlateChange& plate,
               ensemble::Precision precision);

/// Scenarios that march side by side in one pass, in each precision once; asked for one by one.
class LaneBatch {
 public:
  explicit LaneBatch(std::vector<SceneChange> lanes) : lanes_(std::move(lanes)) {}
  Observed of(int lane, ensemble::Precision precision);

 private:
  std::vector<SceneChange> lanes_;
  std::vector<Observed> seen_[2];
};

/// The step of all lanes set to `dt` [s of the lattice], whatever the checks would say of it.
void force_step(simulation::Prepared& prepared, double dt);

}  // namespace rift::stability

#pragma once

#include "engine/simulation/march.hpp"
#include "tests/engine/ensemble/cracked_ensemble.hpp"
#include "tests/expectations.hpp"
#include "tests/shared_cache.hpp"
#include "tests/temporary_folder.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <string>
#include <vector>

namespace rift::simulation {

/// A plate of 700 elements, 48 x 12 mm and two layers thick, pulled by the paper's 5 %; the crack runs at 0.5
/// c_r to 24 mm, 25 mean radii past the start of its window. A step takes 0.2 ms.
inline scene::Preset small_preset(const std::vector<std::string>& overrides = {}) {
  std::string text = R"(
[specimen]
length = "48 mm"
height = "12 mm"
layers = 2
elements = 700
coordination = 5.7   # walls everywhere: 6 is out of reach of so few elements
[loading]
displacement = "0.6 mm"
[crack]
end = "24 mm"
[output]
samples = 50
frames = 5
)";
  const std::string pulled = "displacement = \"0.6 mm\"\n";
  for (const std::string& given : overrides)  // which the displacement would contradict
    if (given.starts_with("loading.force") || given.starts_with("loading.curve"))
      text.erase(std::min(text.find(pulled), text.size()), pulled.size());
  scene::Preset preset = scene::read_preset_text(text, "small.toml", overrides);
  for (const scene::Issue& issue : preset.issues) ADD_FAILURE() << scene::to_text(issue);
  return preset;
}

inline Prepared small_plate(const std::vector<std::string>& overrides = {}) {
  return prepare(small_preset(overrides), shared_cache());
}

/// An ensemble at rest under the pre-stress, its crack about to start.
inline ensemble::CrackedEnsemble ready(const Prepared& p,
                                       const std::vector<fracture::LaneScenario>& scenarios, double dt,
                                       const ensemble::EnsembleOptions& options = {}) {
  ensemble::CrackedEnsemble simulation(p.lattice, p.path, p.preset.scene.crack.start, dt, scenarios, options);
  simulation.start_from(p.displacement);
  simulation.start_crack(p.damped);
  return simulation;
}

inline ensemble::CrackedEnsemble ready(const Prepared& p) {
  return ready(p, {p.lane[0].scenario}, p.step.dt);
}

/// The plate's crack by S-NRT and by P-NRT with the three laws of the paper, eqs. (9)-(11).
inline std::vector<fracture::LaneScenario> four_laws(const Prepared& p) {
  const double zone = p.lattice.mean_radius;
  std::vector<fracture::LaneScenario> lanes(4, p.lane[0].scenario);
  lanes[0].law = {fracture::Technique::simple, 1.0, 0.0};
  lanes[1].law = {fracture::Technique::progressive, 1.0, zone};
  lanes[2].law = {fracture::Technique::progressive, 0.5, zone};
  lanes[3].law = {fracture::Technique::progressive, 2.0, zone};
  return lanes;
}

}  // namespace rift::simulation

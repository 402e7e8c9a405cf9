#pragma once

#include "engine/scene/preset.hpp"

#include <map>
#include <string>
#include <vector>

namespace rift::study {

/// Several presets as one study, so that scenarios of equal lattice and step march side by side whichever
/// figure they belong to.
struct PaperStudy {
  scene::Preset preset;                        // its study: each scene once, all axes named
  std::map<std::string, std::vector<int>> of;  // rows of each preset, by its name (the file's stem)
};

/// A fourth of the elements, scenes still larger than 10,000 elements left out, steps given in seconds four
/// times as long and the ramp in as much time; 0.01 c_r, two thirds of all the work, with the first specimen
/// only.
enum class Effort { full, quick };

/// Elements of the plate that stands for the paper's.
int plate_elements(Effort effort);

/// Merges presets without issues. One without a study stands for its own scene with both stiffnesses, without
/// frames.
PaperStudy merge_presets(const std::vector<std::pair<std::string, scene::Preset>>& presets, Effort effort);

}  // namespace rift::study

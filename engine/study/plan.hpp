#pragma once

#include "engine/scene/preset.hpp"

#include <string>
#include <vector>

namespace rift::study {

/// A scenario of a study on its way to be computed.
struct StudyItem {
  int row = 0;  // of preset.study
  scene::Scene scene;
  std::string key;  // of its result
  int group = 0;    // those of one group share specimen, lattice and pre-stress
  double cost = 0;  // its share of the pass that it marches in   [cost.hpp]
};

/// The scenarios of a study, group by group in the order of first appearance.
std::vector<StudyItem> plan_study(const scene::Preset& preset, const std::string& version);

/// The i-th of n parts of about equal cost, which keep groups together as far as that allows. The same for
/// every process, whatever has been computed.
std::vector<StudyItem> part_of(const std::vector<StudyItem>& items, int shard, int shards);

}  // namespace rift::study

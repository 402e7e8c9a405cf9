#pragma once

#include "engine/scene/preset.hpp"
#include "engine/simulation/prepare.hpp"

#include <cstdint>
#include <set>
#include <string>
#include <vector>

namespace rift::study {

// A scenario of a study is the same one again by its effective preset and the program that computes it.

/// The scenarios' scenes in the order of preset.study. They write no frames: a study keeps numbers.
std::vector<scene::Scene> scenes_of_study(const scene::Preset& preset);

/// A scene as a row of a study that names all axes.
scene::StudyRow study_row_of(const scene::Scene& scene);

/// All that the bits of a scenario's result depend on: effective preset, version and instruction set.
std::string result_key(const scene::Scene& scene, const std::string& version);

/// Hash of the scenarios, in their order, and of this program's version, by which study.json is known.
std::string study_hash(const scene::Preset& preset);

/// A scenario of a study on its way to be computed.
struct StudyItem {
  int row = 0;  // of preset.study
  scene::Scene scene;
  std::string key;     // of its result
  int group = 0;       // those of one group share specimen, lattice and pre-stress
  std::string shares;  // the name of what its group shares, the same for every call
  int specimen = 0;    // those of one packing share its number
  double cost = 0;     // its share of the pass that it marches in
};

/// Scenarios, group by group in the order of first appearance.
std::vector<StudyItem> plan_scenes(std::vector<scene::Scene> scenes, const std::string& version);

/// The same of a study.
std::vector<StudyItem> plan_study(const scene::Preset& preset, const std::string& version);

/// The i-th of n parts of about equal cost, which keep groups together as far as that allows. The same for
/// every process, whatever has been computed.
std::vector<StudyItem> part_of(const std::vector<StudyItem>& items, int shard, int shards);

/// Positions of the scenarios that march together, the longest first so that none is left over at the end:
/// those of equal step, the damped apart from those that are not. After a ramp no lane can be filled again,
/// so that a pass then holds no more than march side by side.
std::vector<std::vector<std::size_t>> passes_of(const std::vector<simulation::LanePlan>& lanes);

/// The way in which a queue of scenarios is done soonest.
struct Queue {
  int lanes = 1;    // side by side
  double time = 0;  // in steps of a kernel whose lanes fill half of 64 bytes
};

/// One long scenario beside many short ones wants few lanes, as the last steps are its own; many of a length
/// fill a register.
/// @param[in] steps  of each scenario
Queue soonest(std::vector<std::int64_t> steps, ensemble::Precision precision);

/// Lanes side by side where there is no end of scenarios.
int lanes_of_many(ensemble::Precision precision);

/// Estimates that need no lattice, for bars and for asking before a long study.

/// Step and steps of a scenario, with a critical step of 0.63 R / c_r (measured on the quickstart plate).
struct StepCount {
  double step_s = 0;
  std::int64_t steps = 0;
};
StepCount estimated_steps(const scene::Scene& scene);

/// The cost of a step: the scene's beams, as many times as its damping and its kinematics make them dearer
/// [rift bench --needs]. The unit is a walk over one beam for as many lanes as march side by side.
double estimated_step_cost(const scene::Scene& scene);

/// The steps of a scenario that marches by itself.
double estimated_cost(const scene::Scene& scene);

/// The same for packing and pre-stress together.
double estimated_preparation(const scene::Scene& scene);

/// Packing's part of it; the rest is one static solution.
inline constexpr double packing_share = 0.7;

/// The cost of preparing items one after the other: each specimen is packed once, each group solved once.
class PreparationCost {
 public:
  /// What this item adds to those before it.
  double next(const StudyItem& item);

 private:
  std::set<int> packed_, solved_;
};

/// What estimates take a machine to do in a second, in the unit of a step's cost.
inline constexpr double assumed_beam_steps_per_s = 1e8;

/// Seconds that these items of a plan take from nothing, roughly.
double estimated_seconds(const std::vector<StudyItem>& items);

}  // namespace rift::study

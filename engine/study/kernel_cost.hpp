#pragma once

#include "engine/results/lane_summary.hpp"
#include "engine/scene/scene.hpp"

#include <map>
#include <string>

namespace rift::study {

/// What a step costs a scenario in the company of as many as fill a register, whoever it marched beside:
/// a property of its scheme. Each form of the kernel is timed once, on a lattice of as many elements, in
/// processor time on one thread, so that nothing else that the machine does counts.
class KernelCosts {
 public:
  /// Seconds of a processor that the scenario's steps cost: steps × beams × the time of a beam and step of
  /// its kernel.
  double cost_s(const scene::Scene& scene, const results::LaneSummary& summary);

 private:
  std::map<std::string, double> seconds_;  // of a beam and step, by the form of the kernel
};

}  // namespace rift::study

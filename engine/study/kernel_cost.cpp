#include "engine/study/kernel_cost.hpp"

#include "engine/ensemble/benchmark.hpp"
#include "engine/scene/needs.hpp"

#include <fmt/format.h>

namespace rift::study {
namespace {

constexpr int runs = 7;
constexpr double seconds_of_a_run = 0.02;

ensemble::BenchCase form_of(const scene::Scene& scene, const results::LaneSummary& s) {
  const ensemble::InstructionSet instructions = ensemble::instruction_set();
  return {.name = "",
          .kinematics = scene.solver.kinematics,
          .precision = scene.solver.precision,
          .scenarios = ensemble::lanes_in_register(scene.solver.precision, instructions),
          .elements = static_cast<int>(s.elements),
          .instructions = instructions,
          .damped = s.beams_damped / s.beams,
          .beta = scene.solver.beta,
          .balanced = scene::needs_of(scene).step_energies,
          .processor_time = true};
}

}  // namespace

double KernelCosts::cost_s(const scene::Scene& scene, const results::LaneSummary& summary) {
  const ensemble::BenchCase form = form_of(scene, summary);
  const std::string key =
      fmt::format("{} {} {} {:.3f} {} {}", static_cast<int>(form.kinematics),
                  static_cast<int>(form.precision), form.elements, form.damped, form.beta, form.balanced);
  auto known = seconds_.find(key);
  if (known == seconds_.end()) {
    // The fastest of the runs: a cache that others use can only make one slower.
    const ensemble::BenchResult timed = ensemble::time_case(form, runs, seconds_of_a_run);
    known = seconds_.emplace(key, 1.0 / timed.beam_steps_per_s.back()).first;
  }
  return summary.steps * summary.beams * known->second;
}

}  // namespace rift::study

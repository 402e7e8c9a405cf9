#include "engine/lattice/lattice.hpp"
#include "engine/scene/derived.hpp"
#include "engine/simulation/prepare.hpp"

#include <algorithm>
#include <cmath>
#include <initializer_list>
#include <string>
#include <utility>
#include <vector>

// What follows from a scene with its lattice, and the ranges of it.

namespace rift::simulation {
namespace {

using Keys = std::vector<std::string>;

// The squares of such numbers, and products of a few of them, are doubles still; those of single precision
// are stored in it, one by one.
constexpr scene::Range held_in_double{1e-60, 1e60}, held_in_single{1e-30, 1e30};
constexpr scene::Range step_range{1e-30, 1e6};  // [s]

/// What carries the load: its keys, with that of the load first.
Keys load_keys(const scene::Scene& scene) {
  return {load_key(scene), "specimen.height", "specimen.length", "material.young_modulus"};
}

Keys stiffness_keys(const scene::Scene& scene) {
  if (scene.material.stiffness == scene::StiffnessChoice::explicit_values)
    return {"material.micro_young_modulus", "material.micro_radius_ratio", "material.micro_poisson_ratio",
            "specimen.height", "specimen.length"};
  return {"material.young_modulus", "material.poisson_ratio", "specimen.height", "specimen.length"};
}

Keys mass_keys(const scene::Scene& scene) {
  return {scene.material.density ? "material.density" : "material.rayleigh_speed",
          "material.young_modulus",
          "material.poisson_ratio",
          "specimen.height",
          "specimen.length",
          "specimen.elements"};
}

Keys with(Keys keys, std::initializer_list<const char*> more) {
  for (const char* key : more)
    if (std::find(keys.begin(), keys.end(), key) == keys.end()) keys.emplace_back(key);
  return keys;
}

template <class Rows, class Of>
void add_extremes(std::vector<scene::DerivedNumber>& numbers, const char* name, const char* unit,
                  const scene::Range& range, const Keys& keys, const Rows& rows, const Of& of) {
  if (rows.empty()) return;
  double smallest = of(rows.front()), largest = smallest;
  for (const auto& row : rows) {
    const double value = of(row);
    if (!(value >= smallest)) smallest = value;  // NaN, too
    if (!(value <= largest)) largest = value;
  }
  numbers.push_back({std::string("an element or a beam with ") + name, smallest, range, unit, keys});
  if (largest != smallest) numbers.push_back({numbers.back().name, largest, range, unit, keys});
}

}  // namespace

const char* load_key(const scene::Scene& scene) {
  if (!scene.loading.curve.row.empty()) return "loading.curve";
  if (scene.loading.traction) return "loading.traction";
  return scene.loading.force ? "loading.force" : "loading.displacement";
}

void refuse_out_of_range(const Prepared& p, const std::vector<scene::DerivedNumber>& numbers) {
  if (std::vector<scene::Issue> issues = scene::range_issues(p.preset, p.preset.scene, numbers);
      !issues.empty())
    throw scene::InputError(std::move(issues));
}

std::vector<scene::DerivedNumber> lattice_numbers(const Prepared& p) {
  const scene::Scene& scene = p.preset.scene;
  const scene::Range range =
      scene.solver.precision == ensemble::Precision::single_precision ? held_in_single : held_in_double;
  const lattice::Lattice& lattice = p.lattice;
  const Keys masses = with(mass_keys(scene), {"specimen.radius_spread", "solver.precision"}),
             stiffnesses = with(stiffness_keys(scene), {"solver.precision"});
  const auto itself = [](double value) { return value; };
  std::vector<scene::DerivedNumber> numbers;
  add_extremes(numbers, "a mass", "kg", range, masses, lattice.mass, itself);
  add_extremes(numbers, "a moment of inertia", "kg m2", range, masses, lattice.inertia, itself);
  add_extremes(numbers, "a stiffness", "N/m", range, stiffnesses, lattice.beam,
               [](const lattice::Beam& beam) { return beam.axial; });
  add_extremes(numbers, "a bending stiffness", "N m", range, stiffnesses, lattice.beam,
               [](const lattice::Beam& beam) { return beam.bending; });
  add_extremes(numbers, "a torsional stiffness", "N m", range, stiffnesses, lattice.beam,
               [](const lattice::Beam& beam) { return beam.twist; });
  numbers.push_back({"beams of a Young's modulus", p.micro.young_modulus, scene::micro_modulus_range, "Pa",
                     stiffness_keys(scene)});
  return numbers;
}

std::vector<scene::DerivedNumber> pull_numbers(const Prepared& p) {
  const scene::Scene& scene = p.preset.scene;
  return {{"a strain", std::abs(p.pulled) / p.lattice.box.height, scene::strain_range(scene), "",
           with(load_keys(scene), {"solver.kinematics", "solver.precision"})}};
}

std::vector<scene::DerivedNumber> prestress_numbers(const Prepared& p) {
  const Keys keys = with(load_keys(p.preset.scene), {"loading.tilt", "loading.shear", "crack.start"});
  const double half_length = 0.5 * p.lattice.box.length;
  return {{"a release rate G_I0", std::abs(fracture::mean_g_i0(p.scale, half_length, half_length)),
           held_in_double, "J/m2", keys},
          {"a stored energy", p.static_energy, held_in_double, "J", keys},
          {"a force of the grip", std::abs(p.grip_force), {0.0, 1e60}, "N", keys}};
}

std::vector<scene::DerivedNumber> critical_step_numbers(const Prepared& p) {
  const scene::Scene& scene = p.preset.scene;
  return {{"a critical step", p.stable.critical, step_range, "s",
           with(mass_keys(scene), {"material.micro_young_modulus", "material.micro_radius_ratio"})}};
}

std::vector<scene::DerivedNumber> step_numbers(const Prepared& p) {
  std::vector<scene::DerivedNumber> numbers;
  for (const LanePlan& lane : p.lane) {
    const scene::Scene& scene = lane.scene;
    const char* course = scene.crack.history.empty() ? "crack.velocity" : "crack.history";
    const char* chosen = scene.solver.dt            ? "solver.dt"
                         : scene.solver.dt_fraction ? "solver.dt_fraction"
                                                    : "crack.damage_zone_ratio";
    if (scene::breaks_freely(scene)) {
      const Keys keys{"fracture.duration", "solver.dt", "solver.dt_fraction"};
      numbers.push_back({"a step", p.step.dt * lane.units.time, step_range, "s", keys});
      numbers.push_back({"a run",
                         *scene.breaking.duration / (p.step.dt * lane.units.time),
                         {1.0, most_steps},
                         "steps",
                         keys});
      continue;
    }
    const Keys keys{course, chosen, "damping.alpha", "crack.start", "crack.end", "specimen.length"};
    numbers.push_back({"a step", p.step.dt * lane.units.time, step_range, "s", keys});
    const double steps = steps_of_crack(lane.scenario.history, p.step.dt, lane.crack_end);
    numbers.push_back({"a run", steps, {0.0, most_steps}, "steps", keys});
  }
  return numbers;
}

}  // namespace rift::simulation

#include "engine/scene/derived_ranges.hpp"

#include "engine/scene/derived.hpp"
#include "engine/scene/wording.hpp"
#include "engine/theory/wave_speeds.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <type_traits>

namespace rift::scene {
namespace {

constexpr Range length_range{1e-9, 100.0};      // [m], of elements and thicknesses
constexpr Range modulus_range{1e-6, 1e16};      // [Pa]
constexpr Range density_range{1e-12, 1e15};     // [kg/m3]
constexpr Range wave_speed_range{1e-6, 1e12};   // [m/s]
constexpr Range damage_zone_range{1e-15, 1e5};  // [m]
constexpr Range torsion_range{0.1, 1e4};
constexpr Range radius_ratio_range{1e-4, 1.0};  // of a beam: its bending is r^2 of its stretching

bool lies_in(double value, const Range& range) { return value >= range.lower && value <= range.upper; }

/// The number that a member holds, NaN where it is none or absent; of a velocity the slowest piece's, in c_r.
struct NumberOf {
  double operator()(double* x) const { return *x; }
  double operator()(std::optional<double>* x) const {
    return x->value_or(std::numeric_limits<double>::quiet_NaN());
  }
  double operator()(int* i) const { return *i; }
  double operator()(long* i) const { return static_cast<double>(*i); }
  double operator()(Exponent exponent) const { return *exponent.p; }
  double operator()(std::vector<VelocityPiece>* pieces) const {
    constexpr double usual_rayleigh_speed = 2200.0;
    double slowest = std::numeric_limits<double>::infinity();
    for (const VelocityPiece& piece : *pieces)
      slowest = std::min(slowest, piece.speed.value / (piece.speed.relative ? 1.0 : usual_rayleigh_speed));
    return slowest;
  }
  template <class Member>
  double operator()(const Member&) const {
    return std::numeric_limits<double>::quiet_NaN();
  }
};

double number_at(Scene scene, const std::string& key) {
  const Parameter* row = find_parameter(key);
  return row ? std::visit(NumberOf{}, row->slot(scene)) : std::numeric_limits<double>::quiet_NaN();
}

/// By how many powers of ten a key's value lies from its default, or from one SI unit where it has none.
double distance_from_usual(const Scene& scene, const std::string& key) {
  static const Scene usual = default_scene();
  const double value = number_at(scene, key), standard = number_at(usual, key);
  if (!std::isfinite(value)) return 0.0;
  if (value == 0.0) return std::numeric_limits<double>::infinity();
  return std::abs(std::log10(std::abs(value)) -
                  (std::isfinite(standard) && standard != 0.0 ? std::log10(std::abs(standard)) : 0.0));
}

std::string to_blame(const Preset& preset, const Scene& scene, const std::vector<std::string>& keys) {
  std::vector<std::string> given;
  std::copy_if(keys.begin(), keys.end(), std::back_inserter(given),
               [&](const std::string& key) { return preset.origins.contains(key); });
  if (given.empty()) return keys.front();
  return *std::max_element(given.begin(), given.end(), [&](const std::string& a, const std::string& b) {
    return distance_from_usual(scene, a) < distance_from_usual(scene, b);
  });
}

/// Gathers the numbers whose keys are all sound.
struct DerivedList {
  const Scene& scene;
  const std::set<std::string>& unsound;
  std::vector<DerivedNumber> numbers = {};

  bool sound(const std::vector<std::string>& keys) const {
    return std::none_of(keys.begin(), keys.end(),
                        [&](const std::string& key) { return unsound.contains(key); });
  }
  /// `value` is asked for only where it can be told.
  template <class Value>
  void add(std::string name, const Range& range, std::string unit, std::vector<std::string> keys,
           const Value& value) {
    if (sound(keys)) numbers.push_back({std::move(name), value(), range, std::move(unit), std::move(keys)});
  }
};

std::vector<std::string> size_keys(const Scene& scene) {
  const Scene::Specimen& s = scene.specimen;
  if (s.shape == packing::Shape::sphere) return {"specimen.length"};
  if (s.shape == packing::Shape::cylinder) return {"specimen.height", "specimen.length"};
  return {"specimen.height", "specimen.length", s.thickness ? "specimen.thickness" : "specimen.layers"};
}

void add_sizes(DerivedList& list) {
  const Scene& scene = list.scene;
  const Scene::Specimen& s = scene.specimen;
  if (!s.thickness && !s.layers) return;  // one of the two is missing, which is told elsewhere
  if (!list.sound({"specimen.shape", "specimen.radii", "crack.technique"})) return;
  std::vector<std::string> keys = size_keys(scene);
  keys.emplace_back("specimen.elements");
  list.add("a thickness", length_range, "m", keys, [&] { return thickness_m(scene); });
  keys.emplace_back("specimen.radius_spread");
  list.add("a mean radius", length_range, "m", keys, [&] { return expected_mean_radius_m(scene); });
  if (scene.crack.technique == fracture::Technique::simple) return;
  keys.insert(keys.begin(), "crack.damage_zone_ratio");
  list.add("a damage zone", damage_zone_range, "m", keys, [&] { return expected_zone_m(scene); });
}

void add_material(DerivedList& list) {
  const Scene& scene = list.scene;
  const Scene::Material& m = scene.material;
  list.add("a shear modulus", modulus_range, "Pa", {"material.young_modulus", "material.poisson_ratio"},
           [&] { return m.young_modulus / (2.0 * (1.0 + m.poisson_ratio)); });
  if (m.stiffness == StiffnessChoice::explicit_values && m.micro_young_modulus && m.micro_radius_ratio) {
    list.add("beams of a Young's modulus", micro_modulus_range, "Pa", {"material.micro_young_modulus"},
             [&] { return *m.micro_young_modulus; });
    list.add("beams of a radius ratio", radius_ratio_range, "", {"material.micro_radius_ratio"},
             [&] { return *m.micro_radius_ratio; });
  }
  if (m.stiffness == StiffnessChoice::explicit_values && m.micro_poisson_ratio)
    list.add("beams of a torsional over bending stiffness", torsion_range, "",
             {"material.micro_poisson_ratio"}, [&] { return 1.0 / (2.0 * (1.0 + *m.micro_poisson_ratio)); });
  if (!m.density && !m.rayleigh_speed) return;
  const std::vector<std::string> keys{m.density ? "material.density" : "material.rayleigh_speed",
                                      "material.young_modulus", "material.poisson_ratio"};
  list.add("a density", density_range, "kg/m3", keys, [&] { return density(scene); });
  list.add("a Rayleigh speed", wave_speed_range, "m/s", keys, [&] { return rayleigh_speed(scene); });
  list.add("a dilatational wave speed", wave_speed_range, "m/s", keys, [&] {
    return rayleigh_speed(scene) / theory::rayleigh_over_shear(m.poisson_ratio, m.plane) *
           theory::dilatational_over_shear(m.poisson_ratio, m.plane);
  });
}

void add_strain(DerivedList& list) {
  const Scene& scene = list.scene;
  if (!can_crack(scene) || scene.loading.force || !scene.loading.curve.row.empty()) return;
  if (scene.loading.displacement == 0.0) return;  // strains nothing, which is told elsewhere
  list.add("a strain", strain_range(scene), "",
           {"loading.displacement", "specimen.height", "solver.kinematics", "solver.precision"},
           [&] { return std::abs(scene.loading.displacement) / scene.specimen.height; });
}

}  // namespace

Range strain_range(const Scene& scene) {
  if (scene.solver.kinematics == lattice::Kinematics::corotational) return {1e-10, 1e6};
  return {scene.solver.precision == ensemble::Precision::single_precision ? 1e-15 : 1e-30, 1e6};
}

std::optional<Issue> range_issue(const Preset& preset, const Scene& scene, const DerivedNumber& number) {
  if (lies_in(number.value, number.range)) return std::nullopt;
  const std::string blamed = to_blame(preset, scene, number.keys);
  std::vector<std::string> others;
  std::copy_if(number.keys.begin(), number.keys.end(), std::back_inserter(others),
               [&](const std::string& key) { return key != blamed; });
  const std::string unit = number.unit.empty() ? "" : " " + number.unit;
  return issue_at(preset, blamed,
                  fmt::format("{}makes {} of {:.4g}{}, which must lie in [{:g}, {:g}]{}",
                              others.empty() ? "" : fmt::format("with {} it ", listed(others, "and")),
                              number.name, number.value, unit, number.range.lower, number.range.upper, unit));
}

std::vector<Issue> range_issues(const Preset& preset, const Scene& scene,
                                const std::vector<DerivedNumber>& numbers) {
  std::vector<Issue> issues;
  for (const DerivedNumber& number : numbers) {
    std::optional<Issue> issue = range_issue(preset, scene, number);
    const auto same = [&](const Issue& earlier) { return earlier.key == issue->key; };
    if (issue && std::none_of(issues.begin(), issues.end(), same)) issues.push_back(std::move(*issue));
  }
  return issues;
}

std::vector<DerivedNumber> derived_numbers(const Preset& preset, const std::set<std::string>& unsound) {
  DerivedList list{preset.scene, unsound};
  add_sizes(list);
  add_material(list);
  add_strain(list);
  return std::move(list.numbers);
}

}  // namespace rift::scene

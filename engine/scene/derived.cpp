#include "engine/scene/derived.hpp"

#include "engine/base/numbers.hpp"
#include "engine/scene/issue.hpp"
#include "engine/scene/spline.hpp"
#include "engine/theory/references.hpp"
#include "engine/theory/wave_speeds.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cassert>
#include <cmath>
#include <limits>
#include <numbers>
#include <type_traits>

namespace rift::scene {

bool can_crack(const Scene& scene) {
  return scene.specimen.shape == packing::Shape::plate || scene.specimen.shape == packing::Shape::block;
}

packing::Box box_of(const Scene& scene) {
  const Scene::Specimen& s = scene.specimen;
  const double height = s.shape == packing::Shape::sphere ? s.length : s.height;
  return {s.length, height, thickness_m(scene), s.shape};
}

packing::PackingRequest request_of(const Scene& scene) {
  const Scene::Specimen& s = scene.specimen;
  return {.box = box_of(scene),
          .elements = s.elements,
          .radius_spread = s.radius_spread,
          .coordination = s.coordination,
          .seed = static_cast<std::uint64_t>(s.seed),
          .radii = s.radii,
          .solid_fraction = s.solid_fraction.value_or(0.0)};
}

double thickness_m(const Scene& scene) {
  const Scene::Specimen& s = scene.specimen;
  if (s.shape == packing::Shape::cylinder || s.shape == packing::Shape::sphere) return s.length;
  if (s.thickness) return *s.thickness;
  assert(s.layers);
  const double elements_per_area = s.elements / (s.length * s.height);
  return 2e-3 * std::sqrt(20000 / (0.2 * 0.04) / elements_per_area) * std::pow(*s.layers / 2, 1.5);
}

double expected_mean_radius_m(const Scene& scene) {
  const Scene::Specimen& s = scene.specimen;
  const double spread2 = s.radius_spread * s.radius_spread;
  const double cube =
      s.radii == packing::Radii::uniform ? 1 + spread2 : std::exp(3 * spread2);  // <r^3> / R^3
  return std::cbrt(0.615 * box_of(scene).volume() / (s.elements * 4.0 / 3.0 * std::numbers::pi * cube));
}

double expected_zone_m(const Scene& scene) {
  if (scene.crack.technique == fracture::Technique::simple || breaks_freely(scene)) return 0.0;
  return scene.crack.damage_zone_ratio * expected_mean_radius_m(scene);
}

double density(const Scene& scene) {
  const Scene::Material& m = scene.material;
  if (m.density) return *m.density;
  assert(m.rayleigh_speed);
  const double shear_speed = *m.rayleigh_speed / theory::rayleigh_over_shear(m.poisson_ratio, m.plane);
  const double shear_modulus = m.young_modulus / (2 * (1 + m.poisson_ratio));
  return shear_modulus / (shear_speed * shear_speed);
}

double rayleigh_speed(const Scene& scene) {
  const Scene::Material& m = scene.material;
  if (m.rayleigh_speed) return *m.rayleigh_speed;
  assert(m.density);
  return theory::wave_speeds(m.young_modulus, m.poisson_ratio, *m.density, m.plane).rayleigh;
}

double speed_m_s(const Speed& speed, double rayleigh_speed) {
  return speed.relative ? speed.value * rayleigh_speed : speed.value;
}

history::SmoothedHistory smoothed_history(const Scene& scene) {
  return history::smoothed_history(scene.crack.history, scene.crack.start, scene.crack.smoothing);
}

double load_time(const Scene& scene) {
  return scene.crack.history.empty() ? 0.0 : scene.crack.history.front().time;
}

double load_at(const LoadCurve& curve, double time) {
  const auto& rows = curve.row;
  if (time <= rows.front()[0]) return rows.front()[1];
  if (time > rows.back()[0]) return rows.back()[1];
  const auto [k, part] = base::interval_at(rows, time, [](const auto& row) { return row[0]; });
  return std::lerp(rows[k - 1][1], rows[k][1], part);
}

std::optional<double> force_at_start(const Scene& scene) {
  const LoadCurve& curve = scene.loading.curve;
  if (!curve.row.empty() && curve.of == LoadCurve::Of::force) return load_at(curve, load_time(scene));
  return scene.loading.force;
}

double displacement_at_start(const Scene& scene) {
  const LoadCurve& curve = scene.loading.curve;
  return curve.row.empty() ? scene.loading.displacement : load_at(curve, load_time(scene));
}

bool grip_moves(const Scene& scene) {
  const LoadCurve& curve = scene.loading.curve;
  return !curve.row.empty() && curve.of == LoadCurve::Of::displacement;
}

bool breaks_freely(const Scene& scene) { return scene.breaking.law != fracture::FractureLaw::prescribed; }

bool keeps_its_velocity(const Scene& scene) {
  return !breaks_freely(scene) && scene.crack.velocity.size() == 1 && scene.crack.history.empty() &&
         scene.crack.toughness.row.empty();
}

double highest_velocity(const Scene& scene) {
  if (!scene.crack.history.empty())
    return history::highest_speed(smoothed_history(scene).history) / rayleigh_speed(scene);
  const bool by_itself = !scene.crack.toughness.row.empty() || breaks_freely(scene);
  double highest = by_itself ? fastest_by_itself : 0.0;
  for (const VelocityPiece& piece : scene.crack.velocity) {
    const Speed& v = piece.speed;
    highest = std::max(highest, v.relative ? v.value : v.value / rayleigh_speed(scene));
  }
  return highest;
}

double path_height_m(const Scene& scene) {
  const CrackLine& path = scene.crack.path;
  if (!path.point.empty()) return std::numeric_limits<double>::quiet_NaN();
  return path.relative ? path.value * scene.specimen.height : path.value;
}

std::vector<std::array<double, 2>> path_points_m(const Scene& scene) {
  constexpr int pieces = 32;  // of a spline, from point to point
  const std::vector<std::array<double, 2>>& point = scene.crack.path.point;
  if (point.empty()) {
    const double height = path_height_m(scene);
    return {{0.0, height}, {scene.specimen.length, height}};
  }
  return scene.crack.path_shape == PathShape::spline ? spline_through(point, pieces) : point;
}

double path_length_m(const Scene& scene) {
  if (scene.crack.path.point.empty()) return scene.specimen.length;
  const std::vector<std::array<double, 2>> point = path_points_m(scene);
  double length = 0.0;
  for (std::size_t k = 0; k + 1 < point.size(); ++k)
    length += std::hypot(point[k + 1][0] - point[k][0], point[k + 1][1] - point[k][1]);
  return length;
}

std::array<double, 2> window_over_length(const Scene& scene) {
  if (scene.output.window) return *scene.output.window;
  if (!scene.crack.history.empty() || !scene.crack.toughness.row.empty() || breaks_freely(scene))
    return {scene.crack.start / scene.specimen.length, crack_end(scene) / scene.specimen.length};
  if (scene.crack.tips == 2) {
    const double zone = expected_zone_m(scene);
    const double from = scene.crack.start + 5.0 * (zone > 0.0 ? zone : expected_mean_radius_m(scene));
    const double echo = echo_free_tip_m(scene);
    const double to =
        std::isinf(echo) ? tip_path_length_m(scene) : echo;  // an echo from an end is back before it
    return {from / scene.specimen.length, to / scene.specimen.length};
  }
  if (highest_velocity(scene) > 0.8) return {0.4, 0.6};
  return {0.2, 0.4};
}

double shortest_window_m(const Scene& scene) {
  return std::max(2.0 * expected_zone_m(scene), 10.0 * expected_mean_radius_m(scene));
}

double tip_path_length_m(const Scene& scene) { return path_length_m(scene) / scene.crack.tips; }

double crack_end(const Scene& scene) {
  if (scene.crack.end) return *scene.crack.end;
  if (!scene.crack.history.empty()) return smoothed_history(scene).end;
  if (!scene.crack.toughness.row.empty() || breaks_freely(scene)) return tip_path_length_m(scene);
  return window_over_length(scene)[1] * scene.specimen.length;
}

double echo_free_tip_m(const Scene& scene, double faster) {
  if (!keeps_its_velocity(scene) || !scene.crack.path.point.empty())
    return std::numeric_limits<double>::quiet_NaN();
  const Scene::Material& m = scene.material;
  const theory::WaveSpeeds speeds =
      theory::wave_speeds(m.young_modulus, m.poisson_ratio, density(scene), m.plane);
  const double path = path_height_m(scene), start = scene.crack.start;
  const double to_grip = std::min(path, scene.specimen.height - path);
  return start + theory::echo_free_advance(speed_m_s(scene.crack.velocity.front().speed, speeds.rayleigh),
                                           2.0 * to_grip, tip_path_length_m(scene) - start,
                                           faster * speeds.dilatational);
}

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

/// Gathers the numbers whose keys are all valid.
struct DerivedList {
  const Scene& scene;
  const std::set<std::string>& invalid;
  std::vector<DerivedNumber> numbers = {};

  bool valid(const std::vector<std::string>& keys) const {
    return std::none_of(keys.begin(), keys.end(),
                        [&](const std::string& key) { return invalid.contains(key); });
  }
  /// `value` is asked for only where it can be told.
  template <class Value>
  void add(std::string name, const Range& range, std::string unit, std::vector<std::string> keys,
           const Value& value) {
    if (valid(keys)) numbers.push_back({std::move(name), value(), range, std::move(unit), std::move(keys)});
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
  if (!list.valid({"specimen.shape", "specimen.radii", "crack.technique"})) return;
  std::vector<std::string> keys = size_keys(scene);
  keys.emplace_back("specimen.elements");
  list.add("a thickness", length_range, "m", keys, [&] { return thickness_m(scene); });
  keys.emplace_back("specimen.radius_spread");
  list.add("a mean radius", length_range, "m", keys, [&] { return expected_mean_radius_m(scene); });
  if (scene.crack.technique == fracture::Technique::simple || breaks_freely(scene)) return;
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
  if (scene.loading.traction) return;             // strains nothing yet as the run starts
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

std::vector<DerivedNumber> derived_numbers(const Preset& preset, const std::set<std::string>& invalid) {
  DerivedList list{preset.scene, invalid};
  add_sizes(list);
  add_material(list);
  add_strain(list);
  return std::move(list.numbers);
}

}  // namespace rift::scene

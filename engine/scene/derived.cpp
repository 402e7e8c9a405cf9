#include "engine/scene/derived.hpp"

#include "engine/scene/spline.hpp"
#include "engine/theory/echo.hpp"
#include "engine/theory/wave_speeds.hpp"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <limits>
#include <numbers>

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
  if (scene.crack.technique == fracture::Technique::simple) return 0.0;
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

history::Course measured_course(const Scene& scene) {
  return history::course_of(scene.crack.history, scene.crack.start, scene.crack.smoothing);
}

double load_time(const Scene& scene) {
  return scene.crack.history.empty() ? 0.0 : scene.crack.history.front().time;
}

double load_at(const LoadCurve& curve, double time) {
  const auto& rows = curve.row;
  if (time <= rows.front()[0]) return rows.front()[1];
  for (std::size_t k = 1; k < rows.size(); ++k)
    if (time <= rows[k][0])
      return std::lerp(rows[k - 1][1], rows[k][1], (time - rows[k - 1][0]) / (rows[k][0] - rows[k - 1][0]));
  return rows.back()[1];
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

bool keeps_its_velocity(const Scene& scene) {
  return scene.crack.velocity.size() == 1 && scene.crack.history.empty() && scene.crack.toughness.row.empty();
}

double highest_velocity(const Scene& scene) {
  if (!scene.crack.history.empty())
    return history::highest_speed(measured_course(scene).history) / rayleigh_speed(scene);
  double highest = scene.crack.toughness.row.empty() ? 0.0 : fastest_by_itself;
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
  if (!scene.crack.history.empty() || !scene.crack.toughness.row.empty())
    return {scene.crack.start / scene.specimen.length, crack_end(scene) / scene.specimen.length};
  if (scene.crack.tips == 2) {
    const double zone = expected_zone_m(scene);
    const double from = scene.crack.start + 5.0 * (zone > 0.0 ? zone : expected_mean_radius_m(scene));
    const double echo = echo_free_tip_m(scene);
    const double to = std::isinf(echo) ? way_of_tip_m(scene) : echo;  // an echo from an end is back before it
    return {from / scene.specimen.length, to / scene.specimen.length};
  }
  if (highest_velocity(scene) > 0.8) return {0.4, 0.6};
  return {0.2, 0.4};
}

double shortest_window_m(const Scene& scene) {
  return std::max(2.0 * expected_zone_m(scene), 10.0 * expected_mean_radius_m(scene));
}

double way_of_tip_m(const Scene& scene) { return path_length_m(scene) / scene.crack.tips; }

double crack_end(const Scene& scene) {
  if (scene.crack.end) return *scene.crack.end;
  if (!scene.crack.history.empty()) return measured_course(scene).end;
  if (!scene.crack.toughness.row.empty()) return way_of_tip_m(scene);
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
                                           2.0 * to_grip, way_of_tip_m(scene) - start,
                                           faster * speeds.dilatational);
}

}  // namespace rift::scene

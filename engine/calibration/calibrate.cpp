#include "engine/calibration/calibrate.hpp"

#include "engine/lattice/stiffness.hpp"
#include "engine/scene/derived.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>

namespace rift::calibration {
namespace {

std::vector<Scattered> over_packings(const std::vector<CylinderResult>& packings,
                                     const std::function<double(const Response&)>& of) {
  std::vector<Scattered> by_beam;
  for (std::size_t k = 0; k < packings.front().responses.size(); ++k) {
    std::vector<double> values;
    for (const CylinderResult& packing : packings) values.push_back(of(packing.responses[k]));
    by_beam.push_back(scattered(values));
  }
  return by_beam;
}

struct Point {
  double radius_ratio, poisson_ratio;
};

/// Where a straight line through two points has this nu.
double crossing(const Point& a, const Point& b, double nu) {
  return a.radius_ratio +
         (nu - a.poisson_ratio) * (b.radius_ratio - a.radius_ratio) / (b.poisson_ratio - a.poisson_ratio);
}

std::array<double, 2> attainable(const std::vector<Scattered>& nu) {
  const auto [low, high] = std::ranges::minmax(nu, {}, &Scattered::mean);
  return {low.mean, high.mean};
}

/// Two neighbours of the scan on either side of this nu.
std::array<Point, 2> bracket(const std::vector<BeamShape>& beams, const std::vector<Scattered>& nu,
                             double wanted) {
  for (std::size_t k = 1; k < beams.size(); ++k)
    if ((nu[k - 1].mean - wanted) * (nu[k].mean - wanted) <= 0.0)
      return {Point{beams[k - 1].radius_ratio, nu[k - 1].mean}, Point{beams[k].radius_ratio, nu[k].mean}};
  throw OutOfReach(wanted, attainable(nu));
}

Calibrated selected(const std::vector<CylinderResult>& packings, double young_modulus, const BeamShape& beams,
                    double slope) {
  const Scattered ratio = young_of(packings).front(), nu = poisson_of(packings).front();
  Calibrated c;
  c.micro = {young_modulus / ratio.mean, beams.poisson_ratio, beams.radius_ratio};
  c.micro_young_deviation = c.micro.young_modulus * ratio.deviation / ratio.mean;
  c.radius_ratio_deviation = std::abs(nu.deviation / slope);
  c.young_modulus = {young_modulus, young_modulus * ratio.deviation / ratio.mean};
  c.poisson_ratio = nu;
  return c;
}

}  // namespace

Scattered scattered(const std::vector<double>& values) {
  Scattered s;
  const auto n = static_cast<double>(values.size());
  for (double v : values) s.mean += v / n;
  for (double v : values) s.deviation += (v - s.mean) * (v - s.mean) / (n - 1.0);
  s.deviation = values.size() > 1 ? std::sqrt(s.deviation) : std::numeric_limits<double>::quiet_NaN();
  return s;
}

OutOfReach::OutOfReach(double wanted, std::array<double, 2> range)
    : std::runtime_error(
          fmt::format("{:.4g} is out of reach of these beams: the cylinders show {:.3f} to {:.3f}", wanted,
                      range[0], range[1])),
      attainable(range) {}

std::vector<CylinderTest> cylinders_for(const scene::Scene& scene, int elements,
                                        const std::vector<BeamShape>& beams) {
  constexpr double diameter = 20e-3;  // any: only ratios of lengths count
  packing::PackingRequest request = scene::request_of(scene);
  request.box = {diameter, 2.0 * diameter, diameter, packing::Shape::cylinder};
  request.elements = elements;
  std::vector<CylinderTest> tests;
  for (int k = 0; k < scene.calibration.packings; ++k) {
    request.seed = static_cast<std::uint64_t>(scene.specimen.seed) + k;
    tests.push_back({request, scene.specimen.contact_tolerance, beams});
  }
  return tests;
}

std::vector<BeamShape> scanned_beams(const scene::Scene& scene) {
  std::vector<BeamShape> beams;
  for (double r : scene.calibration.radius_ratios)
    beams.push_back({r, lattice::bulk_micro_material.poisson_ratio});
  return beams;
}

std::vector<Scattered> young_of(const std::vector<CylinderResult>& packings) {
  return over_packings(packings, [](const Response& r) { return r.young_over_micro; });
}

std::vector<Scattered> poisson_of(const std::vector<CylinderResult>& packings) {
  return over_packings(packings, [](const Response& r) { return r.poisson_ratio; });
}

Calibrated calibrate(const scene::Scene& scene, double young_modulus, double poisson_ratio,
                     base::Cache& cache, const CalibrationProgress& progress, int threads) {
  constexpr double close_enough = 2e-4, share_of_scan = 0.7;
  constexpr int most_secants = 5;
  const int elements = scene.calibration.elements;
  const auto part = [&](double from, double to) {
    return [&progress, from, to](double done) { return !progress || progress(from + (to - from) * done); };
  };
  const std::vector<BeamShape> scan = scanned_beams(scene);
  const auto scanned =
      press_cylinders(cylinders_for(scene, elements, scan), cache, part(0.0, share_of_scan), threads);
  const std::vector<Scattered> nu = poisson_of(scanned);
  auto [a, b] = bracket(scan, nu, poisson_ratio);
  for (int secant = 0;; ++secant) {
    const BeamShape beams{crossing(a, b, poisson_ratio), scan.front().poisson_ratio};
    const double slope = (b.poisson_ratio - a.poisson_ratio) / (b.radius_ratio - a.radius_ratio);
    const double from = share_of_scan + (1.0 - share_of_scan) * secant / (most_secants + 1.0);
    const auto pressed =
        press_cylinders(cylinders_for(scene, elements, {beams}), cache,
                        part(from, from + (1.0 - share_of_scan) / (most_secants + 1.0)), threads);
    const Point found{beams.radius_ratio, poisson_of(pressed).front().mean};
    if (std::abs(found.poisson_ratio - poisson_ratio) <= close_enough || secant == most_secants) {
      Calibrated c = selected(pressed, young_modulus, beams, slope);
      c.attainable = attainable(nu);
      return c;
    }
    (std::abs(a.poisson_ratio - poisson_ratio) > std::abs(b.poisson_ratio - poisson_ratio) ? a : b) = found;
  }
}

}  // namespace rift::calibration

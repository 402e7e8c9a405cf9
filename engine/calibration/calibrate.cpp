#include "engine/calibration/calibrate.hpp"

#include "engine/lattice/lattice.hpp"
#include "engine/scene/derived.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>
#include <set>

namespace rift::calibration {
namespace {

constexpr int most_secants = 5;

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

// Rounded share by share, unlike base::mean_of: what was calibrated before keeps its bits.
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
          fmt::format("{:.4g} is out of reach of these beams: the cylinders show {:.3f} to {:.3f} at "
                      "calibration.radius_ratios",
                      wanted, range[0], range[1])),
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
                     base::Cache& cache, const base::ProgressCallback& progress, int threads) {
  constexpr double close_enough = 2e-4, share_of_scan = 0.7;
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

namespace {

constexpr BeamShape paper_beams{lattice::bulk_micro_material.radius_ratio,
                                lattice::bulk_micro_material.poisson_ratio};

/// Periodic boxes of this coordination, half as many elements as the scan's cylinders.
std::vector<BoxTest> boxes_of(const scene::Scene& scene, double coordination) {
  constexpr double edge = 10e-3;
  packing::PackingRequest request = scene::request_of(scene);
  request.box = {edge, edge, edge, packing::Shape::periodic};
  request.elements = std::max(100, scene.calibration.elements / 2);
  request.coordination = coordination;
  request.solid_fraction = 0.0;
  std::vector<BoxTest> tests;
  for (int k = 0; k < scene.calibration.packings; ++k) {
    request.seed = static_cast<std::uint64_t>(scene.specimen.seed) + k;
    tests.push_back({request, scene.specimen.contact_tolerance, paper_beams});
  }
  return tests;
}

double mean_core(const std::vector<CylinderResult>& cylinders) {
  double sum = 0.0;
  for (const CylinderResult& c : cylinders) sum += c.core_coordination;
  return sum / static_cast<double>(cylinders.size());
}

using Row = nlohmann::ordered_json;

void add_rows(std::vector<Row>& rows, const char* series, const std::vector<CylinderResult>& cylinders) {
  for (const CylinderResult& c : cylinders)
    for (std::size_t k = 0; k < c.beams.size(); ++k)
      rows.push_back({{"series", series},
                      {"elements", c.packing.elements},
                      {"seed", c.packing.seed},
                      {"coordination", c.coordination},
                      {"core_coordination", c.core_coordination},
                      {"solid_fraction", c.solid_fraction},
                      {"micro_radius_ratio", c.beams[k].radius_ratio},
                      {"micro_poisson_ratio", c.beams[k].poisson_ratio},
                      {"young_over_micro", c.responses[k].young_over_micro},
                      {"young_ends_over_micro", c.responses[k].ends_over_micro},
                      {"poisson_ratio", c.responses[k].poisson_ratio},
                      {"anisotropy", nullptr}});
}

void add_rows(std::vector<Row>& rows, const std::vector<BoxResult>& boxes) {
  for (const BoxResult& b : boxes) {
    const Isotropic solid = b.isotropic();
    rows.push_back({{"series", "box"},
                    {"elements", b.packing.elements},
                    {"seed", b.packing.seed},
                    {"coordination", b.coordination},
                    {"core_coordination", b.coordination},
                    {"solid_fraction", b.solid_fraction},
                    {"micro_radius_ratio", paper_beams.radius_ratio},
                    {"micro_poisson_ratio", paper_beams.poisson_ratio},
                    {"young_over_micro", solid.young_modulus},
                    {"young_ends_over_micro", nullptr},
                    {"poisson_ratio", solid.poisson_ratio},
                    {"anisotropy", solid.anisotropy}});
  }
}

}  // namespace

std::vector<Row> rows_of(const CalibrationStudy& study) {
  std::vector<Row> rows;
  for (const auto& packings : study.by_size) add_rows(rows, "size", packings);
  add_rows(rows, "scan", study.scan);
  add_rows(rows, "twisted", study.twisted);
  add_rows(rows, study.boxes);
  return rows;
}

namespace {

/// The cylinders of all sizes, with the paper's beams.
std::vector<CylinderTest> cylinders_of_sizes(const scene::Scene& scene) {
  std::vector<CylinderTest> sizes;
  for (double elements : scene.calibration.sizes)
    for (CylinderTest& test : cylinders_for(scene, static_cast<int>(elements), {paper_beams}))
      sizes.push_back(std::move(test));
  return sizes;
}

/// Those that show what nu_mu matters.
std::vector<CylinderTest> twisted_cylinders(const scene::Scene& scene) {
  return cylinders_for(scene, scene.calibration.elements,
                       {{paper_beams.radius_ratio, 0.0}, {paper_beams.radius_ratio, 0.45}});
}

}  // namespace

std::vector<PlannedSpecimen> planned_specimens(const scene::Scene& scene, bool study) {
  constexpr int unit_strains = 6;
  std::vector<PlannedSpecimen> planned;
  std::set<std::string> packed;
  const auto add = [&](const char* stage, const std::vector<CylinderTest>& tests, int times = 1) {
    for (const CylinderTest& test : tests)
      planned.push_back({.stage = stage,
                         .elements = test.packing.elements,
                         .packed_before = !packed.insert(packing::key_of(test.packing)).second,
                         .solutions = times * static_cast<int>(test.beams.size())});
  };
  const std::vector<CylinderTest> scan =
      cylinders_for(scene, scene.calibration.elements, scanned_beams(scene));
  if (study) {
    add("cylinders of all sizes", cylinders_of_sizes(scene));
    add("scan of r_mu", scan);
    add("scan of nu_mu", twisted_cylinders(scene));
    for (int twice = 0; twice < 2; ++twice)
      for (const BoxTest& box : boxes_of(scene, scene.specimen.coordination))
        planned.push_back(
            {.stage = "periodic boxes", .elements = box.packing.elements, .solutions = unit_strains});
  } else {
    add("scan of r_mu", scan);
  }
  add("beams of the material", cylinders_for(scene, scene.calibration.elements, {paper_beams}),
      most_secants + 1);
  return planned;
}

CalibrationStudy study_calibration(const scene::Scene& scene, base::Cache& cache, const StudyStage& progress,
                                   int threads) {
  const auto stage = [&](const char* name) {
    return [&progress, name](double done) { return !progress || progress(name, done); };
  };
  CalibrationStudy study;
  const auto pressed =
      press_cylinders(cylinders_of_sizes(scene), cache, stage("cylinders of all sizes"), threads);
  const auto packings = static_cast<std::size_t>(scene.calibration.packings);
  for (std::size_t k = 0; k < pressed.size(); k += packings)
    study.by_size.emplace_back(pressed.begin() + k, pressed.begin() + k + packings);

  const int elements = scene.calibration.elements;
  study.scan = press_cylinders(cylinders_for(scene, elements, scanned_beams(scene)), cache,
                               stage("scan of r_mu"), threads);
  study.twisted = press_cylinders(twisted_cylinders(scene), cache, stage("scan of nu_mu"), threads);

  std::vector<BoxTest> boxes = boxes_of(scene, scene.specimen.coordination);
  for (BoxTest& test : boxes_of(scene, mean_core(study.scan))) boxes.push_back(std::move(test));
  study.boxes = homogenise_boxes(boxes, cache, stage("periodic boxes"), threads);
  return study;
}

}  // namespace rift::calibration

#include "engine/calibration/calibration_study.hpp"

#include "engine/lattice/stiffness.hpp"
#include "engine/scene/derived.hpp"

#include <algorithm>

namespace rift::calibration {
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

CalibrationStudy study_calibration(const scene::Scene& scene, base::Cache& cache, const StudyStage& progress,
                                   int threads) {
  const auto stage = [&](const char* name) {
    return [&progress, name](double done) { return !progress || progress(name, done); };
  };
  CalibrationStudy study;
  std::vector<CylinderTest> sizes;
  for (double elements : scene.calibration.sizes)
    for (CylinderTest& test : cylinders_for(scene, static_cast<int>(elements), {paper_beams}))
      sizes.push_back(std::move(test));
  const auto pressed = press_cylinders(sizes, cache, stage("cylinders of all sizes"), threads);
  const auto packings = static_cast<std::size_t>(scene.calibration.packings);
  for (std::size_t k = 0; k < pressed.size(); k += packings)
    study.by_size.emplace_back(pressed.begin() + k, pressed.begin() + k + packings);

  const int elements = scene.calibration.elements;
  study.scan = press_cylinders(cylinders_for(scene, elements, scanned_beams(scene)), cache,
                               stage("scan of r_mu"), threads);
  study.twisted = press_cylinders(
      cylinders_for(scene, elements, {{paper_beams.radius_ratio, 0.0}, {paper_beams.radius_ratio, 0.45}}),
      cache, stage("scan of nu_mu"), threads);

  std::vector<BoxTest> boxes = boxes_of(scene, scene.specimen.coordination);
  for (BoxTest& test : boxes_of(scene, mean_core(study.scan))) boxes.push_back(std::move(test));
  study.boxes = homogenise_boxes(boxes, cache, stage("periodic boxes"), threads);
  return study;
}

}  // namespace rift::calibration

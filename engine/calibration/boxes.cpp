#include "engine/calibration/boxes.hpp"

#include "engine/base/interrupted.hpp"
#include "engine/calibration/each_specimen.hpp"
#include "engine/packing/cached_packing.hpp"

#include <fmt/format.h>

namespace rift::calibration {
namespace {

std::string key_of(const BoxTest& test) {
  constexpr int version = 1;
  return fmt::format("box {} {} tolerance {:a} beams {:a} {:a}", version, packing::key_of(test.packing),
                     test.contact_tolerance, test.beams.radius_ratio, test.beams.poisson_ratio);
}

constexpr std::size_t numbers_before_stiffness = 2;

BoxResult result_of(const BoxTest& test, const std::vector<double>& n) {
  return {test.packing, n[0], n[1], Eigen::Map<const Matrix6>(n.data() + numbers_before_stiffness)};
}

BoxResult homogenise(const BoxTest& test, base::Cache& cache, const CalibrationProgress& tell) {
  constexpr double share_of_packing = 0.4;
  bool found = false;
  const packing::Packing packing = packing::cached_packing(
      test.packing, cache, found, [&](double done) { return tell(share_of_packing * done); }, 1);
  const packing::Specimen specimen =
      packing::make_free_specimen(packing, test.packing.box, test.contact_tolerance);
  const lattice::Lattice lattice =
      lattice::make_lattice(specimen, {1.0, test.beams.poisson_ratio, test.beams.radius_ratio}, 1.0);
  return {test.packing, specimen.packing.coordination, specimen.packing.solid_fraction,
          homogenised_stiffness(lattice, [&](double done) {
            return tell(share_of_packing + (1.0 - share_of_packing) * done);
          })};
}

BoxResult homogenised_or_recalled(const BoxTest& test, base::Cache& cache, const CalibrationProgress& tell) {
  const std::string key = key_of(test);
  const auto known = base::recall(cache, "box", key);
  BoxResult result;
  if (known && known->size() == numbers_before_stiffness + 36) {
    result = result_of(test, *known);
  } else {
    result = homogenise(test, cache, tell);
    std::vector<double> numbers{result.coordination, result.solid_fraction};
    numbers.insert(numbers.end(), result.stiffness.data(), result.stiffness.data() + 36);
    base::remember(cache, "box", key, numbers);
  }
  if (!tell(1.0)) throw base::Interrupted("homogenising boxes");
  return result;
}

}  // namespace

std::vector<BoxResult> homogenise_boxes(const std::vector<BoxTest>& tests, base::Cache& cache,
                                        const CalibrationProgress& progress, int threads) {
  return each_specimen(tests, cache, progress, threads, homogenised_or_recalled);
}

}  // namespace rift::calibration

#include "engine/calibration/homogenise.hpp"

#include "engine/base/interrupted.hpp"
#include "engine/calibration/calibrate.hpp"
#include "engine/lattice/statics.hpp"
#include "engine/packing/packing.hpp"

#include <Eigen/Dense>
#include <fmt/format.h>

#include <array>
#include <cassert>

namespace rift::calibration {
namespace {

/// The a-th unit strain as a symmetric matrix.
Eigen::Matrix3d unit_strain(int a) {
  constexpr std::array<std::array<int, 2>, 6> place{{{0, 0}, {1, 1}, {2, 2}, {1, 2}, {0, 2}, {0, 1}}};
  Eigen::Matrix3d strain = Eigen::Matrix3d::Zero();
  const auto [r, c] = place[a];
  strain(r, c) += 0.5, strain(c, r) += 0.5;
  return strain;
}

/// The motions of a beam's ends where the whole box is strained: those of the elements, and the far end moved
/// by the strain over the beam, whichever image of the element it joins.
lattice::BeamStrain strain_in(const lattice::Beam& beam, const Eigen::Matrix3d& strain,
                              const lattice::Vector6& q_i, const lattice::Vector6& q_j) {
  lattice::Vector6 far = q_j;
  far.head<3>() += strain * (beam.length * beam.axis);
  return lattice::strain_of(beam, q_i, far);
}

/// Forces of the beams on the elements where nothing has moved yet but the box.
std::vector<lattice::Vector6> loads_of_strain(const lattice::Lattice& lattice,
                                              const Eigen::Matrix3d& strain) {
  std::vector<lattice::Vector6> load(lattice.centre.size(), lattice::Vector6::Zero());
  for (std::size_t b = 0; b < lattice.beam.size(); ++b) {
    lattice::Vector6 far = lattice::Vector6::Zero();
    far.head<3>() = strain * (lattice.beam[b].length * lattice.beam[b].axis);
    const lattice::BeamLoads l = lattice::loads_of(lattice.beam[b], lattice::Vector6::Zero(), far);
    const auto& [i, j] = lattice.ends[b];
    load[i].head<3>() += l.force_i, load[i].tail<3>() += l.moment_i;
    load[j].head<3>() -= l.force_i, load[j].tail<3>() += l.moment_j;
  }
  return load;
}

/// Bulk and shear modulus of Voigt's bound.
std::array<double, 2> voigt(const Matrix6& c) {
  const double direct = c(0, 0) + c(1, 1) + c(2, 2), across = c(0, 1) + c(0, 2) + c(1, 2);
  return {(direct + 2.0 * across) / 9.0, (direct - across + 3.0 * (c(3, 3) + c(4, 4) + c(5, 5))) / 15.0};
}

/// The same of Reuss's bound.
std::array<double, 2> reuss(const Matrix6& stiffness) {
  const Matrix6 s = stiffness.inverse();
  const double direct = s(0, 0) + s(1, 1) + s(2, 2), across = s(0, 1) + s(0, 2) + s(1, 2);
  return {1.0 / (direct + 2.0 * across),
          15.0 / (4.0 * direct - 4.0 * across + 3.0 * (s(3, 3) + s(4, 4) + s(5, 5)))};
}

}  // namespace

Matrix6 homogenised_stiffness(const lattice::Lattice& lattice, const base::ProgressCallback& told) {
  assert(lattice.box.shape == packing::Shape::periodic);
  lattice::FreeBody body(lattice, 1);
  std::array<std::vector<lattice::Vector6>, 6> motion;
  constexpr double tolerance = 1e-10;
  for (int a = 0; a < 6; ++a)
    motion[a] = body.at_rest(loads_of_strain(lattice, unit_strain(a)), tolerance,
                             [&](double done) { return !told || told((a + done) / 6.0); });
  Matrix6 stiffness = Matrix6::Zero();
  for (std::size_t k = 0; k < lattice.beam.size(); ++k) {
    const lattice::Beam& beam = lattice.beam[k];
    const auto& [i, j] = lattice.ends[k];
    std::array<lattice::BeamStrain, 6> strain;
    for (int a = 0; a < 6; ++a) strain[a] = strain_in(beam, unit_strain(a), motion[a][i], motion[a][j]);
    for (int a = 0; a < 6; ++a)
      for (int b = 0; b < 6; ++b)
        stiffness(a, b) += 2.0 * lattice::bilinear_energy(beam, strain[a], strain[b]);
  }
  return stiffness / lattice.box.volume();
}

Isotropic isotropic_part(const Matrix6& stiffness) {
  const auto [k_v, g_v] = voigt(stiffness);
  const auto [k_r, g_r] = reuss(stiffness);
  const double k = 0.5 * (k_v + k_r), g = 0.5 * (g_v + g_r);
  return {.young_modulus = 9.0 * k * g / (3.0 * k + g),
          .poisson_ratio = (3.0 * k - 2.0 * g) / (2.0 * (3.0 * k + g)),
          .anisotropy = 5.0 * g_v / g_r + k_v / k_r - 6.0};
}

namespace {

std::string key_of(const BoxTest& test) {
  constexpr int version = 2;
  return fmt::format("box {} {} tolerance {:a} beams {:a} {:a}", version, packing::key_of(test.packing),
                     test.contact_tolerance, test.beams.radius_ratio, test.beams.poisson_ratio);
}

constexpr std::size_t numbers_before_stiffness = 2;

BoxResult result_of(const BoxTest& test, const std::vector<double>& n) {
  return {test.packing, n[0], n[1], Eigen::Map<const Matrix6>(n.data() + numbers_before_stiffness)};
}

BoxResult homogenise(const BoxTest& test, base::Cache& cache, const base::ProgressCallback& tell) {
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

BoxResult homogenised_or_recalled(const BoxTest& test, base::Cache& cache,
                                  const base::ProgressCallback& tell) {
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
                                        const base::ProgressCallback& progress, int threads) {
  return each_specimen(tests, cache, progress, threads, homogenised_or_recalled);
}

}  // namespace rift::calibration

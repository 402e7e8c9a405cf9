#include "engine/calibration/pull.hpp"
#include "engine/lattice/statics.hpp"
#include "tests/engine/packing/packed_once.hpp"

#include <Eigen/Dense>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

// A bar and a cantilever cut from a block, away from its walls, against beam theory with the block's own
// modulus. What is cut has lost beams at its surface, so that a layer of less than an element's radius
// carries nothing: of eleven elements across this leaves at least 0.85 of the section to the bar. The
// cantilever's second moment of area follows from the same layer, to 8 %.

namespace rift::calibration {
namespace {

constexpr double thickness = 10e-3, length = 40e-3, margin = 2e-3;

packing::Packing block_packing(const packing::Box& box) {
  return packing::packed_once(
      {.box = box, .elements = 14'000, .radius_spread = 0.125, .coordination = 6.0, .seed = 1});
}

lattice::Lattice lattice_of(const packing::Packing& packing, const packing::Box& box) {
  return lattice::make_lattice(packing::make_free_specimen(packing, box, 1.0), {356e9, 0.3, 0.3}, 1000.0);
}

/// The elements whose centres lie in a box within the block, moved to its corner.
packing::Packing cut(const packing::Packing& block, const packing::Box& bar) {
  packing::Packing packing;
  for (std::size_t i = 0; i < block.centre.size(); ++i)
    if (const Eigen::Vector3d p = block.centre[i] - Eigen::Vector3d::Constant(margin); packing::contains(bar, p))
      packing.centre.push_back(p), packing.radius.push_back(block.radius[i]);
  return packing;
}

struct Bars {
  double block_modulus, bar_modulus, curvature_modulus;
};

/// Curvature of the deflection along z over x at the middle, by a cubic through the middle half.
double curvature_at_middle(const lattice::Lattice& lattice, const std::vector<lattice::Vector6>& motion) {
  Eigen::Matrix<double, 5, 5> normal = Eigen::Matrix<double, 5, 5>::Zero();
  Eigen::Matrix<double, 5, 1> right = Eigen::Matrix<double, 5, 1>::Zero();
  for (std::size_t i = 0; i < motion.size(); ++i) {
    const Eigen::Vector3d d = lattice.centre[i] - 0.5 * lattice.box.size();
    const double s = d.x() / (0.25 * length);
    if (std::abs(s) > 1.0) continue;
    Eigen::Matrix<double, 5, 1> basis;
    basis << 1.0, s, s * s, s * s * s,
        d.z() * d.z() / (thickness * thickness);  // the last: anticlastic, by nu
    normal += basis * basis.transpose();
    right += basis * motion[i][2];
  }
  return 2.0 * normal.ldlt().solve(right)[2] / std::pow(0.25 * length, 2.0);
}

/// Shear P at the right end, P and the moment P a at the left: a cantilever whose ends are a apart.
std::vector<lattice::Vector6> cantilever_loads(const lattice::Lattice& lattice, double shear) {
  std::vector<int> left, right;
  for (int i = 0; i < static_cast<int>(lattice.centre.size()); ++i) {
    if (lattice.centre[i].x() < 1.5e-3) left.push_back(i);
    if (lattice.centre[i].x() > length - 1.5e-3) right.push_back(i);
  }
  std::vector<lattice::Vector6> load(lattice.centre.size(), lattice::Vector6::Zero());
  Eigen::Vector3d moment = Eigen::Vector3d::Zero();
  const Eigen::Vector3d middle = 0.5 * lattice.box.size();
  const auto add = [&](const std::vector<int>& end, double force) {
    for (int i : end) {
      load[i][2] += force / static_cast<double>(end.size());
      moment +=
          (lattice.centre[i] - middle).cross(Eigen::Vector3d(0, 0, force / static_cast<double>(end.size())));
    }
  };
  add(right, shear), add(left, -shear);
  // The left end takes the moment that is left, by forces and couples of least norm.
  Eigen::MatrixXd sums = Eigen::MatrixXd::Zero(6, 3 * static_cast<long>(left.size()));
  for (std::size_t k = 0; k < left.size(); ++k) {
    const Eigen::Vector3d arm = lattice.centre[left[k]] - middle;
    Eigen::Matrix3d turn;
    turn << 0, -arm.z(), arm.y(), arm.z(), 0, -arm.x(), -arm.y(), arm.x(), 0;
    sums.block<3, 3>(0, 3 * static_cast<long>(k)).setIdentity();
    sums.block<3, 3>(3, 3 * static_cast<long>(k)) = turn / thickness;
  }
  Eigen::Matrix<double, 6, 1> wanted;
  wanted << 0, 0, 0, -moment / thickness;
  const Eigen::VectorXd share = sums.transpose() * (sums * sums.transpose()).ldlt().solve(wanted);
  for (std::size_t k = 0; k < left.size(); ++k)
    load[left[k]].head<3>() += share.segment<3>(3 * static_cast<long>(k));
  return load;
}

Bars measure() {
  const packing::Box box{length + 2 * margin, thickness + 2 * margin, thickness + 2 * margin};
  const packing::Packing packing = block_packing(box);
  const lattice::Lattice block = lattice_of(packing, box);
  lattice::FreeBody block_body(block);
  const packing::Box bar_box{length, thickness, thickness};
  const lattice::Lattice bar = lattice_of(cut(packing, bar_box), bar_box);
  lattice::FreeBody bar_body(bar);
  constexpr double shear = 1.0;
  const auto motion = bar_body.at_rest(cantilever_loads(bar, shear));
  const double inertia = std::pow(thickness, 4.0) / 12.0;
  // The right end's forces lie at their mean x; M at the middle is P times what lies between.
  double lever = 0.0, members = 0.0;
  for (const auto& p : bar.centre)
    if (p.x() > length - 1.5e-3) lever += p.x() - 0.5 * length, members += 1.0;
  return {pull(block, block_body, 0, 100.0).gauge_modulus, pull(bar, bar_body, 0, 100.0).gauge_modulus,
          shear * lever / members / (inertia * std::abs(curvature_at_middle(bar, motion)))};
}

TEST(BarCutFromABlock, MeetsBeamTheoryWithinItsSurface) {
  const Bars bars = measure();
  RecordProperty("block_gpa", std::to_string(bars.block_modulus / 1e9));
  RecordProperty("bar_gpa", std::to_string(bars.bar_modulus / 1e9));
  RecordProperty("cantilever_gpa", std::to_string(bars.curvature_modulus / 1e9));
  const double bar = bars.bar_modulus / bars.block_modulus,
               cantilever = bars.curvature_modulus / bars.block_modulus;
  EXPECT_GT(bar, 0.85);
  EXPECT_LT(bar, 1.0);
  EXPECT_NEAR(cantilever / (bar * bar), 1.0, 0.08);  // I of a square section goes with its area squared
}

}  // namespace
}  // namespace rift::calibration

#include "engine/calibration/pull.hpp"

#include "engine/lattice/statics.hpp"
#include "tests/engine/calibration/cubic_lattice.hpp"
#include "tests/engine/packing/packed_once.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <numbers>

namespace rift::calibration {
namespace {

using cubic_lattice::lattice_of;

double expected_modulus() {  // a chain of beams a column: E S / edge^2
  const double s = std::numbers::pi * cubic_lattice::section_radius * cubic_lattice::section_radius;
  return cubic_lattice::young * s / (cubic_lattice::edge * cubic_lattice::edge);
}

/// A cylinder of elements in no order at all.
lattice::Lattice random_cylinder() {
  const packing::Box box{10e-3, 20e-3, 10e-3, packing::Shape::cylinder};
  const packing::Packing packing = packing::packed_once(
      {.box = box, .elements = 500, .radius_spread = 0.125, .coordination = 6.0, .seed = 2});
  return lattice::make_lattice(packing::make_free_specimen(packing, box, 1.0), {356e9, 0.3, 0.3}, 1000.0);
}

TEST(Pull, OfACubicLatticeIsThatOfItsColumns) {
  const lattice::Lattice lattice = lattice_of({4, 8, 4}, packing::Shape::block);
  lattice::FreeBody body(lattice);
  for (const int axis : {0, 1, 2}) {
    const Pulled pulled = pull(lattice, body, axis, 5.0);
    EXPECT_NEAR(pulled.young_modulus / expected_modulus(), 1.0, 1e-6);
    EXPECT_NEAR(pulled.gauge_modulus / expected_modulus(), 1.0, 1e-6);
    EXPECT_LT(pulled.poisson_ratio.norm(), 1e-6);
  }
}

TEST(EndLoads, BalanceAndDoNotTurn) {
  const lattice::Lattice lattice = random_cylinder();
  const std::vector<lattice::Vector6> load = end_loads(lattice, 1, -7.0);
  Eigen::Vector3d force = Eigen::Vector3d::Zero(), moment = force, on_top = force, moment_on_top = force;
  ASSERT_FALSE(load.empty());
  for (std::size_t i = 0; i < load.size(); ++i) {
    const Eigen::Vector3d arm = lattice.centre[i] - 0.5 * lattice.box.size(), f = load[i].head<3>();
    force += f, moment += arm.cross(f);
    if (lattice.grip[i] == packing::Grip::top) on_top += f, moment_on_top += arm.cross(f);
    EXPECT_EQ(lattice.grip[i] == packing::Grip::none, f.isZero(0.0));
  }
  EXPECT_LT(force.norm(), 1e-12);
  EXPECT_LT(moment.norm(), 1e-14);
  EXPECT_LT((on_top - Eigen::Vector3d(0, -7.0, 0)).norm(), 1e-12);
  EXPECT_LT(moment_on_top.norm(), 1e-14);
}

TEST(EndLoads, NeedThreeElementsAnEnd) {
  lattice::Lattice lattice = lattice_of({2, 4, 1}, packing::Shape::block);
  EXPECT_THROW(end_loads(lattice, 1, 1.0), packing::PackingError);
}

TEST(FreeBody, LeavesEveryElementInBalance) {
  const lattice::Lattice lattice = random_cylinder();
  const std::vector<lattice::Vector6> load = end_loads(lattice, 1, -100.0);
  const std::vector<lattice::Vector6> q = lattice::FreeBody(lattice).at_rest(load);
  std::vector<lattice::Vector6> net = load;
  for (std::size_t b = 0; b < lattice.beam.size(); ++b) {
    const auto& [i, j] = lattice.ends[b];
    const lattice::BeamLoads l = lattice::loads_of(lattice.beam[b], q[i], q[j]);
    net[i].head<3>() += l.force_i, net[i].tail<3>() += l.moment_i;
    net[j].head<3>() -= l.force_i, net[j].tail<3>() += l.moment_j;
  }
  double worst = 0.0;
  for (const lattice::Vector6& f : net)
    worst = std::max(worst, std::max(f.head<3>().norm(), f.tail<3>().norm() / lattice.mean_radius));
  EXPECT_LT(worst,
            1e-7);  // of 100 N; the spring that ties the first element carries nothing, as of all others
}

TEST(GradientInMiddle, FindsALinearFieldUnderAnyRigidMotion) {
  const lattice::Lattice lattice = random_cylinder();
  Eigen::Matrix3d gradient;
  gradient << 1, 2, 3, 4, 5, 6, 7, 8, 9;
  std::vector<lattice::Vector6> q;
  for (const auto& p : lattice.centre) {
    q.emplace_back(lattice::Vector6::Zero());
    q.back().head<3>() = Eigen::Vector3d(0.1, -0.2, 0.3) + gradient * p;
  }
  EXPECT_LT((gradient_in_middle(lattice, q, 1) - gradient).norm(), 1e-9);
}

}  // namespace
}  // namespace rift::calibration

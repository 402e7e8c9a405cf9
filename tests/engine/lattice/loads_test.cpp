#include "engine/lattice/loads.hpp"

#include "tests/engine/packing/packed_once.hpp"

#include <gtest/gtest.h>

namespace rift::lattice {
namespace {

Lattice block() {
  const packing::Box box{16e-3, 10e-3, 6e-3, packing::Shape::block};
  const packing::Packing packing = packing::packed_once(
      {.box = box, .elements = 500, .radius_spread = 0.125, .coordination = 5.5, .seed = 2});
  return make_lattice(packing::make_free_specimen(packing, box, 1.0), {356e9, 0.3, 0.3}, 1000.0);
}

TEST(OppositeTractions, LoadEachFaceByItsAreaAndTurnNothing) {
  const Lattice lattice = block();
  for (const int axis : {0, 1, 2}) {
    const std::vector<Vector6> load = opposite_tractions(lattice, axis);
    Eigen::Vector3d force = Eigen::Vector3d::Zero(), moment = force, above = force;
    std::vector<int> beams(load.size(), 0);
    for (const auto& [i, j] : lattice.ends) ++beams[i], ++beams[j];
    double least_by_beams = 1e9;
    for (std::size_t i = 0; i < load.size(); ++i) {
      const Eigen::Vector3d arm = lattice.centre[i] - 0.5 * lattice.box.size(), f = load[i].head<3>();
      force += f, moment += arm.cross(f);
      if (arm[axis] > 0.0) above += f;
      if (f[axis] != 0.0) least_by_beams = std::min(least_by_beams, std::abs(f[axis]) / beams[i]);
    }
    const double area = lattice.box.section(axis);
    EXPECT_LT(force.norm(), 1e-12 * area);
    EXPECT_LT(moment.norm(), 1e-12 * area * lattice.box.length);
    EXPECT_NEAR(above[axis] / area, 1.0, 1e-12);
    EXPECT_GT(least_by_beams, 0.0);
  }
}

TEST(OppositeTractions, NeedThreeElementsAFace) {
  Lattice few = block();
  few.ends.resize(1), few.beam.resize(1);
  EXPECT_THROW(opposite_tractions(few, 1), packing::PackingError);
}

}  // namespace
}  // namespace rift::lattice

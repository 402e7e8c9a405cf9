#include "engine/lattice/loads.hpp"

#include <Eigen/Dense>
#include <fmt/format.h>

namespace rift::lattice {
namespace {

std::vector<double> beams_of_elements(const Lattice& lattice) {
  std::vector<double> beams(lattice.centre.size(), 0.0);
  for (const auto& [i, j] : lattice.ends) ++beams[i], ++beams[j];
  return beams;
}

/// Of all forces along the axis with this resultant, the least in the sum of force^2 / weight.
void load_face(std::vector<Vector6>& loads, const Lattice& lattice, const std::vector<int>& member,
               const std::vector<double>& weight, int axis, double force) {
  const int across[2] = {(axis + 1) % 3, (axis + 2) % 3};
  const Eigen::Vector3d middle = 0.5 * lattice.box.size();
  const auto basis = [&](int element) -> Eigen::Vector3d {
    const Eigen::Vector3d arm = (lattice.centre[element] - middle) / lattice.mean_radius;
    return {1.0, arm[across[0]], arm[across[1]]};
  };
  Eigen::Matrix3d sums = Eigen::Matrix3d::Zero();
  for (const int i : member) sums += weight[i] * basis(i) * basis(i).transpose();
  const Eigen::Vector3d multiplier = sums.ldlt().solve(Eigen::Vector3d(force, 0.0, 0.0));
  for (const int i : member) loads[i][axis] += weight[i] * basis(i).dot(multiplier);
}

}  // namespace

std::vector<Vector6> opposite_tractions(const Lattice& lattice, int axis) {
  const std::vector<double> weight = beams_of_elements(lattice);
  std::vector<Vector6> loads(lattice.centre.size(), Vector6::Zero());
  for (const int k : {0, 1}) {
    std::vector<int> member = packing::elements_at(lattice.box, packing::ends_of_axis(axis)[k],
                                                   lattice.centre, lattice.radius, traction_depth);
    std::erase_if(member, [&](int i) { return weight[i] == 0.0; });
    if (member.size() < 3)
      throw packing::PackingError(
          fmt::format("too few elements: {} at a face, at least 3 are needed", member.size()));
    load_face(loads, lattice, member, weight, axis, (k == 0 ? -1.0 : 1.0) * lattice.box.section(axis));
  }
  return loads;
}

}  // namespace rift::lattice

#include "engine/calibration/pull.hpp"

#include "engine/lattice/statics.hpp"

#include <Eigen/Dense>
#include <fmt/format.h>

namespace rift::calibration {
namespace {

/// The elements of one end.
struct End {
  std::vector<int> member;
  double mean(const std::vector<double>& of) const {
    double sum = 0.0;
    for (int i : member) sum += of[i];
    return sum / static_cast<double>(member.size());
  }
};

std::array<End, 2> ends_of(const lattice::Lattice& lattice, int axis) {
  std::array<End, 2> ends;
  for (int k = 0; k < 2; ++k)
    ends[k].member = packing::elements_at(lattice.box, packing::ends_of_axis(axis)[k], lattice.centre,
                                          lattice.radius, packing::grip_depth);
  for (const End& end : ends)
    if (end.member.size() < 3)
      throw packing::PackingError(
          fmt::format("too few elements: {} at an end, at least 3 are needed", end.member.size()));
  return ends;
}

/// Of all forces along the axis on the members with the resultant in the middle of the section, the most
/// even.
void load_end(std::vector<lattice::Vector6>& load, const lattice::Lattice& lattice, const End& end, int axis,
              double force) {
  const int across[2] = {(axis + 1) % 3, (axis + 2) % 3};
  const Eigen::Vector3d middle = 0.5 * lattice.box.size();
  Eigen::MatrixXd sums(3, end.member.size());  // force, and the two moments over the mean radius
  for (std::size_t k = 0; k < end.member.size(); ++k) {
    const Eigen::Vector3d arm = (lattice.centre[end.member[k]] - middle) / lattice.mean_radius;
    sums.col(static_cast<long>(k)) << 1.0, arm[across[0]], arm[across[1]];
  }
  const Eigen::Vector3d wanted(force, 0.0, 0.0);
  const Eigen::VectorXd share = sums.transpose() * (sums * sums.transpose()).ldlt().solve(wanted);
  for (std::size_t k = 0; k < end.member.size(); ++k)
    load[end.member[k]][axis] += share[static_cast<long>(k)];
}

}  // namespace

std::vector<lattice::Vector6> end_loads(const lattice::Lattice& lattice, int axis, double force) {
  const auto ends = ends_of(lattice, axis);
  std::vector<lattice::Vector6> load(lattice.centre.size(), lattice::Vector6::Zero());
  load_end(load, lattice, ends[0], axis, -force);
  load_end(load, lattice, ends[1], axis, force);
  return load;
}

Eigen::Matrix3d gradient_in_middle(const lattice::Lattice& lattice,
                                   const std::vector<lattice::Vector6>& motion, int axis) {
  const Eigen::Vector3d middle = 0.5 * lattice.box.size();
  const double reach = 0.25 * lattice.box.size()[axis];
  Eigen::Matrix4d normal = Eigen::Matrix4d::Zero();
  Eigen::Matrix<double, 4, 3> right = Eigen::Matrix<double, 4, 3>::Zero();
  for (std::size_t i = 0; i < motion.size(); ++i) {
    const Eigen::Vector3d d = lattice.centre[i] - middle;
    if (std::abs(d[axis]) > reach) continue;
    const Eigen::Vector4d basis(1.0, d.x() / reach, d.y() / reach, d.z() / reach);
    normal += basis * basis.transpose();
    right += basis * motion[i].head<3>().transpose();
  }
  const Eigen::Matrix<double, 4, 3> fit = normal.ldlt().solve(right);
  return fit.bottomRows<3>().transpose() / reach;
}

Pulled pull(const lattice::Lattice& lattice, lattice::FreeBody& body, int axis, double force,
            const base::ProgressCallback& told) {
  constexpr double tolerance = 1e-10;
  Pulled result;
  result.motion = body.at_rest(end_loads(lattice, axis, force), tolerance, told);
  const auto ends = ends_of(lattice, axis);
  std::vector<double> at, moved;
  for (std::size_t i = 0; i < result.motion.size(); ++i)
    at.push_back(lattice.centre[i][axis]), moved.push_back(result.motion[i][axis]);
  const double stress = force / lattice.box.section(axis);
  const double strain = (ends[1].mean(moved) - ends[0].mean(moved)) / (ends[1].mean(at) - ends[0].mean(at));
  const Eigen::Matrix3d gradient = gradient_in_middle(lattice, result.motion, axis);
  result.young_modulus = stress / strain;
  result.gauge_modulus = stress / gradient(axis, axis);
  for (int c = 0; c < 3; ++c)
    if (c != axis) result.poisson_ratio[c] = -gradient(c, c) / gradient(axis, axis);
  return result;
}

}  // namespace rift::calibration

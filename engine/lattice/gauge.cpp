#include "engine/lattice/gauge.hpp"

#include <Eigen/Dense>

namespace rift::lattice {

std::optional<LocalPlane> local_plane(const std::vector<Eigen::Vector2d>& at, const Eigen::Vector2d& middle,
                                      double radius) {
  constexpr std::size_t fewest = 6;
  constexpr double flattest = 0.05;  // of the spread across to that along
  LocalPlane plane;
  Eigen::Matrix3d normal = Eigen::Matrix3d::Zero();
  const auto row = [&](int i) -> Eigen::Vector3d {  // in radii, so that all three are of one size
    return {1.0, (at[i].x() - middle.x()) / radius, (at[i].y() - middle.y()) / radius};
  };
  for (int i = 0; i < static_cast<int>(at.size()); ++i) {
    if ((at[i] - middle).squaredNorm() > radius * radius) continue;
    plane.point.push_back(i);
    normal += row(i) * row(i).transpose();
  }
  if (plane.point.size() < fewest) return std::nullopt;
  const Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> modes(normal);
  if (modes.eigenvalues()[0] < flattest * flattest * modes.eigenvalues()[2]) return std::nullopt;
  const Eigen::Matrix3d inverse = normal.inverse();
  for (const int i : plane.point) {
    Eigen::Vector3d weight = inverse * row(i);
    weight.tail<2>() /= radius;
    plane.weight.push_back(weight);
  }
  return plane;
}

}  // namespace rift::lattice

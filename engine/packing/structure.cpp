#include "engine/packing/structure.hpp"

#include "engine/packing/neighbours.hpp"

#include <Eigen/Eigenvalues>

#include <algorithm>
#include <cmath>
#include <random>

namespace rift::packing {
namespace {

constexpr double farthest = 2.5, width = 0.05;  // of the classes, in mean diameters

/// Pairs by their distance, over all pairs that there are.
std::vector<double> share_of_pairs(const std::vector<Eigen::Vector3d>& points, const Box& box,
                                   double diameter) {
  std::vector<double> share(static_cast<std::size_t>(std::lround(farthest / width)));
  const std::vector<double> reach(points.size(), 0.5 * farthest * diameter);
  const auto pairs = box.shape == Shape::periodic ? pairs_through_faces(points, reach, box.size())
                                                  : pairs_within_reach(points, reach);
  const double n = static_cast<double>(points.size());
  for (const auto& [i, j] : pairs) {
    const auto k =
        static_cast<std::size_t>(minimum_image(box, points[i], points[j]).norm() / (width * diameter));
    if (k < share.size()) share[k] += 2.0 / (n * (n - 1.0));
  }
  return share;
}

/// Within the walls, at random.
std::vector<Eigen::Vector3d> points_at_random(const Box& box, std::size_t count) {
  std::mt19937_64 engine(20170601);
  const auto uniform = [&] { return static_cast<double>(engine() >> 11) * 0x1.0p-53; };
  std::vector<Eigen::Vector3d> points;
  while (points.size() < count) {
    const Eigen::Vector3d p(uniform() * box.length, uniform() * box.height, uniform() * box.thickness);
    if (contains(box, p)) points.push_back(p);
  }
  return points;
}

void add_pair_correlation(PackingStructure& s, const Packing& packing, const Box& box) {
  constexpr std::size_t fewest = 1000, most = 50'000, times = 8;
  double diameter = 0.0;
  for (double r : packing.radius) diameter += 2.0 * r / static_cast<double>(packing.radius.size());
  const auto points = points_at_random(box, std::clamp(times * packing.centre.size(), fewest, most));
  const std::vector<double> found = share_of_pairs(packing.centre, box, diameter),
                            random = share_of_pairs(points, box, diameter);
  for (std::size_t k = 0; k < found.size(); ++k) {
    s.distance.push_back((static_cast<double>(k) + 0.5) * width);
    s.pair_correlation.push_back(random[k] > 0.0 ? found[k] / random[k] : 0.0);
  }
}

}  // namespace

PackingStructure structure_of(const Packing& packing, const Box& box) {
  PackingStructure s;
  const auto touching = contacts(packing, box, 1.0);
  std::vector<int> degree(packing.radius.size());
  for (const auto& [i, j] : touching) {
    ++degree[i], ++degree[j];
    const Eigen::Vector3d n = minimum_image(box, packing.centre[i], packing.centre[j]).normalized();
    s.fabric += n * n.transpose() / static_cast<double>(touching.size());
  }
  s.coordination.resize(1 + *std::max_element(degree.begin(), degree.end()));
  for (int k : degree) ++s.coordination[k];
  const Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> axes(s.fabric, Eigen::EigenvaluesOnly);
  s.fabric_deviation = (axes.eigenvalues().array() - 1.0 / 3.0).abs().maxCoeff();
  add_pair_correlation(s, packing, box);
  return s;
}

}  // namespace rift::packing

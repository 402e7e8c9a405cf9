#include "engine/lattice/structure.hpp"

#include "engine/lattice/neighbours.hpp"

#include <Eigen/Eigenvalues>

#include <algorithm>
#include <cmath>
#include <random>

namespace rift {
namespace {

constexpr double farthest = 2.5, width = 0.05;  // of the classes, in mean diameters

/// Pairs by their distance, over all pairs that there are.
std::vector<double> share_of_pairs(const std::vector<Eigen::Vector3d>& points, const Box& box,
                                   double diameter) {
  std::vector<double> share(static_cast<std::size_t>(std::lround(farthest / width)));
  const std::vector<double> reach(points.size(), 0.5 * farthest * diameter);
  const auto pairs = box.walls == Walls::periodic ? pairs_through_faces(points, reach, box.size())
                                                  : pairs_within_reach(points, reach);
  const double n = static_cast<double>(points.size());
  for (const auto& [i, j] : pairs) {
    const auto k =
        static_cast<std::size_t>(way_between(box, points[i], points[j]).norm() / (width * diameter));
    if (k < share.size()) share[k] += 2.0 / (n * (n - 1.0));
  }
  return share;
}

/// Where the centres of spheres of this radius can lie, at random.
std::vector<Eigen::Vector3d> points_at_random(const Box& box, double radius, std::size_t count) {
  std::mt19937_64 engine(20170601);
  const auto uniform = [&] { return static_cast<double>(engine() >> 11) * 0x1.0p-53; };
  const double margin = box.walls == Walls::periodic ? 0.0 : radius;
  const Box inner{box.length - 2.0 * margin, box.height - 2.0 * margin, box.thickness - 2.0 * margin,
                  box.walls};
  std::vector<Eigen::Vector3d> points;
  while (points.size() < count) {
    const Eigen::Vector3d p(uniform() * inner.length, uniform() * inner.height, uniform() * inner.thickness);
    if (holds(inner, p)) points.push_back(p);
  }
  return points;
}

void add_pair_correlation(PackingStructure& s, const Packing& packing, const Box& box) {
  constexpr std::size_t fewest = 20'000, most = 50'000;
  double diameter = 0.0;
  for (double r : packing.radius) diameter += 2.0 * r / static_cast<double>(packing.radius.size());
  const auto points = points_at_random(box, 0.5 * diameter, std::clamp(packing.centre.size(), fewest, most));
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
    const Eigen::Vector3d n = way_between(box, packing.centre[i], packing.centre[j]).normalized();
    s.fabric += n * n.transpose() / static_cast<double>(touching.size());
  }
  s.coordination.resize(1 + *std::max_element(degree.begin(), degree.end()));
  for (int k : degree) ++s.coordination[k];
  const Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> axes(s.fabric, Eigen::EigenvaluesOnly);
  s.fabric_deviation = (axes.eigenvalues().array() - 1.0 / 3.0).abs().maxCoeff();
  add_pair_correlation(s, packing, box);
  return s;
}

}  // namespace rift

#include "engine/lattice/specimen.hpp"

#include <numeric>

namespace rift {
namespace {

Grip grip_of(const Eigen::Vector3d& centre, double radius, const Box& box) {
  if (centre.y() <= grip_depth * radius) return Grip::bottom;
  if (box.height - centre.y() <= grip_depth * radius) return Grip::top;
  return Grip::none;
}

/// Root of i's tree, halving the path on the way.
int root(std::vector<int>& parent, int i) {
  while (parent[i] != i) i = parent[i] = parent[parent[i]];
  return i;
}

}  // namespace

std::vector<char> reached_from(const std::vector<char>& anchor, const std::vector<std::array<int, 2>>& beam) {
  std::vector<int> parent(anchor.size());
  std::iota(parent.begin(), parent.end(), 0);
  for (const auto& [i, j] : beam) parent[root(parent, i)] = root(parent, j);
  std::vector<char> anchored(anchor.size(), 0), reached(anchor.size(), 0);
  for (int i = 0; i < static_cast<int>(anchor.size()); ++i)
    if (anchor[i]) anchored[root(parent, i)] = 1;
  for (int i = 0; i < static_cast<int>(anchor.size()); ++i) reached[i] = anchored[root(parent, i)];
  return reached;
}

Specimen make_plate(const Packing& packing, const Box& box, double contact_tolerance) {
  const auto beams = contacts(packing, contact_tolerance);
  const int n = static_cast<int>(packing.radius.size());
  std::vector<Grip> grip(n);
  std::vector<char> at_bottom(n), at_top(n);
  for (int i = 0; i < n; ++i) {
    grip[i] = grip_of(packing.centre[i], packing.radius[i], box);
    at_bottom[i] = grip[i] == Grip::bottom;
    at_top[i] = grip[i] == Grip::top;
  }
  const std::vector<char> from_bottom = reached_from(at_bottom, beams),
                          from_top = reached_from(at_top, beams);

  Specimen plate;
  plate.box = box;
  plate.packing = statistics(packing, box);
  std::vector<int> renumbered(n, -1);
  bool joined = false;
  for (int i = 0; i < n; ++i) {
    joined = joined || (from_bottom[i] && from_top[i]);
    if (!from_bottom[i] && !from_top[i]) {
      ++plate.rattlers;
      continue;
    }
    renumbered[i] = static_cast<int>(plate.centre.size());
    plate.centre.push_back(packing.centre[i]);
    plate.radius.push_back(packing.radius[i]);
    plate.grip.push_back(grip[i]);
  }
  if (!joined) throw PackingError("no path of beams joins the bottom grip to the top grip");
  for (const auto& [i, j] : beams)
    if (renumbered[i] >= 0) plate.beam.push_back({renumbered[i], renumbered[j]});
  return plate;
}

}  // namespace rift

#include "engine/stability/small_lattices.hpp"

#include <cmath>

namespace rift::stability {
namespace {

constexpr lattice::MicroMaterial micro{10e9, 0.3, 0.5};
constexpr double density = 1000.0;

/// @param[in] reach  beams join centres nearer than this many spacings
lattice::Lattice joined(packing::Specimen s, double reach, double cut_at) {
  const int n = static_cast<int>(s.centre.size());
  for (int i = 0; i < n; ++i)
    for (int j = i + 1; j < n; ++j) {
      const Eigen::Vector3d between = s.centre[j] - s.centre[i];
      if (between.norm() > reach * small_spacing) continue;
      if ((s.centre[i].y() < cut_at) != (s.centre[j].y() < cut_at)) continue;
      if (std::abs(between.z()) > 0.1 * small_spacing && between.norm() > 1.1 * small_spacing) continue;
      s.beam.push_back({i, j});
    }
  s.radius.assign(s.centre.size(), 0.5 * small_spacing);
  s.packing.mean_radius = 0.5 * small_spacing;
  return lattice::make_lattice(s, micro, density);
}

}  // namespace

lattice::Lattice small_chain(int elements) {
  packing::Specimen s;
  s.box = {.length = elements * small_spacing, .height = small_spacing, .thickness = small_spacing};
  for (int k = 0; k < elements; ++k)
    s.centre.emplace_back((k + 0.5) * small_spacing, 0.5 * small_spacing, 0.5 * small_spacing);
  s.grip.assign(s.centre.size(), packing::Grip::none);
  s.grip.front() = packing::Grip::bottom;
  return joined(std::move(s), 1.1, -1.0);
}

lattice::Lattice small_block(int nx, int ny, int nz, bool cut) {
  packing::Specimen s;
  s.box = {.length = nx * small_spacing, .height = ny * small_spacing, .thickness = nz * small_spacing};
  for (int x = 0; x < nx; ++x)
    for (int y = 0; y < ny; ++y)
      for (int z = 0; z < nz; ++z) {
        s.centre.emplace_back((x + 0.5) * small_spacing, (y + 0.5) * small_spacing,
                              (z + 0.5) * small_spacing);
        s.grip.push_back(y == 0        ? packing::Grip::bottom
                         : y == ny - 1 ? packing::Grip::top
                                       : packing::Grip::none);
      }
  const int rows_below_the_cut = ny / 2;
  return joined(std::move(s), 1.5, cut ? rows_below_the_cut * small_spacing : -1.0);
}

}  // namespace rift::stability

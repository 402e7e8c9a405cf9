#pragma once

#include <Eigen/Core>

#include <algorithm>
#include <array>
#include <vector>

namespace rift::packing {

/// Points in a box from 0 to `extent`, sorted into cells at least as wide as neighbours reach.
class Cells {
 public:
  /// No more cells than about eight a point, however thin the box.
  /// @param[in] place  of point i in [0, points), as Eigen::Vector3d; outside the box it counts to the
  /// outermost cells
  template <class Place>
  Cells(const Eigen::Vector3d& extent, double width, int points, const Place& place) {
    choose_counts(extent, width, points);
    std::vector<int> cell(points);
    for (int i = 0; i < points; ++i) {
      const Eigen::Vector3d p = place(i);
      cell[i] = index(at(p[0], 0), at(p[1], 1), at(p[2], 2));
    }
    sort(cell);
  }

  /// The points, cell by cell.
  const std::vector<int>& members() const { return member_; }

  /// Calls see(first, last) for runs [first, last) of members() that together are the points in the cells
  /// around a place, cell by cell; in a periodic box those beyond a face are those at its other end, none
  /// twice.
  template <bool periodic, class See>
  void visit_near(double px, double py, double pz, const See& see) const {
    const auto [x0, nx] = beside(at(px, 0), 0, periodic);
    const auto [y0, ny] = beside(at(py, 1), 1, periodic);
    const auto [z0, nz] = beside(at(pz, 2), 2, periodic);
    for (int x = x0; x < x0 + nx; ++x) {
      if (!periodic && nz == count_[2]) {  // a plate's cells follow each other along y
        see(first_[index(x, y0, 0)], first_[index(x, y0 + ny - 1, nz - 1) + 1]);
        continue;
      }
      for (int y = y0; y < y0 + ny; ++y) {
        if constexpr (periodic) {
          for (int z = z0; z < z0 + nz; ++z) {
            const int cell = index(wrapped(x, 0), wrapped(y, 1), wrapped(z, 2));
            see(first_[cell], first_[cell + 1]);
          }
        } else {
          see(first_[index(x, y, z0)], first_[index(x, y, z0 + nz - 1) + 1]);
        }
      }
    }
  }

 private:
  void choose_counts(const Eigen::Vector3d& extent, double width, int points);
  void sort(const std::vector<int>& cell);
  int at(double p, int axis) const {
    return std::clamp(static_cast<int>(p * per_unit_[axis]), 0, count_[axis] - 1);
  }
  int index(int x, int y, int z) const { return (x * count_[1] + y) * count_[2] + z; }
  /// The lowest of the cells beside `at` along an axis, and how many there are.
  std::array<int, 2> beside(int at, int axis, bool periodic) const {
    if (periodic && count_[axis] >= 3) return {at - 1, 3};
    const int lowest = std::max(0, at - 1);
    return {lowest, std::min(count_[axis] - 1, at + 1) - lowest + 1};
  }
  int wrapped(int at, int axis) const { return (at + count_[axis]) % count_[axis]; }

  std::array<int, 3> count_;
  std::array<double, 3> per_unit_;
  std::vector<int> first_, member_;  // of cell c: member_[first_[c]] to member_[first_[c + 1]], ascending
};

/// Pairs (i < j) of points no further apart than reach(i) + reach(j), ordered by i, then j; found by a cell
/// grid, O(N).
/// @param[in] points  N positions
/// @param[in] reach   N, the radius around each point (same unit)
std::vector<std::array<int, 2>> pairs_within_reach(const std::vector<Eigen::Vector3d>& points,
                                                   const std::vector<double>& reach);

/// The same in a periodic box [0, period], pairs through its faces counted too; each pair once, a period
/// being longer than twice what any pair reaches.
std::vector<std::array<int, 2>> pairs_through_faces(const std::vector<Eigen::Vector3d>& points,
                                                    const std::vector<double>& reach,
                                                    const Eigen::Vector3d& period);

/// An order of the points that keeps neighbours near: columns one `cell` wide along x, within a column along
/// y, then z.
std::vector<int> column_order(const std::vector<Eigen::Vector3d>& points, double cell);

}  // namespace rift::packing

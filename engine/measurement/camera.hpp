#pragma once

#include "engine/lattice/gauge.hpp"

#include <functional>
#include <limits>
#include <optional>
#include <vector>

namespace rift::measurement {

/// Where the crack's tip must be [m] for its faces to lie between two places; infinity where it never parts
/// them.
using PartedAt = std::function<double(const Eigen::Vector2d&, const Eigen::Vector2d&)>;

/// Displacements on a grid, as digital image correlation sees them: each point shows the best plane through
/// the motions of a subset, the elements in a circle around it that the crack has not parted from it.
class Camera {
 public:
  /// @param[in] at     N places of the elements [m]
  /// @param[in] point  of the grid [m]
  /// @param[in] radius of a subset [m]
  Camera(std::vector<Eigen::Vector2d> at, std::vector<Eigen::Vector2d> point, double radius,
         const PartedAt& parted_at);

  const std::vector<Eigen::Vector2d>& point() const { return point_; }

  /// What each point shows while the tip is at `tip` [m]; nothing where a subset has lost its hold.
  /// @param motion  of an element, by its number, as Eigen::Vector3d
  template <class Motion>
  std::vector<std::optional<lattice::PlaneMotion>> see(double tip, const Motion& motion) const {
    std::vector<std::optional<lattice::PlaneMotion>> seen;
    seen.reserve(point_.size());
    for (std::size_t p = 0; p < point_.size(); ++p) {
      const bool torn = tip >= subset_[p].first;
      const std::optional<lattice::LocalPlane> rest = torn ? held(p, tip) : std::nullopt;
      const std::optional<lattice::LocalPlane>& plane = torn ? rest : subset_[p].whole;
      seen.push_back(plane ? std::optional(lattice::motion_in(*plane, motion)) : std::nullopt);
    }
    return seen;
  }

 private:
  struct Subset {
    std::vector<int> element;
    std::vector<double> parted_at;                           // from the point, per element
    double first = std::numeric_limits<double>::infinity();  // of these
    std::optional<lattice::LocalPlane> whole;                // while nothing is parted
  };
  std::optional<lattice::LocalPlane> held(std::size_t p, double tip) const;

  std::vector<Eigen::Vector2d> at_, point_;
  double radius_;
  std::vector<Subset> subset_;  // per point
};

/// Points at equal distances, about `apart` [m], in the middles of equal cells of a plate.
struct Grid {
  int columns = 0, rows = 0;
  std::vector<Eigen::Vector2d> point;  // row by row from the bottom [m]
};
Grid grid_over(double length, double height, double apart);

}  // namespace rift::measurement

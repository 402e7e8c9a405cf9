#pragma once

#include <Eigen/Core>

#include <optional>
#include <vector>

namespace rift::fracture {

/// The beams that broke by themselves, as the crack that they make; whatever the order in which they are
/// added.
class GoneBeams {
 public:
  /// @param[in] reach  [m] within which other gone beams count as near
  explicit GoneBeams(double reach) : reach_(reach) {}

  /// @param[in] middle  of the beam [m]
  void add(const Eigen::Vector2d& middle);
  int count() const { return static_cast<int>(gone_.size()); }

  /// The largest x of a gone beam that has two others near it [m]: one alone may break anywhere.
  std::optional<double> leading() const { return leading_; }

 private:
  struct Gone {
    Eigen::Vector2d middle;
    int near;  // gone beams, itself among them
  };
  void look_at(const Gone& gone);

  double reach_;
  std::vector<Gone> gone_;
  std::optional<double> leading_;
};

}  // namespace rift::fracture

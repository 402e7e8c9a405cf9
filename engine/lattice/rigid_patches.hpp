#pragma once

#include "engine/lattice/block_cholesky.hpp"
#include "engine/lattice/blocks.hpp"
#include "engine/lattice/rows.hpp"

#include <Eigen/Core>

#include <vector>

namespace rift::lattice {

/// Elements joined by rows, in the unknowns (u, R theta): what the static solver and its preconditioner work
/// on.
template <class Row>
struct StaticRows {
  std::vector<Eigen::Vector3d> centre;  // n [m]
  double mean_radius = 0;               // R [m]
  std::vector<Row> row;                 // an end that is held has the number n
  Vector6 tie = Vector6::Zero();        // stiffness of springs from the first element to where it was
  std::vector<int> turning;             // elements that turn where they are, ascending
};

/// Preconditioner for the beam lattice: one block per element for the short waves, and the rigid motions of
/// patches a few elements wide, solved directly, for the long ones (two-level additive Schwarz, Dryja and
/// Widlund 1987):
///   M^-1 = D^-1 + P (P^T K P)^-1 P^T
/// P^T K P is added up row by row; K itself is nowhere stored.
class RigidPatches {
 public:
  /// @param[in] edge  of a patch [m]. Throws StaticsError where K is not positive definite.
  template <class Row>
  RigidPatches(const StaticRows<Row>& system, double edge);

  /// M^-1 r in its two parts: z = D^-1 r, and the motions of the patches, which advance() adds.
  /// @return r . M^-1 r
  double solve(Blocks& blocks, const Eigen::VectorXd& residual, Eigen::VectorXd& z);

  /// p = M^-1 r + keep p for the elements [begin, end), after solve().
  void advance(int begin, int end, const Eigen::VectorXd& z, double keep, Eigen::VectorXd& p) const;

 private:
  using Block = BlockCholesky::Block;
  void place(const std::vector<Eigen::Vector3d>& centre, double scale, double edge);
  void restrict_to(int patch, const Eigen::VectorXd& residual);
  /// Motion of an element [6] under the unit rigid motions of its patch.
  Block motions(int element) const;

  std::vector<int> patch_;            // of each element
  std::vector<Eigen::Vector3d> arm_;  // of each element: from the middle of its patch, over R
  std::vector<int> first_, member_;   // elements of patch k: member_[first_[k]] to member_[first_[k + 1]]
  std::vector<Block> inverse_block_;  // D^-1
  BlockCholesky coarse_;              // of P^T K P
  Eigen::VectorXd restricted_, solution_;  // P^T r and what it becomes, [patch][6]
};

}  // namespace rift::lattice

#pragma once

#include <Eigen/Core>

#include <map>
#include <utility>
#include <vector>

namespace rift::lattice {

/// A = L L^T of a sparse symmetric matrix of 6 x 6 blocks, its rows ordered for little fill (approximate
/// minimum degree). Cost that of the fill: of a plate of n blocks about n log n of them.
class BlockCholesky {
 public:
  using Block = Eigen::Matrix<double, 6, 6>;
  /// The blocks on and below the diagonal, by row and column.
  using LowerTriangle = std::map<std::pair<int, int>, Block>;

  /// Answers whether A is positive definite; solves only then.
  bool factorise(int rows, const LowerTriangle& a);

  /// x = A^-1 b. @param[in,out] x  b before, [row][6]
  void solve(Eigen::VectorXd& x);

  /// Blocks of L, those on the diagonal not counted.
  long blocks() const { return static_cast<long>(below_.size()); }

 private:
  void find_structure(const LowerTriangle& a);

  std::vector<int> place_;           // of each row in the order of elimination
  std::vector<int> row_at_;          // and back
  std::vector<int> first_, row_;     // of column j: rows row_[first_[j]] to row_[first_[j + 1]], ascending
  std::vector<Block> below_;         // likewise
  std::vector<Block> inverse_root_;  // of the diagonal's blocks: L_jj^-1
  Eigen::VectorXd permuted_;
};

}  // namespace rift::lattice

#include "engine/lattice/block_cholesky.hpp"

#include <Eigen/Cholesky>
#include <Eigen/OrderingMethods>
#include <Eigen/SparseCore>

#include <algorithm>
#include <iterator>

namespace rift::lattice {
namespace {

/// The rows in the order of elimination.
std::vector<int> order_of_little_fill(int rows, const BlockCholesky::LowerTriangle& a) {
  std::vector<Eigen::Triplet<double>> entries;
  for (const auto& [at, block] : a) {
    entries.emplace_back(at.first, at.second, 1.0);
    if (at.first != at.second) entries.emplace_back(at.second, at.first, 1.0);
  }
  Eigen::SparseMatrix<double> pattern(rows, rows);
  pattern.setFromTriplets(entries.begin(), entries.end());
  Eigen::PermutationMatrix<Eigen::Dynamic, Eigen::Dynamic, int> order;
  Eigen::AMDOrdering<int>()(pattern, order);
  return {order.indices().data(), order.indices().data() + rows};
}

}  // namespace

/// A column of L has the rows of A's and those of the columns that are eliminated into it, their first row
/// less.
void BlockCholesky::find_structure(const LowerTriangle& a) {
  const int n = static_cast<int>(row_at_.size());
  std::vector<std::vector<int>> column(n), children(n);
  for (const auto& [at, block] : a) {
    const auto [low, high] = std::minmax(place_[at.first], place_[at.second]);
    if (low != high) column[low].push_back(high);
  }
  first_.assign(1, 0);
  row_.clear();
  for (int j = 0; j < n; ++j) {
    std::vector<int>& rows = column[j];
    for (const int child : children[j])
      std::copy_if(row_.begin() + first_[child], row_.begin() + first_[child + 1], std::back_inserter(rows),
                   [&](int row) { return row != j; });
    std::sort(rows.begin(), rows.end());
    rows.erase(std::unique(rows.begin(), rows.end()), rows.end());
    if (!rows.empty()) children[rows.front()].push_back(j);
    row_.insert(row_.end(), rows.begin(), rows.end());
    first_.push_back(static_cast<int>(row_.size()));
    rows = {};
  }
}

bool BlockCholesky::factorise(int rows, const LowerTriangle& a) {
  row_at_ = order_of_little_fill(rows, a);
  place_.resize(rows);
  for (int k = 0; k < rows; ++k) place_[row_at_[k]] = k;
  find_structure(a);
  permuted_.resize(6L * rows);
  below_.assign(row_.size(), Block::Zero());
  inverse_root_.assign(rows, Block::Zero());

  // A stands where L will be; each column, once it is of L, is taken off those after it.
  std::vector<Block> diagonal(rows, Block::Zero());
  for (const auto& [at, block] : a) {
    const int i = place_[at.first], j = place_[at.second];
    if (i == j) {
      diagonal[i] = block;
      continue;
    }
    const auto begin = row_.begin() + first_[std::min(i, j)], end = row_.begin() + first_[std::min(i, j) + 1];
    below_[std::lower_bound(begin, end, std::max(i, j)) - row_.begin()] = i > j ? block : block.transpose();
  }
  for (int j = 0; j < rows; ++j) {
    const Eigen::LLT<Block> root(diagonal[j]);
    if (root.info() != Eigen::Success) return false;
    inverse_root_[j] = root.matrixL().solve(Block::Identity());
    for (int k = first_[j]; k < first_[j + 1]; ++k) below_[k] = below_[k] * inverse_root_[j].transpose();
    for (int k = first_[j]; k < first_[j + 1]; ++k) {
      const int column = row_[k];
      diagonal[column].noalias() -= below_[k] * below_[k].transpose();
      int to = first_[column];
      for (int below = k + 1; below < first_[j + 1]; ++below) {
        while (row_[to] != row_[below]) ++to;
        below_[to].noalias() -= below_[below] * below_[k].transpose();
      }
    }
  }
  return true;
}

void BlockCholesky::solve(Eigen::VectorXd& x) {
  const int n = static_cast<int>(row_at_.size());
  Eigen::VectorXd& y = permuted_;
  for (int k = 0; k < n; ++k) y.segment<6>(6L * k) = x.segment<6>(6L * row_at_[k]);
  for (int j = 0; j < n; ++j) {
    const Eigen::Matrix<double, 6, 1> own = inverse_root_[j] * y.segment<6>(6L * j);
    y.segment<6>(6L * j) = own;
    for (int k = first_[j]; k < first_[j + 1]; ++k) y.segment<6>(6L * row_[k]).noalias() -= below_[k] * own;
  }
  for (int j = n - 1; j >= 0; --j) {
    Eigen::Matrix<double, 6, 1> own = y.segment<6>(6L * j);
    for (int k = first_[j]; k < first_[j + 1]; ++k)
      own.noalias() -= below_[k].transpose() * y.segment<6>(6L * row_[k]);
    y.segment<6>(6L * j).noalias() = inverse_root_[j].transpose() * own;
  }
  for (int k = 0; k < n; ++k) x.segment<6>(6L * row_at_[k]) = y.segment<6>(6L * k);
}

}  // namespace rift::lattice

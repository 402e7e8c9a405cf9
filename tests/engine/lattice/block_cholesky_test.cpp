#include "engine/lattice/block_cholesky.hpp"

#include "tests/engine/lattice/dense.hpp"
#include "tests/engine/lattice/hand_made.hpp"

#include <gtest/gtest.h>

namespace rift::lattice {
namespace {

using Block = BlockCholesky::Block;

/// A symmetric matrix on a grid of so many blocks along and across, each joined to those beside it.
BlockCholesky::LowerTriangle grid(int along, int across, double diagonal) {
  hand_made::Draw draw(91);
  BlockCholesky::LowerTriangle a;
  const auto random_block = [&] {
    Block block;
    for (double& entry : block.reshaped()) entry = draw.between(-1.0, 1.0);
    return block;
  };
  for (int row = 0; row < along * across; ++row) {
    const Block block = random_block();
    a[{row, row}] = block + block.transpose() + diagonal * Block::Identity();
    if (row % across > 0) a[{row, row - 1}] = random_block();
    if (row >= across) a[{row, row - across}] = random_block();
  }
  return a;
}

Eigen::MatrixXd dense(const BlockCholesky::LowerTriangle& a, int rows) {
  Eigen::MatrixXd whole = Eigen::MatrixXd::Zero(6 * rows, 6 * rows);
  for (const auto& [at, block] : a) {
    whole.block<6, 6>(6 * at.first, 6 * at.second) = block;
    whole.block<6, 6>(6 * at.second, 6 * at.first) = block.transpose();
  }
  return whole;
}

TEST(BlockCholesky, AgreesWithDenseElimination) {
  for (const auto& [along, across] : {std::pair{1, 1}, {2, 1}, {7, 1}, {5, 6}}) {
    const int rows = along * across;
    const BlockCholesky::LowerTriangle a = grid(along, across, 30.0);
    BlockCholesky root;
    ASSERT_TRUE(root.factorise(rows, a));
    const Eigen::VectorXd b = hand_made::Draw(92).state(rows);
    Eigen::VectorXd x = b;
    root.solve(x);
    const Eigen::VectorXd expected = hand_made::solution_of(dense(a, rows), b);
    EXPECT_NEAR((x - expected).norm(), 0.0, 1e-13 * expected.norm()) << rows;
  }
}

TEST(BlockCholesky, SaysWhereAMatrixIsNotPositiveDefinite) {
  BlockCholesky root;
  EXPECT_TRUE(root.factorise(30, grid(5, 6, 30.0)));
  EXPECT_FALSE(root.factorise(30, grid(5, 6, 2.0)));
}

TEST(BlockCholesky, FillsInLittleMoreThanTheGrowthOfAGrid) {
  const auto fill = [](int edge) {
    BlockCholesky root;
    EXPECT_TRUE(root.factorise(edge * edge, grid(edge, edge, 30.0)));
    return static_cast<double>(root.blocks()) / (edge * edge);
  };
  // Columns of n log n grow by 1.6 (measured) where the grid grows twofold either way; those of a band by 2.
  EXPECT_GT(fill(16), 2.0);
  EXPECT_LT(fill(32) / fill(16), 1.8);
}

}  // namespace
}  // namespace rift::lattice

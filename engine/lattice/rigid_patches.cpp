#include "engine/lattice/rigid_patches.hpp"

#include "engine/lattice/statics.hpp"

#include <Eigen/Cholesky>

#include <array>
#include <cmath>
#include <map>

namespace rift::lattice {
namespace {

using Matrix9 = Eigen::Matrix<double, 9, 9>;
using Matrix9x6 = Eigen::Matrix<double, 9, 6>;

/// A row's stiffness over (u_j - u_i, theta_i, theta_j).
template <class Row>
Matrix9 stiffness_over_strains(const Row& row) {
  Matrix9 k;
  for (int c = 0; c < 9; ++c) {
    std::array<double, 6> i{}, j{};
    (c < 3 ? j[c] : c < 6 ? i[c] : j[c - 3]) = 1.0;
    const EndLoads l = end_loads(row, i.data(), j.data());
    k.col(c) << l.fx, l.fy, l.fz, -l.mix, -l.miy, -l.miz, -l.mjx, -l.mjy, -l.mjz;
  }
  return k;
}

/// What a motion of one end does to (u_j - u_i, theta_i, theta_j).
Matrix9x6 strains_of_i(const BlockCholesky::Block& motion) {
  Matrix9x6 strains = Matrix9x6::Zero();
  strains.topRows<3>() = -motion.topRows<3>();
  strains.middleRows<3>(3) = motion.bottomRows<3>();
  return strains;
}

Matrix9x6 strains_of_j(const BlockCholesky::Block& motion) {
  Matrix9x6 strains = Matrix9x6::Zero();
  strains.topRows<3>() = motion.topRows<3>();
  strains.bottomRows<3>() = motion.bottomRows<3>();
  return strains;
}

/// Adds the stiffness of one end, whose rotation is at `turn` among the strains and whose motion counts with
/// `sign`, to its element's block.
void add_to_diagonal(BlockCholesky::Block& block, const Matrix9& k, int turn, double sign) {
  block.topLeftCorner<3, 3>() += k.topLeftCorner<3, 3>();
  block.topRightCorner<3, 3>() += sign * k.block<3, 3>(0, turn);
  block.bottomLeftCorner<3, 3>() += sign * k.block<3, 3>(turn, 0);
  block.bottomRightCorner<3, 3>() += k.block<3, 3>(turn, turn);
}

/// Adds a^T k b to the block of two patches, on or below the diagonal.
void add_block(BlockCholesky::LowerTriangle& coarse, int of_a, int of_b, const Matrix9x6& a, const Matrix9& k,
               const Matrix9x6& b) {
  const BlockCholesky::Block block = a.transpose() * (k * b);
  const auto [at, is_new] =
      coarse.try_emplace({std::max(of_a, of_b), std::min(of_a, of_b)}, BlockCholesky::Block::Zero());
  at->second += of_a >= of_b ? block : block.transpose();
}

}  // namespace

void RigidPatches::place(const std::vector<Eigen::Vector3d>& centre, double scale, double edge) {
  std::map<std::array<long, 3>, std::vector<int>> patches;
  for (std::size_t i = 0; i < centre.size(); ++i) {
    const auto cell = [&](int c) { return static_cast<long>(std::floor(centre[i][c] / edge)); };
    patches[{cell(0), cell(1), cell(2)}].push_back(static_cast<int>(i));
  }
  patch_.resize(centre.size());
  arm_.resize(centre.size());
  first_.assign(1, 0);
  int patch = 0;
  for (const auto& [cell, members] : patches) {
    Eigen::Vector3d middle = Eigen::Vector3d::Zero();
    for (const int i : members) middle += centre[i] / static_cast<double>(members.size());
    for (const int i : members) patch_[i] = patch, arm_[i] = (centre[i] - middle) / scale;
    member_.insert(member_.end(), members.begin(), members.end());
    first_.push_back(static_cast<int>(member_.size()));
    ++patch;
  }
  restricted_.resize(6L * patch);
  solution_.resize(6L * patch);
}

/// u = U + Omega x d, R theta = R Omega, with Omega scaled by R as the unknowns are.
RigidPatches::Block RigidPatches::motions(int element) const {
  const Eigen::Vector3d& d = arm_[element];
  Block motion = Block::Identity();
  motion.topRightCorner<3, 3>() << 0.0, d.z(), -d.y(), -d.z(), 0.0, d.x(), d.y(), -d.x(), 0.0;
  return motion;
}

template <class Row>
RigidPatches::RigidPatches(const StaticRows<Row>& system, double edge) {
  place(system.centre, system.mean_radius, edge);
  const int n = static_cast<int>(system.centre.size());
  inverse_block_.assign(n, Block::Zero());
  BlockCholesky::LowerTriangle coarse;
  for (const Row& row : system.row) {
    const Matrix9 k = stiffness_over_strains(row);
    const bool i_moves = row.i < n, j_moves = row.j < n;
    if (i_moves) add_to_diagonal(inverse_block_[row.i], k, 3, -1.0);
    if (j_moves) add_to_diagonal(inverse_block_[row.j], k, 6, 1.0);
    Matrix9x6 of_i, of_j;
    if (i_moves) of_i = strains_of_i(motions(row.i));
    if (j_moves) of_j = strains_of_j(motions(row.j));
    if (i_moves && j_moves && patch_[row.i] == patch_[row.j]) {
      of_i += of_j;
      add_block(coarse, patch_[row.i], patch_[row.i], of_i, k, of_i);
      continue;
    }
    if (i_moves) add_block(coarse, patch_[row.i], patch_[row.i], of_i, k, of_i);
    if (j_moves) add_block(coarse, patch_[row.j], patch_[row.j], of_j, k, of_j);
    if (i_moves && j_moves) add_block(coarse, patch_[row.i], patch_[row.j], of_i, k, of_j);
  }
  const auto tie_to_its_place = [&](int element, const Vector6& springs) {
    const Block tie = springs.asDiagonal(), motion = motions(element);
    inverse_block_[element] += tie;
    coarse.at({patch_[element], patch_[element]}) += motion.transpose() * tie * motion;
  };
  tie_to_its_place(0, system.tie);
  // Elements that only turn: springs as stiff as their beams stand for what holds them, here alone.
  for (const int i : system.turning) {
    Vector6 springs = inverse_block_[i].diagonal();
    springs.tail<3>().setZero();
    tie_to_its_place(i, springs);
  }
  bool definite = coarse_.factorise(static_cast<int>(first_.size()) - 1, coarse);
  for (Block& block : inverse_block_) {
    const Eigen::LLT<Block> root(block);
    definite = definite && root.info() == Eigen::Success;
    block = root.solve(Block::Identity());
  }
  if (!definite) throw StaticsError("the lattice's stiffness is not positive definite");
}

void RigidPatches::restrict_to(int patch, const Eigen::VectorXd& residual) {
  Eigen::Vector3d force = Eigen::Vector3d::Zero(), moment = Eigen::Vector3d::Zero();
  for (int k = first_[patch]; k < first_[patch + 1]; ++k) {
    const int i = member_[k];
    const Eigen::Vector3d on = residual.segment<3>(6L * i);
    force += on;
    moment += arm_[i].cross(on) + residual.segment<3>(6L * i + 3);
  }
  restricted_.segment<6>(6L * patch) << force, moment;
}

double RigidPatches::solve(Blocks& blocks, const Eigen::VectorXd& residual, Eigen::VectorXd& z) {
  const auto patches = static_cast<long>(first_.size()) - 1;
  blocks.each_share([&](int s) {
    for (long k = patches * s / blocks.shares(); k < patches * (s + 1) / blocks.shares(); ++k)
      restrict_to(static_cast<int>(k), residual);
  });
  const auto solve_coarse = [&] {
    solution_ = restricted_;
    coarse_.solve(solution_);
  };
  const double short_waves = blocks.sum_beside(solve_coarse, [&](int begin, int end) {
    double sum = 0.0;
    for (int i = begin; i < end; ++i) {
      z.segment<6>(6L * i).noalias() = inverse_block_[i] * residual.segment<6>(6L * i);
      sum += z.segment<6>(6L * i).dot(residual.segment<6>(6L * i));
    }
    return sum;
  });
  return short_waves + restricted_.dot(solution_);
}

void RigidPatches::advance(int begin, int end, const Eigen::VectorXd& z, double keep,
                           Eigen::VectorXd& p) const {
  for (int i = begin; i < end; ++i) {
    const Eigen::Vector3d turn = solution_.segment<3>(6L * patch_[i] + 3);
    Vector6 motion;
    motion << solution_.segment<3>(6L * patch_[i]) + turn.cross(arm_[i]), turn;
    p.segment<6>(6L * i) = (z.segment<6>(6L * i) + motion) + keep * p.segment<6>(6L * i);
  }
}

template RigidPatches::RigidPatches(const StaticRows<BeamRow>&, double);
template RigidPatches::RigidPatches(const StaticRows<StiffnessRow>&, double);

}  // namespace rift::lattice

#include "engine/lattice/rigid_patches.hpp"

#include <Eigen/Dense>

#include <array>
#include <cmath>
#include <map>

namespace rift::lattice {
namespace {

using Triplets = std::vector<Eigen::Triplet<double>>;

/// One element's rows of P: u = U + Omega x d, R theta = R Omega, with Omega scaled by R as the unknowns are.
void add_rigid_motion(Triplets& entries, int element, int patch, const Eigen::Vector3d& d) {
  const int row = 6 * element, column = 6 * patch;
  for (int c = 0; c < 6; ++c) entries.emplace_back(row + c, column + c, 1.0);
  for (int c = 0; c < 3; ++c) {
    const int next = (c + 1) % 3, last = (c + 2) % 3;
    entries.emplace_back(row + c, column + 3 + next, d[last]);
    entries.emplace_back(row + c, column + 3 + last, -d[next]);
  }
}

}  // namespace

void RigidPatches::place(const std::vector<Eigen::Vector3d>& centre, double scale, double edge) {
  std::map<std::array<long, 3>, std::vector<int>> patches;
  for (std::size_t i = 0; i < centre.size(); ++i) {
    const auto cell = [&](int c) { return static_cast<long>(std::floor(centre[i][c] / edge)); };
    patches[{cell(0), cell(1), cell(2)}].push_back(static_cast<int>(i));
  }
  Triplets entries;
  int patch = 0;
  for (const auto& [cell, members] : patches) {
    Eigen::Vector3d middle = Eigen::Vector3d::Zero();
    for (int i : members) middle += centre[i] / static_cast<double>(members.size());
    for (int i : members) add_rigid_motion(entries, i, patch, (centre[i] - middle) / scale);
    ++patch;
  }
  motions_.resize(6 * static_cast<long>(centre.size()), 6 * patch);
  motions_.setFromTriplets(entries.begin(), entries.end());
}

RigidPatches& RigidPatches::factorize(const Matrix& k) {
  const long n = k.rows() / 6;
  inverse_block_.resize(n);
  for (long i = 0; i < n; ++i) {
    const Eigen::Matrix<double, 6, 6> block = k.block(6 * i, 6 * i, 6, 6);
    inverse_block_[i] = block.inverse();
  }
  const Matrix coarse = motions_.transpose() * k * motions_;
  coarse_.compute(coarse);
  info_ = coarse_.info();
  return *this;
}

Eigen::VectorXd RigidPatches::solve(const Eigen::VectorXd& residual) const {
  if (seen) seen(residual);
  const Eigen::VectorXd restricted = motions_.transpose() * residual;
  Eigen::VectorXd correction = motions_ * coarse_.solve(restricted);
  for (std::size_t i = 0; i < inverse_block_.size(); ++i) {
    const long at = 6 * static_cast<long>(i);
    correction.segment<6>(at) += inverse_block_[i] * residual.segment<6>(at);
  }
  return correction;
}

}  // namespace rift::lattice

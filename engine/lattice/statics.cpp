#include "engine/lattice/statics.hpp"

#include "engine/lattice/beam.hpp"
#include "engine/lattice/static_solver.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <numeric>

namespace rift::lattice {

/// Elements that may move, numbered in their order.
struct FreeElements {
  std::vector<int> number;  // of each element; `count` where held
  int count = 0;
  std::vector<int> turning;  // numbers of those that a grip lets turn and nothing else, ascending
  double radius = 0;         // R [m]: unknowns are u and R theta, which puts forces and moments on one scale

  bool is_held(std::size_t element) const { return number[element] == count; }
};

namespace {

/// Those that may move, without rows yet.
template <class Row>
StaticRows<Row> rows_over(const Lattice& lattice, const FreeElements& free) {
  StaticRows<Row> system;
  system.mean_radius = free.radius;
  system.turning = free.turning;
  for (std::size_t i = 0; i < lattice.centre.size(); ++i)
    if (!free.is_held(i)) system.centre.push_back(lattice.centre[i]);
  return system;
}

/// A beam between free elements, in their unknowns.
BeamRow scaled_row(const Lattice& lattice, int beam, const FreeElements& free) {
  BeamRow row = row_of(lattice, beam);
  row.i = free.number[row.i], row.j = free.number[row.j];
  row.bending /= free.radius * free.radius, row.twist /= free.radius * free.radius;
  row.per_length *= free.radius;
  return row;
}

/// The stiffness that a beam has at these poses, likewise.
StiffnessRow tangent_row(const Lattice& lattice, int beam, const FreeElements& free,
                         const std::vector<Pose>& pose) {
  const auto& [i, j] = lattice.ends[beam];
  const Matrix12 tangent = tangent_of(lattice.beam[beam], pose[i], pose[j]);
  const Matrix12 k =
      0.5 * (tangent + tangent.transpose());  // what is not symmetric of one beam cancels at equilibrium
  constexpr std::array<int, 9> at{6, 7, 8, 3, 4, 5, 9, 10, 11};  // u_j, theta_i, theta_j
  const auto scale = [&](int c) { return c < 3 ? 1.0 : 1.0 / free.radius; };
  StiffnessRow row{.i = free.number[i], .j = free.number[j], .k = {}};
  double* entry = row.k.data();
  for (int r = 0; r < 9; ++r)
    for (int c = 0; c <= r; ++c) *entry++ = scale(r) * scale(c) * k(at[r], at[c]);
  return row;
}

/// @param[in] force  N forces and moments [N, N m]
Eigen::VectorXd loads_on(const FreeElements& free, const std::vector<Vector6>& force) {
  Eigen::VectorXd load = Eigen::VectorXd::Zero(6L * free.count);
  for (std::size_t i = 0; i < force.size(); ++i) {
    if (free.is_held(i)) continue;
    load.segment<6>(6L * free.number[i]) = force[i];
    load.segment<3>(6L * free.number[i] + 3) /= free.radius;
  }
  for (const int k : free.turning) load.segment<3>(6L * k).setZero();
  return load;
}

/// Motions of all elements [m, rad], those that are held staying where they are.
std::vector<Vector6> motions_in(const FreeElements& free, const Eigen::VectorXd& unknown) {
  std::vector<Vector6> q(free.number.size(), Vector6::Zero());
  for (std::size_t i = 0; i < q.size(); ++i) {
    if (free.is_held(i)) continue;
    q[i] = unknown.segment<6>(6L * free.number[i]);
    q[i].tail<3>() /= free.radius;
  }
  return q;
}

FreeElements all_free(const Lattice& lattice) {
  FreeElements free{.number = std::vector<int>(lattice.centre.size()),
                    .count = static_cast<int>(lattice.centre.size()),
                    .turning = {},
                    .radius = lattice.mean_radius};
  std::iota(free.number.begin(), free.number.end(), 0);
  return free;
}

/// The whole lattice, its first element tied by springs as stiff as its beams.
StaticRows<BeamRow> tied(const Lattice& lattice, const FreeElements& free) {
  StaticRows<BeamRow> system = rows_over<BeamRow>(lattice, free);
  for (int b = 0; b < static_cast<int>(lattice.beam.size()); ++b)
    system.row.push_back(scaled_row(lattice, b, free));
  const bool turns = lattice.box.shape != packing::Shape::periodic;  // a lattice that repeats cannot turn
  for (int c = 0; c < (turns ? 6 : 3); ++c) {
    const Vector6 unit = Vector6::Unit(c), still = Vector6::Zero();
    Vector6 resisting = Vector6::Zero();
    for (const BeamRow& row : system.row) {
      if (row.i == 0) end_loads(row, unit.data(), still.data()).add_to_i(resisting.data());
      if (row.j == 0) end_loads(row, still.data(), unit.data()).add_to_j(resisting.data());
    }
    system.tie[c] = -resisting[c];
  }
  return system;
}

}  // namespace

struct FreeBody::Tied {
  FreeElements free;
  StaticSolver<BeamRow> solver;
  Tied(const Lattice& lattice, int threads) : free(all_free(lattice)), solver(tied(lattice, free), threads) {}
};

FreeBody::FreeBody(const Lattice& lattice, int threads) : tied_(std::make_unique<Tied>(lattice, threads)) {}

FreeBody::~FreeBody() = default;

std::vector<Vector6> FreeBody::at_rest(const std::vector<Vector6>& load, double tolerance,
                                       const base::ProgressCallback& told) {
  return motions_in(tied_->free, tied_->solver.solve(loads_on(tied_->free, load), tolerance, told));
}

namespace {

/// Those that no grip holds and that a path of beams joins to one, and the gripped ones that may turn.
FreeElements free_between_grips(const Lattice& lattice, const std::vector<char>& present) {
  std::vector<std::array<int, 2>> beams;
  std::vector<char> has_beam(lattice.grip.size(), 0);
  for (std::size_t b = 0; b < present.size(); ++b) {
    if (!present[b]) continue;
    beams.push_back(lattice.ends[b]);
    for (const int i : lattice.ends[b]) has_beam[i] = 1;
  }
  std::vector<char> held(lattice.grip.size());
  for (std::size_t i = 0; i < held.size(); ++i) held[i] = lattice.is_gripped(i);
  const std::vector<char> joined = packing::reached_from(held, beams);
  const auto turns = [&](std::size_t i) { return held[i] && has_beam[i] && !lattice.cannot_turn(i); };
  const auto moves = [&](std::size_t i) { return (!held[i] && joined[i]) || turns(i); };
  FreeElements free{
      .number = std::vector<int>(held.size()), .count = 0, .turning = {}, .radius = lattice.mean_radius};
  for (std::size_t i = 0; i < held.size(); ++i) free.count += moves(i);
  int next = 0;
  for (std::size_t i = 0; i < held.size(); ++i) {
    free.number[i] = moves(i) ? next++ : free.count;
    if (turns(i)) free.turning.push_back(free.number[i]);
  }
  return free;
}

/// Force and moment on each element from the beams that are there.
template <class State, class LoadsOf>
std::vector<Vector6> forces_on(const Lattice& lattice, const std::vector<char>& present,
                               const std::vector<State>& state, const LoadsOf& loads) {
  std::vector<Vector6> force(state.size(), Vector6::Zero());
  for (std::size_t b = 0; b < lattice.beam.size(); ++b) {
    if (!present[b]) continue;
    const auto& [i, j] = lattice.ends[b];
    const BeamLoads l = loads(lattice.beam[b], state[i], state[j]);
    force[i].head<3>() += l.force_i, force[i].tail<3>() += l.moment_i;
    force[j].head<3>() -= l.force_i, force[j].tail<3>() += l.moment_j;
  }
  return force;
}

/// The rows of the beams that are there and that move.
template <class RowOf>
auto moving_rows(const Lattice& lattice, const std::vector<char>& present, const FreeElements& free,
                 const RowOf& row_of) {
  auto system = rows_over<decltype(row_of(0))>(lattice, free);
  for (int b = 0; b < static_cast<int>(present.size()); ++b) {
    const auto& [i, j] = lattice.ends[b];
    if (present[b] && !(free.is_held(i) && free.is_held(j))) system.row.push_back(row_of(b));
  }
  return system;
}

/// The top grip moved, all else where it was.
std::vector<Vector6> gripped(const Lattice& lattice, const Pull& pull) {
  std::vector<Vector6> q(lattice.centre.size(), Vector6::Zero());
  for (std::size_t i = 0; i < q.size(); ++i)
    if (lattice.grip[i] == packing::Grip::top) {
      q[i][0] = pull.middle * pull.shear;
      q[i][1] = pull.at(lattice.centre[i].x() / lattice.box.length);
    }
  return q;
}

}  // namespace

std::vector<Vector6> stretched_at_rest(const Lattice& lattice, const std::vector<char>& present,
                                       const Pull& pull, const base::ProgressCallback& told, int threads) {
  std::vector<Vector6> q = gripped(lattice, pull);
  const FreeElements free = free_between_grips(lattice, present);
  if (free.count == 0) return q;
  const Eigen::VectorXd load =
      loads_on(free, forces_on(lattice, present, q, [](const Beam& beam, const Vector6& i, const Vector6& j) {
                 return loads_of(beam, i, j);
               }));
  StaticSolver<BeamRow> solver(
      moving_rows(lattice, present, free, [&](int b) { return scaled_row(lattice, b, free); }), threads);
  const std::vector<Vector6> moved = motions_in(free, solver.solve(load, 1e-13, told));
  for (std::size_t i = 0; i < q.size(); ++i)
    if (!free.is_held(i)) q[i] += moved[i];  // of what moves, only gripped elements have been moved before
  return q;
}

std::vector<Vector6> stretched_at_rest_corotational(const Lattice& lattice, const std::vector<char>& present,
                                                    const Pull& pull, const base::ProgressCallback& told,
                                                    int threads) {
  constexpr double inner_tolerance = 1e-5;
  constexpr int most_rounds = 20;
  constexpr double usual_rounds = 5.0;  // the linear solution among them
  int solved = 0;
  const base::ProgressCallback tell = [&](double done) {
    return !told || told(std::min(0.99, (solved + done) / usual_rounds));
  };
  // A beam's stretch is the difference of two lengths, rounded to some 1e-16 of them.
  const double strain = std::abs(pull.middle) * std::hypot(1.0, pull.shear) / lattice.box.height;
  const double balanced = std::max(1e-11, 1e-15 / strain);
  std::vector<Pose> pose;
  for (const Vector6& q : stretched_at_rest(lattice, present, pull, tell, threads))
    pose.push_back(pose_of(q));
  ++solved;
  const auto load_of = [](const Beam& beam, const Pose& i, const Pose& j) { return loads_of(beam, i, j); };
  const FreeElements free = free_between_grips(lattice, present);
  double scale = 0.0, unbalance = 0.0;
  for (int round = 0; round < most_rounds; ++round) {
    const std::vector<Vector6> force = forces_on(lattice, present, pose, load_of);
    const Eigen::VectorXd load = loads_on(free, force);
    unbalance = load.norm();
    if (round == 0)
      for (std::size_t i = 0; i < force.size(); ++i)
        if (lattice.is_gripped(i)) scale += force[i].head<3>().squaredNorm();
    if (unbalance <= balanced * std::sqrt(scale)) {
      std::vector<Vector6> q;
      q.reserve(pose.size());
      for (const Pose& p : pose) q.push_back(motion_of(p));
      return q;
    }
    StaticSolver<StiffnessRow> solver(
        moving_rows(lattice, present, free, [&](int b) { return tangent_row(lattice, b, free, pose); }),
        threads);
    const std::vector<Vector6> moves = motions_in(free, solver.solve(load, inner_tolerance, tell));
    ++solved;
    for (std::size_t i = 0; i < pose.size(); ++i) {
      if (free.is_held(i)) continue;
      const Pose moved = pose_of(moves[i]);
      pose[i].u += moved.u;
      pose[i].turn = (moved.turn * pose[i].turn).normalized();
    }
  }
  throw StaticsError(
      fmt::format("the corotational pre-stress did not converge in {} Newton steps: {:.3g} of the grips' "
                  "forces left, limit {:.3g}",
                  most_rounds, unbalance / std::sqrt(scale), balanced));
}

}  // namespace rift::lattice

#include "engine/lattice/statics.hpp"

#include "engine/lattice/corotational.hpp"
#include "engine/lattice/static_system.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>

namespace rift::lattice {
namespace {

std::vector<int> number_the_free(const Lattice& lattice, const std::vector<char>& present) {
  std::vector<std::array<int, 2>> beams;
  for (std::size_t b = 0; b < present.size(); ++b)
    if (present[b]) beams.push_back(lattice.ends[b]);
  std::vector<char> held(lattice.grip.size());
  for (std::size_t i = 0; i < held.size(); ++i) held[i] = lattice.grip[i] != packing::Grip::none;
  const std::vector<char> joined = packing::reached_from(held, beams);
  std::vector<int> number(held.size(), -1);
  int count = 0;
  for (std::size_t i = 0; i < held.size(); ++i)
    if (!held[i] && joined[i]) number[i] = count++;
  return number;
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
                                       const Pull& pull, const base::FractionTold& told) {
  std::vector<Vector6> q = gripped(lattice, pull);
  const StaticSystem system = assemble(lattice, number_the_free(lattice, present), present,
                                       [&](int b) { return stiffness_of(lattice.beam[b]); });
  if (system.centre.empty()) return q;
  const Eigen::VectorXd load = loads_on(
      system, forces_on(lattice, present, q, [](const Beam& beam, const Vector6& i, const Vector6& j) {
        return loads_of(beam, i, j);
      }));
  const std::vector<Vector6> moved = motions_in(system, StaticSolver(system).solve(load, 1e-13, told));
  for (std::size_t i = 0; i < q.size(); ++i)
    if (system.number[i] >= 0) q[i] = moved[i];
  return q;
}

std::vector<Vector6> stretched_at_rest_corotational(const Lattice& lattice, const std::vector<char>& present,
                                                    const Pull& pull, const base::FractionTold& told) {
  constexpr double inner_tolerance = 1e-5;
  constexpr int most_rounds = 20;
  constexpr double usual_rounds = 5.0;  // the linear solution among them
  int solved = 0;
  const base::FractionTold tell = [&](double done) {
    return !told || told(std::min(0.99, (solved + done) / usual_rounds));
  };
  // A beam's stretch is the difference of two lengths, rounded to some 1e-16 of them.
  const double strain = std::abs(pull.middle) * std::hypot(1.0, pull.shear) / lattice.box.height;
  const double balanced = std::max(1e-11, 1e-15 / strain);
  std::vector<Pose> pose;
  for (const Vector6& q : stretched_at_rest(lattice, present, pull, tell)) pose.push_back(pose_of(q));
  ++solved;
  const auto load_of = [](const Beam& beam, const Pose& i, const Pose& j) { return loads_of(beam, i, j); };
  const std::vector<int> number = number_the_free(lattice, present);
  double scale = 0.0, unbalance = 0.0;
  for (int round = 0; round < most_rounds; ++round) {
    const StaticSystem system = assemble(lattice, number, present, [&](int b) -> Matrix12 {
      const auto& [i, j] = lattice.ends[b];
      const Matrix12 k = tangent_of(lattice.beam[b], pose[i], pose[j]);
      return 0.5 * (k + k.transpose());  // what is not symmetric of one beam cancels at equilibrium
    });
    const std::vector<Vector6> force = forces_on(lattice, present, pose, load_of);
    const Eigen::VectorXd load = loads_on(system, force);
    unbalance = load.norm();
    if (round == 0)
      for (std::size_t i = 0; i < force.size(); ++i)
        if (system.number[i] < 0) scale += force[i].head<3>().squaredNorm();
    if (unbalance <= balanced * std::sqrt(scale)) {
      std::vector<Vector6> q;
      q.reserve(pose.size());
      for (const Pose& p : pose) q.push_back(motion_of(p));
      return q;
    }
    const std::vector<Vector6> moves =
        motions_in(system, StaticSolver(system).solve(load, inner_tolerance, tell));
    ++solved;
    for (std::size_t i = 0; i < pose.size(); ++i) {
      if (system.number[i] < 0) continue;
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

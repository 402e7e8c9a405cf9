#include "engine/simulation/march_run.hpp"

#include <fmt/format.h>

#include <cmath>

/// Whether what marches can be a plate that cracks.
namespace rift::simulation {
namespace {

/// No lattice can hold so many times the energy that was put into it. A stable step shows more than there is
/// by C, at most 1 / (1 - (dt / dt_c)^2) times of it, and only where all of it is in the highest mode.
constexpr double more_than_there_is = 1000.0;

}  // namespace

template <class Real>
void Run<Real>::read_books(Seat& seat) {
  LaneResult& lane = lane_of(seat);
  const results::Sample row = books(seat);
  lane.books.push_back(row);
  if (observer_.sample) observer_.sample(row);
  const double residual = std::abs(row.residual);
  if (!(residual <= lane.worst_residual)) lane.worst_residual = residual;
  judge(seat, row);
}

template <class Real>
std::string Run<Real>::what_is_wrong(const LaneResult& lane, const results::Sample& row) {
  const bool exact = scene().solver.kinematics == lattice::Kinematics::linear &&
                     scene().solver.precision == ensemble::Precision::double_precision;
  if (!(std::abs(row.residual) <= (exact ? 1e-6 : 0.1)))
    return fmt::format("the books are open by {:.3g} of the energy", row.residual);
  const double held = row.elastic_j + row.kinetic_translation_j + row.kinetic_rotation_j;
  const double put_in = lane.energy_at_crack_start + std::max(0.0, row.work_external_j);
  if (held > more_than_there_is * put_in && put_in > 0.0)
    return fmt::format("the lattice holds {:.3g} times the energy that was put into it", held / put_in);
  return "";
}

template <class Real>
void Run<Real>::judge(Seat& seat, const results::Sample& row) {
  LaneResult& lane = lane_of(seat);
  const std::string wrong = what_is_wrong(lane, row);
  if (wrong.empty()) {
    lane.sound_at = row.step;
    return;
  }
  lane.outcome = Outcome::diverged;
  lane.where = fmt::format("step {}{}: {}{}", row.step,
                           lane_.size() > 1 ? fmt::format(", lane {}", seat.scenario) : "", wrong,
                           where_it_diverges(index(seat)));
}

template <class Real>
void Run<Real>::watch() {
  for (Seat& seat : seat_) {
    if (seat.scenario < 0 || lane_of(seat).outcome != Outcome::finished) continue;
    if (const results::Sample row = books(seat); row.step != lane_of(seat).sound_at) judge(seat, row);
    if (lane_of(seat).outcome == Outcome::diverged) read_books(seat);  // the last row tells why
  }
}

template <class Real>
std::string Run<Real>::where_it_diverges(int lane) {
  int worst = 0;
  double most = -1.0;
  for (int i = 0; i < static_cast<int>(prepared_.lattice.centre.size()) && std::isfinite(most); ++i) {
    const lattice::Vector6 v = ensemble_.velocity(i, lane);
    const double energy = prepared_.lattice.mass[i] * v.head<3>().squaredNorm() +
                          prepared_.lattice.inertia[i] * v.tail<3>().squaredNorm();
    if (energy > most || !std::isfinite(energy)) most = energy, worst = i;
  }
  const bool lost = !std::isfinite(most);
  most = -1.0;
  int beam = -1;
  for (int b = 0; b < static_cast<int>(prepared_.lattice.beam.size()); ++b) {
    const auto& [i, j] = prepared_.lattice.ends[b];
    if (i != worst && j != worst) continue;
    const double energy = ensemble_.beam_energy(b, lane);
    if (!(energy <= most)) most = energy, beam = b;
  }
  return fmt::format(", {} element {}, and of its beams {} is strained most",
                     lost ? "lost first is" : "fastest is", worst, beam);
}

// What is defined here.
template void Run<double>::read_books(Seat&);
template void Run<float>::read_books(Seat&);
template void Run<double>::watch();
template void Run<float>::watch();

}  // namespace rift::simulation

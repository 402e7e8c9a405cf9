#include "engine/fracture/equation_of_motion.hpp"
#include "engine/scene/derived.hpp"
#include "engine/simulation/march_run.hpp"

#include <fmt/format.h>

#include <array>
#include <cmath>
#include <limits>
#include <stdexcept>

namespace rift::simulation {

// Whether what marches can be a plate that cracks.

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

// Cracks that run by themselves.

namespace {

/// New velocities over one window of the release rate.
constexpr double decisions_in_window = 6.0;
/// A tip that would be slower, in c_r, stops: its history would have no end.
constexpr double slowest = 0.01;
/// Lengths of the windows that must agree that the tip stops, in windows.
constexpr std::array<double, 3> windows_that_agree{1.0, 2.0, 4.0};
/// Standard errors by which G* must fall short of G_c for a stop while the longest window is not full.
constexpr double errors_beyond_doubt = 3.0;
/// Looks at the beams ahead of a resting tip in the time that a Rayleigh wave takes over a window.
constexpr std::int64_t looks_in_window = 32;

}  // namespace

template <class Real>
void Run<Real>::find_velocity(Seat& seat) {
  const LanePlan& lane = plan(seat);
  const scene::Scene::Crack& crack = lane.scene.crack;
  if (crack.toughness.row.empty() || !ensemble_.cracking() || ended(seat)) return;
  if (seat.rest.since >= 0) return await_restart(seat);
  const double window = toughness_window(seat);
  const double tip = ensemble_.tip(index(seat)), moved = ensemble_.speed(index(seat)) * ensemble_.dt();
  const auto decision = [&](double at) {
    return std::floor((at - crack.start) * decisions_in_window / window);
  };
  if (tip < runs_from(seat) + window || decision(tip) == decision(tip - moved)) return;
  if (const auto velocity = velocity_of(seat, tip))
    turn(seat, *velocity);
  else
    stop_tip(seat, tip);
}

/// By the shortest window that lets it run: a dip that a longer one does not show is noise.
template <class Real>
std::optional<double> Run<Real>::velocity_of(const Seat& seat, double tip) const {
  const double thickness = prepared_.scale.thickness * prepared_.path.tips, from = runs_from(seat);
  const fracture::CriticalRate toughness =
      fracture::in_window(lane_[seat.scenario].scene.crack.toughness, tip, toughness_window(seat));
  const double at_rest = fracture::critical_rate(toughness, 0.0, prepared_.rayleigh_speed, tip);
  bool beyond_doubt = false;
  for (const double windows : windows_that_agree) {
    const double window = windows * toughness_window(seat);
    if (tip < from + window) break;
    const std::vector<fracture::ReleasedBeam> beams = released(seat, tip - window);
    const double driving = fracture::driving_force(beams, tip, window, thickness);
    const double velocity = fracture::velocity_over_cr(driving, toughness, prepared_.rayleigh_speed, tip,
                                                       std::max(scene::fastest_by_itself, slowest));
    if (velocity >= slowest) return velocity;
    beyond_doubt =
        windows == windows_that_agree.back() ||
        driving + errors_beyond_doubt * fracture::driving_force_error(beams, tip, window, thickness) <
            at_rest;
  }
  return beyond_doubt ? std::nullopt : std::optional(slowest);
}

template <class Real>
void Run<Real>::turn(Seat& seat, double over_cr) {
  const std::string refused =
      make(seat, {seat.scenario, steps(seat), "crack_velocity", fmt::format("{} c_r", over_cr)});
  if (!refused.empty()) throw std::logic_error("a crack that runs by itself: " + refused);
}

template <class Real>
double Run<Real>::toughness_window(const Seat& seat) const {
  return lane_[seat.scenario].scene.crack.toughness_window * prepared_.lattice.mean_radius;
}

template <class Real>
double Run<Real>::runs_from(const Seat& seat) const {
  return std::max(lane_[seat.scenario].scene.crack.start, seat.rest.restarted_m);
}

template <class Real>
void Run<Real>::stop_tip(Seat& seat, double tip) {
  const double from = runs_from(seat);
  double window = toughness_window(seat);
  for (const double windows : windows_that_agree)
    if (tip >= from + windows * toughness_window(seat)) window = windows * toughness_window(seat);
  seat.rest = {.since = steps(seat),
               .driving = fracture::driving_force(released(seat, tip - window), tip, window,
                                                  prepared_.scale.thickness * prepared_.path.tips),
               .restarted_m = seat.rest.restarted_m};
  if (const std::string refused = make(seat, {seat.scenario, steps(seat), std::string(tip_stops), ""});
      !refused.empty())
    throw std::logic_error("a crack that runs by itself: " + refused);
  lane_of(seat).arrested_m = tip;
  if (lane_of(seat).books.empty() || lane_of(seat).books.back().step != steps(seat)) read_books(seat);
}

/// G* of the moment at which it stopped, times what the strain energy of the beams ahead has become: the
/// field around a resting tip scales with its K, and K^2 with G. The first window's time is left out, in
/// which the resting tip's field spreads over the beams [Freund 1990, section 7.4], the second one is the
/// reference.
template <class Real>
void Run<Real>::await_restart(Seat& seat) {
  Rest& rest = seat.rest;
  const LanePlan& lane = plan(seat);
  const double window = toughness_window(seat), tip = ensemble_.tip(index(seat));
  const double passing = window / (prepared_.rayleigh_speed * lane.units.time * ensemble_.dt());  // in steps
  const std::int64_t apart = std::max<std::int64_t>(1, static_cast<std::int64_t>(passing) / looks_in_window);
  const std::int64_t rested = steps(seat) - rest.since;
  if (rested % apart != 0 || rested < looks_in_window * apart) return;
  rest.sum += energy_ahead(seat, tip, window);
  if (++rest.looks < looks_in_window) return;
  const double energy = rest.sum / looks_in_window;
  rest.sum = 0.0, rest.looks = 0;
  if (rest.reference == 0.0) {
    rest.reference = energy;
    return;
  }
  const double velocity =
      fracture::velocity_over_cr(rest.driving * energy / rest.reference, lane.scene.crack.toughness,
                                 prepared_.rayleigh_speed, tip, std::max(scene::fastest_by_itself, slowest));
  if (velocity < slowest) return;
  read_books(seat);
  rest = {.restarted_m = tip};
  lane_of(seat).arrested_m = std::numeric_limits<double>::quiet_NaN();
  turn(seat, velocity);
}

template <class Real>
double Run<Real>::energy_ahead(const Seat& seat, double tip, double window) const {
  double energy = 0.0;
  for (const fracture::Crossing& c : ensemble_.met())
    if (c.position > tip && c.position <= tip + window) energy += ensemble_.beam_energy(c.beam, index(seat));
  return energy;
}

template <class Real>
std::vector<fracture::ReleasedBeam> Run<Real>::released(const Seat& seat, double from) const {
  const int lane = index(seat);
  const LanePlan& plan = lane_[seat.scenario];
  const history::CrackHistory& history = plan.scenario.history;
  const double tip = ensemble_.tip(lane), unit = prepared_.rayleigh_speed * plan.units.time;
  std::vector<fracture::ReleasedBeam> beams;
  const std::vector<fracture::Crossing>& met = ensemble_.met();
  for (int k = 0; k < static_cast<int>(met.size()) && met[k].position <= tip; ++k) {
    if (met[k].position <= from) continue;
    beams.push_back({met[k].position, ensemble_.booked(k, lane) * plan.units.energy,
                     history::speed_at(history, history::time_of_arrival(history, met[k].position)) / unit});
  }
  return beams;
}

template void Run<double>::find_velocity(Seat&);
template void Run<float>::find_velocity(Seat&);

}  // namespace rift::simulation

#include "engine/fracture/equation_of_motion.hpp"
#include "engine/scene/derived.hpp"
#include "engine/simulation/march_run.hpp"

#include <fmt/format.h>

#include <cmath>
#include <stdexcept>

/// Cracks that run by themselves.
namespace rift {
namespace {

/// New velocities over one window of the release rate.
constexpr double decisions_in_window = 6.0;
/// A tip that would be slower, in c_r, is taken for arrested: its history would have no end.
constexpr double slowest = 0.01;

}  // namespace

template <class Real>
void Run<Real>::find_velocity(Seat& seat) {
  const LanePlan& lane = plan(seat);
  const Scene::Crack& crack = lane.scene.crack;
  if (crack.toughness.row.empty() || !ensemble_.cracking() || ended(seat)) return;
  const double window = crack.toughness_window * prepared_.lattice.mean_radius;
  const double tip = ensemble_.tip(index(seat)), moved = ensemble_.speed(index(seat)) * ensemble_.dt();
  const auto decision = [&](double at) {
    return std::floor((at - crack.start) * decisions_in_window / window);
  };
  if (tip < crack.start + window || decision(tip) == decision(tip - moved)) return;
  const double driving = driving_force(released(seat, tip - window), tip, window,
                                       prepared_.scale.thickness * prepared_.path.tips);
  const double velocity =
      velocity_over_cr(driving, in_window(crack.toughness, tip, window), prepared_.rayleigh_speed, tip,
                       std::max(fastest_by_itself, slowest));
  if (velocity < slowest) return arrest(seat, tip);
  const std::string refused =
      make(seat, {seat.scenario, steps(seat), "crack_velocity", fmt::format("{} c_r", velocity)});
  if (!refused.empty()) throw std::logic_error("a crack that runs by itself: " + refused);
}

template <class Real>
std::vector<ReleasedBeam> Run<Real>::released(const Seat& seat, double from) const {
  const int lane = index(seat);
  const LanePlan& plan = lane_[seat.scenario];
  const CrackHistory& history = plan.scenario.history;
  const double tip = ensemble_.tip(lane), unit = prepared_.rayleigh_speed * plan.units.time;
  std::vector<ReleasedBeam> beams;
  const std::vector<Crossing>& met = ensemble_.met();
  for (int k = 0; k < static_cast<int>(met.size()) && met[k].position <= tip; ++k) {
    if (met[k].position <= from) continue;
    beams.push_back({met[k].position, ensemble_.booked(k, lane) * plan.units.energy,
                     speed_at(history, time_of_arrival(history, met[k].position)) / unit});
  }
  return beams;
}

template <class Real>
void Run<Real>::arrest(Seat& seat, double tip) {
  LanePlan& lane = plan(seat);
  const std::int64_t now = steps(seat);
  total_ += now - lane.schedule.total();
  lane.schedule.fracture = now - lane.schedule.crack_start();
  lane_of(seat).arrested_m = tip;
  if (lane_of(seat).books.empty() || lane_of(seat).books.back().step != now) read_books(seat);
  if (!lane.schedule.frames.empty()) tell_frame(seat);
}

template void Run<double>::find_velocity(Seat&);
template void Run<float>::find_velocity(Seat&);

}  // namespace rift

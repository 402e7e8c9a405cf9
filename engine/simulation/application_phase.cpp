#include "engine/simulation/application_phase.hpp"

#include "engine/fracture/equation_of_motion.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

namespace rift::simulation {
namespace {

/// New velocities over one window of the release rate.
constexpr double decisions_in_window = 6.0;
/// Lengths of the windows that must agree that the tip stops, in windows.
constexpr std::array<double, 3> windows_that_agree{1.0, 2.0, 4.0};
/// Standard errors by which G* must fall short of G_c for a stop while the longest window is not full.
constexpr double errors_beyond_doubt = 3.0;
/// Looks at the beams ahead of a resting tip in the time that a Rayleigh wave takes over a window.
constexpr std::int64_t looks_in_window = 32;

constexpr double fastest_tip = std::max(scene::fastest_by_itself, slowest_by_itself);

/// crack.start, or where the tip restarted last [m].
double runs_from(const OwnCrack& c) { return std::max(c.plan.scene.crack.start, c.rest.restarted_m); }

/// b of all tips that advance together [m].
double thickness_of(const OwnCrack& c) { return c.prepared.scale.thickness * c.prepared.path.tips; }

/// The beams that the tip has released from a position on [m].
std::vector<fracture::ReleasedBeam> released(const OwnCrack& c, double from) {
  const history::CrackHistory& history = c.plan.scenario.history;
  const double tip = c.tip(), unit = c.prepared.rayleigh_speed * c.plan.units.time;
  const std::vector<fracture::DamageableBeam>& beams = c.ensemble.damageable();
  std::vector<fracture::ReleasedBeam> released;
  for (int k = 0; k < static_cast<int>(beams.size()) && beams[k].position <= tip; ++k) {
    const double at = beams[k].position;
    if (at <= from) continue;
    released.push_back({at, c.ensemble.fracture_energy(k, c.lane),
                        history::speed_at(history, history::time_of_arrival(history, at)) / unit});
  }
  return released;
}

/// The strain energy that the beams of the path in a window ahead of the tip would have undamaged, of the
/// lattice [J].
double energy_ahead(const OwnCrack& c) {
  const double tip = c.tip();
  double energy = 0.0;
  for (const fracture::DamageableBeam& beam : c.ensemble.damageable())
    if (beam.position > tip && beam.position <= tip + c.window())
      energy += c.ensemble.beam_energy(beam.beam, c.lane);
  return energy;
}

}  // namespace

bool asks_for_velocity(const OwnCrack& c) {
  const double tip = c.tip(), moved = c.tips.speed(c.lane) * c.ensemble.dt();
  const auto decision = [&](double at) {
    return std::floor((at - c.plan.scene.crack.start) * decisions_in_window / c.window());
  };
  return tip >= runs_from(c) + c.window() && decision(tip) != decision(tip - moved);
}

std::optional<double> velocity_of(const OwnCrack& c) {
  const double thickness = thickness_of(c), from = runs_from(c), tip = c.tip();
  const double rayleigh_speed = c.prepared.rayleigh_speed;
  const fracture::CriticalRate toughness = fracture::in_window(c.plan.scene.crack.toughness, tip, c.window());
  const double at_rest = fracture::critical_rate(toughness, 0.0, rayleigh_speed, tip);
  bool beyond_doubt = false;
  for (const double windows : windows_that_agree) {
    const double window = windows * c.window();
    if (tip < from + window) break;
    const std::vector<fracture::ReleasedBeam> beams = released(c, tip - window);
    const double driving = fracture::driving_force(beams, tip, window, thickness);
    const double velocity = fracture::velocity_over_cr(driving, toughness, rayleigh_speed, tip, fastest_tip);
    if (velocity >= slowest_by_itself) return velocity;
    beyond_doubt =
        windows == windows_that_agree.back() ||
        driving + errors_beyond_doubt * fracture::driving_force_error(beams, tip, window, thickness) <
            at_rest;
  }
  return beyond_doubt ? std::nullopt : std::optional(slowest_by_itself);
}

double driving_at_stop(const OwnCrack& c) {
  const double tip = c.tip();
  double window = c.window();
  for (const double windows : windows_that_agree)
    if (tip >= runs_from(c) + windows * c.window()) window = windows * c.window();
  return fracture::driving_force(released(c, tip - window), tip, window, thickness_of(c));
}

/// G* of the moment at which it stopped, times what the strain energy of the beams ahead has become: the
/// field around a resting tip scales with its K, and K^2 with G. The first window's time is left out, in
/// which the resting tip's field spreads over the beams [Freund 1990, section 7.4], the second one is the
/// reference.
std::optional<double> restart_of(const OwnCrack& c, Rest& rest, std::int64_t rested) {
  const double passing =
      c.window() / (c.prepared.rayleigh_speed * c.plan.units.time * c.ensemble.dt());  // in steps
  const std::int64_t apart = std::max<std::int64_t>(1, static_cast<std::int64_t>(passing) / looks_in_window);
  if (rested % apart != 0 || rested < looks_in_window * apart) return std::nullopt;
  rest.sum += energy_ahead(c);
  if (++rest.looks < looks_in_window) return std::nullopt;
  const double energy = rest.sum / looks_in_window;
  rest.sum = 0.0, rest.looks = 0;
  if (rest.reference == 0.0) {
    rest.reference = energy;
    return std::nullopt;
  }
  const double velocity =
      fracture::velocity_over_cr(rest.driving * energy / rest.reference, c.plan.scene.crack.toughness,
                                 c.prepared.rayleigh_speed, c.tip(), fastest_tip);
  return velocity < slowest_by_itself ? std::nullopt : std::optional(velocity);
}

}  // namespace rift::simulation

#include "engine/simulation/lane_history.hpp"

#include "engine/scene/derived.hpp"

#include <limits>
#include <vector>

namespace rift::simulation {
namespace {

/// Speed over a zone's length from the start on, without the rest before it.
double speed_of_lead(const history::CrackHistory& course, double start, double zone) {
  constexpr double left = 0.01;  // of the zone: the tip has left
  const double from = history::time_of_arrival(course, start + left * zone),
               to = history::time_of_arrival(course, start + zone);
  return (1.0 - left) * zone / (to - from);
}

LaneHistory measured_history(const scene::Scene& scene, double zone, const LaneUnits& units) {
  const history::CrackHistory course = scene::measured_course(scene).history;
  LaneHistory lane;
  if (zone > 0.0) {
    const double speed = speed_of_lead(course, scene.crack.start, zone);
    lane.lead = zone / speed;
    lane.history.stretch.push_back({0.0, scene.crack.start - zone, speed * units.time});
  }
  for (const history::CrackStretch& s : course.stretch)
    lane.history.stretch.push_back({(lane.lead + s.time) / units.time, s.position, s.speed * units.time,
                                    s.acceleration * units.time * units.time});
  return lane;
}

}  // namespace

LaneHistory lane_history(const scene::Scene& scene, double zone, double rayleigh_speed,
                         const LaneUnits& units) {
  if (!scene.crack.history.empty()) return measured_history(scene, zone, units);
  std::vector<history::SpeedUntil> pieces;
  for (const scene::VelocityPiece& piece : scene.crack.velocity)
    pieces.push_back({scene::speed_m_s(piece.speed, rayleigh_speed) * units.time,
                      piece.until.value_or(std::numeric_limits<double>::infinity())});
  return {history::history_of(scene.crack.start - zone, pieces)};
}

}  // namespace rift::simulation

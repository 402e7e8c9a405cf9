#include "engine/measurement/intensity.hpp"

#include "engine/theory/wave_speeds.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

namespace rift::measurement {
namespace {

constexpr double off_edges = 0.9;  // of the way to the nearest edge: at it the expansion ends
constexpr double reach = 2.0;  // of the search, in what is left out beside the faces, beyond the damage zone
constexpr int terms = 6;       // of each mode: more explain no more in the plates tried

std::vector<results::Sample> of_fracture(const std::vector<results::Sample>& samples) {
  std::vector<results::Sample> rows;
  std::copy_if(samples.begin(), samples.end(), std::back_inserter(rows),
               [](const results::Sample& s) { return s.phase == results::Phase::fracture; });
  return rows;
}

double speed_at(const std::vector<results::Sample>& rows, double time) {
  const auto after = std::lower_bound(rows.begin(), rows.end(), time,
                                      [](const results::Sample& s, double t) { return s.time_s < t; });
  if (rows.empty()) return 0.0;
  return after == rows.end() ? rows.back().velocity_m_s : after->velocity_m_s;
}

}  // namespace

/// Where the tip is, along the crack and across it.
struct IntensityReading::Tip {
  double arc;
  Eigen::Vector2d at, along;
  Eigen::Vector2d turned(const Eigen::Vector2d& v) const {
    return {along.dot(v), along.x() * v.y() - along.y() * v.x()};
  }
};

IntensityReading::IntensityReading(fracture::CrackPath path, const Eigen::Vector2d& plate_size,
                                   const ElasticPlate& plate, double rayleigh, const Ring& ring,
                                   const std::vector<results::Sample>& samples,
                                   const fracture::RateScale& scale)
    : path_(std::move(path)),
      size_(plate_size),
      plate_(plate),
      ring_(ring),
      crack_(of_fracture(samples)),
      scale_(scale),
      rayleigh_(rayleigh),
      own_rayleigh_(
          plate.young_modulus > 0.0
              ? theory::wave_speeds(plate.young_modulus, plate.poisson_ratio, plate.density, plate.plane)
                    .rayleigh
              : rayleigh) {}

/// To the nearest edge, back to where the faces leave the line through the tip, and to the other tip.
IntensityReading::Clear IntensityReading::clear_around(const Tip& tip) const {
  const double leaves = 0.5 * ring_.beside_faces;
  Clear clear{off_edges * std::min({tip.at.x(), tip.at.y(), size_.x() - tip.at.x(), size_.y() - tip.at.y()}),
              NoFit::edge};
  const auto narrow = [&](double radius, NoFit what) {
    if (radius < clear.radius) clear = {radius, what};
  };
  double arc = 0.0;
  for (std::size_t k = 1; k < path_.point.size() && arc < tip.arc; ++k) {
    const Eigen::Vector2d from = tip.turned(path_.point[k - 1] - tip.at);
    arc += (path_.point[k] - path_.point[k - 1]).norm();
    const Eigen::Vector2d to = arc < tip.arc ? tip.turned(path_.point[k] - tip.at) : Eigen::Vector2d(0, 0);
    if (std::abs(from.y()) <= leaves) continue;
    const double part = std::max(0.0, (leaves - std::abs(to.y())) / (std::abs(from.y()) - std::abs(to.y())));
    narrow((to + std::min(part, 1.0) * (from - to)).norm(), NoFit::bend);
  }
  if (path_.tips == 2) narrow(off_edges * (2.0 * tip.arc - fracture::length_of(path_)), NoFit::other_tip);
  return clear;
}

void IntensityReading::fit(IntensityPoint& seen, const Tip& tip, const SeenField& field,
                           const std::vector<Eigen::Vector2d>& point) const {
  const Clear clear = clear_around(tip);
  seen.clear = clear.radius;
  if (seen.over_cr * rayleigh_ >= own_rayleigh_) return void(seen.why = NoFit::fast);
  if (clear.radius <= 1.5 * ring_.inner) return void(seen.why = clear.what);
  std::vector<Eigen::Vector2d> from_tip, moved;
  for (std::size_t p = 0; p < field.motion.size(); ++p) {
    if (!field.motion[p]) continue;
    from_tip.push_back(tip.turned(point[p] - tip.at));
    moved.push_back(tip.turned(field.motion[p]->u.head<2>()));
  }
  const double beside = reach * ring_.beside_faces;
  const NearTip near(plate_, seen.over_cr * rayleigh_);
  const IntensityFit ring{.inner = ring_.inner,
                          .outer = std::min(ring_.outer, clear.radius),
                          .beside_faces = ring_.beside_faces,
                          .terms = terms};
  if (!fit_intensity(near, from_tip, moved, ring)) return void(seen.why = NoFit::points);
  seen.k = locate_intensity(near, from_tip, moved, ring, {beside, beside + ring_.zone});
  if (!seen.k) seen.why = NoFit::tip;
}

IntensityPoint IntensityReading::at(const SeenField& field, const std::vector<Eigen::Vector2d>& point) const {
  const double arc = arc_of_tip(path_, field.tip);
  IntensityPoint seen{
      .time = field.time, .tip = field.tip, .over_cr = speed_at(crack_, field.time) / rayleigh_, .k = {}};
  seen.g_id = fracture::rate_around(crack_, field.tip, 2.0 * ring_.inner, scale_).ratio *
              (scale_.g_i0 + scale_.g_i0_slope * field.tip);
  const Eigen::Vector2d before = fracture::point_on(path_, arc - 0.5 * ring_.beside_faces),
                        at = fracture::point_on(path_, arc);
  fit(seen, {arc, at, (at - before).normalized()}, field, point);
  return seen;
}

const char* reason_of(NoFit why) {
  switch (why) {
    case NoFit::none:
      return "";
    case NoFit::edge:
      return "the ring is too near to an edge of the plate";
    case NoFit::bend:
      return "the ring is too near to a bend of the path";
    case NoFit::other_tip:
      return "the ring is too near to the other tip";
    case NoFit::fast:
      return "the tip is as fast as the surface wave";
    case NoFit::points:
      return "there are too few points in the ring";
    case NoFit::tip:
      return "the field has no tip near the crack's";
  }
  return "";
}

double arc_of_tip(const fracture::CrackPath& path, double tip) {
  return path.tips == 2 ? 0.5 * fracture::length_of(path) + tip : tip;
}

PartedAt parted_by(const fracture::CrackPath& path) {
  return
      [path, middle = 0.5 * fracture::length_of(path)](const Eigen::Vector2d& a, const Eigen::Vector2d& b) {
        const std::optional<double> arc = fracture::first_crossing(path, a, b);
        if (!arc) return std::numeric_limits<double>::infinity();
        return path.tips == 2 ? std::abs(*arc - middle) : *arc;
      };
}

}  // namespace rift::measurement

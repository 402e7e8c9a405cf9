#pragma once

#include "engine/fracture/crack_path.hpp"
#include "engine/fracture/release_rate.hpp"
#include "engine/measurement/camera.hpp"
#include "engine/measurement/near_tip.hpp"
#include "engine/results/schema.hpp"

#include <limits>
#include <optional>
#include <vector>

namespace rift::measurement {

/// What a camera sees of a plate at one moment.
struct SeenField {
  double time = 0, tip = 0;                                 // [s], [m]
  std::vector<std::optional<lattice::PlaneMotion>> motion;  // of each point
};

/// Why a moment has no stress intensities.
enum class NoFit { none, edge, bend, other_tip, fast, points, tip };

/// "the ring is too near to an edge of the plate", ...
const char* reason_of(NoFit why);

/// Stress intensities of one moment, and the release rate by the energy balance there.
struct IntensityPoint {
  double time = 0, tip = 0;          // [s], [m]
  double over_cr = 0;                // velocity of the tip
  std::optional<StressIntensity> k;  // nothing where no ring around the tip can be fitted
  NoFit why = NoFit::none;
  double clear = 0;  // [m] around the tip, before an edge, a bend or the other tip ends the expansion
  /// By the energy balance over twice the inner radius, damping with it as `rift experiment` reads it [J/m2].
  double g_id = std::numeric_limits<double>::quiet_NaN();
};

/// What is fitted around the tip, in the plate's lengths [m].
struct Ring {
  double inner = 0, outer = 0;
  double beside_faces = 0;  // what is nearer to the faces is left out: a subset there sees both
  double zone = 0;          // of damage, ahead of the tip
};

/// Fits the fields of one crack.
class IntensityReading {
 public:
  /// @param[in] rayleigh  that velocities are given over [m/s]: the material's, whatever the plate's own is
  /// @param[in] samples  of the lane, in time
  /// @param[in] scale  of the lane
  IntensityReading(fracture::CrackPath path, const Eigen::Vector2d& plate_size, const ElasticPlate& plate,
                   double rayleigh, const Ring& ring, const std::vector<results::Sample>& samples,
                   const fracture::RateScale& scale);

  /// The ring's outer radius is less where an edge of the plate, a bend of the path or the other tip is
  /// nearer.
  /// @param[in] point  where the field was seen [m]
  IntensityPoint at(const SeenField& field, const std::vector<Eigen::Vector2d>& point) const;

 private:
  struct Tip;
  /// Fits the point's k, or says why not.
  void fit(IntensityPoint& seen, const Tip& tip, const SeenField& field,
           const std::vector<Eigen::Vector2d>& point) const;
  struct Clear {
    double radius = 0;
    NoFit what = NoFit::none;  // that is nearest
  };
  Clear clear_around(const Tip& tip) const;

  fracture::CrackPath path_;
  Eigen::Vector2d size_;
  ElasticPlate plate_;
  Ring ring_;
  std::vector<results::Sample> crack_;  // of the fracture phase
  fracture::RateScale scale_;
  double rayleigh_;      // of the material
  double own_rayleigh_;  // of the plate
};

/// Arc length of the tip that is looked at: the only one, or of two the one that runs along the path.
double arc_of_tip(const fracture::CrackPath& path, double tip);

/// Where the tip is when the crack has parted two places.
PartedAt parted_by(const fracture::CrackPath& path);

}  // namespace rift::measurement

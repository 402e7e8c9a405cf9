#pragma once

#include "engine/fracture/crack_path.hpp"
#include "engine/fracture/release_rate.hpp"
#include "engine/measurement/camera.hpp"
#include "engine/measurement/stress_intensity.hpp"
#include "engine/results/schema.hpp"

#include <limits>
#include <optional>
#include <vector>

namespace rift {

/// What a camera sees of a plate at one moment.
struct SeenField {
  double time = 0, tip = 0;                        // [s], [m]
  std::vector<std::optional<PlaneMotion>> motion;  // of each point
};

/// Stress intensities of one moment, and what the lattice's books say there.
struct IntensityPoint {
  double time = 0, tip = 0;          // [s], [m]
  double over_cr = 0;                // velocity of the tip
  std::optional<StressIntensity> k;  // nothing where no ring around the tip can be fitted
  double g_id = std::numeric_limits<double>::quiet_NaN();  // of the books over twice the inner radius [J/m2]
};

/// What is fitted around the tip, in the plate's lengths [m].
struct Ring {
  double inner = 0, outer = 0;
  double beside_faces = 0;  // what is nearer to the faces is left out: a subset there sees both
  double zone = 0;          // of damage, behind the tip
};

/// Fits the fields of one crack.
class IntensityReading {
 public:
  /// @param[in] books  of the lane, in time
  /// @param[in] scale  of the lane
  IntensityReading(CrackPath path, const Eigen::Vector2d& plate_size, const ElasticPlate& plate,
                   const Ring& ring, const std::vector<results::Sample>& books, const RateScale& scale);

  /// The ring's outer radius is less where an edge of the plate or a bend of the path is nearer.
  /// @param[in] point  where the field was seen [m]
  IntensityPoint at(const SeenField& field, const std::vector<Eigen::Vector2d>& point) const;

 private:
  struct Tip;
  std::optional<StressIntensity> fit(const Tip& tip, double speed, const SeenField& field,
                                     const std::vector<Eigen::Vector2d>& point) const;
  double clear_around(const Tip& tip) const;

  CrackPath path_;
  Eigen::Vector2d size_;
  ElasticPlate plate_;
  Ring ring_;
  std::vector<results::Sample> crack_;  // books of the fracture phase
  RateScale scale_;
  double rayleigh_;
};

/// Arc length of the tip that is looked at: the only one, or of two the one that runs along the path.
double arc_of_tip(const CrackPath& path, double tip);

/// Where the tip is when the crack has parted two places.
PartedAt parted_by(const CrackPath& path);

}  // namespace rift

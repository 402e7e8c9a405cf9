#pragma once

#include "engine/base/cache.hpp"
#include "engine/calibration/cylinders.hpp"
#include "engine/calibration/homogenise.hpp"

namespace rift::calibration {

/// A periodic box that is homogenised with beams of unit modulus.
struct BoxTest {
  packing::PackingRequest packing;  // in a periodic box
  double contact_tolerance = 1;
  BeamShape beams;
};

struct BoxResult {
  packing::PackingRequest packing;
  double coordination = 0, solid_fraction = 0;
  Matrix6 stiffness;  // over E_mu
  Isotropic isotropic() const { return isotropic_part(stiffness); }
};

/// Homogenises all boxes; as press_cylinders() does it.
std::vector<BoxResult> homogenise_boxes(const std::vector<BoxTest>& tests, base::Cache& cache,
                                        const CalibrationProgress& progress = {}, int threads = 0);

}  // namespace rift::calibration

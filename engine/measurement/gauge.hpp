#pragma once

#include "engine/measurement/local_plane.hpp"

#include <array>

namespace rift::measurement {

/// A virtual strain gauge and velocity probe: what it shows is the best plane through the motions of the
/// elements under it, whatever their place through the thickness.
struct Gauge {
  std::array<double, 2> point{};  // [m]
  LocalPlane plane;
};

}  // namespace rift::measurement

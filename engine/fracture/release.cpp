#include "engine/fracture/release.hpp"

#include <cmath>

namespace rift::fracture {

double stiffness_left(const ReleaseLaw& law, double tip, double crossing) {
  if (tip >= crossing) return 0.0;
  const double ahead = crossing - tip;  // l - b
  if (law.technique == Technique::simple || ahead >= law.zone_length) return 1.0;
  return std::pow(ahead / law.zone_length, law.exponent);
}

}  // namespace rift::fracture

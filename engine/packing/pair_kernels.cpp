#include "engine/packing/pair_kernels.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

// Sanitizers cannot be in the function that chooses among the clones as the program is loaded.
#if defined(__x86_64__) && defined(__GNUC__) && !defined(__clang__) && !defined(__SANITIZE_ADDRESS__) && \
    !defined(__SANITIZE_THREAD__)
#define RIFT_FOR_EACH_INSTRUCTION_SET \
  __attribute__((target_clones("arch=x86-64-v4", "arch=x86-64-v3", "default")))
#else
#define RIFT_FOR_EACH_INSTRUCTION_SET
#endif

namespace rift::packing {

RIFT_FOR_EACH_INSTRUCTION_SET
void find_gaps(PairGroup& p, int count) {
  for (int k = 0; k < count; ++k) {
    const double squared = p.x[k] * p.x[k] + p.y[k] * p.y[k] + p.z[k] * p.z[k];
    p.squared[k] = squared;
    p.gap[k] = squared - p.reach[k] * p.reach[k];
  }
}

RIFT_FOR_EACH_INSTRUCTION_SET
void find_forces(ContactGroup& c, int count) {
  for (int k = 0; k < count; ++k) {
    const double distance = std::sqrt(std::max(c.squared[k], std::numeric_limits<double>::min()));
    const double overlap = c.reach[k] - distance, push = overlap / distance;
    c.overlap[k] = overlap;
    c.x[k] *= push, c.y[k] *= push, c.z[k] *= push;
  }
}

RIFT_FOR_EACH_INSTRUCTION_SET
void find_flat_pushes(const Box& box, double scale, const SpherePacking::Sphere* sphere, int count,
                      SpherePacking::Vector* force) {
  const double length = box.length, height = box.height, thickness = box.thickness;
  for (int k = 0; k < count; ++k) {
    const double radius = scale * sphere[k].shape;
    force[k].x = push_between(sphere[k].x, length, radius);
    force[k].y = push_between(sphere[k].y, height, radius);
    force[k].z = push_between(sphere[k].z, thickness, radius);
  }
}

}  // namespace rift::packing

#include "engine/fracture/face_contact.hpp"

#include <algorithm>
#include <cmath>

namespace rift {

FaceContact face_contact(const Beam& beam, const BeamStrain& strain, const Eigen::Vector3d& slip,
                         double friction) {
  FaceContact contact{std::min(strain.stretch, 0.0), strain.bend_i + strain.bend_j - slip};
  const double most = -friction * beam.axial * contact.shortening * beam.length / (3.0 * beam.bending);
  const double held = contact.sliding.norm();
  if (held > most) contact.sliding *= most / held;
  return contact;
}

double bilinear_energy(const Beam& beam, const FaceContact& a, const FaceContact& b) {
  return 0.5 * beam.axial * a.shortening * b.shortening + 0.75 * beam.bending * a.sliding.dot(b.sliding);
}

}  // namespace rift

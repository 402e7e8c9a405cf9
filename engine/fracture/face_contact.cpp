#include "engine/fracture/face_contact.hpp"

#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>

namespace rift::fracture {

double face_stiffness(const lattice::Beam& beam) { return 6.0 * beam.bending / (beam.length * beam.length); }

Eigen::Vector3d face_gap(const lattice::Beam& beam, const lattice::Vector6& q_i,
                         const lattice::Vector6& q_j) {
  const Eigen::Vector3d turned = q_i.tail<3>() + q_j.tail<3>();
  return q_j.head<3>() - q_i.head<3>() - 0.5 * beam.length * turned.cross(beam.axis);
}

Eigen::Vector3d face_gap(const lattice::Beam& beam, const lattice::Pose& i, const lattice::Pose& j) {
  const Eigen::Vector3d carried = i.turn * beam.axis + j.turn * beam.axis - 2.0 * beam.axis;
  return j.u - i.u - 0.5 * beam.length * carried;
}

FaceContact face_contact(const Eigen::Vector3d& gap, const Eigen::Vector3d& normal,
                         const Eigen::Vector3d& slip, double friction) {
  const double open = normal.dot(gap);
  FaceContact contact{std::min(open, 0.0), gap - open * normal - slip};
  const double most = -friction * contact.overlap, held = contact.sliding.norm();
  if (held > most) contact.sliding *= most / held;
  return contact;
}

double bilinear_energy(double stiffness, const FaceContact& a, const FaceContact& b) {
  return 0.5 * stiffness * (a.overlap * b.overlap + a.sliding.dot(b.sliding));
}

}  // namespace rift::fracture

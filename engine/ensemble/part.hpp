#pragma once

#include <cstdint>

namespace rift::ensemble {

/// Kernels compiled for several instruction sets see nothing but these plain rows and pointers.

/// The stiffness of a beam as the hot loop reads it   [physics.md §2]; `Real` is the precision of the state.
template <class Real>
struct BeamStiffness {
  Real axial;    // k_a [N/m]
  Real bending;  // w [N m]
  Real twist;    // k_t [N m]
};

/// What the linear closed form reads of a beam.
template <class Real>
struct LinearBeam {
  Real nx, ny, nz;
  Real two_per_length;  // 2 / l [1/m]
  BeamStiffness<Real> stiffness;
};

/// What the corotational form reads: the chord in the base state is l n + base, so that nothing is lost of a
/// small change of it.
template <class Real>
struct CorotationalBeam {
  Real nx, ny, nz;              // initial axis
  Real length;                  // l [m]
  Real base_x, base_y, base_z;  // u_j - u_i in the base state [m]
  BeamStiffness<Real> stiffness;
};

/// A sound beam in the order of its first element; that one is known from the place in the list.
template <class Form>
struct SoundRow {
  std::int32_t j;     // row of the second element's state
  std::int32_t slot;  // of its force in the ring
  Form form;
};

/// Four sound beams side by side, for one scenario alone.
inline constexpr int group_size = 4;
template <class Real, int Numbers>
struct BeamGroup {
  std::int32_t i[group_size], j[group_size];            // rows of state
  std::int32_t slot_i[group_size], slot_j[group_size];  // of the forces in the ring
  std::int32_t complete;                                // elements before this one have all their forces now
  Real number[Numbers][group_size];                     // the members of the form, in their order
};

/// A beam that the crack crosses.
template <class Real, class Form>
struct CrossingRow {
  std::int32_t k;                 // its place among the crossing beams
  std::int32_t i, j;              // rows of state
  std::int32_t extra_i, extra_j;  // rows of extra forces, -1 where the element is another part's
  Form form;
  Real base[9];  // force on i, moments on i and j in the base state; 0 where the form's loads are of all, not
                 // of the change
};

/// A crossing beam whose faces press on each other once it is gone   [fracture/face_contact.hpp].
template <class Real, class Form>
struct ContactRow {
  std::int32_t k, i, j, extra_i, extra_j;  // as of CrossingRow
  Form form;
  Real normal[2];  // of the faces, from i to j; none of it along z
  Real gap[3];     // in the base state, 0 where the form's is of all
};

/// A beam with viscous damping   [paper eq. (8)].
template <class Real>
struct DampedRow {
  std::int32_t i, j, extra_i, extra_j;
  std::int32_t crossing;    // its place among the crossing beams, or -1
  std::int32_t at_surface;  // 0 or 1
  Real nx, ny, nz;
  Real axial, twist, bend;  // at alpha = 1
};

/// Sums that are kept for each chunk of elements, so that they do not depend on who adds them up [J].
enum Account : int {
  elastic,
  kinetic_translation,
  kinetic_rotation,
  step_correction,
  contact_elastic,  // at a moment
  pending_damping,
  pending_numerical,
  pending_contact,
  pending_grip,  // of the step under way, at a moment
  spent_damping,
  spent_numerical,
  spent_contact,
  spent_grip,  // so far
  accounts
};

inline constexpr int chunk_size = 128;  // elements

/// The elements [begin, end) and all that bears on them, for one thread. Rows beyond the elements are copies
/// of other parts' elements, made before each step.
template <class Real>
struct PartView {
  std::int32_t begin, end;
  Real *q, *v, *rate;  // rows of state; rate may be null (then v is the rate)
  Real* ring;          // forces of elements under way, slot = element & mask
  std::int32_t mask;
  const Real* per_mass;     // [element][2]: 1/m, 1/I; 0 where gripped
  const double* mass;       // [element][2]: m, I
  const std::uint8_t* top;  // [element]: 1 where the moving grip holds it
  const double* base;       // [row][6 or 7] the base state, in double

  std::int32_t halo;  // beams from another part's element to one of this part; they come first
  const std::int32_t* halo_i;
  const std::int32_t* first;  // [own + 1] of the other beams, by their first element
  const void* beam;           // SoundRow
  std::int32_t groups;
  const void* group;  // BeamGroup

  std::int32_t specials;
  const std::int32_t* special;     // own elements with extra forces, ascending
  Real* extra;                     // [special][6][lane]
  Real *damping, *damping_before;  // [special][6][lane], null without damping
  std::int32_t crossings;
  const void* crossing;  // CrossingRow
  const Real* factor;    // [crossing][lane]
  std::int32_t contacts;
  const void* contact;                   // ContactRow
  Real *contact_force, *contact_before;  // [special][6][lane], null without contact
  const Real* slip;                      // [crossing][3][lane] as the forces of the step before left it
  Real* slip_after;                      // where this step's leave it; null where they are only weighed
  const Real *touches, *friction;        // [lane]: 1 where the lane's faces touch; mu
  std::int32_t damped;
  const DampedRow<Real>* damped_row;
  const Real *alpha_at_surface, *alpha_elsewhere;  // [lane]

  double* account;  // [chunk][accounts][lane], chunk 0 begins at `begin`
  double* speed;    // [element][6][lane], null or where to put the velocities of this moment
};

/// What a step needs to know beside the state.
struct StepConstants {
  double dt;
  double beta_before, beta_after;  // of the step that ends, and of the one that begins
  double grip_before, grip_after;  // speed of the top grip in them [m/s]
};

/// The kernels of one precision, lane count and kinematics.
template <class Real>
struct Kernel {
  void (*advance)(const PartView<Real>&, const StepConstants&) = nullptr;
  void (*advance_booked)(const PartView<Real>&,
                         const StepConstants&) = nullptr;  // with the books of every step
  void (*weigh)(const PartView<Real>&, const StepConstants&) = nullptr;
};

}  // namespace rift::ensemble

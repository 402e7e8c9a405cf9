#pragma once

#include <cstdint>

namespace rift::ensemble {

// Kernels compiled for several instruction sets see nothing but these plain rows and pointers. `Real` is the
// precision of the state; a `Beam` is what a form of the beam reads of one, LinearBeam or CorotationalBeam in
// some precision.

/// Stiffnesses of a beam   [model.md §2].
template <class Real>
struct BeamStiffness {
  Real axial;    // k_a [N/m]
  Real bending;  // w [N m]
  Real twist;    // k_t [N m]
};

/// What the linear closed form reads of a beam.
template <class Real>
struct LinearBeam {
  using Number = Real;
  static constexpr int position_numbers = 6;  // of an element: displacement [m], rotation [rad]
  Real nx, ny, nz;                            // axis
  Real two_per_length;                        // 2 / l [1/m]
  BeamStiffness<Real> stiffness;
};

/// What the corotational form reads of a beam: the chord in the base state is l n + base, so that nothing is
/// lost of a small change of it.
template <class Real>
struct CorotationalBeam {
  using Number = Real;
  static constexpr int position_numbers = 7;  // of an element: displacement [m], unit quaternion
  Real nx, ny, nz;                            // initial axis
  Real length;                                // l [m]
  Real base_x, base_y, base_z;                // u_j - u_i in the base state [m]
  BeamStiffness<Real> stiffness;
};

/// Numbers of a beam's form, in their order; the last three are its stiffnesses.
template <class Beam>
inline constexpr int beam_numbers = sizeof(Beam) / sizeof(typename Beam::Number);

/// An intact beam in the order of its first element; that one is known from the place in the list.
template <class Beam>
struct IntactRow {
  std::int32_t j;     // row of the second element's state
  std::int32_t slot;  // of its force in the ring
  Beam form;
};

/// The dampers of an intact beam at alpha = 1, along and about the axis of its form   [paper eq. (8)].
template <class Real>
struct Dampers {
  Real axial, twist, bend;
  std::int32_t at_surface;  // 0 or 1; below 0 where the beam is not damped
};

/// For one scenario alone intact beams go side by side, as many as the kernel says: what each of these arrays
/// holds of a group.
struct BeamGroup {
  static constexpr int i = 0, j = 1, slot_i = 2, slot_j = 3, rows = 4;  // rows of state; slots in the ring
  static constexpr int damper_slot_i = 0, damper_slot_j = 1, at_surface = 2, damper_rows = 3;
  static constexpr int damper_numbers = 3;  // axial, twist, bend
  static constexpr int ring_row = 8;        // numbers of a row of the rings, six of them used
};

/// Beams that the walk has found above their thresholds: bit k of `which` is lane k of the intact beam
/// `place`, or, for one scenario alone, beam k of the group `place`.
struct WatchedRow {
  std::int32_t place;
  std::uint32_t which;
};

/// A beam that can be damaged.
template <class Beam>
struct DamageableRow {
  std::int32_t k;                 // its place among the damageable beams
  std::int32_t i, j;              // rows of state
  std::int32_t extra_i, extra_j;  // rows of additional loads, -1 where the element is another part's
  Beam form;
  typename Beam::Number base[9];  // force on i, moments on i and j in the base state; 0 where the form's
                                  // loads are of all, not of the change
};

/// A damageable beam whose faces press on each other once it is gone   [fracture/face_contact.hpp].
template <class Beam>
struct ContactRow {
  std::int32_t k, i, j, extra_i, extra_j;  // as of DamageableRow
  Beam form;
  typename Beam::Number normal[2];  // of the faces, from i to j; none of it along z
  typename Beam::Number gap[3];     // in the base state, 0 where the form's is of all
};

/// A damageable beam with viscous damping   [paper eq. (8)].
template <class Real>
struct DampedRow {
  std::int32_t i, j, extra_i, extra_j;
  std::int32_t damageable;  // its place among the damageable beams
  std::int32_t at_surface;  // 0 or 1
  Real nx, ny, nz;
  Real axial, twist, bend;  // at alpha = 1
};

/// A force from outside on an element with additional loads, for a unit of the lane's load.
template <class Real>
struct LoadedRow {
  std::int32_t extra;
  Real load[6];  // [N, N m]
};

/// Energies that are summed for each chunk of elements, so that they do not depend on who adds them up [J].
enum Account : int {
  elastic,
  kinetic_translation,
  kinetic_rotation,
  step_correction,
  contact_elastic,  // now
  pending_damping,
  pending_numerical,
  pending_contact,
  pending_grip,  // of the step under way, now
  coming_grip,   // of that step and the next together, at this moment's force
  spent_damping,
  spent_numerical,
  spent_contact,
  spent_grip,  // so far
  accounts
};

inline constexpr int chunk_size = 128;  // elements

/// The elements [begin, end) and their loads, for one thread. Rows beyond the elements are copies of other
/// parts' elements, made before each step. What has a `next` is read from the one and written to the other:
/// the same where a step moves the elements, another where energies are evaluated.
template <class Real>
struct PartView {
  std::int32_t begin, end;
  const Real *q, *v, *rate;  // rows of state; rate may be null (then v is the rate)
  Real *next_q, *next_v, *next_rate;
  Real* mean_q;  // rows of state: the mean of the positions a step before and a step after; null if linear
  Real* ring;    // forces of elements under way, slot = element & mask
  std::int32_t mask;
  const Real* per_mass;     // [element][6]: 1/m, 1/I; 0 where a grip or a roller holds the component
  const double* mass;       // [element][2]: m [kg], I [kg m2]
  const std::uint8_t* top;  // [element]: 1 where the moving grip holds it
  const double* base;       // [row][6] the base state, in double

  std::int32_t extras;
  const std::int32_t* extra_element;  // own elements of damageable beams, ascending
  Real* extra;                        // [extra element][6][lane] loads of these beams
  Real* contact;                      // [extra element][6][lane] of their faces, null without contact
  const Real* contact_before;
  Real* next_contact_before;
  std::int32_t loaded_elements;
  const LoadedRow<Real>* loaded;
  const Real* load;                   // [lane] size of the load now
  const Real* factor;                 // [damageable][lane] what is left of the stiffness
  const Real* slip;                   // [damageable][3][lane] as the forces of the step before left it [m]
  Real* slip_after;                   // where this step's leave it
  const Real *in_contact, *friction;  // [lane]: 1 where the lane's faces touch; mu

  std::int32_t damped_elements;
  const std::int32_t* damped_element;  // own elements that dampers act on, ascending
  Real* damping_ring;                  // as `ring`, of intact beams' dampers
  const Dampers<Real>* dampers;        // [intact beam]
  const Real* damping_before;          // [damped element][6][lane] at the step before
  Real* next_damping_before;
  std::int32_t damped_beams;  // damageable ones
  const DampedRow<Real>* damped;
  Real* damping;                                   // [extra element][6][lane] of these, null without damping
  const Real *alpha_at_surface, *alpha_elsewhere;  // [lane]

  // Where beams break by themselves: the intact beams are those that are whole or softened.
  const Real* left;  // [intact beam][lane] what is left of the stiffness; unused in groups, whose numbers
                     // are of what is left
  const Real* watch_above;  // [intact beam][lane] or [group][beam]: energies of the change since the base
                            // state, above which the walk notes a beam [J]
  WatchedRow* watched;
  std::int32_t* watched_count;

  double* account;   // [chunk][accounts][lane], chunk 0 begins at `begin`
  double* velocity;  // [row][6][lane], where to put the velocities of this moment, or null
};

/// The part with its beams.
template <class Beam>
struct BeamView : PartView<typename Beam::Number> {
  std::int32_t halo;  // beams from another part's element to one of this part; they come first
  const std::int32_t* halo_i;
  const std::int32_t* first;  // [own + 1] of the other beams, by their first element
  const IntactRow<Beam>* intact;
  std::int32_t groups;
  const std::int32_t* group_rows;             // [group][BeamGroup::rows][beam]
  const std::int32_t* group_complete;         // [group]: elements before have all their forces now
  const typename Beam::Number* group_number;  // [group][number of the form][beam]
  const std::int32_t* group_dampers;          // [group]: its place in the two below, or -1; null without
  const std::int32_t* group_damper_rows;      // [damped group][BeamGroup::damper_rows][beam]
  const typename Beam::Number* group_damper_number;  // [damped group][BeamGroup::damper_numbers][beam]
  std::int32_t damageable_beams;
  const DamageableRow<Beam>* damageable;
  std::int32_t softened_beams;  // of them, where beams break by themselves under a strained base state
  const std::int32_t* softened;
  std::int32_t contacts;
  const ContactRow<Beam>* contact_row;
};

/// What a step needs to know beside the state.
struct StepConstants {
  double dt;                       // [s]
  double beta_before, beta_after;  // of eq. (2), of the step that ends and of the one that begins
  double grip_before, grip_after;  // speed of the top grip in them [m/s]
  /// With the accounts of the step, where something dissipates or the grip moves: the two halves of eq. (2)
  /// one by one.
  bool balanced = false;
  bool operator==(const StepConstants&) const = default;
};

/// The kernels of one form of the beam and lane count.
template <class Beam>
struct Kernel {
  using Function = void (*)(const BeamView<Beam>&, const StepConstants&);
  Function advance = nullptr;
  Function advance_with_balance = nullptr;  // with the accounts of the step
  /// With all energies of this moment; moves the elements to the other rows of state.
  Function evaluate_energies = nullptr;
  // Of corotational beams alone, null for linear ones:
  Function find_means = nullptr;  // fills mean_q of the part's elements, before the three above
  Function add_beam_energies =
      nullptr;         // adds what the beams hold to the energies of this moment, after them
  int group_size = 0;  // beams that go side by side where there is one lane
};

}  // namespace rift::ensemble

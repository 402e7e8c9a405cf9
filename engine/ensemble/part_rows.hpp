#pragma once

#include "engine/ensemble/numbers.hpp"
#include "engine/ensemble/part.hpp"
#include "engine/fracture/crack_path.hpp"
#include "engine/lattice/forces.hpp"

#include <memory>
#include <vector>

namespace rift::ensemble {

/// Arrays of all lanes, [row][component][lane], that the kernels of every part work on.
struct StateArrays {
  explicit StateArrays(Precision p)
      : q(p),
        v(p),
        rate(p),
        next_q(p),
        next_v(p),
        next_rate(p),
        mean_q(p),
        per_mass(p),
        factor(p),
        alpha_at_surface(p),
        alpha_elsewhere(p),
        in_contact(p),
        friction(p),
        load(p),
        slip(p),
        slip_after(p) {}
  Numbers q, v, rate, next_q, next_v, next_rate, mean_q;  // as of PartView
  AlignedVector<double> velocity;                         // of this moment, as of PartView
  Numbers per_mass, factor, alpha_at_surface, alpha_elsewhere, in_contact, friction, load;
  Numbers slip, slip_after;
  AlignedVector<double> mass, base;
  std::vector<std::uint8_t> top;
};

/// How an ensemble marches; none of it changes what comes out, but for the kinematics, the precision and the
/// last bits.
struct EnsembleOptions {
  lattice::Kinematics kinematics = lattice::Kinematics::linear;
  Precision precision = Precision::double_precision;
  int threads = 1;
  InstructionSet instructions = instruction_set();
  int lanes = 0;         // of the kernel; 0 for the fewest that hold the scenarios
  bool contact = false;  // whether any scenario's faces touch, now or later
  /// Whether the damageable beams break by themselves (an ensemble sees that from its scenarios): the walk
  /// has them among the intact ones then, with what is left of each. Linear kinematics, without contact and
  /// dampers.
  bool breaking = false;
};

/// Numbers beyond the last row of state that a kernel may read (columns_of()).
inline constexpr std::size_t row_padding = 2;

/// What the rows of all parts are made from.
struct RowSource {
  const lattice::Lattice& lattice;
  const EnsembleOptions& options;
  int lanes;                                  // of the kernel
  const std::vector<lattice::Vector6>& base;  // N, the base state
  const std::vector<fracture::DamageableBeam>& damageable;
  const std::vector<lattice::DampedBeam>& damped;
  const std::vector<lattice::Vector6>& outside;  // N forces and moments for a unit of load, or none
};

/// First elements of `parts` ranges with about equally many beams, and N; all but the last multiples of
/// chunk_size, so that sums by chunks do not depend on them. Fewer parts where there are fewer chunks.
std::vector<int> cut_evenly(const lattice::Lattice& lattice, int parts);

/// The rows that one thread works on, with the kernels that walk them, whatever the form of the beam and the
/// precision.
struct Part {
  explicit Part(Precision p)
      : damping_before(p), contact_before(p), next_damping_before(p), next_contact_before(p) {}
  Part(const Part&) = delete;
  virtual ~Part() = default;
  /// Finds mean_q of its elements; does nothing in linear kinematics.
  virtual void find_means(StateArrays& state, const StepConstants& constants) = 0;
  virtual void advance(StateArrays& state, const StepConstants& constants) = 0;
  /// Evaluates the accounts of this moment and moves the elements to the other rows of state.
  /// @param[out] velocities  of this moment, [element][6][lane], may be null
  virtual void evaluate_energies(StateArrays& state, const StepConstants& constants, double* velocities) = 0;
  /// Adds to these accounts what the beams hold, by the velocities of this moment (StateArrays); does nothing
  /// in linear kinematics, where evaluate_energies() has done so.
  virtual void add_beam_energies(StateArrays& state, const StepConstants& constants) = 0;
  /// Where beams break by themselves: what is left of one in a lane, and the energy of its change since the
  /// base state above which the walk notes it from now on [J]. @param[in] k  its place among the damageable
  /// beams, whoever owns its elements
  virtual void set_left(int k, int lane, double left, double watch_above) = 0;
  /// Appends the beams of a lane that the walk has noted last, as places among the damageable beams.
  virtual void add_watched(int lane, std::vector<int>& k) const = 0;

  std::vector<int> ghost;  // elements of other parts that it refers to, in the order of their copies' rows
  int first_ghost_row = 0;
  std::vector<std::int32_t> extra_element, damped_element;
  Numbers damping_before, contact_before, next_damping_before, next_contact_before;
  AlignedVector<double> account;
};

/// The part that owns the elements [begin, end).
/// @param[in] first_ghost_row  where its copies of others begin
std::unique_ptr<Part> make_part(const RowSource& source, int begin, int end, int first_ghost_row);

}  // namespace rift::ensemble

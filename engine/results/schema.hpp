#pragma once

#include <array>
#include <cstdint>
#include <string>
#include <vector>

/// What a run leaves behind, as plain data. Everything here is SI and knows nothing of how it was computed.
namespace rift::results {

enum class Phase : std::uint8_t { loading, hold, fracture };

/// One lane's energies at one step; energies and works in J since the start of the run.
struct Sample {
  std::int64_t step = 0;
  double time_s = 0;
  Phase phase = Phase::fracture;
  std::int32_t lane = 0;
  double tip_m = 0;
  double velocity_m_s = 0;  // of the tip
  double elastic_j = 0;
  double kinetic_translation_j = 0;
  double kinetic_rotation_j = 0;
  double step_correction_j = 0;
  double fracture_j = 0;
  double damping_j = 0;
  double numerical_damping_j = 0;
  double work_external_j = 0;
  double residual = 0;      // relative to the largest lattice energy so far
  double contact_j = 0;     // by friction of the crack's faces, and as they meet and part between two steps
  double grip_force_n = 0;  // with which the upper grip pulls along y
};

/// What a virtual gauge shows at one step of one lane; displacements and strains since the unloaded plate.
struct GaugeRow {
  std::int64_t step = 0;
  double time_s = 0;
  std::int32_t lane = 0;
  std::int32_t gauge = 0;  // by the order of output.gauges
  double x_m = 0, y_m = 0;
  double ux_m = 0, uy_m = 0, uz_m = 0;
  double vx_m_s = 0, vy_m_s = 0, vz_m_s = 0;
  double strain_xx = 0, strain_yy = 0, strain_xy = 0;
};

/// Release rate at one tip position, by a centred difference; all but the first are over G_I0 [-].
struct RatePoint {
  double tip_m = 0;
  double ratio = 0;             // G_ID/G_I0, damping counted in (paper, section 3.2)
  double ratio_fracture = 0;    // what the released beams took
  double ratio_paper = 0;       // `ratio` with the kinetic energy of translation alone (paper, eq. (7))
  double ratio_difference = 0;  // energy balance without damping less `ratio_fracture`: rounding
};

/// The lattice as a viewer needs it.
struct Geometry {
  std::vector<std::array<float, 3>> position;     // N [m], unloaded
  std::vector<float> radius;                      // N [m]
  std::vector<std::array<std::int32_t, 2>> beam;  // B pairs of elements
  std::vector<std::int32_t> crossing;             // the beams that the crack path crosses, ascending
};

/// The lattice as the run has it, in double precision: all that it takes to rebuild the run elsewhere. Empty
/// where the run keeps none. Beams have the order of Geometry::beam, and the stiffnesses of the first lane:
/// those of another go with its E_mu.
struct Mechanics {
  std::vector<std::array<double, 3>> centre;     // N [m], unloaded
  std::vector<double> radius, mass, inertia;     // N [m], [kg], [kg m2]
  std::vector<std::uint8_t> grip;                // N: 0 free, 1 held by the bottom grip, 2 by the top one
  std::vector<double> axial, bending, twist;     // B: k_a = E S / l [N/m], w = 2 E I / l, k_t = G I_0 / l [N m]
  std::vector<double> crossing_position;         // of each of Geometry::crossing: s_b [m]
};

/// The state of one lane at one moment; a field not asked for is empty.
struct Frame {
  std::int64_t step = 0;
  double time_s = 0;
  std::int32_t lane = 0;
  double tip_m = 0;
  std::vector<std::array<float, 3>> displacement;  // N [m]
  std::vector<std::array<float, 3>> velocity;      // N [m/s]
  std::vector<float> damage_factor;                // per crossing beam, 1 intact, 0 broken
  std::vector<float> elastic_energy;               // N [J], half of each beam's to each of its elements
  std::vector<std::array<float, 3>> rotation;      // N [rad], rotation vectors
};

/// A beam that the crack has released for good.
struct ReleaseEvent {
  std::int32_t beam = 0;
  std::int32_t lane = 0;
  double time_s = 0;
  double position_m = 0;  // of the tip that meets it: arc length, or half length of two tips; x of a free one
  double energy_j = 0;    // fracture energy of its whole release
  double x_m = 0, y_m = 0;  // of its middle, unloaded
  double tension = 0;  // share of the axial stretch in the elastic energy as it breaks: 1 is plain tension
};

}  // namespace rift::results

#include "engine/scene/parameters.hpp"

#include "engine/scene/toml_text.hpp"

#include <cassert>

namespace rift::scene {

namespace {

using enum Dimension;

constexpr double largest_exact_integer =
    9007199254740991.0;  // 2^53 - 1: every value of the range is a double

constexpr Range closed(double lower, double upper) { return {lower, upper, false, false}; }
constexpr Range above(double lower, double upper) { return {lower, upper, true, false}; }
constexpr Range below(double lower, double upper) { return {lower, upper, false, true}; }
constexpr Range inside(double lower, double upper) { return {lower, upper, true, true}; }

// A row reads: key, default, member, doc, dimension, range, choices. Sources of defaults: model.md §1, 3-7.

std::vector<Parameter> specimen_rows() {
  return {
      {"specimen.shape",
       "plate",
       [](Scene& s) -> Slot { return &s.specimen.shape; },
       "Shape of the specimen. Plates, and blocks of any thickness, are gripped along their bottom and their "
       "top and cracked; cylinders are compressed (`rift calibrate`); `rift pack` fills them all.",
       none,
       {},
       {"plate", "block", "cylinder", "sphere", "periodic"}},
      {"specimen.length", "200 mm", [](Scene& s) -> Slot { return &s.specimen.length; },
       "Length L of the plate along x, the direction of the crack; the diameter of a cylinder or a sphere.",
       length, above(0, 100)},
      {"specimen.height", "40 mm", [](Scene& s) -> Slot { return &s.specimen.height; },
       "Height H of the plate along y, between the grips; of a cylinder along its axis.", length,
       above(0, 100)},
      {"specimen.layers", "2", [](Scene& s) -> Slot { return &s.specimen.layers; },
       "Elements through the thickness, which follows from `layers` and `elements`: another number of "
       "elements gives another thickness. Excludes `thickness`.",
       none, above(0, 100)},
      {"specimen.thickness", "", [](Scene& s) -> Slot { return &s.specimen.thickness; },
       "Thickness B of the plate along z, in place of `layers`; of a block or a periodic box.", length,
       above(0, 100)},
      {"specimen.elements", "20000", [](Scene& s) -> Slot { return &s.specimen.elements; },
       "Number N of spheres. With `layers`, fewer make a thicker plate.", none, closed(2, 5e6)},
      {"specimen.radii",
       "uniform",
       [](Scene& s) -> Slot { return &s.specimen.radii; },
       "Distribution of the radii around their mean.",
       none,
       {},
       {"uniform", "log-normal"}},
      {"specimen.radius_spread", "0.125", [](Scene& s) -> Slot { return &s.specimen.radius_spread; },
       "Uniform radii lie within plus or minus this fraction of their mean; of log-normal ones it is the "
       "standard deviation of ln r, at most 0.4. 0 for equal spheres.",
       none, below(0, 0.95)},
      {"specimen.coordination", "6.0", [](Scene& s) -> Slot { return &s.specimen.coordination; },
       "Coordination number of the packing, 2 contacts / N, walls not counted.", none, closed(4, 7)},
      {"specimen.solid_fraction", "", [](Scene& s) -> Slot { return &s.specimen.solid_fraction; },
       "Volume of the spheres over that of the specimen, in place of `coordination`.", none,
       closed(0.4, 0.8)},
      {"specimen.contact_tolerance", "1", [](Scene& s) -> Slot { return &s.specimen.contact_tolerance; },
       "A beam joins every pair nearer than this times the sum of their radii.", none, closed(1, 1.2)},
      {"specimen.seed", "1", [](Scene& s) -> Slot { return &s.specimen.seed; }, "Seed of the random packing.",
       none, closed(0, largest_exact_integer)},
  };
}

std::vector<Parameter> material_rows() {
  return {
      {"material.young_modulus", "10 GPa", [](Scene& s) -> Slot { return &s.material.young_modulus; },
       "Young's modulus E of the material.", pressure, above(0, 1e13)},
      {"material.poisson_ratio", "0.3", [](Scene& s) -> Slot { return &s.material.poisson_ratio; },
       "Poisson's ratio of the material.", none, inside(-1, 0.5)},
      {"material.plane",
       "stress",
       [](Scene& s) -> Slot { return &s.material.plane; },
       "Plane stress or plane strain, for elastic constants, wave speeds and theoretical references.",
       none,
       {},
       {"stress", "strain"}},
      {"material.rayleigh_speed", "2200 m/s", [](Scene& s) -> Slot { return &s.material.rayleigh_speed; },
       "Rayleigh speed c_R, from which the density follows. Excludes `density`.", speed, above(0, 1e5)},
      {"material.density", "", [](Scene& s) -> Slot { return &s.material.density; },
       "Density, from which the Rayleigh speed follows, in place of `rayleigh_speed`.", density,
       above(0, 1e5)},
      {"material.stiffness",
       "in-situ",
       [](Scene& s) -> Slot { return &s.material.stiffness; },
       "Stiffness of the beams: scaled so that this specimen has E, the paper's bulk set, calibrated to E "
       "and ν by cylinders in compression (`rift calibrate`), or given by the `micro_*` keys.",
       none,
       {},
       {"in-situ", "bulk", "calibrated", "explicit"}},
      {"material.micro_young_modulus", "", [](Scene& s) -> Slot { return &s.material.micro_young_modulus; },
       "Young's modulus of a beam, with stiffness = \"explicit\".", pressure, above(0, 1e15)},
      {"material.micro_poisson_ratio", "", [](Scene& s) -> Slot { return &s.material.micro_poisson_ratio; },
       "Poisson's ratio of a beam, with stiffness = \"explicit\".", none, inside(-1, 0.5)},
      {"material.micro_radius_ratio", "", [](Scene& s) -> Slot { return &s.material.micro_radius_ratio; },
       "Radius of a beam over the mean radius of its two elements, with stiffness = \"explicit\".", none,
       above(0, 1)},
  };
}

std::vector<Parameter> loading_rows() {
  return {
      {"loading.displacement", "2 mm", [](Scene& s) -> Slot { return &s.loading.displacement; },
       "Displacement of the top face along y, held while the crack runs; below 0 the plate is compressed, "
       "which needs `crack.friction`.",
       length, closed(-10, 10)},
      {"loading.force", "", [](Scene& s) -> Slot { return &s.loading.force; },
       "Force of the top grip along y when the crack starts, in place of the displacement, which then "
       "follows from the force.",
       Dimension::force, closed(-1e9, 1e9)},
      {"loading.curve", "", [](Scene& s) -> Slot { return &s.loading.curve; },
       "A measured load in place of both: rows of time and displacement or force, or a CSV file, in the time "
       "of `crack.history` (without a history in the time of the run). The plate is at rest under the load "
       "at the start of the crack; a displacement then continues while the crack runs, a force leaves the "
       "grips where they are."},
      {"loading.traction", "", [](Scene& s) -> Slot { return &s.loading.traction; },
       "Opposite tractions on the top and the bottom face along y, in place of the grips: put on when the "
       "run "
       "starts, and held while the beams break by themselves (`fracture.law`).",
       pressure, above(0, 1e12)},
      {"loading.rise_time", "1 us", [](Scene& s) -> Slot { return &s.loading.rise_time; },
       "Time in which the traction rises, in proportion to time.", time, closed(0, 10)},
      {"loading.rollers", "false", [](Scene& s) -> Slot { return &s.loading.rollers; },
       "With `traction`: the left and the right face slide along y on rollers, without moving along x, as "
       "planes of "
       "symmetry do."},
      {"loading.shear", "0", [](Scene& s) -> Slot { return &s.loading.shear; },
       "The top face moves along x too, by this many times the displacement.", none, closed(-1000, 1000)},
      {"loading.tilt", "0", [](Scene& s) -> Slot { return &s.loading.tilt; },
       "Uneven opening of the top face: this fraction of the displacement more at the right end and less at "
       "the left end, so that the stored energy varies along the crack.",
       none, inside(-1, 1)},
      {"loading.grip_rotation",
       "held",
       [](Scene& s) -> Slot { return &s.loading.grip_rotation; },
       "Whether the grips hold the rotations of their elements beside the displacements, or leave them free.",
       none,
       {},
       {"held", "free"}},
      {"loading.method",
       "static",
       [](Scene& s) -> Slot { return &s.loading.method; },
       "Pre-stress by one static solve, or by ramping the top face in time.",
       none,
       {},
       {"static", "ramp"}},
      {"loading.ramp_steps", "20000", [](Scene& s) -> Slot { return &s.loading.ramp_steps; },
       "Steps of loading, with method = \"ramp\".", none, closed(1, 1e8)},
      {"loading.hold_steps", "10000", [](Scene& s) -> Slot { return &s.loading.hold_steps; },
       "Steps of stabilisation after the ramp.", none, closed(0, 1e8)},
      {"loading.ramp_beta", "0.9", [](Scene& s) -> Slot { return &s.loading.ramp_beta; },
       "Numerical damping during ramp and stabilisation; switched off before the crack starts.", none,
       above(0, 1)},
  };
}

std::vector<Parameter> crack_rows() {
  return {
      {"crack.velocity", "0.5 c_r", [](Scene& s) -> Slot { return &s.crack.velocity; },
       "Velocity of the tip, always with a unit; piecewise constant as in \"0.2 c_r until 40 mm, 0.6 c_r\"."},
      {"crack.history", "", [](Scene& s) -> Slot { return &s.crack.history; },
       "A measured history in place of the velocity: rows of time and tip position, with the standard "
       "uncertainty of the position where it is known; or a CSV file of them."},
      {"crack.smoothing",
       "monotone",
       [](Scene& s) -> Slot { return &s.crack.smoothing; },
       "How the measured rows are smoothed: by a monotone penalised spline, as smooth as the uncertainties "
       "(without them: cross-validation) allow; or not at all, with straight lines between the rows.",
       none,
       {},
       {"monotone", "none"}},
      {"crack.history_gap", "10", [](Scene& s) -> Slot { return &s.crack.history_gap; },
       "Rows count as missing where the time between two rows exceeds this many median intervals.", none,
       above(1, 1e6)},
      {"crack.toughness", "", [](Scene& s) -> Slot { return &s.crack.toughness; },
       "Critical release rate against velocity or position, as rows or a CSV file: the crack is then "
       "predicted: its velocity follows from the energy released, beginning with `velocity`."},
      {"crack.toughness_window", "12", [](Scene& s) -> Slot { return &s.crack.toughness_window; },
       "Distance, in mean radii, over which the release rate of a predicted crack is averaged; its velocity "
       "is updated every sixth of this distance.",
       none, closed(1, 1000)},
      {"crack.path", "0.5 H", [](Scene& s) -> Slot { return &s.crack.path; },
       "Line of the crack: straight along x at a height, or through points, as a list or a CSV file."},
      {"crack.path_shape",
       "polyline",
       [](Scene& s) -> Slot { return &s.crack.path_shape; },
       "How the points are joined: by straight lines, or by a centripetal Catmull-Rom spline.",
       none,
       {},
       {"polyline", "spline"}},
      {"crack.start", "0", [](Scene& s) -> Slot { return &s.crack.start; },
       "Where the tip starts; beams before it are absent from the pre-stress on (a notch; with two tips its "
       "half length).",
       length, closed(0, 100)},
      {"crack.end", "", [](Scene& s) -> Slot { return &s.crack.end; },
       "Where the run ends; without it at the end of the measuring window.", length, above(0, 100)},
      {"crack.tips", "1", [](Scene& s) -> Slot { return &s.crack.tips; },
       "Number of tips: 1, running to the right; 2, running from the middle of the path to both sides at one "
       "velocity: every position is then the half length of the crack.",
       none, closed(1, 2)},
      {"crack.technique",
       "progressive",
       [](Scene& s) -> Slot { return &s.crack.technique; },
       "Release of a beam at once (S-NRT), or over a damage zone ahead of the tip (P-NRT).",
       none,
       {},
       {"simple", "progressive"}},
      {"crack.release_order",
       "crossing",
       [](Scene& s) -> Slot { return &s.crack.release_order; },
       "When the tip releases a beam: where the path crosses it, at the height of its middle along the path, "
       "or as it comes by the first of its two elements, which so loses all its beams across the path at "
       "once.",
       none,
       {},
       {"crossing", "middle", "node"}},
      {"crack.relaxation", "linear", [](Scene& s) -> Slot { return Exponent{&s.crack.relaxation}; },
       "Exponent p of the stiffness (1 - b/l)^p over the damage zone: linear 1, square-root 0.5, quadratic "
       "2.",
       none, above(0, 16)},
      {"crack.damage_zone_ratio", "1", [](Scene& s) -> Slot { return &s.crack.damage_zone_ratio; },
       "Length r_l ahead of the tip over which beams are released, in mean radii: a parameter of the release "
       "scheme, no property of the material. Below 4 results depend on the lattice (docs/limits.md).",
       none, above(0, 1000)},
      {"crack.friction", "", [](Scene& s) -> Slot { return &s.crack.friction; },
       "Coulomb friction of the crack's faces, which are in contact where they meet; 0 for contact without "
       "friction. Without the key there is no contact, as in the paper, and the faces pass through each "
       "other.",
       none, closed(0, 100)},
  };
}

std::vector<Parameter> fracture_rows() {
  return {
      {"fracture.law",
       "prescribed",
       [](Scene& s) -> Slot { return &s.breaking.law; },
       "What breaks the beams: a crack that moves along its path as `[crack]` says; or each beam breaks by "
       "itself wherever it is, softening (cohesive) or all at once (snap, which radiates most of the "
       "energy). Then `crack.path` and `crack.start` make the notch.",
       none,
       {},
       {"prescribed", "cohesive", "snap"}},
      {"fracture.release_rate", "", [](Scene& s) -> Slot { return &s.breaking.release_rate; },
       "Critical energy release rate G_c of the material, per area of the crack.", release_rate,
       above(0, 1e9)},
      {"fracture.strength", "", [](Scene& s) -> Slot { return &s.breaking.strength; },
       "Tensile strength at which a cohesive beam begins to soften; lowered, with a note, where the lattice "
       "does not resolve the zone over which its cracks soften.",
       pressure, above(0, 1e13)},
      {"fracture.kappa", "0.71", [](Scene& s) -> Slot { return &s.breaking.kappa; },
       "Energy that breaking one beam takes, over G_c times the area that it stands for: a property of the "
       "lattice, not of the material.",
       none, above(0, 100)},
      {"fracture.duration", "", [](Scene& s) -> Slot { return &s.breaking.duration; },
       "Time that the run lasts where beams break by themselves.", time, above(0, 10)},
  };
}

std::vector<Parameter> damping_rows() {
  return {
      {"damping.alpha", "0", [](Scene& s) -> Slot { return &s.damping.alpha; },
       "Viscous damping of the beams, as a fraction of critical.", none, closed(0, 1)},
      {"damping.region",
       "none",
       [](Scene& s) -> Slot { return &s.damping.region; },
       "Which beams are damped: none, those near the crack surface, all.",
       none,
       {},
       {"none", "surface", "all"}},
      {"damping.surface_width", "1.5", [](Scene& s) -> Slot { return &s.damping.surface_width; },
       "Beams with an end within this distance of the path, in mean radii, are near the crack surface.", none,
       above(0, 100)},
  };
}

std::vector<Parameter> solver_rows() {
  return {
      {"solver.kinematics",
       "linear",
       [](Scene& s) -> Slot { return &s.solver.kinematics; },
       "Beam axes fixed at the initial geometry, or turning with the elements (any rotation).",
       none,
       {},
       {"linear", "corotational"}},
      {"solver.precision",
       "double",
       [](Scene& s) -> Slot { return &s.solver.precision; },
       "Precision of the state, which holds changes since the pre-stress; the energy balance is always in "
       "double precision.",
       none,
       {},
       {"double", "single"}},
      {"solver.dt", "", [](Scene& s) -> Slot { return &s.solver.dt; },
       "Time step; without `dt` and `dt_fraction` it is chosen from the critical step and the damage zone.",
       time, above(0, 1)},
      {"solver.dt_fraction", "", [](Scene& s) -> Slot { return &s.solver.dt_fraction; },
       "Time step as a fraction of the undamped critical step, in place of `dt`.", none, inside(0, 1)},
      {"solver.beta", "1", [](Scene& s) -> Slot { return &s.solver.beta; },
       "Parameter of the integrator: 1 conserves energy, below 1 damps.", none, above(0, 1)},
  };
}

std::vector<Parameter> output_rows() {
  return {
      {"output.samples", "400", [](Scene& s) -> Slot { return &s.output.samples; },
       "Number of samples of energies and release rate over the run, evenly spaced in time; eleven more mark "
       "the measuring window.",
       none, closed(10, 1e6)},
      {"output.frames", "40", [](Scene& s) -> Slot { return &s.output.frames; },
       "Frames of the fields over the run; 0 for none.", none, closed(0, 1e5)},
      {"output.fields",
       R"(["displacement", "damage"])",
       [](Scene& s) -> Slot { return &s.output.fields; },
       "Fields of a frame; energy is the elastic energy by element, rotation the rotation vector of each.",
       none,
       {},
       {"displacement", "velocity", "damage", "energy", "rotation"}},
      {"output.window", "", [](Scene& s) -> Slot { return &s.output.window; },
       "Measuring window as two fractions of the length; by default [0.2, 0.4], or [0.4, 0.6] above 0.8 c_R; "
       "with two tips from five damage zones (simple: five mean radii) past the start to the first boundary "
       "reflection.",
       none, closed(0, 1)},
      {"output.g_i0_reference",
       "strip",
       [](Scene& s) -> Slot { return &s.output.g_i0_reference; },
       "Reference of the release rate: energy per length of the pre-stressed strip, middle half; or sigma^2 "
       "pi a / E' of a central crack of half length a, with crack.tips = 2.",
       none,
       {},
       {"strip", "griffith"}},
      {"output.gauges", "", [](Scene& s) -> Slot { return &s.output.gauges; },
       "Points of the plate, as [\"x\", \"y\"], at which a virtual gauge shows displacement, velocity and "
       "strain "
       "at "
       "every sample."},
      {"output.gauge_length", "8", [](Scene& s) -> Slot { return &s.output.gauge_length; },
       "Diameter of a gauge, in mean radii; it reads the least-squares plane through the elements under it.",
       none, closed(4, 1000)},
  };
}

std::vector<Parameter> calibration_rows() {
  return {
      {"calibration.sizes", "[500, 1000, 2000, 4000, 7500, 15000, 25000, 35000]",
       [](Scene& s) -> Slot { return &s.calibration.sizes; },
       "Numbers of elements of the cylinders that show the convergence of E and ν.", none, closed(100, 5e6)},
      {"calibration.packings", "5", [](Scene& s) -> Slot { return &s.calibration.packings; },
       "Packings for each size, with consecutive seeds.", none, closed(1, 100)},
      {"calibration.elements", "15000", [](Scene& s) -> Slot { return &s.calibration.elements; },
       "Elements of the cylinders that scan the beams' radius ratio.", none, closed(100, 5e6)},
      {"calibration.radius_ratios", "[0.1, 0.15, 0.2, 0.25, 0.3, 0.4, 0.5, 0.65, 0.8, 1]",
       [](Scene& s) -> Slot { return &s.calibration.radius_ratios; },
       "Radius ratios r_µ of the scanned beams: radius over the mean radius of their two elements.", none,
       closed(0.05, 1)},
  };
}

std::vector<Parameter> film_rows() {
  return {
      {"film.title", "", [](Scene& s) -> Slot { return Word{&s.film.title}; },
       "Title above the film. Without one, and where `--set` changes loading, material, crack or damping of "
       "a preset "
       "that has one, it says what is in the run."},
      {"film.field",
       "uy",
       [](Scene& s) -> Slot { return Word{&s.film.field}; },
       "Field that gives the colours: displacements, velocities, energy densities or damage.",
       none,
       {},
       {"ux", "uy", "uz", "u", "vx", "vy", "vz", "v", "kinetic", "elastic", "damage"}},
      {"film.colours",
       "of the field",
       [](Scene& s) -> Slot { return Word{&s.film.colours}; },
       "Colour map; the field's own is coolwarm where it has two signs, else viridis.",
       none,
       {},
       {"of the field", "coolwarm", "vik", "viridis", "inferno", "cividis"}},
      {"film.camera",
       "plate",
       [](Scene& s) -> Slot { return Word{&s.film.camera}; },
       "The whole plate; a close-up that follows the tip; or a side view of the out-of-plane displacement.",
       none,
       {},
       {"plate", "tip", "side"}},
      {"film.beams",
       "none",
       [](Scene& s) -> Slot { return Word{&s.film.beams}; },
       "Beams that are drawn: none, those that the crack crosses, or all.",
       none,
       {},
       {"none", "crossing", "all"}},
      {"film.magnification", "1", [](Scene& s) -> Slot { return &s.film.magnification; },
       "Magnification of the displacements; in the side view of the out-of-plane displacements only.", none,
       closed(0, 1000)},
      {"film.close_up", "20 mm", [](Scene& s) -> Slot { return &s.film.close_up; },
       "Height of the region that a close-up shows.", length, above(0, 100)},
      {"film.chart", "true", [](Scene& s) -> Slot { return &s.film.chart; },
       "Whether a chart of the energy budget is drawn below the picture."},
      {"film.boundaries", "false", [](Scene& s) -> Slot { return &s.film.boundaries; },
       "Whether grips, measures and the crack's path are drawn around the plate."},
  };
}

std::vector<Parameter> all_rows() {
  std::vector<Parameter> rows;
  for (const auto part : {specimen_rows, material_rows, loading_rows, crack_rows, fracture_rows, damping_rows,
                          solver_rows, output_rows, calibration_rows, film_rows}) {
    const std::vector<Parameter> table = part();
    rows.insert(rows.end(), table.begin(), table.end());
  }
  return rows;
}

}  // namespace

std::span<const Parameter> parameters() {
  static const std::vector<Parameter> rows = all_rows();
  return rows;
}

const Parameter* find_parameter(std::string_view key) {
  for (const Parameter& row : parameters()) {
    if (row.key == key) return &row;
  }
  return nullptr;
}

std::string table_of(const Parameter& row) { return std::string(row.key.substr(0, row.key.find('.'))); }
std::string name_of(const Parameter& row) { return std::string(row.key.substr(row.key.find('.') + 1)); }

Scene default_scene() {
  static const Scene standard = [] {  // read once: a study of many scenarios asks for it often
    Scene scene{};
    for (const Parameter& row : parameters()) {
      if (row.standard.empty()) continue;
      [[maybe_unused]] const std::string problem = assign(scene, row, value_from_text(row.standard));
      assert(problem.empty());
    }
    return scene;
  }();
  return standard;
}

}  // namespace rift::scene

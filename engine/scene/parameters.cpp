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
       "top "
       "and cracked; cylinders are pressed (`rift calibrate`); `rift pack` fills them all.",
       none,
       {},
       {"plate", "block", "cylinder", "sphere", "periodic"}},
      {"specimen.length", "200 mm", [](Scene& s) -> Slot { return &s.specimen.length; },
       "Length L of the plate along x, the way of the crack; the diameter of a cylinder or a sphere.", length,
       above(0, 100)},
      {"specimen.height", "40 mm", [](Scene& s) -> Slot { return &s.specimen.height; },
       "Height H of the plate along y, between the grips; of a cylinder along its axis.", length,
       above(0, 100)},
      {"specimen.layers", "2", [](Scene& s) -> Slot { return &s.specimen.layers; },
       "Elements through the thickness; with `elements`, `length` and `height` it fixes the thickness. "
       "Excludes `thickness`.",
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
       "Plane elasticity in which constants, wave speeds and references are read.",
       none,
       {},
       {"stress", "strain"}},
      {"material.rayleigh_speed", "2200 m/s", [](Scene& s) -> Slot { return &s.material.rayleigh_speed; },
       "Rayleigh speed c_r, from which the density follows. Excludes `density`.", speed, above(0, 1e5)},
      {"material.density", "", [](Scene& s) -> Slot { return &s.material.density; },
       "Density, from which the Rayleigh speed follows, in place of `rayleigh_speed`.", density,
       above(0, 1e5)},
      {"material.stiffness",
       "in-situ",
       [](Scene& s) -> Slot { return &s.material.stiffness; },
       "Beams: scaled to this specimen's own modulus, the paper's bulk set, calibrated to E and nu by "
       "cylinders "
       "in compression (`rift calibrate`), or the `micro_*` given.",
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
       "Displacement of the top face along y, held while the crack runs; below 0 the plate is pressed, which "
       "needs `crack.friction`.",
       length, closed(-10, 10)},
      {"loading.force", "", [](Scene& s) -> Slot { return &s.loading.force; },
       "Pull of the top grip along y as the crack starts, in place of the displacement, which follows from "
       "it.",
       Dimension::force, closed(-1e9, 1e9)},
      {"loading.curve", "", [](Scene& s) -> Slot { return &s.loading.curve; },
       "A measured load in place of both: rows of time and displacement or force, or a CSV file, by the "
       "clock "
       "of `crack.history` (without one the run's). The plate is at rest under the load of the crack's first "
       "moment; a displacement then goes on while the crack runs, a force leaves the grips where they are."},
      {"loading.shear", "0", [](Scene& s) -> Slot { return &s.loading.shear; },
       "The top face moves along x too, by this many times the displacement.", none, closed(-1000, 1000)},
      {"loading.tilt", "0", [](Scene& s) -> Slot { return &s.loading.tilt; },
       "The top face opens unevenly: by this fraction of the displacement more at the right end and less at "
       "the left one. A crack then finds more, or less, on its way.",
       none, inside(-1, 1)},
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
       "Numerical damping while ramping and holding; taken out before the crack starts.", none, above(0, 1)},
  };
}

std::vector<Parameter> crack_rows() {
  return {
      {"crack.velocity", "0.5 c_r", [](Scene& s) -> Slot { return &s.crack.velocity; },
       "Velocity of the tip, always with a unit; in pieces: \"0.2 c_r until 40 mm, 0.6 c_r\"."},
      {"crack.history", "", [](Scene& s) -> Slot { return &s.crack.history; },
       "A measured history in place of the velocity: rows of time and tip position, and the position's "
       "standard uncertainty where it is known; or a CSV file of them."},
      {"crack.smoothing",
       "monotone",
       [](Scene& s) -> Slot { return &s.crack.smoothing; },
       "How the history becomes the tip's course: a monotone penalised spline, as smooth as the "
       "uncertainties "
       "(without them: cross-validation) allow; or straight lines from row to row.",
       none,
       {},
       {"monotone", "none"}},
      {"crack.history_gap", "10", [](Scene& s) -> Slot { return &s.crack.history_gap; },
       "A longer time between two rows of the history, in times of their median, is taken for missing rows.",
       none, above(1, 1e6)},
      {"crack.toughness", "", [](Scene& s) -> Slot { return &s.crack.toughness; },
       "Critical release rate against velocity or position, as rows or a CSV file: the crack then runs by "
       "itself, as fast as what is released allows, from `velocity` on."},
      {"crack.toughness_window", "12", [](Scene& s) -> Slot { return &s.crack.toughness_window; },
       "Way of the tip, in mean radii, over which the release rate of a crack that runs by itself is "
       "smoothed; "
       "its velocity is found anew every sixth of it.",
       none, closed(1, 1000)},
      {"crack.path", "0.5 H", [](Scene& s) -> Slot { return &s.crack.path; },
       "Line of the crack: straight along x at a height, or through points, as a list or a CSV file."},
      {"crack.path_shape",
       "polyline",
       [](Scene& s) -> Slot { return &s.crack.path_shape; },
       "Through the points straight, with kinks; or by a centripetal Catmull-Rom spline.",
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
      {"crack.relaxation", "linear", [](Scene& s) -> Slot { return Exponent{&s.crack.relaxation}; },
       "Exponent p of the stiffness (1 - b/l)^p over the damage zone: linear 1, square-root 0.5, quadratic "
       "2.",
       none, above(0, 16)},
      {"crack.damage_zone_ratio", "1", [](Scene& s) -> Slot { return &s.crack.damage_zone_ratio; },
       "Length of the damage zone r_l, in mean radii.", none, above(0, 1000)},
      {"crack.friction", "", [](Scene& s) -> Slot { return &s.crack.friction; },
       "Coulomb friction of the crack's faces, which press on each other where they meet; 0 for none. "
       "Without "
       "it they do not touch, as in the paper, and pass through each other.",
       none, closed(0, 100)},
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
       "A beam with an end this near to the path, in mean radii, is near the crack surface.", none,
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
       "Numbers of the state, which holds changes since the pre-stress; the books are in double always.",
       none,
       {},
       {"double", "single"}},
      {"solver.dt", "", [](Scene& s) -> Slot { return &s.solver.dt; },
       "Time step; without it and `dt_fraction` chosen from the critical step and the damage zone.", time,
       above(0, 1)},
      {"solver.dt_fraction", "", [](Scene& s) -> Slot { return &s.solver.dt_fraction; },
       "Time step as a fraction of the undamped critical step, in place of `dt`.", none, inside(0, 1)},
      {"solver.beta", "1", [](Scene& s) -> Slot { return &s.solver.beta; },
       "Parameter of the integrator: 1 conserves energy, below 1 damps.", none, above(0, 1)},
  };
}

std::vector<Parameter> output_rows() {
  return {
      {"output.samples", "400", [](Scene& s) -> Slot { return &s.output.samples; },
       "Samples of the energies and the release rate over the run, at least; a power of two of steps apart.",
       none, closed(10, 1e6)},
      {"output.frames", "40", [](Scene& s) -> Slot { return &s.output.frames; },
       "Frames of the fields over the run; 0 for none.", none, closed(0, 1e5)},
      {"output.fields",
       R"(["displacement", "damage"])",
       [](Scene& s) -> Slot { return &s.output.fields; },
       "Fields of a frame; energy is the elastic energy by element.",
       none,
       {},
       {"displacement", "velocity", "damage", "energy"}},
      {"output.window", "", [](Scene& s) -> Slot { return &s.output.window; },
       "Window of the plateau as two fractions of the length; without it [0.2, 0.4], or [0.4, 0.6] above 0.8 "
       "c_r; with two tips from five damage zones (simple: five mean radii) past the start to the first "
       "echo.",
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
       "Diameter of a gauge, in mean radii: what it shows is the best plane through the elements under it.",
       none, closed(4, 1000)},
  };
}

std::vector<Parameter> calibration_rows() {
  return {
      {"calibration.sizes", "[500, 1000, 2000, 4000, 7500, 15000, 25000, 35000]",
       [](Scene& s) -> Slot { return &s.calibration.sizes; },
       "Elements of the cylinders that show how E and nu converge.", none, closed(100, 5e6)},
      {"calibration.packings", "5", [](Scene& s) -> Slot { return &s.calibration.packings; },
       "Packings of each size, of seeds that follow each other.", none, closed(1, 100)},
      {"calibration.elements", "15000", [](Scene& s) -> Slot { return &s.calibration.elements; },
       "Elements of the cylinders that scan the beams' radius ratio.", none, closed(100, 5e6)},
      {"calibration.radius_ratios", "[0.1, 0.15, 0.2, 0.25, 0.3, 0.4, 0.5, 0.65, 0.8, 1]",
       [](Scene& s) -> Slot { return &s.calibration.radius_ratios; },
       "Radii of the scanned beams over the mean radius of their two elements, r_mu.", none, closed(0.05, 1)},
  };
}

std::vector<Parameter> film_rows() {
  return {
      {"film.title", "", [](Scene& s) -> Slot { return Word{&s.film.title}; }, "Title over the film."},
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
       "The whole plate; a close-up that follows the tip; or from the side, what leaves the plane.",
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
       "Magnification of the displacements; from the side only of those out of the plane.", none,
       closed(0, 1000)},
      {"film.close_up", "20 mm", [](Scene& s) -> Slot { return &s.film.close_up; },
       "Height of what a close-up shows.", length, above(0, 100)},
      {"film.chart", "true", [](Scene& s) -> Slot { return &s.film.chart; },
       "Whether the energy budget grows in a chart under the picture."},
      {"film.boundaries", "false", [](Scene& s) -> Slot { return &s.film.boundaries; },
       "Whether grips, measures and the crack's path are drawn around the plate."},
  };
}

std::vector<Parameter> all_rows() {
  std::vector<Parameter> rows;
  for (const auto part : {specimen_rows, material_rows, loading_rows, crack_rows, damping_rows, solver_rows,
                          output_rows, calibration_rows, film_rows}) {
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
  Scene scene{};
  for (const Parameter& row : parameters()) {
    if (row.standard.empty()) continue;
    [[maybe_unused]] const std::string problem = assign(scene, row, value_from_text(row.standard));
    assert(problem.empty());
  }
  return scene;
}

}  // namespace rift::scene

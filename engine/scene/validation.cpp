#include "engine/scene/validation.hpp"

#include "engine/scene/derived.hpp"
#include "engine/scene/issue.hpp"
#include "engine/scene/needs.hpp"
#include "engine/scene/rows_text.hpp"
#include "engine/scene/units.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <initializer_list>
#include <utility>

namespace rift::scene {

namespace {

struct Checks {
  const Preset& preset;
  const Scene& scene;
  std::set<std::string> invalid;
  std::vector<Issue> issues;

  bool given(const std::string& key) const { return preset.origins.contains(key); }
  bool valid(std::initializer_list<const char*> keys) const {
    return std::none_of(keys.begin(), keys.end(), [&](const char* key) { return invalid.contains(key); });
  }
  void say(const std::string& key, std::string text) {
    issues.push_back(issue_at(preset, key, std::move(text)));
  }
};

std::string millimetres(double metres) { return rounded_text(metres, Dimension::length); }

/// "line 7" or "--set", to point at the other side of a contradiction.
std::string where(const Preset& preset, const std::string& key) {
  const Origin& origin = preset.origins.at(key);
  return origin.line == 0 ? origin.file : fmt::format("line {}", origin.line);
}

constexpr std::array<std::pair<const char*, const char*>, 12> exclusive{
    {{"specimen.thickness", "specimen.layers"},
     {"specimen.solid_fraction", "specimen.coordination"},
     {"material.density", "material.rayleigh_speed"},
     {"loading.force", "loading.displacement"},
     {"loading.curve", "loading.displacement"},
     {"loading.curve", "loading.force"},
     {"loading.traction", "loading.displacement"},
     {"loading.traction", "loading.force"},
     {"loading.traction", "loading.curve"},
     {"crack.history", "crack.velocity"},
     {"crack.history", "crack.toughness"},
     {"solver.dt", "solver.dt_fraction"}}};

void check_exclusive(Checks& c) {
  for (const auto& [one, other] : exclusive) {
    if (!c.given(one) || !c.given(other)) continue;
    c.say(one, fmt::format("excludes {} ({}): give one of them", other, where(c.preset, other)));
  }
}

void check_micro(Checks& c) {
  if (!c.valid({"material.stiffness"})) return;
  const bool wanted = c.scene.material.stiffness == StiffnessChoice::explicit_values;
  std::vector<std::string> missing;
  for (const char* key :
       {"material.micro_young_modulus", "material.micro_poisson_ratio", "material.micro_radius_ratio"}) {
    if (wanted && !c.given(key)) missing.emplace_back(key);
    if (!wanted && c.given(key)) c.say(key, "goes with material.stiffness = \"explicit\" only");
  }
  if (!missing.empty()) c.say("material.stiffness", fmt::format("needs {} as well", listed(missing, "and")));
}

void check_damping(Checks& c) {
  if (!c.valid({"damping.alpha", "damping.region"})) return;
  const bool somewhere = c.scene.damping.region != DampingRegion::none;
  if (c.scene.damping.alpha > 0 && !somewhere) {
    c.say("damping.alpha", "damps nothing with damping.region = \"none\": choose \"surface\" or \"all\"");
  }
  if (c.scene.damping.alpha == 0 && somewhere) {
    c.say("damping.region", "damps nothing with damping.alpha = 0: give an alpha above 0");
  }
}

/// Which keys a shape takes; false where its sizes are not valid.
bool check_shape(Checks& c) {
  if (!c.valid({"specimen.shape"})) return false;
  const packing::Shape shape = c.scene.specimen.shape;
  const auto excluded = [&](const char* key, const char* why) {
    if (c.given(key)) c.say(key, why);
  };
  if (shape != packing::Shape::plate)
    excluded("specimen.layers", "goes with specimen.shape = \"plate\" only");
  if (shape == packing::Shape::cylinder || shape == packing::Shape::sphere)
    excluded("specimen.thickness", "applies to boxes only: the diameter of a round shape is specimen.length");
  if (shape == packing::Shape::sphere) excluded("specimen.height", "a sphere has one size, specimen.length");
  if (!needs_calibration(c.scene))
    for (const char* key :
         {"calibration.sizes", "calibration.packings", "calibration.elements", "calibration.radius_ratios"})
      excluded(key, "goes with specimen.shape = \"cylinder\" or material.stiffness = \"calibrated\" only");
  const bool needs_thickness = shape == packing::Shape::block || shape == packing::Shape::periodic;
  if (needs_thickness && !c.given("specimen.thickness"))
    c.say("specimen.shape", "needs specimen.thickness as well");
  return !needs_thickness || c.given("specimen.thickness");
}

void check_radii(Checks& c) {
  constexpr double widest_log_normal = 0.4;  // one sphere in a thousand is then 3.5 times the mean
  if (!c.valid({"specimen.radii", "specimen.radius_spread"})) return;
  if (c.scene.specimen.radii == packing::Radii::log_normal &&
      c.scene.specimen.radius_spread > widest_log_normal)
    c.say("specimen.radius_spread",
          fmt::format("of log-normal radii must lie in [0, {}]", widest_log_normal));
}

void check_sizes(Checks& c) {
  if (!check_shape(c)) return;
  if (!c.valid({"specimen.length", "specimen.height", "specimen.layers", "specimen.thickness",
                "specimen.elements", "specimen.radii", "specimen.radius_spread"})) {
    return;
  }
  if (c.given("specimen.thickness") && c.given("specimen.layers")) return;  // which one counts is not known
  const double diameter = 2 * expected_mean_radius_m(c.scene), thickness = thickness_m(c.scene);
  const std::string element = fmt::format("one element, {} across on average", millimetres(diameter));
  if (c.scene.specimen.shape == packing::Shape::periodic) {
    if (box_of(c.scene).size().minCoeff() < 3 * diameter)
      c.say("specimen.elements", fmt::format("too few: a periodic box must be wider than three elements, {} "
                                             "across on average, for none to touch its own image",
                                             millimetres(diameter)));
    return;
  }
  if (can_crack(c.scene) && thickness < diameter) {
    const bool by_layers = !c.scene.specimen.thickness;
    c.say(by_layers ? "specimen.layers" : "specimen.thickness",
          fmt::format("{}is thinner than {}: make it thicker, or raise specimen.elements",
                      by_layers ? fmt::format("a plate of {} ", millimetres(thickness)) : "", element));
  }
  const packing::Box box = box_of(c.scene);
  if (std::min(box.length, box.height) < diameter) {
    c.say("specimen.elements",
          fmt::format("too few for specimen.length and specimen.height: the {} is smaller than {}",
                      can_crack(c.scene) ? "plate" : "specimen", element));
  }
}

void check_path(Checks& c) {
  if (!c.valid({"crack.path", "specimen.height"})) return;
  if (path_height_m(c.scene) >= c.scene.specimen.height) {
    c.say("crack.path",
          fmt::format("must lie inside the plate, (0, {})", millimetres(c.scene.specimen.height)));
  }
}

/// What a load that is not one displacement does not go with.
void check_curve(Checks& c) {
  const Scene::Loading& loading = c.scene.loading;
  const char* key = loading.curve.row.empty() ? "loading.force" : "loading.curve";
  if (force_at_start(c.scene) && c.scene.material.stiffness == StiffnessChoice::bulk)
    c.say(key,
          "a force does not go with material.stiffness = \"bulk\", whose plate is not as stiff as the "
          "material");
  if (!grip_moves(c.scene)) return;
  if (loading.method == LoadingMethod::ramp) c.say(key, "goes with loading.method = \"static\" only");
  if (loading.tilt != 0.0 || loading.shear != 0.0)
    c.say(key, "moves the grip along y alone: leave loading.tilt and loading.shear out");
}

/// What a crack that nobody moves needs, and what does not go with it yet.
void check_breaking(Checks& c) {
  if (!c.valid({"fracture.law"})) return;
  const Scene::Fracture& breaking = c.scene.breaking;
  const std::string law = word_of("fracture.law", breaking.law);
  if (!breaks_freely(c.scene)) {
    for (const char* key :
         {"fracture.release_rate", "fracture.strength", "fracture.duration", "loading.traction"})
      if (c.given(key)) c.say(key, "goes with fracture.law = \"cohesive\" or \"snap\" only");
    return;
  }
  const bool snaps = breaking.law == fracture::FractureLaw::snap;
  std::vector<std::string> missing;
  for (const char* key : {"fracture.release_rate", "fracture.strength", "fracture.duration"})
    if (!c.given(key) && !(snaps && std::string_view(key) == "fracture.strength")) missing.emplace_back(key);
  if (!missing.empty()) c.say("fracture.law", fmt::format("needs {} as well", listed(missing, "and")));
  if (snaps && c.given("fracture.strength"))
    c.say("fracture.strength",
          "goes with fracture.law = \"cohesive\" only: a beam that snaps bears what its "
          "release rate says");
  const auto excluded = [&](bool is_so, const char* key) {
    if (is_so && c.valid({key})) c.say(key, fmt::format("does not go with fracture.law = \"{}\" yet", law));
  };
  excluded(c.scene.solver.kinematics == lattice::Kinematics::corotational, "solver.kinematics");
  excluded(c.scene.loading.method == LoadingMethod::ramp, "loading.method");
  excluded(c.scene.damping.region != DampingRegion::none, "damping.region");
  excluded(c.scene.crack.tips == 2, "crack.tips");
  excluded(c.scene.crack.release_order != fracture::ReleaseOrder::crossing, "crack.release_order");
  excluded(c.scene.crack.friction.has_value(), "crack.friction");
  for (const char* key : {"crack.history", "crack.toughness"})
    if (c.given(key))
      c.say(key, fmt::format("does not go with fracture.law = \"{}\": nobody moves that crack", law));
}

void check_loading(Checks& c) {
  const Scene::Loading& loading = c.scene.loading;
  if (loading.rollers && !loading.traction)
    c.say("loading.rollers", "goes with loading.traction only: the grips hold the plate");
  if (loading.traction) {
    if (loading.grip_rotation != GripRotation::held)
      c.say("loading.grip_rotation", "goes without loading.traction, which takes the place of the grips");
    if (loading.tilt != 0.0 || loading.shear != 0.0)
      c.say("loading.traction", "goes without loading.tilt and loading.shear, which are the grips'");
    return;
  }
  const bool ramp = loading.method == LoadingMethod::ramp;
  if (loading.tilt != 0.0 && ramp) c.say("loading.tilt", "goes with loading.method = \"static\" only");
  if (loading.shear != 0.0 && ramp) c.say("loading.shear", "goes with loading.method = \"static\" only");
  if (c.valid({"crack.history", "loading.curve", "crack.friction"})) {
    const std::vector<Issue> rows = load_issues(c.preset);
    c.issues.insert(c.issues.end(), rows.begin(), rows.end());
    if (!rows.empty()) return;
  }
  check_curve(c);
  if (!c.valid({"loading.displacement", "loading.force", "loading.curve", "crack.history", "crack.friction"}))
    return;
  const std::optional<double> force = force_at_start(c.scene);
  const double load = force.value_or(displacement_at_start(c.scene));
  const char* key = !loading.curve.row.empty() ? "loading.curve"
                    : force                    ? "loading.force"
                                               : "loading.displacement";
  if (load == 0.0) c.say(key, "must not be 0: the plate would not be strained");
  if (load < 0.0 && !c.scene.crack.friction)
    c.say(key, "below 0 needs crack.friction: the faces of the crack would pass through each other");
}

void check_gauges(Checks& c) {
  if (!c.valid({"output.gauges", "specimen.length", "specimen.height"})) return;
  const double length = c.scene.specimen.length, height = c.scene.specimen.height;
  for (const auto& [x, y] : c.scene.output.gauges)
    if (!(x >= 0.0 && x <= length && y >= 0.0 && y <= height))
      c.say("output.gauges", fmt::format("({}, {}) lies outside the plate of {} by {}", millimetres(x),
                                         millimetres(y), millimetres(length), millimetres(height)));
}

/// Rows which are wrong say nothing further of the crack's way.
void check_rows(Checks& c) {
  const auto take = [&](const char* key, std::vector<Issue> found) {
    if (found.empty()) return;
    c.invalid.insert(key);
    for (Issue& issue : found) c.issues.push_back(std::move(issue));
  };
  if (c.valid({"crack.history", "crack.history_gap", "crack.smoothing", "crack.start"}))
    take("crack.history", history_issues(c.preset));
  take("crack.toughness", toughness_issues(c.preset));
  if (c.valid({"specimen.length", "specimen.height"})) take("crack.path", path_issues(c.preset));
  if (c.scene.crack.path.point.empty() && c.scene.crack.path_shape == PathShape::spline)
    c.say("crack.path_shape", "goes with a crack.path through points only");
}

/// Whether c_R follows from the material at all.
bool knows_rayleigh_speed(const Checks& c) {
  const bool both = c.given("material.density") && c.given("material.rayleigh_speed");
  return !both && c.valid({"material.young_modulus", "material.poisson_ratio", "material.plane",
                           "material.rayleigh_speed", "material.density"});
}

void check_speeds(Checks& c) {
  if (!c.valid({"crack.velocity", "crack.history"}) || !knows_rayleigh_speed(c)) return;
  if (highest_velocity(c.scene) <= highest_velocity_over_cr) return;
  const double limit = highest_velocity_over_cr * rayleigh_speed(c.scene);
  const bool measured = !c.scene.crack.history.empty();
  const std::string reached =
      measured ? fmt::format("reaches {:.3g} c_r: it ", highest_velocity(c.scene)) : std::string{};
  c.say(measured ? "crack.history" : "crack.velocity",
        fmt::format("{}must lie in (0, {}] c_r, here (0, {}]", reached, highest_velocity_over_cr,
                    rounded_text(limit, Dimension::speed)));
}

/// "the end of the plate, 200 mm", as far as a tip can run.
std::string end_of_plate(const Scene& scene) {
  const std::string at = millimetres(tip_path_length_m(scene));
  if (!scene.crack.path.point.empty()) return fmt::format("the end of the path, {}", at);
  return scene.crack.tips == 1 ? fmt::format("the end of the plate, {}", at)
                               : fmt::format("the ends of the plate, {} from its middle", at);
}

double measured_end(const Scene& scene) { return smoothed_history(scene).end; }

/// Start and end on the plate and in order; false where nothing further can be said of the crack's way.
bool check_ends(Checks& c) {
  const auto& [path_length, crack] = std::pair{tip_path_length_m(c.scene), c.scene.crack};
  if (crack.start >= path_length) {
    c.say("crack.start", fmt::format("must lie before {}", end_of_plate(c.scene)));
    return false;
  }
  if (!crack.history.empty() && crack_end(c.scene) > measured_end(c.scene)) {
    c.say("crack.end",
          fmt::format("lies beyond the history, which ends at {}", millimetres(measured_end(c.scene))));
    return false;
  }
  if (!crack.history.empty() && measured_end(c.scene) > path_length) {
    c.say("crack.history", fmt::format("continues to {}, beyond {}", millimetres(measured_end(c.scene)),
                                       end_of_plate(c.scene)));
    return false;
  }
  if (!crack.end) return true;
  if (*crack.end > path_length) {
    c.say("crack.end", fmt::format("must not lie beyond {}", end_of_plate(c.scene)));
    return false;
  }
  if (*crack.end <= crack.start) {
    c.say("crack.end", fmt::format("must lie beyond crack.start = {}", millimetres(crack.start)));
    return false;
  }
  return true;
}

/// Two tips have a default window only where five damage zones end well before the first boundary reflection.
bool check_window_of_two(Checks& c) {
  if (c.scene.crack.tips != 2 || c.given("output.window")) return true;
  if (!c.scene.crack.history.empty() || !c.scene.crack.toughness.row.empty()) return true;
  if (!c.scene.crack.path.point.empty()) {
    c.say("crack.path", "goes through points, so two tips have no default window: give output.window");
    return false;
  }
  if (c.scene.crack.velocity.size() > 1) {
    c.say("crack.velocity", "changes along the path, so two tips have no default window: give output.window");
    return false;
  }
  if (!c.valid({"specimen.height", "specimen.layers", "specimen.thickness", "specimen.elements",
                "specimen.radius_spread", "crack.path", "crack.technique", "crack.damage_zone_ratio"}) ||
      path_height_m(c.scene) >= c.scene.specimen.height ||
      (c.given("specimen.thickness") && c.given("specimen.layers"))) {
    return false;
  }
  const auto [lower, upper] = window_over_length(c.scene);
  const double length = c.scene.specimen.length, least = shortest_window_m(c.scene);
  if ((upper - lower) * length >= least) return true;
  const bool progressive = c.scene.crack.technique == fracture::Technique::progressive;
  c.say(progressive ? "crack.damage_zone_ratio" : "specimen.elements",
        fmt::format("leaves two tips (crack.tips) no window: five {} end at a half length of {}, the first "
                    "boundary reflection returns at {}, and {} are needed between: raise specimen.elements, "
                    "or height and length, or give output.window",
                    progressive ? "damage zones" : "mean radii", millimetres(lower * length),
                    millimetres(upper * length), millimetres(least)));
  return false;
}

/// The measuring window lies on the crack's way. The blame goes to the window where it was given.
bool check_window(Checks& c) {
  const double length = c.scene.specimen.length;
  const double slack = 1e-9 * length;  // 0.4 L is not the double that 80 mm is
  const auto [lower, upper] = window_over_length(c.scene);
  const bool window_given = c.given("output.window");
  const std::string window = fmt::format("the measuring window, {} to {},", millimetres(lower * length),
                                         millimetres(upper * length));
  const std::size_t before = c.issues.size();
  if (upper * length > tip_path_length_m(c.scene) + slack) {
    const bool by_path = !window_given && !c.scene.crack.path.point.empty();
    c.say(by_path ? "crack.path" : "output.window",
          fmt::format("{} ends beyond {}", window, end_of_plate(c.scene)));
  } else if (upper * length > crack_end(c.scene) + slack) {
    c.say(window_given ? "output.window" : "crack.end",
          fmt::format("{} ends beyond crack.end = {}", window, millimetres(crack_end(c.scene))));
  }
  if (lower * length < c.scene.crack.start - slack) {
    c.say(window_given ? "output.window" : "crack.start",
          fmt::format("{} begins before crack.start = {}", window, millimetres(c.scene.crack.start)));
  }
  return c.issues.size() == before;
}

void check_pieces(Checks& c) {
  if (!c.scene.crack.history.empty()) return;
  const double start = c.scene.crack.start, end = crack_end(c.scene);
  for (const VelocityPiece& piece : c.scene.crack.velocity) {
    if (!piece.until || (*piece.until > start && *piece.until < end)) continue;
    c.say("crack.velocity", fmt::format("'until {}' lies outside the crack's path, {} to {}",
                                        millimetres(*piece.until), millimetres(start), millimetres(end)));
  }
}

void check_crack_way(Checks& c) {
  if (!c.valid({"specimen.length", "crack.start", "crack.end", "crack.tips", "crack.history",
                "crack.toughness", "crack.path"}))
    return;
  if (c.scene.specimen.shape == packing::Shape::block && !c.given("specimen.thickness")) return;
  if (!check_ends(c)) return;
  // The default window depends on the velocity, a velocity in m/s on c_r.
  if (!c.valid({"crack.velocity", "output.window"}) || !knows_rayleigh_speed(c)) return;
  if (check_window_of_two(c) && check_window(c)) check_pieces(c);
}

void check_reference(Checks& c) {
  if (!c.valid({"crack.tips", "output.g_i0_reference"})) return;
  if (c.scene.output.g_i0_reference == ReleaseRateReference::griffith && c.scene.crack.tips != 2)
    c.say("output.g_i0_reference",
          "goes with crack.tips = 2 only, because it is the reference of a central crack");
}

}  // namespace

std::vector<std::string> rivals_of(const std::string& key) {
  std::vector<std::string> rivals;
  for (const auto& [one, other] : exclusive) {
    if (key == one) rivals.emplace_back(other);
    if (key == other) rivals.emplace_back(one);
  }
  if (key == "crack.history") rivals.emplace_back("crack.start");
  return rivals;
}

std::vector<Issue> validate(const Preset& preset, const std::set<std::string>& invalid) {
  Checks checks{preset, preset.scene, invalid, {}};
  check_exclusive(checks);
  if (const auto out = range_issues(preset, preset.scene, derived_numbers(preset, invalid)); !out.empty()) {
    checks.issues.insert(checks.issues.end(), out.begin(), out.end());
    return std::move(checks.issues);  // the others compute with these numbers
  }
  check_sizes(checks);
  check_radii(checks);
  check_micro(checks);
  if (!checks.valid({"specimen.shape"}) || !can_crack(preset.scene)) return std::move(checks.issues);
  check_damping(checks);
  check_breaking(checks);
  check_loading(checks);
  check_gauges(checks);
  check_rows(checks);
  check_path(checks);
  check_speeds(checks);
  check_crack_way(checks);
  check_reference(checks);
  return std::move(checks.issues);
}

}  // namespace rift::scene

#include "engine/mechanics/statics.hpp"
#include "engine/stability/cracked_plate.hpp"
#include "engine/stability/families.hpp"

#include <fmt/format.h>

#include <cmath>
#include <memory>
#include <utility>

/// Families over a plate that is packed, pulled and cracked as any run's.
namespace rift {
namespace {

using Words = std::vector<std::string>;

void add(Cases& cases, const char* family, std::string name, Ending expected, std::string names,
         Words overrides, SceneChange scene = {}, PlateChange plate = {}) {
  cases.push_back({family, std::move(name), expected, std::nan(""), std::move(names),
                   [overrides = std::move(overrides), scene = std::move(scene), plate = std::move(plate)](
                       Precision precision) { return crack(overrides, scene, plate, precision); }});
}

void add_side_by_side(Cases& cases, const char* family,
                      const std::vector<std::pair<std::string, SceneChange>>& lanes) {
  std::vector<SceneChange> changes;
  changes.reserve(lanes.size());
  for (const auto& [name, change] : lanes) changes.push_back(change);
  const auto pass = std::make_shared<SideBySide>(std::move(changes));
  for (int k = 0; k < static_cast<int>(lanes.size()); ++k)
    cases.push_back({family, lanes[static_cast<std::size_t>(k)].first, Ending::closes, std::nan(""), "",
                     [pass, k](Precision precision) { return pass->of(k, precision); }});
}

/// Beams of given E_mu, nu_mu, r_mu.
SceneChange beams(double young, double poisson, double ratio) {
  return [=](Scene& s) {
    s.material.stiffness = StiffnessChoice::explicit_values;
    s.material.micro_young_modulus = young, s.material.micro_poisson_ratio = poisson;
    s.material.micro_radius_ratio = ratio;
  };
}

/// Long enough for whatever is unstable to show.
const Words slow{"crack.velocity=0.1 c_r", "crack.end=22 mm"};

constexpr double young = 356e9, poisson = 0.3, ratio = 0.3;

/// The beams within a third of the height around the plate's middle a thousandfold and more as stiff; all
/// that follows from the lattice is computed again.
void stiffen_inclusion(Prepared& p, double contrast) {
  const Box& box = p.lattice.box;
  const Eigen::Vector2d middle(0.5 * box.length, 0.5 * box.height);
  for (std::size_t b = 0; b < p.lattice.beam.size(); ++b) {
    const auto& [i, j] = p.lattice.ends[b];
    const Eigen::Vector2d at = 0.5 * (p.lattice.centre[i] + p.lattice.centre[j]).head<2>();
    if ((at - middle).norm() > box.height / 3.0) continue;
    Beam& beam = p.lattice.beam[b];
    beam.axial *= contrast, beam.bending *= contrast, beam.twist *= contrast;
  }
  const std::vector<char> present(p.lattice.beam.size(), 1);
  p.displacement = stretched_at_rest(p.lattice, present, p.preset.scene.loading.displacement);
  p.stable = stable_step(p.lattice);
  force_step(p, 0.4 * p.stable.critical);
}

/// A plate whose every beam is damped, at a fraction of the limit that this leaves of the step.
PlateChange damped_step(double fraction) {
  return
      [fraction](Prepared& p) { force_step(p, fraction * damped_limit(p, damped_beams(p, p.lane), p.lane)); };
}

SceneChange damped(double alpha) {
  return [alpha](Scene& s) {
    s.damping.alpha = alpha;
    s.damping.region = DampingRegion::all;
    s.solver.dt_fraction = 1e-3;  // the case sets its own
  };
}

}  // namespace

void add_forced_steps(Cases& cases) {
  const char* family = "step of a run";
  for (const char* fraction : {"0.1", "0.5", "0.9", "0.99"})
    add(cases, family, fmt::format("{} of critical", fraction), Ending::closes, "",
        {fmt::format("solver.dt_fraction={}", fraction)});
  for (const char* fraction : {"1", "1.01", "2"})
    add(cases, family, fmt::format("dt_fraction = {}", fraction), Ending::refused, "must lie in (0, 1)",
        {fmt::format("solver.dt_fraction={}", fraction)});
  add(cases, family, "dt = 1 us", Ending::refused, "the critical step of this lattice is",
      {"solver.dt=1 us"});
  add(cases, family, "beta = 1.1", Ending::refused, "must lie in (0, 1]", {"solver.beta=1.1"});
  for (const double fraction : {1.01, 1.1, 2.0})
    add(cases, family, fmt::format("{:g} of critical, the check overruled", fraction), Ending::diverges, "",
        slow, {}, [fraction](Prepared& p) { force_step(p, fraction * p.stable.critical); });
  add(cases, family, "beta = 1.5, the check overruled", Ending::diverges, "", slow,
      [](Scene& s) { s.solver.beta = 1.5; });
}

void add_beams(Cases& cases) {
  for (const double factor : {1e-6, 1e-3, 1.0, 1e3, 1e6})
    add(cases, "stiffness of the beams", fmt::format("E_mu x {:g}", factor), Ending::closes, "", {},
        [=](Scene& s) {
          beams(young * factor, poisson, ratio)(s);
          s.crack.velocity = {{{0.5 * std::sqrt(factor), true}, {}}};
        });
  for (const double nu : {-0.9, -0.5, 0.0, 0.499})
    add(cases, "Poisson's ratio of the beams", fmt::format("nu_mu = {:g}", nu), Ending::closes, "", {},
        beams(young, nu, ratio));
  for (const double r : {0.02, 0.1, 0.6, 1.0})
    add(cases, "radius of the beams", fmt::format("r_mu = {:g}", r), Ending::closes, "", {},
        beams(young, poisson, r));
  for (const double factor : {1e-6, 1e6})
    add(cases, "density", fmt::format("x {:g}", factor), Ending::closes, "", {}, [factor](Scene& s) {
      s.material.rayleigh_speed.reset();
      s.material.density = 600.0 * factor;
    });
  for (const double contrast : {1e-4, 1e4})
    add(cases, "inclusion", fmt::format("{:g} as stiff", contrast), Ending::closes, "", {}, {},
        [contrast](Prepared& p) { stiffen_inclusion(p, contrast); });
}

void add_packings(Cases& cases) {
  for (const double k : {1.0, 2.0, 5.0, 10.0, 20.0})
    add(cases, "ratio of the radii", fmt::format("largest to smallest {:g}", k), Ending::closes, "",
        {"specimen.layers=5", "specimen.elements=600", "specimen.coordination=5"},
        [k](Scene& s) { s.specimen.radius_spread = (k - 1.0) / (k + 1.0); });
}

void add_damping(Cases& cases) {
  const char* family = "damping";
  for (const double alpha : {0.01, 0.1, 0.5, 1.0}) {
    add(cases, family, fmt::format("alpha = {:g} at 0.95 of its limit", alpha), Ending::closes, "", {},
        damped(alpha), damped_step(0.95));
    add(cases, family, fmt::format("alpha = {:g} at 1.05 of it, the check overruled", alpha),
        Ending::diverges, "", slow, damped(alpha), damped_step(1.05));
  }
  add(cases, family, "alpha = 1 at 0.9 of the undamped limit", Ending::refused,
      "the critical step of this lattice with this damping is",
      {"damping.alpha=1", "damping.region=all", "solver.dt_fraction=0.9"});
}

void add_cracks(Cases& cases, const SuiteOptions& options) {
  for (const double r_l : {0.01, 0.1, 1.0, 10.0, 50.0, 1000.0})
    add(cases, "damage zone", fmt::format("r_l = {:g}", r_l), Ending::closes, "", {},
        [r_l](Scene& s) { s.crack.damage_zone_ratio = r_l; });
  std::vector<std::pair<std::string, SceneChange>> velocities;
  for (const double v : {0.01, 0.1, 0.5, 0.9, 1.0, 1.5, 2.0})
    velocities.emplace_back(fmt::format("{:g} c_r{}", v, v > 1.0 ? ", beyond any positive limit" : ""),
                            [v](Scene& s) {
                              s.crack.velocity = {{{v, true}, {}}};
                            });
  add_side_by_side(cases, "velocity", velocities);
  if (!options.quick)
    for (const double v : {1e-4, 1e-3})
      add(cases, "velocity", fmt::format("{:g} c_r, to 3 mm", v), Ending::closes, "",
          {"crack.end=3 mm", "output.window=[0.03, 0.12]"}, [v](Scene& s) {
            s.crack.velocity = {{{v, true}, {}}};
          });
  add(cases, "velocity", "2.5 c_r", Ending::refused, "must lie in (0, 2] c_r", {"crack.velocity=2.5 c_r"});
  // Books of turning beams close as the square of the step does.
  for (const auto& [kinematics, fraction] : {std::pair{"linear", 0.5}, std::pair{"corotational", 0.1}})
    for (const double strain : {1e-9, 1e-6, 1e-3, 0.05, 0.5})
      add(cases, "pre-strain", fmt::format("{:g}, {}", strain, kinematics), Ending::closes, "",
          {fmt::format("solver.kinematics={}", kinematics), fmt::format("solver.dt_fraction={}", fraction)},
          [strain](Scene& s) { s.loading.displacement = strain * s.specimen.height; });
}

}  // namespace rift

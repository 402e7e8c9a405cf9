#include "engine/base/cache.hpp"
#include "engine/lattice/lattice.hpp"
#include "engine/lattice/statics.hpp"
#include "engine/measurement/specimen_properties.hpp"
#include "engine/stability/cracked_plate.hpp"
#include "engine/stability/suite.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <limits>
#include <memory>
#include <utility>

/// Families over a plate that is packed, pulled and cracked as any run's.
namespace rift::stability {
namespace {

using Words = std::vector<std::string>;
using Claims = std::vector<Claim>;
using Expectation = std::function<Claims(const Observed&, ensemble::Precision)>;
using Memory = std::shared_ptr<CachedRun>;

constexpr double without_bound = std::numeric_limits<double>::infinity();

/// What is the same but for rounding: 1e-12 in double; in single precision as far as its ratios are known.
double rounding(ensemble::Precision precision) {
  return precision == ensemble::Precision::double_precision ? 1e-12 : single_ratio_tolerance;
}

/// A crack of the suite's plate that others are compared with, too.
Memory plate(Words overrides, SceneChange scene = {}, PlateChange change = {}) {
  return std::make_shared<CachedRun>([overrides = std::move(overrides), scene = std::move(scene),
                                      change = std::move(change)](ensemble::Precision precision) {
    return crack(overrides, scene, change, precision);
  });
}

void add(Cases& cases, const char* family, std::string name, Memory seen, Expectation claims) {
  cases.push_back(
      {.family = family,
       .name = std::move(name),
       .run = [seen = std::move(seen)](ensemble::Precision precision) { return seen->of(precision); },
       .claims = std::move(claims)});
}

void add(Cases& cases, const char* family, std::string name, CaseEnd expected, std::string names,
         Words overrides, SceneChange scene = {}, PlateChange plate = {}) {
  cases.push_back(
      {.family = family,
       .name = std::move(name),
       .expected = expected,
       .names = std::move(names),
       .run = [overrides = std::move(overrides), scene = std::move(scene), plate = std::move(plate)](
                  ensemble::Precision precision) { return crack(overrides, scene, plate, precision); }});
}

/// Beams of given E_mu, nu_mu, r_mu.
SceneChange beams(double young, double poisson, double ratio) {
  return [=](scene::Scene& s) {
    s.material.stiffness = scene::StiffnessChoice::explicit_values;
    s.material.micro_young_modulus = young, s.material.micro_poisson_ratio = poisson;
    s.material.micro_radius_ratio = ratio;
  };
}

SceneChange at_velocity(double over_cr) {
  return [over_cr](scene::Scene& s) { s.crack.velocity = {{{over_cr, true}, {}}}; };
}

/// Long enough for whatever is unstable to show.
const Words slow{"crack.velocity=0.1 c_r", "crack.end=22 mm"};

constexpr double young = 356e9, poisson = 0.3, ratio = 0.3;

/// The same crack on another clock: its ratio is that of the one it is compared with, step by step.
Claims same_on_another_clock(const Observed& seen, const Observed& reference, double time,
                             ensemble::Precision precision) {
  return {
      claim_near("ratio over that of x 1", seen.ratio / reference.ratio, 1.0, rounding(precision)),
      claim_near("time of the crack over that of x 1", seen.time_s / reference.time_s, time, 1e-12 * time),
      claim_near("steps", static_cast<double>(seen.steps), static_cast<double>(reference.steps), 0.0)};
}

/// Cases whose time scales by a power of a factor, at a step that scales with it.
/// @param[in] scene  of a factor;  @param[in] power  of the factor, by which times grow
void add_scaled(Cases& cases, const char* family, const char* name,
                const std::function<SceneChange(double)>& scene, double power, double stored_power,
                const std::vector<double>& factors) {
  const auto dt = std::make_shared<double>(0.0);
  const Memory reference = plate({}, scene(1.0), [dt](simulation::Prepared& p) { *dt = p.step.dt; });
  for (const double factor : factors) {
    const double time = std::pow(factor, power);
    const Memory scaled = std::make_shared<CachedRun>([=](ensemble::Precision precision) {
      (void)reference->of(precision);
      return crack(
          {}, scene(factor), [=](simulation::Prepared& p) { force_step(p, *dt * time); }, precision);
    });
    add(cases, family, fmt::format("{}x {:g}", name, factor), factor == 1.0 ? reference : scaled,
        [=](const Observed& seen, ensemble::Precision precision) {
          const Observed& of_one = reference->of(precision);
          Claims claims = same_on_another_clock(seen, of_one, time, precision);
          const double stored = std::pow(factor, stored_power);
          claims.push_back(claim_near("stored energy over that of x 1", seen.stored / of_one.stored, stored,
                                      rounding(precision) * stored));
          return claims;
        });
  }
}

/// The energy that a displacement stores grows with every stiffness, and by no larger a factor than the
/// stiffness that grows most (the static solution is a minimum of the energy).
Claim stored_between(double seen, const Observed& reference, double one, double other, std::string of) {
  constexpr double strictly = 1e-6;
  const auto [low, high] = std::minmax(one, other);
  return {"stored energy over that of " + std::move(of), low * (1.0 + strictly), high * (1.0 - strictly),
          seen / reference.stored};
}

/// Energies of the plate before an inclusion is put in [J]: all of it, and of the inclusion's beams.
struct WithoutInclusion {
  double all = 0, inclusion = 0;
};

/// The beams within a third of the height around the plate's middle a thousandfold and more as stiff; all
/// that follows from the lattice is computed again.
WithoutInclusion stiffen_inclusion(simulation::Prepared& p, double contrast) {
  WithoutInclusion before;
  const packing::Box& box = p.lattice.box;
  const Eigen::Vector2d middle(0.5 * box.length, 0.5 * box.height);
  for (std::size_t b = 0; b < p.lattice.beam.size(); ++b) {
    const double energy = lattice::energy_of_beam(p.lattice, static_cast<int>(b),
                                                  p.preset.scene.solver.kinematics, p.displacement);
    before.all += energy;
    const auto& [i, j] = p.lattice.ends[b];
    const Eigen::Vector2d at = 0.5 * (p.lattice.centre[i] + p.lattice.centre[j]).head<2>();
    if ((at - middle).norm() > box.height / 3.0) continue;
    before.inclusion += energy;
    lattice::Beam& beam = p.lattice.beam[b];
    beam.axial *= contrast, beam.bending *= contrast, beam.twist *= contrast;
  }
  const std::vector<char> present(p.lattice.beam.size(), 1);
  p.displacement = lattice::stretched_at_rest(p.lattice, present, p.preset.scene.loading.displacement);
  p.stable = lattice::stable_step(p.lattice);
  force_step(p, 0.4 * p.stable.critical);
  return before;
}

/// What the plate stores with the inclusion c times as stiff: less than the old displacements would
/// (U + (c - 1) U_i), more than the old stresses would (U^2 / (U - (1 - 1/c) U_i)); neither is the solution.
Claim stored_with_inclusion(double seen, const WithoutInclusion& before, double c) {
  constexpr double strictly = 1e-3;
  const double most = 1.0 + (c - 1.0) * before.inclusion / before.all;
  const double least = 1.0 / (1.0 - (1.0 - 1.0 / c) * before.inclusion / before.all);
  return {"stored energy over that of the even plate", least * (1.0 + strictly), most * (1.0 - strictly),
          seen / before.all};
}

/// A plate whose every beam is damped, at a fraction of the limit that this leaves of the step.
PlateChange damped_step(double fraction, const std::shared_ptr<double>& limit = {}) {
  return [fraction, limit](simulation::Prepared& p) {
    const double damped = simulation::damped_limit(p, simulation::damped_beams(p, p.lane), p.lane);
    if (limit) *limit = damped / p.stable.critical;
    force_step(p, fraction * damped);
  };
}

SceneChange damped(double alpha) {
  return [alpha](scene::Scene& s) {
    s.damping.alpha = alpha;
    s.damping.region = scene::DampingRegion::all;
    s.solver.dt_fraction = 1e-3;  // the case sets its own
  };
}

}  // namespace

void add_forced_steps(Cases& cases) {
  const char* family = "step of a run";
  const auto at = [](double fraction) { return plate({fmt::format("solver.dt_fraction={}", fraction)}); };
  const Memory reference = at(0.1);
  for (const double fraction : {0.1, 0.5, 0.9, 0.99})
    add(cases, family, fmt::format("{} of critical", fraction), fraction == 0.1 ? reference : at(fraction),
        [=](const Observed& seen, ensemble::Precision precision) {
          const Observed& fine = reference->of(precision);
          // Measured at 5,000 elements: +0.004 at 0.5 and +0.015 at 0.9; this plate is smaller.
          return Claims{
              claim_near("ratio less that at 0.1 of critical", seen.ratio - fine.ratio, 0.0, 0.03),
              claim_near("steps times fraction over those at 0.1 of critical",
                         static_cast<double>(seen.steps) * fraction / (static_cast<double>(fine.steps) * 0.1),
                         1.0, 2.0 / static_cast<double>(seen.steps))};
        });
  for (const char* fraction : {"1", "1.01", "2"})
    add(cases, family, fmt::format("dt_fraction = {}", fraction), CaseEnd::refused, "must lie in (0, 1)",
        {fmt::format("solver.dt_fraction={}", fraction)});
  add(cases, family, "dt = 1 us", CaseEnd::refused, "the critical step of this lattice is",
      {"solver.dt=1 us"});
  add(cases, family, "beta = 1.1", CaseEnd::refused, "must lie in (0, 1]", {"solver.beta=1.1"});
  for (const double fraction : {1.01, 1.1, 2.0})
    add(cases, family, fmt::format("{:g} of critical, the check overruled", fraction), CaseEnd::diverges, "",
        slow, {}, [fraction](simulation::Prepared& p) { force_step(p, fraction * p.stable.critical); });
  add(cases, family, "beta = 1.5, the check overruled", CaseEnd::diverges, "", slow,
      [](scene::Scene& s) { s.solver.beta = 1.5; });
}

void add_beams(Cases& cases) {
  add_scaled(cases, "stiffness of the beams", "E_mu ",
             [](double factor) {
               return [=](scene::Scene& s) {
                 beams(young * factor, poisson, ratio)(s);
                 at_velocity(0.5 * std::sqrt(factor))(s);
               };
             },
             -0.5, 1.0, {1e-6, 1e-3, 1.0, 1e3, 1e6});
  const Memory reference = plate({}, beams(young, poisson, ratio));
  for (const double nu : {-0.9, -0.5, 0.0, 0.499})
    add(cases, "Poisson's ratio of the beams", fmt::format("ν_µ = {:g}", nu),
        plate({}, beams(young, nu, ratio)), [=](const Observed& seen, ensemble::Precision precision) {
          // Only the twist stiffness changes, as G_mu = E_mu / (2 (1 + nu_mu)) does.
          return Claims{stored_between(seen.stored, reference->of(precision), 1.0,
                                       (1.0 + poisson) / (1.0 + nu), "ν_µ = 0.3")};
        });
  for (const double r : {0.02, 0.1, 0.6, 1.0})
    add(cases, "radius of the beams", fmt::format("r_µ = {:g}", r), plate({}, beams(young, poisson, r)),
        [=](const Observed& seen, ensemble::Precision precision) {
          // S grows with the square of the radius, I and I_0 with its fourth power.
          return Claims{stored_between(seen.stored, reference->of(precision), std::pow(r / ratio, 2.0),
                                       std::pow(r / ratio, 4.0), "r_µ = 0.3")};
        });
  add_scaled(cases, "density", "",
             [](double factor) {
               return [factor](scene::Scene& s) {
                 s.material.rayleigh_speed.reset();
                 s.material.density = 600.0 * factor;
               };
             },
             0.5, 0.0, {1e-6, 1e6});
  for (const double contrast : {1e-4, 1e4}) {
    const auto before = std::make_shared<WithoutInclusion>();
    add(cases, "inclusion", fmt::format("{:g} as stiff", contrast),
        plate({}, {}, [=](simulation::Prepared& p) { *before = stiffen_inclusion(p, contrast); }),
        [=](const Observed& seen, ensemble::Precision) {
          return Claims{stored_with_inclusion(seen.stored, *before, contrast)};
        });
  }
}

void add_packings(Cases& cases) {
  for (const double k : {1.0, 2.0, 5.0, 10.0, 20.0}) {
    const double spread = (k - 1.0) / (k + 1.0);
    struct Extremes {
      double least = 0, most = 0;  // of the elements in the dynamics, over the mean of all
    };
    const auto radii = std::make_shared<Extremes>();
    const auto look = [radii](simulation::Prepared& p) {
      const auto [least, most] = std::minmax_element(p.specimen.radius.begin(), p.specimen.radius.end());
      *radii = {*least / p.specimen.packing.mean_radius, *most / p.specimen.packing.mean_radius};
    };
    add(cases, "ratio of the radii", fmt::format("largest to smallest {:g}", k),
        plate(
            {"specimen.layers=5", "specimen.elements=600", "specimen.coordination=5"},
            [=](scene::Scene& s) { s.specimen.radius_spread = spread; }, look),
        [=](const Observed&, ensemble::Precision) {
          // Uniform within 1 -+ spread: of 600 the mean is known to 2.4 % of the spread, and the largest is a
          // hundredth off its bound. The smallest are rattlers.
          const double slack = 0.06 * spread + 1e-12;
          return Claims{
              claim_near("largest radius over the mean", radii->most, 1.0 + spread, slack),
              {"least radius over the mean", 1.0 - spread - slack, 1.0 - 0.5 * spread + slack, radii->least}};
        });
  }
}

void add_damping(Cases& cases) {
  const char* family = "damping";
  Memory weaker;
  std::shared_ptr<double> wider;
  for (const double alpha : {0.01, 0.1, 0.5, 1.0}) {
    const auto limit = std::make_shared<double>(std::nan(""));
    const Memory seen = plate({}, damped(alpha), damped_step(0.95, limit));
    add(cases, family, fmt::format("alpha = {:g} at 0.95 of its limit", alpha), seen,
        [=](const Observed& here, ensemble::Precision precision) {
          // One mode alone would have sqrt(1 + alpha^2) - alpha; an element feels the dampers of all its
          // beams.
          return Claims{{"limit of the step over the undamped one", 0.0,
                         wider ? *wider * (1.0 - 1e-3) : std::sqrt(1.0 + alpha * alpha) - alpha, *limit},
                        {"share of the energy that damping dissipates", 1e-6, 1.0, here.damped},
                        {"that share over the share of the weaker damping", weaker ? 1.0 + 1e-3 : 1.0,
                         without_bound, weaker ? here.damped / weaker->of(precision).damped : 1.0}};
        });
    weaker = seen, wider = limit;
    add(cases, family, fmt::format("alpha = {:g} at 1.05 of it, the check overruled", alpha),
        CaseEnd::diverges, "", slow, damped(alpha), damped_step(1.05));
  }
  add(cases, family, "alpha = 1 at 0.9 of the undamped limit", CaseEnd::refused,
      "the critical step of this lattice with this damping is",
      {"damping.alpha=1", "damping.region=all", "solver.dt_fraction=0.9"});
}

namespace {

/// G_ID / G_I0 of progressive release with r_l = 1 and of simple release over v / c_R, and with r_l = 8 at
/// 0.5 [model.md sections 9, 10: 5,000 and 20,000 elements].
struct KnownRatio {
  double over_cr, progressive, simple;
};
constexpr KnownRatio known_ratios[] = {
    {0.05, 0.896, 0.290}, {0.2, 0.736, 0.323}, {0.5, 0.575, 0.375}, {0.8, 0.346, 0.281}, {1.0, 0.122, 0.103}};
constexpr double known_with_long_zone = 0.92;
/// A window of ten mean radii holds some 17 beams, which scatter as much as their mean: a quarter of 0.6.
constexpr double scatter_of_window = 0.2;

double known_ratio(double over_cr) {
  const auto after = std::find_if(std::begin(known_ratios) + 1, std::end(known_ratios) - 1,
                                  [&](const KnownRatio& known) { return known.over_cr >= over_cr; });
  const KnownRatio &one = *(after - 1), &other = *after;
  const double t = (over_cr - one.over_cr) / (other.over_cr - one.over_cr);
  return one.progressive + t * (other.progressive - one.progressive);
}

/// The longer the zone, the less of what arrives is left to short waves, from simple release on; where it is
/// much longer than the plate all beams are soft before the tip comes, and there is little left to release.
void add_damage_zones(Cases& cases) {
  const auto zone = [](double r_l) {
    return plate({}, [r_l](scene::Scene& s) { s.crack.damage_zone_ratio = r_l; });
  };
  const auto close = [](const char* what, double expected, double slack) -> Expectation {
    return [=](const Observed& seen, ensemble::Precision) {
      return Claims{claim_near(what, seen.ratio, expected, slack)};
    };
  };
  /// Beside the case that it is compared with.
  const auto against = [](const char* what, Memory other, double low, double high) -> Expectation {
    return [=](const Observed& seen, ensemble::Precision precision) {
      return Claims{{what, low, high, seen.ratio - other->of(precision).ratio}};
    };
  };
  const char* family = "damage zone";
  const Memory simple = plate({"crack.technique=simple"}), tenth = zone(0.1), one = zone(1.0),
               ten = zone(10.0), fifty = zone(50.0);
  add(cases, family, "r_l = 0.01", zone(0.01),
      against("ratio less that of simple release", simple, -0.03, 0.03));
  add(cases, family, "r_l = 0.1", tenth, against("ratio less that of simple release", simple, 0.0, 0.2));
  add(cases, family, "r_l = 1", one, [=](const Observed& seen, ensemble::Precision precision) {
    Claims claims = close("ratio", known_ratio(0.5), scatter_of_window)(seen, precision);
    claims.push_back({"ratio less that of r_l = 0.1", 0.02, 1.0, seen.ratio - tenth->of(precision).ratio});
    return claims;
  });
  add(cases, family, "r_l = 10", ten, [=](const Observed& seen, ensemble::Precision precision) {
    Claims claims = close("ratio", known_with_long_zone, scatter_of_window)(seen, precision);
    claims.push_back({"ratio less that of r_l = 1", 0.05, 1.0, seen.ratio - one->of(precision).ratio});
    return claims;
  });
  add(cases, family, "r_l = 50", fifty, close("ratio", known_with_long_zone, scatter_of_window));
  add(cases, family, "r_l = 1000", zone(1000.0), against("ratio less that of r_l = 50", fifty, -1.0, -0.1));
}

/// What two static solutions give of a crack that ends and is read like these.
std::shared_ptr<double> at_no_velocity(const Words& overrides) {
  scene::Preset preset = plate_preset(overrides);
  base::Cache none;
  const simulation::Prepared p = simulation::prepare(preset, none);
  return std::make_shared<double>(measurement::quasi_static_ratio(p, p.lane.front().window));
}

/// The faster, the less: near the static limit for the slowest, near what is known on the way.
void add_velocities(Cases& cases, const SuiteOptions& options) {
  const char* family = "velocity";
  constexpr double slowest = 0.01;
  const std::vector<double> all{slowest, 0.1, 0.5, 0.9, 1.0, 1.5, 2.0};
  std::vector<SceneChange> lanes;
  for (const double v : all) lanes.push_back(at_velocity(v));
  const auto pass = std::make_shared<LaneBatch>(std::move(lanes));
  for (int k = 0; k < static_cast<int>(all.size()); ++k) {
    const double v = all[static_cast<std::size_t>(k)];
    const Expectation expected = [=](const Observed& seen, ensemble::Precision precision) {
      if (v == slowest)
        return Claims{claim_near("ratio less that of two static solutions", seen.ratio - *at_no_velocity({}),
                                 0.0, 0.05)};
      Claims claims{{"ratio less that of the next slower one", -1.0, v > 1.0 ? -1e-3 : -0.02,
                     seen.ratio - pass->of(k - 1, precision).ratio}};
      if (v <= 1.0) claims.push_back(claim_near("ratio", seen.ratio, known_ratio(v), scatter_of_window));
      return claims;
    };
    cases.push_back({.family = family,
                     .name = fmt::format("{:g} c_R{}", v, v > 1.0 ? ", beyond any positive limit" : ""),
                     .run = [pass, k](ensemble::Precision precision) { return pass->of(k, precision); },
                     .claims = expected});
  }
  const Words short_way{"crack.end=3 mm", "output.window=[0.03, 0.12]"};
  if (!options.quick)
    for (const double v : {1e-4, 1e-3})
      add(cases, family, fmt::format("{:g} c_R, to 3 mm", v), plate(short_way, at_velocity(v)),
          [=](const Observed& seen, ensemble::Precision) {
            return Claims{claim_near("ratio less that of two static solutions",
                                     seen.ratio - *at_no_velocity(short_way), 0.0, 0.02)};
          });
  add(cases, family, "2.5 c_r", CaseEnd::refused, "must lie in (0, 2] c_r", {"crack.velocity=2.5 c_r"});
}

/// Linear kinematics knows no strain: the ratio is that of every other. Turning beams come to it as the
/// strain vanishes, and their ratio grows with it: by 0.076 at 5 % strain and 5,000 elements. Balances of
/// turning beams close as the square of the step does.
void add_strains(Cases& cases) {
  const char* family = "pre-strain";
  const auto strained = [](double strain, const char* kinematics, double fraction) {
    return plate(
        {fmt::format("solver.kinematics={}", kinematics), fmt::format("solver.dt_fraction={}", fraction)},
        [strain](scene::Scene& s) { s.loading.displacement = strain * s.specimen.height; });
  };
  constexpr double usual = 0.05, grows = 0.076 / usual;
  const Memory linear = strained(usual, "linear", 0.5), fine = strained(usual, "linear", 0.1);
  for (const double strain : {1e-9, 1e-6, 1e-3, usual, 0.5})
    add(cases, family, fmt::format("{:g}, linear", strain),
        strain == usual ? linear : strained(strain, "linear", 0.5),
        [=](const Observed& seen, ensemble::Precision precision) {
          const Observed& at_usual = linear->of(precision);
          return Claims{
              claim_near("ratio over that of 0.05", seen.ratio / at_usual.ratio, 1.0, rounding(precision)),
              claim_near("stored energy over strain squared, over that of 0.05",
                         seen.stored / at_usual.stored * std::pow(usual / strain, 2.0), 1.0,
                         rounding(precision))};
        });
  for (const double strain : {1e-9, 1e-6, 1e-3, usual, 0.5})
    add(cases, family, fmt::format("{:g}, corotational", strain), strained(strain, "corotational", 0.1),
        [=](const Observed& seen, ensemble::Precision precision) {
          const double more = seen.ratio - fine->of(precision).ratio;
          if (strain < usual)
            return Claims{claim_near("ratio less the linear one", more, 0.0, 2.0 * grows * strain + 1e-3)};
          return Claims{
              {"ratio less the linear one", 0.02, strain == usual ? 2.0 * grows * usual : 1.0, more}};
        });
}

}  // namespace

void add_cracks(Cases& cases, const SuiteOptions& options) {
  add_damage_zones(cases);
  add_velocities(cases, options);
  add_strains(cases);
}

}  // namespace rift::stability

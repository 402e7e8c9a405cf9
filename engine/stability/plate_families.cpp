#include "engine/lattice/lattice.hpp"
#include "engine/lattice/statics.hpp"
#include "engine/stability/plate_cases.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <limits>
#include <memory>
#include <utility>

/// Families of steps, beams, packings and damping, over a plate that is packed, pulled and cracked as any
/// run's.
namespace rift::stability {
namespace {

constexpr double without_bound = std::numeric_limits<double>::infinity();

/// Beams of given E_mu, nu_mu, r_mu.
SceneChange beams(double young, double poisson, double ratio) {
  return [=](scene::Scene& s) {
    s.material.stiffness = scene::StiffnessChoice::explicit_values;
    s.material.micro_young_modulus = young, s.material.micro_poisson_ratio = poisson;
    s.material.micro_radius_ratio = ratio;
  };
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

}  // namespace rift::stability

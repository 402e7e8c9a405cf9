#include "engine/base/cache.hpp"
#include "engine/measurement/specimen_properties.hpp"
#include "engine/stability/plate_cases.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <limits>

/// Families of damage zones, velocities and pre-strains.
namespace rift::stability {
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

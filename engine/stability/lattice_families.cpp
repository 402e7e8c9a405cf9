#include "engine/ensemble/ensemble.hpp"
#include "engine/lattice/lattice.hpp"
#include "engine/lattice/stable_step.hpp"
#include "engine/lattice/statics.hpp"
#include "engine/packing/packing.hpp"
#include "engine/simulation/march.hpp"
#include "engine/stability/free_vibration.hpp"
#include "engine/stability/suite.hpp"

#include <fmt/format.h>

#include <cmath>
#include <memory>

/// Families over lattices made by hand.
namespace rift::stability {
namespace {

struct Vibrating {
  lattice::Lattice lattice = small_block(5, 5, 3);
  lattice::HighestMode mode = lattice::highest_mode(lattice);
  lattice::StableStep stable = lattice::stable_step(lattice);
};

constexpr std::int64_t growing_steps = 4000;

/// A crack at 0.5 of the speed of a bar's waves along any path of a lattice that is pulled by 1 %.
/// @param[in] least, most  beams that the path crosses
Observed crack_along(const lattice::Lattice& lattice, const fracture::CrackPath& path, double until,
                     int least, int most, ensemble::Precision precision) {
  const lattice::StableStep stable = lattice::stable_step(lattice);
  const double speed = 500.0, dt = 0.3 * stable.critical;
  const std::vector<char> present(lattice.beam.size(), 1);
  const std::vector<lattice::Vector6> base =
      lattice::stretched_at_rest(lattice, present, 0.01 * lattice.box.height);
  fracture::LaneScenario scenario;
  scenario.law = {fracture::Technique::progressive, 1.0, lattice.mean_radius};
  scenario.history = history::history_of(-scenario.law.zone_length, {{speed, until}});
  Observed seen;
  seen.limit = simulation::ledger_limit(lattice::Kinematics::linear, precision);
  const std::vector<fracture::DamageableBeam> beams = fracture::damageable_beams(path, lattice, 0.0);
  ensemble::Ensemble s(lattice, beams, dt, {scenario}, {.precision = precision},
                       std::make_shared<ensemble::PrescribedTips>(dt));
  s.start_from(base);
  s.start_crack({});
  seen.residual = 0.0;
  seen.steps = static_cast<std::int64_t>(1.2 * (until + scenario.law.zone_length) / (speed * dt));
  for (std::int64_t n = 0; n < seen.steps; ++n) {
    s.step();
    const double error = std::abs(s.balance(0).error);
    if (!(error <= seen.residual)) seen.residual = error;
  }
  int released = 0;
  double taken = 0.0;
  for (int k = 0; k < static_cast<int>(beams.size()); ++k)
    released += s.factor(k, 0) == 0.0, taken += s.fracture_energy(k, 0);
  seen.claims.push_back({"beams released", double(least), double(most), double(released)});
  seen.claims.push_back(claim_near("of the beams that the path crosses",
                                   released / static_cast<double>(beams.size()), 1.0, 0.0));
  seen.claims.push_back(claim_near("sum of their energies over the fracture energy of the balance",
                                   taken / s.balance(0).fracture, 1.0, 1e-9));
  seen.ending = seen.residual <= seen.limit ? CaseEnd::closes : CaseEnd::open;
  return seen;
}

/// Energy of a block that is pulled by 1 mm [J].
double energy_pulled(const lattice::Lattice& lattice) {
  const std::vector<char> all(lattice.beam.size(), 1);
  return lattice::elastic_energy(lattice, all, lattice::Kinematics::linear,
                                 lattice::stretched_at_rest(lattice, all, 1e-3));
}

/// Two halves that nothing joins: the upper one is lifted as a whole and nothing is strained.
Observed halves_apart(ensemble::Precision precision) {
  const lattice::Lattice lattice = small_block(4, 6, 2, true), whole = small_block(4, 6, 2);
  Observed seen = vibrate_freely(lattice, 0.9 * lattice::stable_step(lattice).critical, 2000, precision);
  seen.claims.push_back(claim_near("energy when pulled over that of the uncut block",
                                   energy_pulled(lattice) / energy_pulled(whole), 0.0, 1e-15));
  return seen;
}

Observed rattlers_only(ensemble::Precision) {
  packing::Packing packing;
  for (const double x : {1e-3, 4e-3})
    for (const double y : {1e-3, 4e-3})
      for (const double z : {1e-3, 4e-3}) packing.centre.emplace_back(x, y, z);
  packing.radius.assign(8, 1e-3);
  Observed seen;
  try {
    (void)packing::make_plate(packing, {.length = 5e-3, .height = 5e-3, .thickness = 5e-3}, 1.0);
  } catch (const packing::PackingError& error) {
    seen.ending = CaseEnd::refused;
    seen.said = error.what();
  }
  return seen;
}

}  // namespace

// The first family: its cases are those from the first on.
void add_free_vibration(Cases& cases, const SuiteOptions& options) {
  const auto block = std::make_shared<Vibrating>();
  for (const double fraction : {0.1, 0.5, 0.9, 0.99, 1.0, 1.01, 1.1, 2.0}) {
    const double dt = fraction * block->stable.critical;
    const double growth = lattice::step_of_mode(block->mode.omega * dt, 1.0).growth();
    cases.push_back({"time step", fmt::format("{:g} of critical", fraction),
                     growth > 0.0 ? CaseEnd::diverges : CaseEnd::closes, growth, "",
                     [block, dt](ensemble::Precision p) {
                       return vibrate(block->lattice, block->mode, dt, 1.0, growing_steps, p);
                     }});
  }
  // At the limit itself K + U - C is some 1e-5 of K + U: single precision cannot balance it.
  cases[4].expected_in_single = CaseEnd::open;
  for (const double beta : {0.9, 0.99, 1.0, 1.01, 1.1, 1.5}) {
    const double dt = 0.5 * block->stable.critical;
    const double growth = lattice::step_of_mode(block->mode.omega * dt, beta).growth();
    cases.push_back({"beta", fmt::format("{:g} at half the critical step", beta),
                     growth > 0.0 ? CaseEnd::diverges : CaseEnd::closes, growth, "",
                     [block, dt, beta](ensemble::Precision p) {
                       return vibrate(block->lattice, block->mode, dt, beta, growing_steps, p);
                     }});
  }
  const std::int64_t steps = options.quick ? 10'000 : 1'000'000;
  cases.push_back({"drift", fmt::format("{} steps of free vibration at 0.9 of critical", steps),
                   CaseEnd::closes, std::nan(""), "", [block, steps](ensemble::Precision p) {
                     return vibrate_freely(block->lattice, 0.9 * block->stable.critical, steps, p);
                   }});
}

void add_small_lattices(Cases& cases) {
  for (const int elements : {2, 20})
    cases.push_back({"small lattices", elements == 2 ? "two elements, one beam" : "a chain of 20 elements",
                     CaseEnd::closes, std::nan(""), "", [elements](ensemble::Precision p) {
                       const lattice::Lattice chain = small_chain(elements);
                       return vibrate_freely(chain, 0.9 * lattice::stable_step(chain).critical, 5000, p);
                     }});
  cases.push_back({"small lattices", "cut in two", CaseEnd::closes, std::nan(""), "", halves_apart});
  cases.push_back({"small lattices", "rattlers only", CaseEnd::refused, std::nan(""), "grip", rattlers_only});
}

void add_paths(Cases& cases) {
  const auto block = std::make_shared<lattice::Lattice>(small_block(12, 8, 2));
  const double r = small_spacing;
  const auto add = [&](const char* name, const fracture::CrackPath& path, double until, int least, int most) {
    cases.push_back({"crack path", name, CaseEnd::closes, std::nan(""), "", [=](ensemble::Precision p) {
                       return crack_along(*block, path, until, least, most, p);
                     }});
  };
  // Between two rows: 12 x 2 upright beams and 2 x 11 x 2 diagonal ones. The others were counted apart;
  // aslant, where rounding decides to which side a centre on the path belongs, 40 if all belong to one.
  add("through the rows", {{{0, 4.0 * r}, {12 * r, 4.0 * r}}}, 12 * r, 68, 68);
  add("along a row of beams", {{{0, 4.5 * r}, {12 * r, 4.5 * r}}}, 12 * r, 68, 68);
  add("through the elements' centres, inclined", {{{0, 2.0 * r}, {5 * r, 7.0 * r}}}, 7 * r, 40, 48);
  add("leaving the plate", {{{0, 4.0 * r}, {6 * r, 4.0 * r}, {18 * r, 16.0 * r}}}, 20 * r, 66, 66);
  add("crossing itself",
      {{{0, 3.0 * r}, {8 * r, 3.1 * r}, {8.2 * r, 5.1 * r}, {4.1 * r, 5.0 * r}, {4.3 * r, 2.0 * r}}}, 17 * r,
      92, 92);
}

GrowthCurve growth_around_the_limit() {
  const Vibrating v;
  const double truth = 2.0 / v.mode.omega;
  GrowthCurve curve{v.stable.element_bound / truth, v.stable.critical / truth, {}, {}, {}};
  for (const double x : {0.5,    0.6,    0.7,   0.8,   0.85,  0.9,  0.95, 0.98, 0.99, 0.995, 0.999, 0.9999,
                         1.0001, 1.0003, 1.001, 1.002, 1.005, 1.01, 1.02, 1.03, 1.05, 1.07,  1.1}) {
    curve.step.push_back(x);
    curve.expected.push_back(lattice::step_of_mode(2.0 * x, 1.0).growth());
    curve.seen.push_back(
        vibrate(v.lattice, v.mode, x * truth, 1.0, growing_steps, ensemble::Precision::double_precision)
            .growth);
  }
  return curve;
}

}  // namespace rift::stability

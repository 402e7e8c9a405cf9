#include "engine/simulation/summary.hpp"
#include "tests/engine/simulation/small_plate.hpp"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <cmath>

namespace rift::simulation {
namespace {

TEST(PreStress, ByARampStoresWhatTheStaticSolveSaysOfTheGripsWork) {
  const Prepared ramp =
      small_plate({"loading.method=ramp", "loading.ramp_steps=6000", "loading.hold_steps=3000"});
  const Prepared at_once = small_plate();
  const RunResult pulled = march(ramp, {}), released = march(at_once, {});
  ASSERT_EQ(pulled.outcome, Outcome::finished) << pulled.lane[0].where;
  EXPECT_NEAR(pulled.lane[0].energy_at_crack_start / at_once.static_energy, 1.0, 0.01);  // model.md §4
  EXPECT_LT(pulled.lane[0].prestress_kinetic, 0.01);
  const double by_ramp = rates_of(ramp, pulled).plateau.mean.ratio,
               by_solve = rates_of(at_once, released).plateau.mean.ratio;
  EXPECT_NEAR(by_ramp, by_solve, 0.02);  // what still swings after the ramp: below 1 % of the energy
  const results::Sample& end = pulled.lane[0].samples.back();
  // Pulled slowly, the plate stores nearly all of the grip's work before it cracks.
  EXPECT_NEAR(pulled.lane[0].energy_at_crack_start / end.work_external_j, 1.0, 0.05);
  EXPECT_GE(end.numerical_damping_j, 0.0);
}

/// The bulk set on a lattice of its own, which "bulk" does without.
const std::vector<std::string> bulk_beams{
    "material.stiffness=explicit", "material.micro_young_modulus=356 GPa", "material.micro_poisson_ratio=0.3",
    "material.micro_radius_ratio=0.3"};

// Other stiffness, other time and energy, on one lattice.
TEST(Scaling, BulkBeamsAreThoseOfALatticeOfTheirOwn) {
  for (const std::string kinematics : {"linear", "corotational"}) {
    std::vector<std::string> common{"crack.velocity=0.6 c_r", "damping.alpha=0.01", "damping.region=all",
                                    "solver.dt=1e-7 s", "solver.kinematics=" + kinematics};
    std::vector<std::string> own_keys = common, bulk_keys = common;
    own_keys.insert(own_keys.end(), bulk_beams.begin(), bulk_beams.end());
    bulk_keys.push_back("material.stiffness=bulk");
    const Prepared own = small_plate(own_keys), bulk = small_plate(bulk_keys);
    ASSERT_LT(bulk.micro.young_modulus, 0.95 * own.micro.young_modulus);
    const RunResult a = march(own, {}), b = march(bulk, {});
    const std::vector<results::Sample>&rows = a.lane[0].samples, &scaled = b.lane[0].samples;
    ASSERT_EQ(rows.size(), scaled.size());
    EXPECT_NEAR(scaled.back().time_s / rows.back().time_s, 1.0, 1e-12);
    EXPECT_NEAR(scaled.back().velocity_m_s / rows.back().velocity_m_s, 1.0, 1e-12);
    for (double results::Sample::*column :
         {&results::Sample::elastic_j, &results::Sample::kinetic_translation_j,
          &results::Sample::kinetic_rotation_j, &results::Sample::step_correction_j,
          &results::Sample::fracture_j, &results::Sample::damping_j})
      EXPECT_NEAR(scaled.back().*column / rows.back().*column, 1.0, 1e-6) << kinematics;
    EXPECT_NEAR(scale_of(bulk, bulk.lane[0]).g_i0 / own.scale.g_i0, 1.0, 1e-9);
    EXPECT_NEAR(b.lane[0].energy_at_crack_start / a.lane[0].energy_at_crack_start, 1.0, 1e-9);
  }
}

// model.md §5: in linear kinematics the ratio at v with E_mu is that at v sqrt(E_mu'/E_mu) with E_mu' over
// the same window: time scales, nothing else does.
TEST(Scaling, BulkBeamsAtAVelocityAreInSituBeamsAtALowerOne) {
  const auto plateau = [](const std::vector<std::string>& overrides, double& micro) {
    std::vector<std::string> all{"solver.dt_fraction=0.4", "output.window=[0.2, 0.4]"};
    all.insert(all.end(), overrides.begin(), overrides.end());
    const Prepared p = small_plate(all);
    micro = p.micro.young_modulus;
    return rates_of(p, march(p, {})).plateau;
  };
  double bulk_micro = 0.0, in_situ_micro = 0.0;
  plateau({}, in_situ_micro);
  for (const std::string technique : {"simple", "progressive"})
    for (const double v : {0.3, 0.7, 1.0}) {
      std::vector<std::string> of_bulk{fmt::format("crack.velocity={} c_r", v),
                                       "crack.technique=" + technique};
      of_bulk.insert(of_bulk.end(), bulk_beams.begin(), bulk_beams.end());
      const fracture::Plateau bulk = plateau(of_bulk, bulk_micro);
      const double scaled = v * std::sqrt(in_situ_micro / bulk_micro);
      ASSERT_LT(scaled, 0.95 * v);
      const fracture::Plateau in_situ = plateau(
          {fmt::format("crack.velocity={} c_r", scaled), "crack.technique=" + technique}, in_situ_micro);
      const fracture::Plateau unscaled =
          plateau({fmt::format("crack.velocity={} c_r", v), "crack.technique=" + technique}, in_situ_micro);
      ASSERT_TRUE(bulk.reached && in_situ.reached);
      // The step scales as well but for the Lanczos margin of 1e-5.
      EXPECT_NEAR(bulk.mean.ratio, in_situ.mean.ratio, 1e-3) << technique << v;
      EXPECT_GT(std::abs(bulk.mean.ratio - unscaled.mean.ratio), 0.01) << technique << v;
    }
}

// What the lattice does whatever its size   [model.md §9]: a faster crack is paid less, a progressive
// release more than a simple one, and rates by the two ways agree to the residual of the books.
TEST(Rates, FallWithVelocityAndRiseWithAProgressiveRelease) {
  const auto plateau = [](const std::string& technique, const std::string& velocity) {
    const Prepared p = small_plate(
        {"crack.technique=" + technique, "crack.velocity=" + velocity, "output.window=[0.2, 0.4]"});
    const fracture::Plateau found = rates_of(p, march(p, {})).plateau;
    EXPECT_TRUE(found.reached);
    EXPECT_NEAR(found.mean.ratio_difference, 0.0, 1e-10);
    return found.mean.ratio;
  };
  const double slow = plateau("progressive", "0.2 c_r"), middle = plateau("progressive", "0.5 c_r"),
               fast = plateau("progressive", "1.0 c_r");
  EXPECT_GT(slow, middle);
  EXPECT_GT(middle, fast);
  EXPECT_GT(slow, plateau("simple", "0.2 c_r"));
}

}  // namespace
}  // namespace rift::simulation

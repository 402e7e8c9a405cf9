#include "engine/simulation/prepare.hpp"

#include "engine/base/interrupted.hpp"
#include "engine/calibration/calibrate.hpp"
#include "engine/lattice/statics.hpp"
#include "engine/reference/plain_simulation.hpp"
#include "engine/simulation/own_constants.hpp"
#include "tests/engine/simulation/small_plate.hpp"
#include "tests/expectations.hpp"
#include "tests/temporary_folder.hpp"

#include <fmt/format.h>

#include <bit>
#include <cmath>
#include <cstdint>
#include <numbers>

namespace rift::simulation {
namespace {

std::string refusal(const std::vector<std::string>& overrides) {
  try {
    small_plate(overrides);
  } catch (const scene::InputError& error) {
    return error.what();
  }
  return "not refused";
}

/// Energy of the beams in the middle half of the plate [J], by the forces on them: 1/2 of displacement x
/// load.
double middle_half_energy(const lattice::Lattice& lattice, const std::vector<lattice::Vector6>& q) {
  double energy = 0.0;
  for (std::size_t b = 0; b < lattice.beam.size(); ++b) {
    const auto& [i, j] = lattice.ends[b];
    const double middle = 0.5 * (lattice.centre[i].x() + lattice.centre[j].x()) / lattice.box.length;
    if (middle < 0.25 || middle >= 0.75) continue;
    const lattice::BeamLoads l = lattice::loads_of(lattice.beam[b], q[i], q[j]);
    energy += 0.5 * (l.force_i.dot(q[j].head<3>() - q[i].head<3>()) - l.moment_i.dot(q[i].tail<3>()) -
                     l.moment_j.dot(q[j].tail<3>()));
  }
  return energy;
}

// Another solve, on the lattice with its final modulus, and another way to the energy than prepare()'s.
TEST(Prepare, InSituBeamsMakeAStripOfTheMaterialsOwnModulus) {
  const Prepared p = small_plate({"material.poisson_ratio=0.25"});
  const std::vector<char> all(p.lattice.beam.size(), 1);
  const double delta = 1e-4,
               energy = middle_half_energy(p.lattice, lattice::stretched_at_rest(p.lattice, all, delta));
  const double modulus = 2.0 * (energy / 0.024) * 0.012 / (p.lattice.box.thickness * delta * delta);
  const double wanted = 10e9 / (1.0 - 0.25 * 0.25);
  EXPECT_NEAR(modulus / wanted, 1.0, 1e-9);
  EXPECT_NEAR(p.strip_modulus / wanted, 1.0, 1e-9);
}

// 1/2 E' (delta/H)^2 H, energy per area of the strip.
TEST(Prepare, StripReferenceIsTheContinuumsWithInSituBeams) {
  const Prepared p = small_plate();
  EXPECT_NEAR(p.scale.g_i0 / (0.5 * 10e9 / 0.91 * 0.6e-3 * 0.6e-3 / 0.012), 1.0, 1e-9);
  EXPECT_EQ(p.scale.length, 0.048);
  EXPECT_EQ(p.scale.thickness, p.lattice.box.thickness);
}

const std::vector<std::string> two_tips{"crack.tips=2", "output.window=[0.2, 0.4]"};

std::vector<std::string> two_tips_and(std::vector<std::string> more) {
  more.insert(more.end(), two_tips.begin(), two_tips.end());
  return more;
}

// pi sigma^2 a / E' with sigma = 2 G_strip / delta, and E' of what the specimen stores over the height that is
// strained, with its own nu.
TEST(Prepare, GriffithsReferenceIsTheCentralCracksOfTheSpecimensOwnStress) {
  const Prepared p = small_plate(two_tips_and({"output.g_i0_reference=griffith"}));
  const OwnConstants own = own_constants(p, shared_cache());
  const double strip = small_plate(two_tips).scale.g_i0, delta = 0.6e-3, sigma = 2.0 * strip / delta;
  const double modulus = sigma / (delta / own.between_grips);  // of the strip: E' / (1 - nu^2)
  const double e_prime = modulus * (1.0 - std::pow(own.poisson_ratio(), 2.0));
  EXPECT_NEAR(p.scale.g_i0_slope / (std::numbers::pi * sigma * sigma / e_prime), 1.0, 1e-9);
  EXPECT_EQ(p.scale.g_i0, 0.0);
  EXPECT_EQ(p.scale.tips, 2);
  const Prepared bulk =
      small_plate(two_tips_and({"output.g_i0_reference=griffith", "material.stiffness=bulk"}));
  EXPECT_NEAR(bulk.scale.g_i0_slope / p.scale.g_i0_slope, bulk.strip_modulus / p.strip_modulus, 1e-9);
}

TEST(Prepare, TwoTipsKeepTheStripsReferenceUnlessToldOtherwise) {
  const Prepared two = small_plate(two_tips), one = small_plate();
  EXPECT_EQ(two.scale.g_i0, one.scale.g_i0);
  EXPECT_EQ(two.scale.g_i0_slope, 0.0);
  EXPECT_EQ(two.scale.tips, 2);
  EXPECT_EQ(one.scale.tips, 1);
}

TEST(Prepare, BulkAndExplicitBeamsAreTakenAsTheyAre) {
  const Prepared bulk = small_plate({"material.stiffness=bulk"});
  const LaneUnits units = bulk.lane[0].units;
  EXPECT_NEAR(bulk.micro.young_modulus * units.energy / 356e9, 1.0, 1e-12);
  EXPECT_GT(bulk.strip_modulus * units.energy, 1.2 * 10e9 / 0.91);  // a thin plate is stiffer than the bulk
  EXPECT_NEAR(wave_speed_ratio(bulk, bulk.lane[0]), 1.0 / units.time, 1e-9);
  const Prepared own = small_plate({"material.stiffness=explicit", "material.micro_young_modulus=178 GPa",
                                    "material.micro_poisson_ratio=0.3", "material.micro_radius_ratio=0.3"});
  EXPECT_NEAR(own.strip_modulus / (bulk.strip_modulus * units.energy), 0.5, 1e-9);  // all go with E_mu
  EXPECT_NEAR(own.step.critical / (bulk.step.critical * units.time), std::sqrt(2.0), 1e-6);
}

TEST(Prepare, CalibratedBeamsAreThoseOfCylindersOfTheScenesMaterial) {
  const Prepared plate =
      small_plate({"material.stiffness=calibrated", "material.poisson_ratio=0.25", "calibration.elements=400",
                   "calibration.packings=2", "calibration.radius_ratios=[0.2, 0.4, 0.8]"});
  base::Cache none;
  const lattice::MicroMaterial beams = calibration::calibrate(plate.preset.scene, 10e9, 0.25, none).micro;
  EXPECT_EQ(plate.micro.young_modulus, beams.young_modulus);
  EXPECT_EQ(plate.micro.radius_ratio, beams.radius_ratio);
  EXPECT_NE(plate.micro.radius_ratio, 0.3);
  EXPECT_EQ(plate.lane[0].units.energy, 1.0);
}

TEST(Prepare, SaysWhichPoissonsRatiosCylindersCanHave) {
  try {
    small_plate({"material.stiffness=calibrated", "material.poisson_ratio=0.49", "calibration.elements=300",
                 "calibration.packings=1", "calibration.radius_ratios=[0.3, 0.6]"});
    FAIL();
  } catch (const scene::InputError& error) {
    EXPECT_NE(
        std::string(error.what())
            .find("material.poisson_ratio=0.49: 0.49 is out of reach of these beams: the cylinders show 0."),
        std::string::npos)
        << error.what();
  }
}

/// What prepare() says to a specimen of this shape.
std::string answer_to(const std::string& specimen) {
  const scene::Preset preset = scene::read_preset_text("[specimen]\nelements = 600\n" + specimen, "x.toml");
  EXPECT_TRUE(preset.issues.empty());
  try {
    return fmt::format("prepared {} mm", 1e3 * prepare(preset, shared_cache()).lattice.box.thickness);
  } catch (const scene::InputError& error) {
    return error.what();
  }
}

TEST(Prepare, CracksBlocksAndNoOtherShape) {
  EXPECT_EQ(answer_to("shape = \"block\"\nlength = \"60 mm\"\nheight = \"12 mm\"\nthickness = \"3 mm\"\n"
                      "coordination = 5.7"),
            "prepared 3 mm");
  for (const std::string shape :
       {"shape = \"cylinder\"", "shape = \"sphere\"", "shape = \"periodic\"\nthickness = \"40 mm\""})
    EXPECT_TRUE(contains(answer_to(shape), "cannot be cracked: plates and blocks are")) << shape;
}

/// Largest force on a free element from the beams that are there, over the largest force of any beam.
double unbalanced(const Prepared& p, double notch_end) {
  reference::PlainSimulation s(p.lattice, fracture::damageable_beams(p.path, p.lattice, notch_end), p.step.dt,
                               p.lane[0].scenario);
  s.start_from(p.displacement);
  double worst = 0.0, largest = 0.0;
  for (int i = 0; i < static_cast<int>(p.lattice.centre.size()); ++i) {
    const double force = s.motion(s.f, i).head<3>().norm();
    if (p.lattice.grip[i] == packing::Grip::none) worst = std::max(worst, force);
    largest = std::max(largest, force);
  }
  return worst / largest;
}

TEST(Prepare, NotchedBeamsAreAbsentFromThePreStressOn) {
  const Prepared notched = small_plate({"crack.start=0.008"}), whole = small_plate();
  EXPECT_LT(unbalanced(notched, 0.008), 1e-9);
  EXPECT_GT(unbalanced(notched, 0.0), 1e-2);  // with the cut beams in place nothing would be at rest
  EXPECT_LT(unbalanced(whole, 0.0), 1e-9);
  EXPECT_LT(notched.static_energy, 0.95 * whole.static_energy);
  EXPECT_EQ(notched.scale.g_i0, whole.scale.g_i0);  // of the strip without its notch
  EXPECT_EQ(notched.micro.young_modulus, whole.micro.young_modulus);
  ensemble::CrackedEnsemble s = ready(notched);
  int cut = 0;
  ASSERT_FALSE(s.damageable().empty());
  for (int k = 0; k < static_cast<int>(s.damageable().size()); ++k) {
    EXPECT_EQ(s.factor(k, 0), s.damageable()[k].position <= 0.008 ? 0.0 : 1.0);
    cut += s.factor(k, 0) == 0.0 ? 1 : 0;
  }
  EXPECT_GT(cut, 10);
  EXPECT_NEAR(s.balance(0).elastic / notched.static_energy, 1.0, 1e-12);
}

TEST(Prepare, NotchOfTwoTipsLiesInTheMiddleAndIsSolvedForItself) {
  const TemporaryFolder folder;
  base::Cache cache{folder.path(), {}};
  prepare(small_preset({"crack.start=0.008"}), cache);
  const Prepared p = prepare(small_preset(two_tips_and({"crack.start=0.008"})), cache);
  EXPECT_TRUE(p.packing_from_cache);
  EXPECT_FALSE(p.statics_from_cache);
  EXPECT_LT(unbalanced(p, 0.008), 1e-9);
  int left = 0, right = 0;
  ensemble::CrackedEnsemble s = ready(p);
  ASSERT_FALSE(s.damageable().empty());
  for (int k = 0; k < static_cast<int>(s.damageable().size()); ++k) {
    const auto& [i, j] = p.lattice.ends[s.damageable()[k].beam];
    const double x = 0.5 * (p.lattice.centre[i].x() + p.lattice.centre[j].x()) - 0.024;
    if (s.factor(k, 0) == 0.0) ++(x < 0.0 ? left : right);
    if (std::abs(x) < 0.007) {
      EXPECT_EQ(s.factor(k, 0), 0.0);
    } else if (std::abs(x) > 0.009) {
      EXPECT_EQ(s.factor(k, 0), 1.0);
    }
  }
  EXPECT_GT(left, 10);
  EXPECT_GT(right, 10);
}

TEST(Prepare, HistoryBeginsAZonesLengthBehindTheNotch) {
  const Prepared p = small_plate({"crack.start=0.008", "crack.damage_zone_ratio=2.5"});
  EXPECT_DOUBLE_EQ(p.lane[0].scenario.law.zone_length, 2.5 * p.lattice.mean_radius);
  EXPECT_DOUBLE_EQ(history::tip_at(p.lane[0].scenario.history, 0.0), 0.008 - 2.5 * p.lattice.mean_radius);
  const Prepared simple = small_plate({"crack.start=0.008", "crack.technique=simple"});
  EXPECT_DOUBLE_EQ(history::tip_at(simple.lane[0].scenario.history, 0.0), 0.008);
  EXPECT_EQ(simple.lane[0].scenario.law.zone_length, 0.0);
}

TEST(Prepare, DampsTheBeamsNearThePathOrAllOrNone) {
  EXPECT_TRUE(small_plate().damped.empty());
  const Prepared all = small_plate({"damping.alpha=0.0002", "damping.region=all"});
  EXPECT_EQ(all.damped.size(), all.lattice.beam.size());
  EXPECT_EQ(all.lane[0].scenario.alpha_elsewhere, 0.0002);
  const Prepared surface = small_plate({"damping.alpha=0.001", "damping.region=surface"});
  EXPECT_EQ(surface.lane[0].scenario.alpha_at_surface, 0.001);
  EXPECT_EQ(surface.lane[0].scenario.alpha_elsewhere, 0.0);
  const double near = 1.5 * surface.lattice.mean_radius;
  const auto is_near = [&](int i) { return std::abs(surface.lattice.centre[i].y() - 0.006) <= near; };
  std::size_t expected = 0;
  for (const auto& [i, j] : surface.lattice.ends) expected += is_near(i) || is_near(j) ? 1 : 0;
  EXPECT_EQ(surface.damped.size(), expected);
  EXPECT_GT(expected, 50U);
  for (const lattice::DampedBeam& b : surface.damped) EXPECT_TRUE(is_near(b.i) || is_near(b.j));
}

TEST(Prepare, RefusesAPathThatCrossesNoBeam) {
  EXPECT_EQ(refusal({"crack.path=1 um"}), "--set crack.path=1 um: crosses no beam of this lattice");
}

TEST(Prepare, RefusesACoordinationThatThePlateCannotHave) {
  const std::string text = refusal({"specimen.coordination=6.9"});
  EXPECT_TRUE(contains(text, "specimen.coordination=6.9: a coordination of 6.9 is out of reach"));
}

TEST(Prepare, StopsWhenToldToWhilePacking) {
  base::Cache none;
  int asked = 0;
  try {
    prepare(small_preset(), none, [&](std::string_view, double) { return ++asked < 3; });
    ADD_FAILURE() << "went on";
  } catch (const base::Interrupted& stopped) {
    EXPECT_STREQ(stopped.what(), "stopped while packing");
  }
  EXPECT_EQ(asked, 3);
}

TEST(Prepare, GivesTheSameBitsFromTheCacheAndRebuildsADamagedOne) {
  const TemporaryFolder folder;
  base::Cache cache{folder.path(), {}};
  const scene::Preset preset = small_preset({"crack.start=0.008"});
  const Prepared first = prepare(preset, cache), second = prepare(preset, cache);
  EXPECT_FALSE(first.packing_from_cache || first.statics_from_cache);
  EXPECT_TRUE(second.packing_from_cache && second.statics_from_cache);
  EXPECT_TRUE(cache.notes.empty());
  EXPECT_EQ(first.specimen.centre, second.specimen.centre);
  EXPECT_EQ(first.displacement, second.displacement);
  EXPECT_EQ(first.step.dt, second.step.dt);
  EXPECT_EQ(first.scale.g_i0, second.scale.g_i0);

  int damaged = 0;
  for (const auto& entry : std::filesystem::directory_iterator(folder.path())) {
    std::string bytes = read_text(entry.path());
    bytes[bytes.size() / 2] ^= 4;
    write_text(entry.path(), bytes);
    ++damaged;
  }
  EXPECT_EQ(damaged, 4);  // packing, whole plate, notched plate, critical step
  const Prepared third = prepare(preset, cache);
  EXPECT_FALSE(third.packing_from_cache || third.statics_from_cache);
  EXPECT_EQ(cache.notes.size(), 4U);
  EXPECT_EQ(first.displacement, third.displacement);
  cache.notes.clear();
  EXPECT_TRUE(prepare(preset, cache).packing_from_cache);
  EXPECT_TRUE(cache.notes.empty());
}

// A cached packing, or stretch, of one plate must never serve another.
TEST(Prepare, TakesNothingFromTheCacheOfAnotherPlate) {
  const TemporaryFolder folder;
  base::Cache cache{folder.path(), {}};
  prepare(small_preset({"crack.start=0.008"}), cache);
  for (const std::string other : {"specimen.seed=2", "specimen.radius_spread=0.1", "specimen.length=0.0481",
                                  "specimen.coordination=5.6"}) {
    EXPECT_FALSE(prepare(small_preset({"crack.start=0.008", other}), cache).packing_from_cache) << other;
  }
  for (const std::string other :
       {"crack.start=0.009", "crack.path=0.4 H", "specimen.contact_tolerance=1.001"}) {
    const Prepared p = prepare(small_preset({"crack.start=0.008", other}), cache);
    EXPECT_TRUE(p.packing_from_cache) << other;
    EXPECT_FALSE(p.statics_from_cache) << other;
  }
  const Prepared p = prepare(
      small_preset({"crack.start=0.008", "loading.displacement=0.0003", "material.young_modulus=5 GPa"}),
      cache);
  EXPECT_TRUE(p.statics_from_cache) << "linear: one solve serves any displacement and modulus";
}

TEST(Prepare, RefusesWhatFollowsFromTheLatticeAndIsOutOfItsRange) {
  EXPECT_TRUE(contains(refusal({"crack.velocity=1e-300 c_r"}), "--set crack.velocity=1e-300 c_r: with "));
  EXPECT_TRUE(contains(refusal({"crack.velocity=1e-300 c_r"}), " steps, which must lie in [0, 1e+12] steps"));
  EXPECT_TRUE(contains(refusal({"solver.dt=1e-40"}), "makes a step of 1e-40 s, which must lie in"));
  EXPECT_TRUE(contains(refusal({"loading.force=1e-200"}), "--set loading.force=1e-200: with "));
  EXPECT_TRUE(contains(refusal({"loading.force=1e-200"}), "makes a strain of "));
  EXPECT_EQ(refusal({"crack.velocity=1e-6 c_r"}), "not refused");
}

/// How often the stage of the damped critical step reports progress while these lanes are prepared.
int rounds_of_the_damped_limit(const std::vector<scene::Scene>& lanes, base::Cache& cache) {
  int told = 0;
  prepare(small_preset(), lanes, cache, [&](std::string_view stage, double) {
    told += stage == "critical step with damping";
    return true;
  });
  return told;
}

scene::Scene damped_by(double alpha) {
  scene::Scene scene = small_preset({"damping.region=all", "damping.alpha=0.01"}).scene;
  scene.damping.alpha = alpha;
  return scene;
}

// It depends on what is damped and how much, and on nothing else of a lane.
TEST(Prepare, ComputesTheDampedLimitOnceForLanesThatDampAlike) {
  base::Cache none;
  const scene::Scene damped = damped_by(0.01), harder = damped_by(0.02);
  scene::Scene faster = damped;
  faster.crack.velocity = {{{0.7, true}, {}}};
  const int once = rounds_of_the_damped_limit({damped}, none);
  EXPECT_GT(once, 50);
  EXPECT_EQ(rounds_of_the_damped_limit({damped, faster, faster}, none), once);
  EXPECT_GT(rounds_of_the_damped_limit({damped, faster, harder}, none), once);
}

TEST(Prepare, TakesTheLimitsOfTheStepFromTheCache) {
  const TemporaryFolder folder;
  base::Cache cache{folder.path(), {}};
  const scene::Scene damped = damped_by(0.01);
  EXPECT_GT(rounds_of_the_damped_limit({damped}, cache), 50);
  EXPECT_EQ(rounds_of_the_damped_limit({damped}, cache), 0);
  EXPECT_GT(rounds_of_the_damped_limit({damped_by(0.02)}, cache), 50);
  scene::Scene surface = damped;
  surface.damping.region = scene::DampingRegion::surface;
  EXPECT_GT(rounds_of_the_damped_limit({surface}, cache), 50);
  int told = 0;
  const Prepared p = prepare(small_preset(), {damped, surface}, cache, [&](std::string_view stage, double) {
    told += stage.starts_with("critical step");
    return true;
  });
  EXPECT_EQ(told, 0);
  base::Cache none;
  const Prepared fresh = prepare(small_preset(), {damped, surface}, none);
  EXPECT_EQ(p.stable.critical, fresh.stable.critical);
  EXPECT_EQ(p.stable.element_bound, fresh.stable.element_bound);
  for (const int lane : {0, 1})
    EXPECT_EQ(p.lane[lane].step.critical_damped, fresh.lane[lane].step.critical_damped);
  EXPECT_LT(p.lane[0].step.critical_damped, p.lane[1].step.critical_damped);
}

TEST(Prepare, ForgetsTheLimitsOfAStepOfOtherMassesOrBeams) {
  const TemporaryFolder folder;
  base::Cache cache{folder.path(), {}};
  const double usual = prepare(small_preset(), cache).stable.critical,
               heavier = prepare(small_preset({"material.density=1000"}), cache).stable.critical,
               softer = prepare(small_preset({"material.young_modulus=5 GPa"}), cache).stable.critical;
  EXPECT_GT(heavier, 1.05 * usual);
  EXPECT_NEAR(softer, usual, 1e-9 * usual);  // the density follows from the same Rayleigh speed
  base::Cache none;
  EXPECT_EQ(softer, prepare(small_preset({"material.young_modulus=5 GPa"}), none).stable.critical);
}

TEST(Prepare, StopsWhileTheCriticalStepIsComputed) {
  const TemporaryFolder folder;
  base::Cache cache{folder.path(), {}};
  for (const char* at : {"critical step", "critical step with damping"}) try {
      prepare(small_preset({"damping.alpha=0.01", "damping.region=all"}), cache,
              [&](std::string_view stage, double) { return stage != at; });
      FAIL() << "went on";
    } catch (const base::Interrupted& stopped) {
      EXPECT_STREQ(stopped.what(), "stopped while computing the critical step");
    }
}

}  // namespace
}  // namespace rift::simulation

#include "engine/simulation/summary.hpp"
#include "tests/engine/simulation/small_plate.hpp"

#include <fmt/format.h>

#include <cmath>

namespace rift::ensemble {
namespace {

double ratio_with(const std::vector<std::string>& overrides) {
  std::vector<std::string> all{"crack.velocity=0.3 c_r", "output.frames=0"};
  all.insert(all.end(), overrides.begin(), overrides.end());
  const simulation::Prepared p = simulation::small_plate(all);
  const simulation::RunResult result = simulation::march(p, {});
  EXPECT_EQ(result.outcome, simulation::Outcome::finished) << result.lane[0].where;
  const fracture::Plateau plateau = simulation::rates_of(p, result).plateau;
  EXPECT_TRUE(plateau.reached);
  return plateau.mean.ratio;
}

// The bound is the issue's; what is measured is some 1e-6.
TEST(SinglePrecision, ChangesTheRatioByLessThanTwoThousandths) {
  for (const std::string kinematics : {"linear", "corotational"})
    for (const std::string technique : {"simple", "progressive"}) {
      const std::vector<std::string> scene{"solver.kinematics=" + kinematics, "crack.technique=" + technique};
      std::vector<std::string> in_single = scene;
      in_single.push_back("solver.precision=single");
      EXPECT_NEAR(ratio_with(in_single), ratio_with(scene), 0.002) << kinematics << ' ' << technique;
    }
}

// Pulled a hundredth as far, the plate strains by 0.05 %: what corotation adds shrinks with the strain.
TEST(CorotationalPlate, TendsToTheLinearOneForSmallStrains) {
  const double linear = ratio_with({});
  const double far = ratio_with({"solver.kinematics=corotational"});
  const double near = ratio_with({"solver.kinematics=corotational", "loading.displacement=6 um"});
  EXPECT_NEAR(near, linear, 0.005);
  EXPECT_GT(std::abs(far - linear), 5.0 * std::abs(near - linear));
}

/// The worst residual of a crack that releases its beams at once.
double worst_residual_at(double fraction, const std::string& velocity) {
  const simulation::Prepared p =
      simulation::small_plate({"solver.kinematics=corotational", "crack.technique=simple", "output.frames=0",
                               "crack.velocity=" + velocity, fmt::format("solver.dt_fraction={}", fraction)});
  return simulation::march(p, {}).lane[0].worst_residual;
}

// What is left are third derivatives of the strains: an error of the step, which falls with its square.
TEST(CorotationalBooks, CloseBetterTheSmallerTheStep) {
  const double coarse = worst_residual_at(0.5, "0.5 c_r"), fine = worst_residual_at(0.125, "0.5 c_r");
  EXPECT_GT(coarse, 1e-8);  // there is something to see
  EXPECT_LT(fine, coarse / 8.0);
}

// Release at once fills the highest modes, which beams that turn pass on to lower ones. With forces of this
// moment's directions velocity Verlet makes energy of that: 3.6e-4 at 0.5 c_r, 2.0e-4 at 0.1 c_r.
// [model.md §3]
TEST(CorotationalBooks, StayWithinTheirLimitUnderReleaseAtOnce) {
  EXPECT_LT(worst_residual_at(0.5, "0.5 c_r"), 1e-4);
  EXPECT_LT(worst_residual_at(0.5, "0.1 c_r"), 1e-4);
}

}  // namespace
}  // namespace rift::ensemble

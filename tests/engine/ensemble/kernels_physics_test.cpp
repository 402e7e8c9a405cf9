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

/// The residual at the end of one and the same stretch of the crack.
double residual_at(double fraction) {
  const simulation::Prepared p =
      simulation::small_plate({"solver.kinematics=corotational", "crack.technique=simple", "output.frames=0",
                               fmt::format("solver.dt_fraction={}", fraction)});
  return std::abs(simulation::march(p, {}).lane[0].samples.back().residual);
}

// Velocity Verlet keeps K + U - C exactly for linear forces only. Brutal release fills the highest modes, and
// what corotation makes of them is an error of the step, which falls at least with its square.
TEST(CorotationalBooks, CloseBetterTheSmallerTheStep) {
  const double coarse = residual_at(0.5), fine = residual_at(0.125);
  EXPECT_GT(coarse, 1e-6);  // there is something to see
  EXPECT_LT(fine, coarse / 8.0);
}

}  // namespace
}  // namespace rift::ensemble

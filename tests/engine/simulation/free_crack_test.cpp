#include "engine/simulation/record.hpp"
#include "engine/simulation/summary.hpp"
#include "tests/engine/simulation/small_plate.hpp"

namespace rift::simulation {
namespace {

/// A notched plate pulled apart by tractions, whose beams break by themselves.
Prepared pulled_apart(const std::vector<std::string>& more = {}) {
  std::vector<std::string> overrides{
      "loading.traction=13 MPa", "loading.rise_time=1 us",        "crack.start=12 mm",
      "fracture.law=cohesive",   "fracture.release_rate=2 kJ/m2", "fracture.strength=200 MPa",
      "fracture.duration=60 us"};
  overrides.insert(overrides.end(), more.begin(), more.end());
  return small_plate(overrides);
}

TEST(FreeCrack, RunsFromTheNotchAndSaysWhatBroke) {
  const Prepared p = pulled_apart();
  std::vector<results::ReleaseEvent> events;
  Observer observer;
  observer.event = [&](const results::ReleaseEvent& e) { events.push_back(e); };
  const RunResult result = march(p, observer, {.threads = 2});
  const LaneResult& lane = result.lane.at(0);
  ASSERT_EQ(result.outcome, Outcome::finished) << lane.where;
  EXPECT_LT(lane.worst_residual, 1e-12);
  EXPECT_EQ(static_cast<int>(events.size()), lane.broken.gone);
  ASSERT_GT(events.size(), 10U);
  EXPECT_EQ(lane.broken.first_s, events.front().time_s);
  EXPECT_NEAR(events.front().x_m, 0.012, 4.0 * p.lattice.mean_radius);
  EXPECT_NEAR(events.front().y_m, 0.006, 4.0 * p.lattice.mean_radius);
  double energy = 0.0;
  for (const results::ReleaseEvent& e : events) {
    energy += e.energy_j;
    EXPECT_TRUE(e.tension >= 0.0 && e.tension <= 1.0) << e.tension;
    // Each takes the energy of breaking a beam, and more where it is torn faster than a step can follow.
    EXPECT_GT(e.energy_j / (0.71 * 2000.0 * fracture::area_of_beam(p.lattice)), 0.9);
  }
  EXPECT_LT(energy, lane.samples.back().fracture_j);
  EXPECT_GT(energy, 0.3 * lane.samples.back().fracture_j);
  EXPECT_GT(lane.broken.leading_m, 0.0);
  EXPECT_EQ(lane.samples.back().tip_m, lane.broken.leading_m);
  EXPECT_GT(lane.samples.back().work_external_j, lane.samples.back().fracture_j);

  const results::LaneSummary summary = lane_summary(p, result, 0, rates_of(p, result, 0), {}, 0.0);
  EXPECT_EQ(summary.crack_course, "free");
  EXPECT_EQ(summary.beams_broken, lane.broken.gone);
  EXPECT_LT(summary.strength_pa, 200e6);
  EXPECT_EQ(summary.strength_wished_pa, 200e6);
  EXPECT_TRUE(std::isnan(summary.ratio));
  const results::Geometry geometry = geometry_of(p);
  EXPECT_EQ(geometry.crossing.size(), geometry.beam.size());
}

TEST(FreeCrack, StopsWhereTheLoadIsTooSmall) {
  const Prepared p = pulled_apart({"loading.traction=1 MPa"});
  const RunResult result = march(p, {});
  EXPECT_EQ(result.lane[0].broken.gone, 0);
  EXPECT_EQ(result.lane[0].samples.back().tip_m, 0.012);
}

// In the first steps there is less motion than what the step corrects of it: K + U - C is below zero.
TEST(FreeCrack, ClosesItsBalanceFromTheFirstStepOfALoadThatBeginsAtNothing) {
  for (const char* beta : {"solver.beta=1", "solver.beta=0.95"}) {
    const Prepared p = pulled_apart({beta, "output.samples=4000"});
    const RunResult result = march(p, {});
    const LaneResult& lane = result.lane.at(0);
    EXPECT_EQ(result.outcome, Outcome::finished) << beta << ": " << lane.where;
    EXPECT_LT(lane.worst_residual, 1e-6) << beta;
    EXPECT_EQ(lane.samples.at(1).step, 1) << "the test looks too late";
  }
}

TEST(FreeCrack, OfAClampedStripStartsFromItsPreStress) {
  const Prepared p =
      small_plate({"loading.displacement=0.15 mm", "crack.start=12 mm", "fracture.law=cohesive",
                   "fracture.release_rate=3 kJ/m2", "fracture.strength=1 GPa", "fracture.duration=20 us"});
  const RunResult result = march(p, {});
  ASSERT_EQ(result.outcome, Outcome::finished) << result.lane[0].where;
  EXPECT_GT(result.lane[0].broken.gone, 10);
  EXPECT_LT(result.lane[0].worst_residual, 1e-12);
}

// Rollers keep a plate without a notch in a plane wave: nothing moves along x at its sides.
TEST(FreeCrack, RollersHoldTheSidesAndDoNoWork) {
  const Prepared p = pulled_apart({"loading.rollers=true", "crack.start=0 mm", "loading.traction=5 MPa"});
  EXPECT_FALSE(p.rollers.empty());
  Observer observer;
  double most = 0.0, at_sides = 0.0;
  observer.frame = [&](const results::Frame& frame) {
    for (const auto& u : frame.displacement) most = std::max(most, std::abs(static_cast<double>(u[0])));
    for (const int i : p.rollers)
      at_sides = std::max(at_sides, std::abs(static_cast<double>(frame.displacement[i][0])));
  };
  const RunResult result = march(p, observer);
  EXPECT_GT(most, 0.0);
  EXPECT_EQ(at_sides, 0.0);
  EXPECT_LT(result.lane[0].worst_residual, 1e-12);
}

}  // namespace
}  // namespace rift::simulation

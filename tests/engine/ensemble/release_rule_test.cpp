#include "tests/engine/simulation/small_plate.hpp"

#include <cmath>

namespace rift::ensemble {
namespace {

/// A rule without a path: each beam softens by its own largest stretch, whatever its neighbours do.
class CohesiveBeams : public ReleaseRule {
 public:
  CohesiveBeams(double first, double last) : first_(first), last_(last) {}

  void set_lane(int lane, const fracture::LaneScenario&) override { lanes_ = std::max(lanes_, lane + 1); }
  void start(int, std::int64_t) override {}
  void predict_damage(const State& state, std::int64_t, std::vector<DamageIncrement>& increments) override {
    for (int lane = 0; lane < lanes_; ++lane)
      for (int k = 0; k < static_cast<int>(state.damageable().size()); ++k) {
        const int beam = state.damageable()[k].beam;
        const double before = state.factor(k, lane);
        if (before == 0.0 || state.strain(beam, lane).stretch <= 0.0) continue;
        const double stretch =
            std::sqrt(2.0 * state.beam_energy(beam, lane) / state.lattice().beam[beam].axial);
        const double after = std::min(before, state.rounded(stiffness_left(stretch)));
        if (after != before) increments.push_back({.k = k, .lane = lane, .before = before, .after = after});
      }
  }
  void save(NamedNumbers&) const override {}
  void restore(const State&, const NamedNumbers&) override {}

 private:
  double stiffness_left(double stretch) const {
    if (stretch <= first_) return 1.0;
    return stretch >= last_ ? 0.0 : first_ / stretch * (last_ - stretch) / (last_ - first_);
  }
  double first_, last_;  // [m]
  int lanes_ = 0;
};

// Beams anywhere in the plate break by their own strain, and the energy balance closes as exactly as along a
// path.
TEST(ReleaseRule, MayFollowACriterionOfTheBeamsThemselves) {
  const simulation::Prepared p = simulation::small_plate({"crack.start=0.008"});
  std::vector<fracture::DamageableBeam> beams;
  for (int b = 0; b < static_cast<int>(p.lattice.beam.size()); ++b) beams.push_back({.beam = b});
  std::vector<char> on_path(beams.size(), 0);
  for (const fracture::DamageableBeam& d : fracture::damageable_beams(p.path, p.lattice, 0.008))
    beams[d.beam].absent = d.absent, on_path[d.beam] = 1;
  double longest = 0.0;
  for (int b = 0; b < static_cast<int>(beams.size()); ++b)
    if (!beams[b].absent)
      longest = std::max(
          longest,
          std::sqrt(2.0 * lattice::energy_of_beam(p.lattice, b, lattice::Kinematics::linear, p.displacement) /
                    p.lattice.beam[b].axial));
  for (const Precision precision : {Precision::double_precision, Precision::single_precision}) {
    const auto rule = std::make_shared<CohesiveBeams>(0.6 * longest, 1.2 * longest);
    Ensemble s(p.lattice, beams, p.step.dt, {{}, {}}, {.precision = precision, .threads = 2}, rule);
    s.start_from(p.displacement);
    s.start_crack({});
    double worst = 0.0;
    for (int n = 0; n < 300; ++n) {
      s.step();
      if (n % 20 == 0) worst = std::max(worst, std::abs(s.balance(1).error));
    }
    int gone = 0, off_path = 0, partly = 0;
    for (int k = 0; k < static_cast<int>(beams.size()); ++k) {
      EXPECT_EQ(s.factor(k, 0), s.factor(k, 1));
      if (beams[k].absent) continue;
      gone += s.factor(k, 0) == 0.0;
      off_path += s.factor(k, 0) == 0.0 && !on_path[k];
      partly += s.factor(k, 0) > 0.0 && s.factor(k, 0) < 1.0;
    }
    EXPECT_GT(gone, 20);
    EXPECT_GT(off_path, 0);
    EXPECT_GT(partly, 20);
    EXPECT_GT(s.balance(0).fracture, 0.01 * s.balance(0).largest);
    EXPECT_LT(worst, precision == Precision::double_precision ? 1e-12 : 1e-3);
  }
}

}  // namespace
}  // namespace rift::ensemble

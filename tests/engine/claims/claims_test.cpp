#include "engine/claims/claims.hpp"

#include "engine/results/series.hpp"
#include "engine/scene/preset.hpp"
#include "engine/study/store.hpp"
#include "tests/expectations.hpp"
#include "tests/temporary_folder.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <filesystem>
#include <fstream>
#include <functional>
#include <set>

namespace rift::claims {
namespace {

/// A made-up row: Broberg 0.5 everywhere, so that a ratio of 0.5 + delta is off by delta.
SummaryRow row_at(double v, long seed, double ratio) {
  SummaryRow row;
  row.crack_velocity_over_cr = v;
  row.technique = "progressive", row.relaxation = 1.0, row.damage_zone_ratio = 1.0;
  row.damping_region = "none", row.stiffness = "in-situ";
  row.seed = static_cast<double>(seed), row.elements = 20000, row.length_m = 0.2;
  row.ratio = ratio, row.ratio_scatter = 0.01, row.ratio_trend = 0.0;
  row.broberg = 0.5, row.freund = 0.5, row.strip = 1.0;
  row.wall_fracture_s = 1.0;
  return row;
}

using OfVelocity = std::function<double(double v)>;

/// Three specimens at all velocities: 0.5 + delta(v), and plus and minus `half` about it, a standard
/// deviation of `half`.
std::vector<SummaryRow> rows_of(const OfVelocity& delta, double half = 0.0) {
  std::vector<SummaryRow> rows;
  for (double v : claimed_velocities())
    for (long seed : {1, 2, 3})
      rows.push_back(row_at(v, seed, 0.5 + delta(v) + half * static_cast<double>(seed - 2)));
  return rows;
}
Curve curve_with(const OfVelocity& delta, double half = 0.0) { return curve_of(rows_of(delta, half), {}); }
Curve off_by(double delta, double half = 0.0) {
  return curve_with([=](double) { return delta; }, half);
}

// The margins stand here as the rules say them: 0.05 is near, 0.03 too low or too high, 0.02 no influence, a
// scatter of 0.05 along the window quasi-constant.
constexpr double bit = 1e-6;  // on this or that side of a margin

TEST(Near, HoldsUpToTheMargin) {
  EXPECT_EQ(is_near(off_by(0.05 - bit), {}).verdict, Verdict::holds);
  EXPECT_EQ(is_near(off_by(-0.05 + bit), {}).verdict, Verdict::holds);
  EXPECT_EQ(is_near(off_by(0.05 + bit), {}).verdict, Verdict::does_not_hold);
  EXPECT_EQ(is_near(off_by(-0.05 - bit), {}).verdict, Verdict::does_not_hold);
}

TEST(Near, TakesTheDistanceWithoutItsSign) {
  const Curve both_ways = curve_with([](double v) { return v < 0.45 ? 0.2 : -0.2; });
  EXPECT_EQ(is_near(both_ways, {}).verdict, Verdict::does_not_hold);
}

TEST(Near, LooksAtItsVelocitiesOnlyEndsIncluded) {
  const Curve curve = curve_with([](double v) { return v < 0.59 ? 1.0 : 0.0; });
  EXPECT_EQ(is_near(curve, {0.6, 1.0}).verdict, Verdict::holds);
  EXPECT_EQ(is_near(curve, {0.5, 1.0}).verdict, Verdict::does_not_hold);
}

TEST(Near, TellsWhatWasMeasured) {
  EXPECT_EQ(is_near(off_by(0.04, 0.01), {0.6, 1.0}).measured, "0.6-1: mean |delta| 0.040, scatter 0.010");
}

TEST(Near, IsNotDecidableWhereSpecimensScatterBeyondTheMargin) {
  EXPECT_EQ(is_near(off_by(0.0, 0.05 - bit), {}).verdict, Verdict::holds);
  EXPECT_EQ(is_near(off_by(0.0, 0.05 + bit), {}).verdict, Verdict::not_decidable);
  EXPECT_EQ(is_near(off_by(1.0, 0.05 + bit), {}).verdict, Verdict::not_decidable);
}

TEST(Near, IsNotDecidableWhereAVelocityIsMissing) {
  std::vector<SummaryRow> rows = rows_of([](double) { return 0.0; });
  std::erase_if(rows, [](const SummaryRow& r) { return r.crack_velocity_over_cr == 0.7; });
  const Judgement j = is_near(curve_of(rows, {}), {0.6, 1.0});
  EXPECT_EQ(j.verdict, Verdict::not_decidable);
  EXPECT_EQ(j.measured, "no result at 0.7 c_R");
  EXPECT_EQ(is_near(curve_of(rows, {}), {0.1, 0.6}).verdict, Verdict::holds);
}

TEST(TooLow, HoldsBelowTheMargin) {
  EXPECT_EQ(is_too_low(off_by(-0.03 - bit), {}).verdict, Verdict::holds);
  EXPECT_EQ(is_too_low(off_by(-0.03 + bit), {}).verdict, Verdict::does_not_hold);
  EXPECT_EQ(is_too_low(off_by(0.03 + bit), {}).verdict, Verdict::does_not_hold);
  EXPECT_EQ(is_too_low(off_by(-1.0, 0.03 + bit), {}).verdict, Verdict::not_decidable);
}

TEST(TooHigh, HoldsAboveTheMargin) {
  EXPECT_EQ(is_too_high(off_by(0.03 + bit), {}).verdict, Verdict::holds);
  EXPECT_EQ(is_too_high(off_by(0.03 - bit), {}).verdict, Verdict::does_not_hold);
  EXPECT_EQ(is_too_high(off_by(-0.03 - bit), {}).verdict, Verdict::does_not_hold);
}

TEST(TooHigh, TakesTheDistanceWithItsSign) {
  // 0.4 to 0.8: five velocities, +0.2 and -0.2 nearly cancel
  const Curve curve = curve_with([](double v) { return v < 0.55 ? -0.2 : v < 0.65 ? 0.0 : 0.2; });
  EXPECT_EQ(is_too_high(curve, {0.4, 0.8}).verdict, Verdict::does_not_hold);
}

TEST(AgreesOnlyIn, WantsItNearInsideAndNotElsewhere) {
  const auto inside_and_out = [](double in, double out) {
    return agrees_only_in(curve_with([=](double v) { return v > 0.59 ? in : out; }), {0.6, 1.0});
  };
  EXPECT_EQ(inside_and_out(0.04, 0.06).verdict, Verdict::holds);
  EXPECT_EQ(inside_and_out(0.04, 0.04).verdict, Verdict::does_not_hold);
  EXPECT_EQ(inside_and_out(0.06, 0.06).verdict, Verdict::does_not_hold);
  EXPECT_EQ(inside_and_out(0.04, 0.21).measured,
            "mean |delta| 0.040 over 0.6-1, 0.210 elsewhere, scatter 0.000");
}

TEST(BetterThan, IsTheSmallerMeanDistance) {
  EXPECT_EQ(is_better(off_by(0.10), off_by(-0.11), {}).verdict, Verdict::holds);
  EXPECT_EQ(is_better(off_by(-0.11), off_by(0.10), {}).verdict, Verdict::does_not_hold);
}

TEST(BetterThan, ComparesSpecimenBySpecimen) {
  // Specimens scatter by 0.02, twice the gain, but each of them gains the same.
  EXPECT_EQ(is_better(off_by(0.10, 0.02), off_by(0.11, 0.02), {}).verdict, Verdict::holds);
  // Here the gain is 0.03, 0.01 and -0.01: a scatter of 0.02 about 0.01.
  EXPECT_EQ(is_better(off_by(0.10, 0.02), off_by(0.11), {}).verdict, Verdict::not_decidable);
}

TEST(NoInfluence, HoldsUpToTheMargin) {
  const Curve reference = off_by(0.2);
  EXPECT_EQ(has_no_influence(off_by(0.2 + 0.02 - bit), reference, {}).verdict, Verdict::holds);
  EXPECT_EQ(has_no_influence(off_by(0.2 - 0.02 - bit), reference, {}).verdict, Verdict::does_not_hold);
  EXPECT_EQ(has_no_influence(off_by(0.2, 0.02 + bit), reference, {}).verdict, Verdict::not_decidable);
  EXPECT_EQ(has_no_influence(off_by(0.2), {}, {}).verdict, Verdict::not_decidable);
}

TEST(QuasiConstant, LooksAtTheTrendAlongTheWindowOverItsStandardError) {
  CurvePoint point = off_by(0.0).front();
  for (const double sign : {1.0, -1.0}) {
    point.trend.assign(3, sign * (0.05 - bit));
    EXPECT_EQ(is_quasi_constant(point).verdict, Verdict::holds);
    point.trend.assign(3, sign * (0.05 + bit));
    EXPECT_EQ(is_quasi_constant(point).verdict, Verdict::does_not_hold);
  }
  // Mean 0.1, standard error 0.1 / sqrt(3): within two; of half the scatter it is not.
  point.trend = {0.0, 0.1, 0.2};
  EXPECT_EQ(is_quasi_constant(point).verdict, Verdict::holds);
  point.trend = {0.05, 0.1, 0.15};
  EXPECT_EQ(is_quasi_constant(point).verdict, Verdict::does_not_hold);
  EXPECT_EQ(is_quasi_constant(point).measured, "0.01: +0.100 ± 0.029");
}

// Our single specimens differ by 0.03 on average, with a deviation of 0.01: the paper's single one may have
// any of 0.02 to 0.04.
TEST(DiffersBy, ComparesANumberOfOneSpecimenWithOurSpreadOfSingleOnes) {
  const Curve reference = off_by(0.0), curve = off_by(0.03, 0.01);
  EXPECT_EQ(differs_by(curve, reference, 0.5, 0.02 + bit).verdict, Verdict::holds);
  EXPECT_EQ(differs_by(curve, reference, 0.5, 0.02 - bit).verdict, Verdict::not_decidable);
  EXPECT_EQ(differs_by(curve, reference, 0.5, 0.01 - bit).verdict, Verdict::does_not_hold);
  EXPECT_EQ(differs_by(reference, curve, 0.5, 0.03).verdict, Verdict::holds) << "without its sign";
  EXPECT_EQ(differs_by(curve, reference, 0.55, 0.03).verdict, Verdict::not_decidable) << "no result";
}

TEST(QuasiConstant, ForMostIsMoreThanHalf) {
  const auto constant_up_to = [](int count) {
    Curve curve = off_by(0.0);  // twelve velocities
    for (std::size_t k = count; k < curve.size(); ++k) curve[k].trend.assign(3, 0.1);
    return is_mostly_constant(curve, {}).verdict;
  };
  EXPECT_EQ(constant_up_to(7), Verdict::holds);
  EXPECT_EQ(constant_up_to(6), Verdict::does_not_hold);
}

TEST(ValueAtAVelocity, IsNearOrBelow) {
  EXPECT_EQ(is_near_value(off_by(0.45 + bit), 1.0, 1.0).verdict, Verdict::holds);
  EXPECT_EQ(is_near_value(off_by(0.45 - bit), 1.0, 1.0).verdict, Verdict::does_not_hold);
  EXPECT_EQ(is_below(off_by(-0.1 - bit), 0.01, 0.4).verdict, Verdict::holds);
  EXPECT_EQ(is_below(off_by(-0.1 + bit), 0.01, 0.4).verdict, Verdict::does_not_hold);
  EXPECT_EQ(is_below({}, 0.01, 0.4).verdict, Verdict::not_decidable);
}

TEST(SeveralParts, HoldTogetherAndFailForOne) {
  const Part yes{"a", {Verdict::holds, "1"}}, no{"b", {Verdict::does_not_hold, "2"}},
      unknown{"c", {Verdict::not_decidable, "3"}};
  EXPECT_EQ(all_of({yes, yes}).verdict, Verdict::holds);
  EXPECT_EQ(all_of({yes, unknown}).verdict, Verdict::not_decidable);
  EXPECT_EQ(all_of({unknown, no, yes}).verdict, Verdict::does_not_hold);
  EXPECT_EQ(all_of({no, unknown}).verdict, Verdict::does_not_hold);
  EXPECT_EQ(all_of({}).verdict, Verdict::not_decidable);
  EXPECT_EQ(all_of({yes, no}).measured, "a (holds): 1; b (does not hold): 2");
}

TEST(Curve, TakesTheRowsOfItsSelectionOnly) {
  std::vector<SummaryRow> rows = {row_at(0.5, 1, 0.6), row_at(0.5, 2, 0.7)};
  const auto other = [&]() -> SummaryRow& { return rows.emplace_back(row_at(0.5, 3, 9.0)); };
  other().technique = "simple";
  other().relaxation = 2.0;
  other().damage_zone_ratio = 1.5;
  other().damping_region = "all";
  other().elements = 5000;
  other().length_m = 0.4;
  other().prestress_method = "ramp";
  other().axes = {{"path", "0.4 H"}};
  other().axes = {{"dt_fraction", "0.17"}};
  other().ratio = NAN;
  other().crack_velocity_over_cr = NAN;
  const Curve curve = curve_of(rows, {});
  ASSERT_EQ(curve.size(), 1u);
  EXPECT_EQ(curve[0].ratio, (std::vector<double>{0.6, 0.7}));
  EXPECT_EQ(curve[0].seed, (std::vector<long>{1, 2}));
}

TEST(LineThroughPoints, ExplainsAll) {
  const Line line = line_through({1, 2, 3, 4}, {2, 4, 6, 8});
  EXPECT_NEAR(line.slope, 2.0, 1e-14);
  EXPECT_NEAR(line.r_squared, 1.0, 1e-14);
  EXPECT_NEAR(line_through({1, 2, 3, 4}, {1, -1, -1, 1}).r_squared, 0.0, 1e-14);
}

/// The names in the headings of a page of docs/, as "fig07" in "## Fig. 7 (fig07)".
std::set<std::string> headings_of(const char* page) {
  std::ifstream file(std::string(RIFT_SOURCE_DIR "/docs/") + page);
  std::set<std::string> names;
  for (std::string line; std::getline(file, line);)
    if (line.starts_with("## ") && line.ends_with(")")) {
      EXPECT_TRUE(names.insert(line.substr(line.rfind('(') + 1, line.size() - line.rfind('(') - 2)).second)
          << line;
    }
  return names;
}

TEST(Claims, AreThoseThatTheDocsJudgeEachOnce) {
  std::set<std::string> of_the_paper, beyond;
  for (const Claim& claim : claims())
    EXPECT_TRUE((claim.beyond ? beyond : of_the_paper).insert(claim.name).second) << claim.name;
  EXPECT_EQ(of_the_paper, headings_of("reproduction.md"));
  EXPECT_EQ(beyond, headings_of("beyond.md"));
}

TEST(Claims, AreJudgedOrSayWhyNot) {
  for (const Claim& claim : not_empty(claims()))
    EXPECT_NE(static_cast<bool>(claim.judge), !claim.standing.empty()) << claim.name;
}

TEST(Claims, ThatArePicturesNameOnePresetAndItsMoments) {
  int pictures = 0;
  for (const Claim& claim : not_empty(claims())) {
    if (claim.pictures_at.empty()) continue;
    ++pictures;
    EXPECT_EQ(claim.needs.size(), 1U) << claim.name;
    EXPECT_FALSE(claim.judge) << claim.name;
    for (const double at : not_empty(claim.pictures_at)) EXPECT_TRUE(at >= 0 && at <= 1) << claim.name;
  }
  EXPECT_EQ(pictures, 4);
}

TEST(Claims, WithoutAnyResultAreNotDecidable) {
  int judged = 0;
  for (const Claim& claim : claims()) {
    if (!claim.judge || claim.needs.empty()) continue;  // of drawings and of theory
    EXPECT_EQ(claim.judge(Evidence{}).verdict, Verdict::not_decidable) << claim.name;
    ++judged;
  }
  EXPECT_GT(judged, 10);
}

TEST(Claims, NeedPresetsThatAreThere) {
  int needed = 0;
  for (const Claim& claim : claims())
    for (const std::string& name : claim.needs) {
      EXPECT_TRUE(std::filesystem::exists(std::string(RIFT_SOURCE_DIR "/presets/") + name + ".toml")) << name;
      ++needed;
    }
  EXPECT_GT(needed, 10);
}

// What fig11 sees in rows that are as the paper says, and in rows whose linear scheme is off.
TEST(Claims, FollowTheRowsTheyAreGiven) {
  const auto rows_with = [](double linear) {
    std::vector<SummaryRow> all;
    for (double p : {0.5, 1.0, 2.0})
      for (SummaryRow row : rows_of([=](double) { return p == 0.5 ? -0.1 : p == 1.0 ? linear : 0.0; })) {
        row.relaxation = p;
        all.push_back(row);
      }
    return all;
  };
  const Claim* claim = find_claim("fig11");
  ASSERT_NE(claim, nullptr);
  EXPECT_EQ(claim->judge({.rows = rows_with(0.01)}).verdict, Verdict::holds);
  EXPECT_EQ(claim->judge({.rows = rows_with(0.1)}).verdict, Verdict::does_not_hold);
}

results::Sample sample_of_fig05(double time_s, results::Phase phase, double kinetic_j, double elastic_j) {
  results::Sample sample;
  sample.time_s = time_s, sample.phase = phase;
  sample.kinetic_translation_j = 0.75 * kinetic_j, sample.kinetic_rotation_j = 0.25 * kinetic_j;
  sample.elastic_j = elastic_j, sample.fracture_j = 100.0 - elastic_j - kinetic_j;
  return sample;
}

// Its times, energies and inertia are read from a series as a study stores it.
TEST(ClaimOfFig5, ReadsTheColumnsOfASeries) {
  using results::Phase;
  const TemporaryFolder folder;
  const auto verdict = [&](double kinetic_of_loading) {
    const std::vector<results::Sample> samples{
        sample_of_fig05(0.47e-3, Phase::loading, kinetic_of_loading, 99.0),
        sample_of_fig05(0.71e-3, Phase::hold, 0.0, 100.0),
        sample_of_fig05(0.72e-3, Phase::fracture, 0.0, 100.0),
        sample_of_fig05(1.16e-3, Phase::fracture, 8.0, 40.0)};
    write_text(folder / "series.csv", results::series_csv(samples, {}));
    SummaryRow row = row_at(0.2, 1, 0.5);
    row.prestress_method = "ramp", row.prestress_kinetic_fraction = 0.001;
    return find_claim("fig05")->judge({.rows = {row}, .series = [&](const SummaryRow&) {
                                         return study::read_series(folder / "series.csv");
                                       }});
  };
  EXPECT_EQ(verdict(0.5).verdict, Verdict::holds) << verdict(0.5).measured;
  EXPECT_EQ(verdict(2.0).verdict, Verdict::does_not_hold) << verdict(2.0).measured;
}

// A plate of a fourth of the elements has its path through twice the share of the beams.
TEST(Fig08, JudgesTheShareOfDampedBeamsOfThePapersPlate) {
  const auto measured_with = [](int elements, double share) {
    SummaryRow row = row_at(0.1, 1, 0.5);
    row.technique = "simple", row.damping_region = "surface", row.elements = elements;
    row.damping_alpha = 0.001, row.beams = 1e4, row.beams_damped = share * row.beams;
    return find_claim("fig08")->judge({.rows = {row}, .elements = elements}).measured;
  };
  EXPECT_TRUE(contains(measured_with(20000, 0.053), "damped at the surface (holds): 5.3 %"));
  EXPECT_TRUE(contains(measured_with(20000, 0.061), "damped at the surface (does not hold): 6.1 %"));
  EXPECT_TRUE(
      contains(measured_with(5000, 0.106), "damped at the surface (holds): 5.3 %, scaled to 20000 elements"));
  EXPECT_TRUE(contains(measured_with(5000, 0.122), "damped at the surface (does not hold): 6.1 %"));
}

}  // namespace
}  // namespace rift::claims

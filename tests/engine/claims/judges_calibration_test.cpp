#include "engine/claims/claims.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <vector>

namespace rift::claims {
namespace {

struct Size {
  int elements;
  double young_gpa, poisson;
};

Evidence evidence_of(const std::vector<Size>& sizes) {
  Evidence evidence;
  for (const Size& size : sizes)
    for (const double sign : {-1.0, 1.0}) {
      calibration::CylinderResult& cylinder = evidence.cylinders.emplace_back();
      cylinder.packing.elements = size.elements;
      cylinder.responses.resize(1);
      cylinder.responses[0].young_over_micro = (size.young_gpa + 0.1 * sign) / 356.0;
      cylinder.responses[0].poisson_ratio = size.poisson + 0.001 * sign;
    }
  return evidence;
}

TEST(Fig17, HoldsWhereTheMeansAbove15000StayWithinTwoAndAHalfPercent) {
  EXPECT_EQ(find_claim("fig17")
                ->judge(evidence_of({{500, 13, 0.4}, {15000, 10.2, 0.31}, {35000, 9.8, 0.32}}))
                .verdict,
            Verdict::holds);
  EXPECT_EQ(find_claim("fig17")->judge(evidence_of({{15000, 10.3, 0.31}, {35000, 9.7, 0.31}})).verdict,
            Verdict::does_not_hold);
  EXPECT_EQ(find_claim("fig17")->judge(evidence_of({{15000, 10.0, 0.30}, {35000, 10.0, 0.33}})).verdict,
            Verdict::does_not_hold);
}

TEST(Fig17, IsNotDecidableBySmallCylinders) {
  EXPECT_EQ(find_claim("fig17")->judge(evidence_of({{500, 10, 0.3}, {7500, 10, 0.3}})).verdict,
            Verdict::not_decidable);
}

TEST(Table2, HoldsWithin3PercentAndNuBetween30And33) {
  EXPECT_EQ(find_claim("table2")->judge(evidence_of({{15000, 10.3, 0.31}, {35000, 10.1, 0.329}})).verdict,
            Verdict::holds);
  EXPECT_EQ(find_claim("table2")->judge(evidence_of({{15000, 9.9, 0.31}, {35000, 9.9, 0.31}})).verdict,
            Verdict::does_not_hold);
  EXPECT_EQ(find_claim("table2")->judge(evidence_of({{15000, 10.3, 0.31}, {35000, 10.3, 0.34}})).verdict,
            Verdict::does_not_hold);
  EXPECT_EQ(find_claim("table2")->judge(evidence_of({{500, 10.3, 0.31}})).verdict, Verdict::not_decidable);
}

TEST(Table2, TellsTheDeviation) {
  const std::string measured = find_claim("table2")->judge(evidence_of({{15000, 9.785, 0.31}})).measured;
  EXPECT_NE(measured.find("-5.0 % of 10.3"), std::string::npos) << measured;
}

}  // namespace
}  // namespace rift::claims

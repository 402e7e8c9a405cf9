#include "engine/theory/references.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

namespace rift::theory {
namespace {

TEST(TanhSinh, IntegratesASmoothFunction) {
  EXPECT_NEAR(tanh_sinh([](double x, double) { return std::exp(x); }), std::numbers::e - 1.0, 1e-15);
}

TEST(TanhSinh, IntegratesRootsAtBothEnds) {
  const auto half_circle = [](double x, double y) { return std::sqrt(x * y); };
  EXPECT_NEAR(tanh_sinh(half_circle), std::numbers::pi / 8.0, 1e-15);
}

TEST(TanhSinh, TellsTheTwoEndsApart) {
  EXPECT_NEAR(tanh_sinh([](double x, double y) { return x * x + 10.0 * y; }), 1.0 / 3.0 + 5.0, 1e-14);
}

TEST(TanhSinh, ResolvesALayerAtAnEnd) {
  // int_0^1 w / (x + w) dx = w ln((1 + w) / w), most of it near x ~ w
  const double w = 1e-8;
  const double exact = w * std::log((1.0 + w) / w);
  EXPECT_NEAR(tanh_sinh([&](double x, double) { return w / (x + w); }) / exact, 1.0, 1e-13);
}

TEST(TanhSinh, RefinesUntilASharpPeakIsResolved) {
  // int_0^1 dx / (1 + ((x - 1/2) / w)^2) = 2 w atan(1 / (2 w)); the poles at 1/2 +- i w ask for a step near w
  // / 4.
  const double w = 0.01;
  const auto peak = [&](double x, double) { return 1.0 / (1.0 + (x - 0.5) * (x - 0.5) / (w * w)); };
  EXPECT_NEAR(tanh_sinh(peak), 2.0 * w * std::atan(0.5 / w), 1e-15);
}

}  // namespace
}  // namespace rift::theory

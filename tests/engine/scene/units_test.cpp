#include "engine/scene/units.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

namespace rift::scene {
namespace {

void expect_problem(const char* text, Dimension dimension, const char* problem) {
  const Parsed<double> parsed = read_quantity(text, dimension);
  EXPECT_FALSE(parsed.value) << text;
  EXPECT_EQ(parsed.problem, problem) << text;
}

TEST(ReadQuantity, GivesTheNearestDoubleToTheDecimalInSi) {
  EXPECT_EQ(read_quantity("2 mm", Dimension::length).value, 0.002);
  EXPECT_EQ(read_quantity("0.47 ms", Dimension::time).value, 0.00047);
  EXPECT_EQ(read_quantity("0.487mm", Dimension::length).value, 0.000487);
  EXPECT_EQ(read_quantity("2.35e-2 us", Dimension::time).value, 2.35e-8);
  EXPECT_EQ(read_quantity(" +3E+1 cm ", Dimension::length).value, 0.3);
}

TEST(ReadQuantity, KnowsTheUnitsOfEachDimension) {
  EXPECT_EQ(read_quantity("10 GPa", Dimension::pressure).value, 10e9);
  EXPECT_EQ(read_quantity("3 MPa", Dimension::pressure).value, 3e6);
  EXPECT_EQ(read_quantity("2200 m/s", Dimension::speed).value, 2200.0);
  EXPECT_EQ(read_quantity("2.2 km/s", Dimension::speed).value, 2200.0);
  EXPECT_EQ(read_quantity("667 kg/m3", Dimension::density).value, 667.0);
  EXPECT_EQ(read_quantity("667 kg/m^3", Dimension::density).value, 667.0);
  EXPECT_EQ(read_quantity("1.2 g/cm3", Dimension::density).value, 1200.0);
  EXPECT_EQ(read_quantity("5 µs", Dimension::time).value, 5e-6);
}

TEST(ReadQuantity, SaysWhatIsWrong) {
  expect_problem("wide", Dimension::length, "expected a length such as \"2 mm\"");
  expect_problem("", Dimension::time, "expected a time such as \"0.47 ms\"");
  expect_problem("2 parsec", Dimension::length, "unknown unit 'parsec' for a length: use m, mm, um or nm");
  expect_problem("2 mm", Dimension::pressure, "unknown unit 'mm' for a pressure: use GPa, MPa, kPa or Pa");
  expect_problem("0.2", Dimension::length, "needs a unit: m, mm, um or nm");
  expect_problem("0x10 m", Dimension::length, "unknown unit 'x10 m' for a length: use m, mm, um or nm");
}

TEST(ReadQuantity, RejectsWhatIsNoFiniteDouble) {
  expect_problem("nan mm", Dimension::length, "must be a finite number");
  expect_problem("-inf m", Dimension::length, "must be a finite number");
  expect_problem("infinity m", Dimension::length, "must be a finite number");
  const char* held = "the number is too large or too small to be held";
  expect_problem("1e400 m", Dimension::length, held);
  expect_problem("1e-400 m", Dimension::length, held);
  expect_problem("1e305 GPa", Dimension::pressure, held);
  expect_problem("1e99999999999 m", Dimension::length, held);
}

TEST(QuantityText, IsReadable) {
  EXPECT_EQ(quantity_text(0.002, Dimension::length), "2 mm");
  EXPECT_EQ(quantity_text(0.00047, Dimension::time), "470 us");
  EXPECT_EQ(quantity_text(2.35e-8, Dimension::time), "23.5 ns");
  EXPECT_EQ(quantity_text(10e9, Dimension::pressure), "10 GPa");
  EXPECT_EQ(quantity_text(2200, Dimension::speed), "2200 m/s");
  EXPECT_EQ(quantity_text(0, Dimension::length), "0 m");
  EXPECT_EQ(quantity_text(-0.003, Dimension::length), "-3 mm");
  EXPECT_EQ(quantity_text(0.125, Dimension::none), "0.125");
}

TEST(QuantityText, FallsBackToSiWhereNoShortTextIsExact) {
  EXPECT_EQ(quantity_text(0.1 + 0.2 - 0.2, Dimension::length), "0.10000000000000003 m");
}

TEST(QuantityText, ReadsBackToTheSameBits) {
  std::mt19937_64 random(7);
  std::uniform_real_distribution<double> exponent(-30, 30), mantissa(-10, 10);
  for (int i = 0; i < 20000; ++i) {
    const double x = mantissa(random) * std::pow(10.0, std::floor(exponent(random)));
    for (const Dimension d :
         {Dimension::length, Dimension::time, Dimension::pressure, Dimension::speed, Dimension::density}) {
      ASSERT_EQ(read_quantity(quantity_text(x, d), d).value, x) << quantity_text(x, d);
    }
  }
}

TEST(RoundedText, HasSixDigits) { EXPECT_EQ(rounded_text(0.4 * 0.2 + 1e-12, Dimension::length), "80 mm"); }

}  // namespace
}  // namespace rift::scene

#include "engine/fracture/energy_balance.hpp"

#include <gtest/gtest.h>

namespace rift::fracture {
namespace {

/// A balance of exact numbers that closes: 100 at the start, 24 of work, 36 lost, 88 left.
constexpr EnergyBalance closed{.elastic = 70.0,
                               .kinetic_translation = 16.0,
                               .kinetic_rotation = 4.0,
                               .step_correction = 2.0,
                               .start = 100.0,
                               .fracture = 20.0,
                               .damping = 12.0,
                               .numerical_damping = 4.0,
                               .work_external = 24.0,
                               .largest = 128.0};

TEST(EnergyBalance, LatticeEnergyIsKineticPlusElasticLessTheCorrection) {
  EXPECT_DOUBLE_EQ(closed.total(), 70.0 + 16.0 + 4.0 - 2.0);
}

TEST(EnergyBalance, HasNoErrorWhereItCloses) { EXPECT_NEAR(balance_error(closed), 0.0, 1e-16); }

TEST(EnergyBalance, AnyTermMovesTheErrorByItsOwnErrorOverTheLargestEnergy) {
  constexpr double error = 0.5;
  const auto with = [](double EnergyBalance::*term) {
    EnergyBalance balance = closed;
    balance.*term += error;
    return balance_error(balance);
  };
  const double moved = error / 128.0;
  for (const auto term : {&EnergyBalance::fracture, &EnergyBalance::damping,
                          &EnergyBalance::numerical_damping, &EnergyBalance::contact, &EnergyBalance::elastic,
                          &EnergyBalance::kinetic_translation, &EnergyBalance::kinetic_rotation})
    EXPECT_DOUBLE_EQ(with(term), moved);
  for (const auto term :
       {&EnergyBalance::work_external, &EnergyBalance::start, &EnergyBalance::step_correction})
    EXPECT_DOUBLE_EQ(with(term), -moved);
}

// In the first step K and C are equal but for rounding, which is no measure of an error.
TEST(EnergyBalance, OfALatticeThatBeginsToMoveIsOverTheCorrection) {
  EnergyBalance balance;
  balance.kinetic_translation = 2e-9 + 1e-24, balance.step_correction = 2e-9;
  balance.largest = balance.total();
  EXPECT_LT(balance_error(balance), 1e-14);
  balance.fracture = 1e-10;
  EXPECT_NEAR(balance_error(balance), 0.05, 1e-9);
  balance.start = balance.largest = 1e-20;  // of a lattice with energy its own is the scale, however small
  EXPECT_GT(balance_error(balance), 1e9);
}

TEST(EnergyBalance, OpenedOnAnUnloadedLatticeIsClosed) {
  EXPECT_EQ(balance_error(EnergyBalance{}), 0.0);  // and not 0/0
}

}  // namespace
}  // namespace rift::fracture

#include "engine/fracture/release_rate.hpp"

#include <gtest/gtest.h>

namespace rift::fracture {
namespace {

/// Books of exact numbers that close: 100 at the start, 24 of work, 36 lost, 88 left.
Ledger closed_books() {
  return {.energy_start = 100.0,
          .fracture = 20.0,
          .damping = 12.0,
          .numerical_damping = 4.0,
          .work_external = 24.0,
          .largest = 128.0};
}
constexpr LatticeEnergy energy_left{
    .elastic = 70.0, .kinetic_translation = 16.0, .kinetic_rotation = 4.0, .step_correction = 2.0};

TEST(Ledger, LatticeEnergyIsKineticPlusElasticLessTheCorrection) {
  EXPECT_DOUBLE_EQ(energy_left.total(), 70.0 + 16.0 + 4.0 - 2.0);
}

TEST(Ledger, HasNoResidualWhereTheBooksClose) {
  EXPECT_NEAR(residual_of(closed_books(), energy_left), 0.0, 1e-16);
}

TEST(Ledger, AnyColumnMovesTheResidualByItsOwnErrorOverTheLargestEnergy) {
  constexpr double error = 0.5;
  const auto with = [](double Ledger::*column) {
    Ledger books = closed_books();
    books.*column += error;
    return residual_of(books, energy_left);
  };
  const double moved = error / 128.0;
  EXPECT_DOUBLE_EQ(with(&Ledger::fracture), moved);
  EXPECT_DOUBLE_EQ(with(&Ledger::damping), moved);
  EXPECT_DOUBLE_EQ(with(&Ledger::numerical_damping), moved);
  EXPECT_DOUBLE_EQ(with(&Ledger::work_external), -moved);
  EXPECT_DOUBLE_EQ(with(&Ledger::energy_start), -moved);
  const auto with_energy = [](double LatticeEnergy::*column) {
    LatticeEnergy energy = energy_left;
    energy.*column += error;
    return residual_of(closed_books(), energy);
  };
  EXPECT_DOUBLE_EQ(with_energy(&LatticeEnergy::elastic), moved);
  EXPECT_DOUBLE_EQ(with_energy(&LatticeEnergy::kinetic_translation), moved);
  EXPECT_DOUBLE_EQ(with_energy(&LatticeEnergy::kinetic_rotation), moved);
  EXPECT_DOUBLE_EQ(with_energy(&LatticeEnergy::step_correction), -moved);
}

TEST(Ledger, OpenedOnAnUnloadedLatticeIsClosed) {
  EXPECT_EQ(residual_of(Ledger{}, LatticeEnergy{}), 0.0);  // and not 0/0
}

TEST(Ledger, ARowOfTheBooksHoldsEveryColumn) {
  Ledger books = closed_books();
  const results::Sample row = balance(books, energy_left);
  EXPECT_EQ(row.elastic_j, 70.0);
  EXPECT_EQ(row.kinetic_translation_j, 16.0);
  EXPECT_EQ(row.kinetic_rotation_j, 4.0);
  EXPECT_EQ(row.step_correction_j, 2.0);
  EXPECT_EQ(row.fracture_j, 20.0);
  EXPECT_EQ(row.damping_j, 12.0);
  EXPECT_EQ(row.numerical_damping_j, 4.0);
  EXPECT_EQ(row.work_external_j, 24.0);
  EXPECT_NEAR(row.residual, 0.0, 1e-16);
}

TEST(Ledger, NotesTheLargestEnergySoFar) {
  Ledger books = closed_books();
  LatticeEnergy energy = energy_left;
  energy.elastic = 200.0;
  balance(books, energy);
  EXPECT_EQ(books.largest, 218.0);
  balance(books, energy_left);
  EXPECT_EQ(books.largest, 218.0);
}

}  // namespace
}  // namespace rift::fracture

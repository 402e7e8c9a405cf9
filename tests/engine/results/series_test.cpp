#include "engine/results/series.hpp"

#include "tests/engine/results/small_run.hpp"

#include <gtest/gtest.h>

#include <bit>
#include <cmath>
#include <cstdlib>
#include <limits>
#include <sstream>

namespace rift::results {
namespace {

std::vector<std::vector<std::string>> table_of(const std::string& csv) {
  std::vector<std::vector<std::string>> table;
  std::istringstream lines(csv);
  for (std::string line; std::getline(lines, line);) {
    auto& row = table.emplace_back();
    std::size_t from = 0;
    for (std::size_t comma; (comma = line.find(',', from)) != std::string::npos; from = comma + 1)
      row.push_back(line.substr(from, comma - from));
    row.push_back(line.substr(from));
  }
  return table;
}

TEST(Series, ColumnsAreTheContract) {
  EXPECT_EQ(series_header(),
            "step,time_s,phase,lane,tip_m,velocity_m_s,energy_elastic_j,energy_kinetic_translation_j,"
            "energy_kinetic_rotation_j,energy_step_correction_j,energy_fracture_j,energy_damping_j,"
            "energy_numerical_damping_j,work_external_j,ledger_residual,energy_contact_j,grip_force_n,ratio,"
            "ratio_fracture,ratio_paper,ratio_difference");
}

TEST(Series, NumbersReadBackToTheSameBits) {
  const auto sample = small_run::sample(123456789012, 3, 0.1);
  const RatePoint rate{0.1, 2.0 / 3, 5e-324, std::numeric_limits<double>::max(), -0.0};
  const auto table = table_of(series_row(sample, &rate));
  ASSERT_EQ(table.size(), 1U);
  ASSERT_EQ(table[0].size(), table_of(series_header())[0].size());
  EXPECT_EQ(table[0][0], "123456789012");
  EXPECT_EQ(table[0][2], "fracture");
  EXPECT_EQ(table[0][3], "3");
  const std::vector<std::pair<int, double>> expected{{1, sample.time_s},
                                                     {4, 0.1},
                                                     {5, 1100.1},
                                                     {6, 0.1 + 0.2},
                                                     {7, 1.0 / 3},
                                                     {8, 2e-300},
                                                     {9, -3e-9},
                                                     {10, 0.25},
                                                     {11, 0.125},
                                                     {12, 0.0625},
                                                     {13, 1e22},
                                                     {14, 5e-12},
                                                     {17, rate.ratio},
                                                     {18, rate.ratio_fracture},
                                                     {19, rate.ratio_paper},
                                                     {20, rate.ratio_difference}};
  for (const auto& [column, value] : expected) {
    const double read = std::strtod(table[0][column].c_str(), nullptr);
    EXPECT_EQ(std::bit_cast<std::uint64_t>(read), std::bit_cast<std::uint64_t>(value)) << column;
  }
  EXPECT_EQ(table[0][6], "0.30000000000000004") << "shortest form";
}

TEST(Series, UndefinedIsAnEmptyField) {
  auto sample = small_run::sample(1, 0, 0.1);
  sample.residual = std::nan("");
  const auto row = series_row(sample);
  EXPECT_TRUE(row.ends_with(",1e+22,,0,0,,,,\n")) << row;
}

TEST(Series, RatesGoToTheSampleOfTheSameTipAndLane) {
  const std::vector<Sample> samples{small_run::sample(1, 0, 0.1), small_run::sample(1, 1, 0.1),
                                    small_run::sample(2, 0, 0.2),
                                    small_run::sample(2, 1, std::nextafter(0.2, 1))};
  const std::vector<RateCurve> rates{{0, {{0.1, 1, 0, 0, 0}, {0.2, 2, 0, 0, 0}}}, {1, {{0.2, 3, 0, 0, 0}}}};
  const auto matched = match_rates(samples, rates);
  ASSERT_EQ(matched.size(), 4U);
  EXPECT_EQ(matched[0], &rates[0].points[0]);
  EXPECT_EQ(matched[1], nullptr) << "the point belongs to the other lane";
  EXPECT_EQ(matched[2], &rates[0].points[1]);
  EXPECT_EQ(matched[3], nullptr) << "a neighbouring tip is another tip";
}

TEST(Series, LoadingHasNoRate) {
  auto sample = small_run::sample(1, 0, 0.1);
  sample.phase = Phase::hold;
  const std::vector<RateCurve> rates{{0, {{0.1, 1, 0, 0, 0}}}};
  EXPECT_EQ(match_rates(std::vector{sample}, rates)[0], nullptr);
}

TEST(Series, CanBeReadWhileItGrows) {
  const TemporaryFolder scratch;
  SeriesWriter writer(scratch / "s.csv");
  writer.write(small_run::sample(1, 0, 0.1));
  writer.write(small_run::sample(2, 0, 0.2));
  writer.flush();
  EXPECT_EQ(read_text(scratch / "s.csv"),
            series_csv(std::vector{small_run::sample(1, 0, 0.1), small_run::sample(2, 0, 0.2)}, {}));
}

}  // namespace
}  // namespace rift::results

#pragma once

#include "engine/base/csv.hpp"
#include "engine/base/files.hpp"
#include "engine/results/records.hpp"
#include "engine/results/schema.hpp"

#include <array>
#include <filesystem>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace rift::results {

// The names that series.csv, the archive and the exports share, each beside the number it stands for.

template <typename Row>
struct Column {
  const char* name;
  double Row::*value;
};

/// Columns of series.csv behind step, time_s, phase and lane.
inline constexpr std::array sample_columns{
    Column<Sample>{"tip_m", &Sample::tip_m},
    Column<Sample>{"velocity_m_s", &Sample::velocity_m_s},
    Column<Sample>{"energy_elastic_j", &Sample::elastic_j},
    Column<Sample>{"energy_kinetic_translation_j", &Sample::kinetic_translation_j},
    Column<Sample>{"energy_kinetic_rotation_j", &Sample::kinetic_rotation_j},
    Column<Sample>{"energy_step_correction_j", &Sample::step_correction_j},
    Column<Sample>{"energy_fracture_j", &Sample::fracture_j},
    Column<Sample>{"energy_damping_j", &Sample::damping_j},
    Column<Sample>{"energy_numerical_damping_j", &Sample::numerical_damping_j},
    Column<Sample>{"work_external_j", &Sample::work_external_j},
    Column<Sample>{"ledger_residual", &Sample::residual},
    Column<Sample>{"energy_contact_j", &Sample::contact_j},
    Column<Sample>{"grip_force_n", &Sample::grip_force_n},
};

/// Columns of gauges.csv behind step, time_s, lane and gauge.
inline constexpr std::array gauge_columns{
    Column<GaugeRow>{"x_m", &GaugeRow::x_m},
    Column<GaugeRow>{"y_m", &GaugeRow::y_m},
    Column<GaugeRow>{"ux_m", &GaugeRow::ux_m},
    Column<GaugeRow>{"uy_m", &GaugeRow::uy_m},
    Column<GaugeRow>{"uz_m", &GaugeRow::uz_m},
    Column<GaugeRow>{"vx_m_s", &GaugeRow::vx_m_s},
    Column<GaugeRow>{"vy_m_s", &GaugeRow::vy_m_s},
    Column<GaugeRow>{"vz_m_s", &GaugeRow::vz_m_s},
    Column<GaugeRow>{"strain_xx", &GaugeRow::strain_xx},
    Column<GaugeRow>{"strain_yy", &GaugeRow::strain_yy},
    Column<GaugeRow>{"strain_xy", &GaugeRow::strain_xy},
};

/// Columns of a rate curve behind the tip position.
inline constexpr std::array rate_columns{
    Column<RatePoint>{"ratio", &RatePoint::ratio},
    Column<RatePoint>{"ratio_fracture", &RatePoint::ratio_fracture},
    Column<RatePoint>{"ratio_paper", &RatePoint::ratio_paper},
    Column<RatePoint>{"ratio_difference", &RatePoint::ratio_difference},
};

/// Columns of the events behind beam and lane.
inline constexpr std::array event_columns{
    Column<ReleaseEvent>{"time_s", &ReleaseEvent::time_s},
    Column<ReleaseEvent>{"position_m", &ReleaseEvent::position_m},
    Column<ReleaseEvent>{"energy_j", &ReleaseEvent::energy_j},
    Column<ReleaseEvent>{"x_m", &ReleaseEvent::x_m},
    Column<ReleaseEvent>{"y_m", &ReleaseEvent::y_m},
    Column<ReleaseEvent>{"tension", &ReleaseEvent::tension},
};

/// The names of columns, a comma before each.
template <typename Columns>
[[nodiscard]] std::string names_of(const Columns& columns) {
  std::string names;
  for (const auto& column : columns) names += ',' + base::csv_field(column.name);
  return names;
}

/// A row's numbers in columns, a comma before each.
template <typename Row, typename Columns>
[[nodiscard]] std::string numbers_of(const Row& row, const Columns& columns) {
  std::string numbers;
  for (const auto& column : columns) numbers += ',' + base::csv_field(row.*column.value);
  return numbers;
}

// `series.csv`: one row per sample and lane. Numbers are the shortest text that reads back to the same bits;
// what is not defined (NaN, a release rate where none is known) is an empty field.

/// gauges.csv: one row per gauge, lane and moment, in the journal's order.
std::string gauges_csv(std::span<const GaugeRow> rows);

/// Names of the columns, in their order, without a line end.
[[nodiscard]] std::string series_header();

/// "loading", "hold" or "fracture".
[[nodiscard]] std::string_view phase_name(Phase phase);

/// One line, with its end; the rate columns empty without `rate`.
[[nodiscard]] std::string series_row(const Sample& sample, const RatePoint* rate = nullptr);

/// For each sample its release rate: the point of its lane at exactly the same tip position, in the fracture
/// phase only (before it the tip stands still and has no rate); null where there is none. Points into
/// `rates`. Cost O(samples · log(points)).
[[nodiscard]] std::vector<const RatePoint*> match_rates(std::span<const Sample> samples,
                                                        std::span<const RateCurve> rates);

/// The whole table, rates filled in.
[[nodiscard]] std::string series_csv(std::span<const Sample> samples, std::span<const RateCurve> rates);

/// The table while the run goes on: rate columns empty. Throws WorldError where the file exists or the disk
/// is full.
class SeriesWriter {
 public:
  explicit SeriesWriter(const std::filesystem::path& path);
  void write(const Sample& sample) { file_.append(series_row(sample)); }
  void flush() { file_.flush(); }
  void close() { file_.close(); }

 private:
  base::AppendFile file_;
};

}  // namespace rift::results

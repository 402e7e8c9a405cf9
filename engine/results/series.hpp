#pragma once

#include "engine/base/files.hpp"
#include "engine/results/records.hpp"

#include <filesystem>
#include <span>
#include <string>
#include <string_view>
#include <vector>

/// `series.csv`: one row per sample and lane. Numbers are the shortest text that reads back to the same bits;
/// what is not defined (NaN, a release rate where none is known) is an empty field.
namespace rift::results {

/// gauges.csv: one row per gauge, lane and moment, in the journal's order.
std::string gauges_csv(std::span<const GaugeRow> rows);

/// Names of the columns, in their order, without a line end.
[[nodiscard]] std::string series_header();

/// "loading", "hold" or "fracture".
[[nodiscard]] std::string_view phase_name(Phase phase);

/// A double as a CSV field: shortest round-trip form, empty where it is NaN.
[[nodiscard]] std::string csv_number(double value);

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

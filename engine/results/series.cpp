#include "engine/results/series.hpp"

#include <fmt/format.h>

#include <cassert>
#include <cmath>
#include <map>

namespace rift::results {

std::string series_header() {
  std::string header = "step,time_s,phase,lane";
  for (const auto& column : sample_columns) header += fmt::format(",{}", column.name);
  for (const auto& column : rate_columns) header += fmt::format(",{}", column.name);
  return header;
}

std::string_view phase_name(Phase phase) {
  switch (phase) {
    case Phase::loading:
      return "loading";
    case Phase::hold:
      return "hold";
    case Phase::fracture:
      return "fracture";
  }
  assert(false);
  return "";
}

std::string csv_number(double value) {
  return std::isfinite(value) ? fmt::format("{}", value) : std::string();
}

std::string series_row(const Sample& sample, const RatePoint* rate) {
  std::string row = fmt::format("{},{},{},{}", sample.step, csv_number(sample.time_s),
                                phase_name(sample.phase), sample.lane);
  for (const auto& column : sample_columns) row += "," + csv_number(sample.*column.value);
  for (const auto& column : rate_columns)
    row += "," + (rate ? csv_number(rate->*column.value) : std::string());
  return row + "\n";
}

std::vector<const RatePoint*> match_rates(std::span<const Sample> samples, std::span<const RateCurve> rates) {
  std::map<std::pair<std::int32_t, double>, const RatePoint*> at;
  for (const auto& curve : rates)
    for (const auto& point : curve.points)
      if (!std::isnan(point.tip_m)) at.insert_or_assign({curve.lane, point.tip_m}, &point);
  std::vector<const RatePoint*> found;
  found.reserve(samples.size());
  for (const auto& sample : samples) {
    const bool may_have = sample.phase == Phase::fracture && !std::isnan(sample.tip_m);
    const auto point = may_have ? at.find({sample.lane, sample.tip_m}) : at.end();
    found.push_back(point == at.end() ? nullptr : point->second);
  }
  return found;
}

std::string series_csv(std::span<const Sample> samples, std::span<const RateCurve> rates) {
  const auto matched = match_rates(samples, rates);
  std::string text = series_header() + "\n";
  for (std::size_t i = 0; i < samples.size(); ++i) text += series_row(samples[i], matched[i]);
  return text;
}

std::string gauges_csv(std::span<const GaugeRow> rows) {
  std::string text = "step,time_s,lane,gauge";
  for (const auto& column : gauge_columns) text += fmt::format(",{}", column.name);
  text += '\n';
  for (const GaugeRow& row : rows) {
    text += fmt::format("{},{},{},{}", row.step, csv_number(row.time_s), row.lane, row.gauge);
    for (const auto& column : gauge_columns) text += "," + csv_number(row.*column.value);
    text += '\n';
  }
  return text;
}

SeriesWriter::SeriesWriter(const std::filesystem::path& path) : file_(path) {
  file_.append(series_header() + "\n");
  file_.flush();
}

}  // namespace rift::results

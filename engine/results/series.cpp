#include "engine/results/series.hpp"

#include <cassert>
#include <cmath>
#include <map>

namespace rift::results {

std::string series_header() {
  return "step,time_s,phase,lane" + names_of(sample_columns) + names_of(rate_columns);
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

std::string series_row(const Sample& sample, const RatePoint* rate) {
  const std::string rates = rate ? numbers_of(*rate, rate_columns) : std::string(rate_columns.size(), ',');
  return base::csv_fields(sample.step, sample.time_s, phase_name(sample.phase), sample.lane) +
         numbers_of(sample, sample_columns) + rates + "\n";
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
  std::string text = "step,time_s,lane,gauge" + names_of(gauge_columns) + "\n";
  for (const GaugeRow& row : rows)
    text +=
        base::csv_fields(row.step, row.time_s, row.lane, row.gauge) + numbers_of(row, gauge_columns) + "\n";
  return text;
}

SeriesWriter::SeriesWriter(const std::filesystem::path& path) : file_(path) {
  file_.append(series_header() + "\n");
  file_.flush();
}

}  // namespace rift::results

#include "viz/draw/moment.hpp"

#include "engine/results/archive.hpp"
#include "engine/results/json_input.hpp"
#include "engine/results/lane_summary.hpp"

#include <algorithm>

namespace rift::viz {
namespace {

template <typename Row>
auto first_after(const std::vector<Row>& rows, double time_s) {
  return std::upper_bound(rows.begin(), rows.end(), time_s,
                          [](double t, const Row& row) { return t < row.time_s; });
}

}  // namespace

LaneReader::LaneReader(const Pane& pane)
    : index_(pane.run / results::journal_name),
      lane_(pane.lane),
      header_(results::read_json(index_.header_json(), pane.run / results::journal_name)) {}

std::span<const results::Sample> LaneReader::samples_until(double since_start_s) const {
  const auto& samples = index_.samples(lane_);
  const auto start = std::find_if(samples.begin(), samples.end(), [](const results::Sample& s) {
    return s.phase == results::Phase::fracture;
  });
  const auto end = first_after(samples, start_s() + since_start_s);
  return start < end ? std::span(start, end) : std::span<const results::Sample>{};
}

double LaneReader::start_s() const {
  const auto& frames = index_.frames(lane_);
  if (frames.empty()) throw std::runtime_error("lane " + std::to_string(lane_) + " holds no frames yet");
  return frames.front().time_s;
}

double LaneReader::lasts_s() const {
  const double end = index_.frames(lane_).back().time_s;
  const double planned = header_.value("steps", 0.0) * header_.value("dt_s", 0.0);
  return (index_.summary_json() ? end : std::max(planned, end)) - start_s();
}

double LaneReader::velocity_at(double time_s) const {
  const auto& samples = index_.samples(lane_);
  const auto after = first_after(samples, time_s);
  return after == samples.begin() ? 0 : std::prev(after)->velocity_m_s;
}

/// What the header says of the lane; undefined where it says nothing.
results::LaneSummary LaneReader::scenario() const {
  const auto scenarios =
      results::lane_summaries_of(header_.value("scenarios", nlohmann::ordered_json::array()));
  const auto lane = static_cast<std::size_t>(lane_);
  return lane < scenarios.size() ? scenarios[lane] : results::LaneSummary{};
}

Moment LaneReader::at(double since_start_s, const Look& look) {
  const double time_s = start_s() + since_start_s;
  // A time that came as a difference may lie a rounding before the frame it means.
  const double until_s = time_s * (1 + 1e-12);
  if (!index_.summary_json() && index_.frames(lane_).back().time_s <= until_s) index_.extend();
  const auto after = first_after(index_.frames(lane_), until_s);
  const results::FrameEntry& entry = after == index_.frames(lane_).begin() ? *after : *std::prev(after);
  if (offset_ != entry.offset) frame_ = index_.frame(entry);
  offset_ = entry.offset;
  Moment moment;
  moment.since_start_s = entry.time_s - start_s();
  moment.tip_m = entry.tip_m;
  moment.velocity_m_s = velocity_at(entry.time_s);
  moment.history_s = entry.time_s + scenario().history_clock_s;
  moment.is_last = index_.summary_json() && after == index_.frames(lane_).end();
  moment.value = values_of(*find_field(look.field), frame_, geometry(), header_);
  if (look.magnification != 0) moment.displacement = frame_.displacement;
  moment.damage_factor = frame_.damage_factor;
  return moment;
}

}  // namespace rift::viz

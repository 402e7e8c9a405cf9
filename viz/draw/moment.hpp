#pragma once

#include "engine/results/journal_index.hpp"
#include "engine/results/lane_summary.hpp"
#include "viz/field.hpp"
#include "viz/job.hpp"

#include <nlohmann/json.hpp>

#include <cmath>
#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <vector>

/// One lane of a run, as its pane shows it.
namespace rift::viz {

/// What a pane shows of one moment.
struct Moment {
  double since_start_s = 0, tip_m = 0, velocity_m_s = 0;
  double history_s = 0;  // what the clock of a measured history shows; NaN without one
  bool is_last = false;  // the run has ended and nothing comes after
  std::vector<std::array<float, 3>> displacement;  // N [m]
  std::vector<float> value;                        // N, of the field that gives the colours [SI]
  std::vector<float> damage_factor;                // of each crossing beam; only where beams are drawn
};

/// Reads the moments of a lane.
class LaneReader {
 public:
  explicit LaneReader(const Pane& pane);

  [[nodiscard]] const results::Geometry& geometry() const { return index_.geometry(); }
  [[nodiscard]] const nlohmann::ordered_json& header() const { return header_; }
  /// The samples of the crack up to a time since its start [s]; as long as no later moment is asked for.
  [[nodiscard]] std::span<const results::Sample> samples_until(double since_start_s) const;
  /// The release rate against the tip; none before the run has ended.
  [[nodiscard]] const std::vector<results::RatePoint>& rates() const { return index_.rates(lane_); }
  [[nodiscard]] const std::vector<results::GaugeRow>& gauges() const { return index_.gauges(lane_); }
  [[nodiscard]] const std::vector<results::ReleaseEvent>& events() const { return index_.events(lane_); }
  [[nodiscard]] bool has_history() const { return std::isfinite(scenario().history_clock_s); }
  /// Whether its beams break by themselves: what starts then is the loads, not a crack.
  [[nodiscard]] bool breaks_by_itself() const { return scenario().crack_course == "free"; }
  /// When the crack, or the loads of beams that break by themselves, start [s], and how long that lasts as
  /// far as is known.
  [[nodiscard]] double start_s() const;
  [[nodiscard]] double lasts_s() const;
  /// The last stored moment until a time since the crack's start [s], or the first, with what the look needs
  /// of it. Asked of a run that goes on it looks what has been added.
  [[nodiscard]] Moment at(double since_start_s, const Look& look);
  /// The frame of the moment that was asked for last.
  [[nodiscard]] const results::Frame& frame() const { return frame_; }

 private:
  [[nodiscard]] double velocity_at(double time_s) const;
  [[nodiscard]] results::LaneSummary scenario() const;

  results::JournalIndex index_;
  std::int32_t lane_;
  nlohmann::ordered_json header_;
  results::Frame frame_;
  std::optional<std::uint64_t> offset_;  // of that frame
};

}  // namespace rift::viz

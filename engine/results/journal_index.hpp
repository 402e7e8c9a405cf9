#pragma once

#include "engine/base/ownership.hpp"
#include "engine/results/journal.hpp"
#include "engine/results/schema.hpp"

#include <cstdint>
#include <filesystem>
#include <functional>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace rift::results {

/// All of a journal but the fields of its frames, which are many and large.
struct JournalScan {
  std::string header_json;
  std::optional<Geometry> geometry;
  Mechanics mechanics;  // empty in journals of rift 0.1, and of what does not march
  std::vector<Sample> samples;
  std::vector<ReleaseEvent> events;
  std::vector<RateCurve> rates;
  std::vector<GaugeRow> gauges;
  std::optional<std::string> summary_json;  // only where the run ended by itself
  std::int32_t lanes = 0;                   // "lanes" of the header, or more where records name more
  std::int64_t frames = 0;                  // over all lanes
  std::int64_t last_step = 0;               // of samples and frames
  double last_time_s = 0;
  std::uint64_t good_bytes = 0;
  JournalState state = JournalState::whole;
  std::string reason;  // why the reading stopped; empty where the journal is whole
};

/// Reads the whole journal once; memory O(geometry + samples + one frame). Throws WorldError as JournalReader
/// does.
[[nodiscard]] JournalScan scan_journal(const std::filesystem::path& path);

/// Calls `visit` with the frames of each moment, those of all its lanes together, in the journal's order;
/// where a lane has two of one moment the later one holds. Memory O(one moment). Throws WorldError where a
/// frame does not fit `geometry`.
void for_each_moment(const std::filesystem::path& path, const Geometry& geometry,
                     const std::function<void(std::span<const Frame>)>& visit);

/// "displacement" where there is one lane, "displacement_lane3" where there are several (lane 0 included).
[[nodiscard]] std::string lane_name(std::string_view field, std::int32_t lane, std::int32_t lanes);

// What the records of one journal must agree on.

/// "lanes" of a run's header; 0 where it names none.
[[nodiscard]] std::int32_t lanes_of_header(const std::string& header_json);

/// Throws WorldError where a field of the frame has not as many values as the geometry has elements or
/// crossing beams.
void check_fit(const std::filesystem::path& path, const Geometry& geometry, const Frame& frame);

/// Where a frame stands in its journal.
struct FrameEntry {
  std::uint64_t offset = 0;
  std::int64_t step = 0;
  double time_s = 0;
  double tip_m = 0;
};

/// A journal whose frames are read in any order, of a run that may still be going on. Memory O(geometry +
/// samples + gauges' rows + one frame).
class JournalIndex {
 public:
  /// Reads what is whole. Throws WorldError where it cannot be read or does not begin as a journal does: with
  /// a header and a geometry.
  explicit JournalIndex(std::filesystem::path path);

  /// Reads on from where it stopped: what a run that goes on has added since. Throws RunReplaced where the
  /// journal is another run's by now.
  void extend();

  [[nodiscard]] const std::string& header_json() const { return header_json_; }
  [[nodiscard]] const Geometry& geometry() const { return geometry_; }
  [[nodiscard]] std::int32_t lanes() const { return static_cast<std::int32_t>(lane_.size()); }
  /// Of one lane, in the order of time.
  [[nodiscard]] const std::vector<FrameEntry>& frames(std::int32_t lane) const {
    return lane_.at(lane).frames;
  }
  [[nodiscard]] const std::vector<Sample>& samples(std::int32_t lane) const { return lane_.at(lane).samples; }
  /// What gauges showed, and which beams were released, in the order of time.
  [[nodiscard]] const std::vector<GaugeRow>& gauges(std::int32_t lane) const { return lane_.at(lane).gauges; }
  [[nodiscard]] const std::vector<ReleaseEvent>& events(std::int32_t lane) const {
    return lane_.at(lane).events;
  }
  /// The release rate against the tip; none before the run has ended.
  [[nodiscard]] const std::vector<RatePoint>& rates(std::int32_t lane) const { return lane_.at(lane).rates; }
  /// Only where the run has ended by itself.
  [[nodiscard]] const std::optional<std::string>& summary_json() const { return summary_json_; }
  /// How the reading came to its end, and why for people.
  [[nodiscard]] JournalState state() const { return state_; }
  [[nodiscard]] const std::string& reason() const { return reason_; }

  /// Reads a frame of `frames()` once more. Throws WorldError where the journal has changed, RunReplaced
  /// where it is another run's.
  [[nodiscard]] Frame frame(const FrameEntry& entry) const;

 private:
  struct Lane {
    std::vector<FrameEntry> frames;
    std::vector<Sample> samples;
    std::vector<GaugeRow> gauges;
    std::vector<ReleaseEvent> events;
    std::vector<RatePoint> rates;
  };
  void take(Record&& record, std::uint64_t offset);
  Lane& lane(std::int32_t number);

  std::filesystem::path path_;
  base::HeldFile held_;
  std::uint64_t good_bytes_ = 0;
  std::string header_json_;
  Geometry geometry_;
  std::vector<Lane> lane_;
  std::optional<std::string> summary_json_;
  JournalState state_ = JournalState::whole;
  std::string reason_;
};

}  // namespace rift::results

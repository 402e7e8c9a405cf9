#pragma once

#include "engine/results/journal.hpp"

#include <cstdint>
#include <filesystem>
#include <functional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace rift::results {

/// All of a journal but the fields of its frames, which are many and large.
struct JournalScan {
  std::string header_json;
  std::optional<Geometry> geometry;
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

}  // namespace rift::results

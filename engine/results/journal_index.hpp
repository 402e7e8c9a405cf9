#pragma once

#include "engine/base/ownership.hpp"
#include "engine/results/journal.hpp"

#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

namespace rift::results {

/// Where a frame stands in its journal.
struct FrameEntry {
  std::uint64_t offset = 0;
  std::int64_t step = 0;
  double time_s = 0;
  double tip_m = 0;
};

/// A journal whose frames are read in any order, of a run that may still be going on. Memory O(geometry +
/// samples
/// + one frame).
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

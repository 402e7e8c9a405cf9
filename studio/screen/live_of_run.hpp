#pragma once

#include "engine/results/journal_index.hpp"
#include "studio/screen/live.hpp"

#include <nlohmann/json.hpp>

#include <chrono>
#include <filesystem>

namespace rift::studio {

/// What a run's header says of it: names, sizes, titles and references of its lanes.
[[nodiscard]] Live live_of_header(const nlohmann::ordered_json& header, const std::filesystem::path& run);

/// Takes the lanes' ratios from the summary of a run that has ended.
void take_results(Live& live, const nlohmann::ordered_json& summary);

/// The screen of a run from its journal, read only: of a run that goes on elsewhere, or has ended.
class LiveOfRun {
 public:
  /// Throws WorldError where the folder holds no run that can be read.
  explicit LiveOfRun(const std::filesystem::path& run);

  /// Reads what has been added since. @return whether there was anything
  /// Throws RunReplaced where the folder holds another run by now, or none.
  bool look();
  [[nodiscard]] const Live& live() const { return live_; }

 private:
  void read_lane(int lane);
  void read_progress();
  [[nodiscard]] std::string state() const;

  using Clock = std::chrono::steady_clock;
  results::JournalIndex journal_;
  nlohmann::ordered_json header_;
  Live live_;
  Clock::time_point looked_ = Clock::now();
};

}  // namespace rift::studio

#pragma once

#include "engine/base/ownership.hpp"
#include "engine/results/journal.hpp"
#include "engine/results/series.hpp"

#include <nlohmann/json_fwd.hpp>

#include <cstdint>
#include <filesystem>
#include <functional>
#include <vector>

namespace rift::results {

/// Writes a run's folder while the run goes on and completes it at the end. Killed at any moment it leaves a
/// journal that is whole up to the last flush. One thread at a time. Every failure is a WorldError with path
/// and reason.
class RunWriter {
 public:
  /// @param folder  made by create_run_folder(), and owned by the caller (ClaimedFolder) where others might
  ///                write into it
  /// @param header  an object: what is run and by what: "preset" (effective, as text), "version", "seed",
  ///                "compiler", "instruction_set", "lanes" (how many) and more; each becomes
  ///                /scene/NAME of the archive
  /// @param mechanics  empty where nobody is to rebuild the run
  RunWriter(std::filesystem::path folder, const nlohmann::ordered_json& header, const Geometry& geometry,
            const Mechanics& mechanics = {});

  /// Goes on with a run that was stopped or killed, behind the first `journal_bytes` of its journal;
  /// series.csv is written anew up to there. What a stopped run had assembled at its end is dropped.
  RunWriter(std::filesystem::path folder, std::uint64_t journal_bytes);

  void sample(const Sample& sample);
  void frame(const Frame& frame);
  void event(const ReleaseEvent& event);
  void gauge(const GaugeRow& row);
  /// After each batch: what was given so far is then seen by `watch` and survives a kill. Throws WorldError
  /// where the folder no longer holds this journal: another run has replaced it.
  void flush();
  /// After flush(): how long the journal is.
  [[nodiscard]] std::uint64_t journal_bytes() const;

  /// The run has ended by itself: the rates and the summary (undefined values null) go into the journal, then
  /// complete_folder() does the rest.
  /// @param rate_per_lane  points of lane 0, 1, ...
  void finish(const nlohmann::ordered_json& summary,
              const std::vector<std::vector<RatePoint>>& rate_per_lane);

 private:
  void check_still_ours() const;

  std::filesystem::path folder_;
  JournalWriter journal_;
  base::HeldFile held_;
  SeriesWriter series_;
};

/// Makes what the end of a run leaves from its journal, which has come to its end: the final series.csv,
/// gauges.csv where there are gauges, run.vtkhdf and, last, summary.json. Each appears whole or not at all.
/// Throws WorldError.
/// @param check  asked before the tables and before the summary; stops by throwing
void complete_folder(const std::filesystem::path& folder, const std::function<void()>& check = {});

}  // namespace rift::results

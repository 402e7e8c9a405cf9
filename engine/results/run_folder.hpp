#pragma once

#include "engine/base/ownership.hpp"

#include <cstdint>
#include <filesystem>
#include <optional>
#include <set>
#include <stdexcept>
#include <string>
#include <string_view>

/// The folder of a run: made, and found again (docs/results-format.md).
namespace rift::results {

/// The folder is there and must not be written into; the user's mistake, exit code 2.
struct FolderExists : std::runtime_error {
  using std::runtime_error::runtime_error;
};

/// The folder of a run: made and owned before the first costly step, given back if nothing came of it. An
/// empty folder is as good as none. A folder that holds anything is refused, unless it holds a run and
/// `force` says to replace it; the former run stays until there is something to put in its place.
class ClaimedFolder {
 public:
  /// Throws FolderExists, or WorldError where the folder cannot be made or written to, or where another
  /// process writes into it or into an export below it.
  ClaimedFolder(std::filesystem::path folder, bool force);

  /// There is something to put into it: removes a former run's own files, its exports among them; files that
  /// rift did not write are never touched.
  const std::filesystem::path& keep();
  /// False where nothing keeps another process out.
  [[nodiscard]] bool has_locks() const { return owned_.has_locks(); }

 private:
  base::OwnedFolder owned_;
  bool force_;
};

/// Claims a folder and keeps it, as ClaimedFolder does; owned by nobody afterwards.
void create_run_folder(const std::filesystem::path& folder, bool force);

/// Removes a run's own files and its exports from a folder that the caller owns.
void clear_run_folder(const std::filesystem::path& folder);

/// Removes from an export's folder what an earlier export of its kind ("csv", "pvd", "ovito", "paraview",
/// "measure") has left and this one did not write.
/// @param written  names of files in it
void remove_other_exports(const std::filesystem::path& folder, const std::string& kind,
                          const std::set<std::string>& written);

/// Removes from a report's folder the files of these names and its charts.
void remove_report(const std::filesystem::path& folder, const std::set<std::string>& names);

/// Whether another process writes into the folder: a run or an export into its own, a study, a report.
/// False where there is no such folder.
[[nodiscard]] bool is_folder_being_written(const std::filesystem::path& folder);

/// A run's journal is no longer the one that was opened.
struct RunReplaced : base::WorldError {
  using base::WorldError::WorldError;
};

/// Throws RunReplaced where another run's journal has taken this one's place, or none is there: what was read
/// before and what is read now do not belong together.
void check_same_run(const base::HeldFile& journal);

enum class RunCondition : std::uint8_t {
  finished,    // the run ended by itself
  unfinished,  // stopped, killed or still going on; whole up to its last flush
  damaged,     // the journal is damaged at byte good_bytes; what lies before is whole
  not_a_run,   // no journal, or none of ours
};

/// What a folder holds, by its journal.
struct RunState {
  RunCondition condition = RunCondition::not_a_run;
  std::string reason;                       // for people: why it is not finished, or not a run
  std::string header_json;                  // empty where the journal holds none
  std::optional<std::string> summary_json;  // where the run ended by itself
  std::int32_t lanes = 0;
  std::int64_t samples = 0;
  std::int64_t frames = 0;
  std::int64_t last_step = 0;
  double last_time_s = 0;
  std::uint64_t good_bytes = 0;  // of the journal
  bool has_archive = false;      // run.vtkhdf is there
};

/// Reads the journal once. Throws WorldError only where it is there and cannot be read.
[[nodiscard]] RunState inspect_run(const std::filesystem::path& folder);

}  // namespace rift::results

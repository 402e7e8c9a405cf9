#pragma once

#include <cstdint>
#include <filesystem>
#include <optional>
#include <stdexcept>
#include <string>
#include <vector>

/// The folder of a run: made, and found again (docs/results-format.md).
namespace rift::results {

/// The folder is there and must not be written into; the user's mistake, exit code 2.
struct FolderExists : std::runtime_error {
  using std::runtime_error::runtime_error;
};

/// Makes the folder and its parents, and tries whether it can be written to. An empty folder is as good as
/// none. A folder that holds anything is refused, unless it holds a run and `force` says to replace it; the
/// former run stays for now. Throws FolderExists, or WorldError where the folder cannot be made or written
/// to.
/// @return the folders that were made, innermost first: who gives up removes them
std::vector<std::filesystem::path> claim_run_folder(const std::filesystem::path& folder, bool force);

/// Claims the folder and removes a former run's own files, its exports among them; files that rift did not
/// write are never touched.
void create_run_folder(const std::filesystem::path& folder, bool force);

/// Removes what `rift measure` has left in a folder, and no other file.
void remove_measured(const std::filesystem::path& folder);

/// The folder of a run: claimed before the first costly step, given back if nothing came of it. With `force`
/// the former run in it stays until there is something to put in its place. Throws as claim_run_folder().
class ClaimedFolder {
 public:
  ClaimedFolder(std::filesystem::path folder, bool force);
  ~ClaimedFolder();
  ClaimedFolder(const ClaimedFolder&) = delete;
  ClaimedFolder& operator=(const ClaimedFolder&) = delete;

  /// There is something to put into it.
  const std::filesystem::path& keep();

 private:
  std::filesystem::path folder_;
  bool force_, kept_ = false;
  std::vector<std::filesystem::path> made_;
};

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

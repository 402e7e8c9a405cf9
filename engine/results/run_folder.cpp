#include "engine/results/run_folder.hpp"

#include "engine/base/files.hpp"
#include "engine/base/world_error.hpp"
#include "engine/results/archive.hpp"
#include "engine/results/checkpoint.hpp"
#include "engine/results/journal_index.hpp"

#include <fmt/format.h>

#include <string_view>
#include <system_error>
#include <utility>
#include <vector>

namespace rift::results {
namespace {

namespace fs = std::filesystem;

bool has_affixes(std::string_view name, std::string_view prefix, std::string_view suffix) {
  return name.size() >= prefix.size() + suffix.size() && name.starts_with(prefix) && name.ends_with(suffix);
}

/// Films and pictures as `rift render` names them where nobody says otherwise.
bool is_picture(std::string_view name) {
  for (const char* film : {".mp4", ".webm", ".gif"})
    if (has_affixes(name, "film_", film)) return true;
  return has_affixes(name, "poster_", ".png") || (name.ends_with(".png") && name.find("_at_") != name.npos);
}

/// What `rift verify` has put aside: "journal_damaged.rift", "series_damaged2.csv".
bool is_put_aside(std::string_view name) {
  for (const char* stem :
       {"journal_damaged", "run_damaged", "series_damaged", "gauges_damaged", "summary_damaged"})
    if (name.starts_with(stem)) return true;
  return false;
}

bool is_run_file(const std::string& file) {
  const std::string name = base::target_name(file);  // what a kill has left is ours as well
  return name == journal_name || name == archive_name || name == series_name || name == summary_name ||
         name == gauges_name || name == steering_name || has_affixes(name, "checkpoint", ".h5") ||
         is_picture(name) || is_put_aside(name) || name == base::probe_name;
}

bool is_measured_folder(std::string_view name) {
  return name == "measure" || name.starts_with("measure_lane");
}

bool is_export_folder(std::string_view name) {
  return name == "csv" || name == "pvd" || name == "paraview" || name == "ovito" || is_measured_folder(name);
}

bool is_export(std::string_view folder, const std::string& file) {
  const std::string name = base::target_name(file);
  if (folder == "csv")
    return name == "series.csv" || name == "events.csv" || name == "rate.csv" || name == "crack.csv";
  if (folder == "paraview") return name == archive_name;
  if (folder == "ovito") return name.ends_with(".dump");
  if (is_measured_folder(folder))
    return name == "report.html" || name == "summary.json" || name == "field.csv" ||
           name == "stress_intensity.csv";
  if (folder == "charts")  // of what was measured
    return name.ends_with(".csv") || name.ends_with(".gp") || name.ends_with(".svg") ||
           name.ends_with(".png");
  return folder == "pvd" && (name == "run.pvd" || has_affixes(name, "frame_", ".vtp"));
}

std::vector<fs::path> entries(const fs::path& folder) {
  std::error_code error;
  std::vector<fs::path> paths;
  for (auto entry = fs::directory_iterator(folder, error); !error && entry != fs::directory_iterator();
       entry.increment(error))
    paths.push_back(entry->path());
  if (error) throw base::WorldError("read the folder", folder, error.message());
  return paths;
}

/// Removes what was exported into a folder as `kind`, and the folder where nothing else is in it.
void remove_export(const fs::path& folder, const std::string& kind) {
  for (const auto& path : entries(folder)) {
    const std::string file = path.filename().string();
    if (is_measured_folder(kind) && file == "charts" && fs::is_directory(path) && !fs::is_symlink(path))
      remove_export(path, file);
    else if (is_export(kind, file) && !fs::is_directory(path))
      base::remove_file(path);
  }
  if (entries(folder).empty()) base::remove_file(folder);
}

/// Refuses a folder below which another process is writing an export.
void check_exports(const fs::path& folder) {
  for (const auto& path : entries(folder))
    if (is_export_folder(path.filename().string()) && is_folder_being_written(path))
      throw base::WorldError("write into", folder,
                             "another process is writing " + path.filename().string() + " in it");
}

/// How to go on with the run in the folder, where that can be; asked of a folder that will not be replaced.
std::string what_to_do(const fs::path& folder) {
  const RunState state = inspect_run(folder);
  const bool can_be_resumed =
      !state.header_json.empty() && (state.condition != RunCondition::finished || !state.has_archive ||
                                     fs::exists(folder / checkpoint_name));
  if (!can_be_resumed)
    return fmt::format("{} exists and is not empty; --force replaces a run in it", folder.string());
  return fmt::format("{0} holds an unfinished run: 'rift resume {0}' continues it, --force replaces it",
                     folder.string());
}

void check_contents(const fs::path& folder, bool force) {
  if (base::is_being_written(folder /
                             journal_name))  // from another node, which the folder's lock may not reach
    throw base::WorldError("write into", folder, "another process is writing it");
  bool empty = true, holds_run = false;
  for (const auto& path : entries(folder)) {
    empty = false;
    holds_run = holds_run || is_run_file(path.filename().string());
  }
  if (!empty && !force) throw FolderExists(what_to_do(folder));
  if (!empty && !holds_run)
    throw FolderExists(
        fmt::format("{} holds other files and no run; --force replaces only runs", folder.string()));
  check_exports(folder);
}

}  // namespace

void remove_report(const fs::path& folder, const std::set<std::string>& names) {
  for (const auto& path : entries(folder)) {
    const std::string file = path.filename().string();
    if (file == "charts" && fs::is_directory(path) && !fs::is_symlink(path)) remove_export(path, file);
    if (names.contains(file) && !fs::is_directory(path)) base::remove_file(path);
  }
}

void remove_other_exports(const fs::path& folder, const std::string& kind,
                          const std::set<std::string>& written) {
  for (const auto& path : entries(folder)) {
    const std::string file = path.filename().string();
    if (base::target_name(file) == file && is_export(kind, file) && !written.contains(file) &&
        !fs::is_directory(path))
      base::remove_file(path);
  }
}

ClaimedFolder::ClaimedFolder(fs::path folder, bool force)
    : owned_(std::move(folder), [force](const fs::path& p) { check_contents(p, force); }), force_(force) {}

const fs::path& ClaimedFolder::keep() {
  check_contents(owned_.path(), force_);
  clear_run_folder(owned_.path());
  owned_.keep();
  return owned_.path();
}

void create_run_folder(const fs::path& folder, bool force) { ClaimedFolder(folder, force).keep(); }

void clear_run_folder(const fs::path& folder) {
  for (const auto& path : entries(folder)) {
    const auto name = path.filename().string();
    if (is_run_file(name) && !fs::is_directory(path)) base::remove_file(path);
    if (is_export_folder(name) && fs::is_directory(path) && !fs::is_symlink(path)) remove_export(path, name);
  }
}

RunState inspect_run(const fs::path& folder) {
  RunState state;
  const auto journal = folder / journal_name;
  std::error_code ignored;
  if (!fs::exists(journal, ignored)) {
    state.reason = fmt::format("{} holds no {}", folder.string(), journal_name);
    return state;
  }
  auto scan = scan_journal(journal);
  state.reason = scan.reason;
  state.header_json = std::move(scan.header_json);
  state.summary_json = std::move(scan.summary_json);
  state.lanes = scan.lanes;
  state.samples = static_cast<std::int64_t>(scan.samples.size());
  state.frames = scan.frames;
  state.last_step = scan.last_step;
  state.last_time_s = scan.last_time_s;
  state.good_bytes = scan.good_bytes;
  state.has_archive = fs::exists(folder / archive_name, ignored);

  if (scan.state == JournalState::foreign) {
    state.condition = RunCondition::not_a_run;
  } else if (scan.state == JournalState::damaged) {
    state.condition = RunCondition::damaged;
  } else if (scan.state == JournalState::whole && state.summary_json) {
    state.condition = RunCondition::finished;
  } else {
    state.condition = RunCondition::unfinished;
    if (state.header_json.empty())
      state.reason = fmt::format(
          "its journal does not say yet what the run computes; where it was killed there is nothing to "
          "continue, and 'rift run PRESET --out {} --force' begins it again",
          folder.string());
    else if (state.reason.empty())
      state.reason = "the run has not ended: stopped, killed or still going on";
  }
  return state;
}

bool is_folder_being_written(const fs::path& folder) {
  // The journal's lock is seen by other nodes, too, where the folder's is not.
  return base::is_owned(folder) || base::is_being_written(folder / journal_name);
}

void check_same_run(const base::HeldFile& journal) {
  if (!journal.is_still_there())
    throw RunReplaced("read", journal.path(), "it was removed or replaced by another run meanwhile");
}

}  // namespace rift::results

#include "engine/results/run_folder.hpp"

#include "engine/results/archive.hpp"
#include "engine/results/files.hpp"
#include "engine/results/journal_scan.hpp"
#include "engine/results/world_error.hpp"

#include <fmt/format.h>

#include <string_view>
#include <system_error>
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

bool is_run_file(std::string_view name) {
  if (name.ends_with(".part")) name.remove_suffix(5);  // left by a kill
  return name == journal_name || name == archive_name || name == series_name || name == summary_name ||
         name == gauges_name || name == steering_name || has_affixes(name, "checkpoint", ".h5") ||
         is_picture(name) || is_put_aside(name);
}

bool is_measured_folder(std::string_view name) {
  return name == "measure" || name.starts_with("measure_lane");
}

bool is_export_folder(std::string_view name) {
  return name == "csv" || name == "pvd" || name == "paraview" || name == "ovito" || is_measured_folder(name);
}

bool is_export(std::string_view folder, std::string_view name) {
  if (name.ends_with(".part")) name.remove_suffix(5);
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
  if (error) throw WorldError("read the folder", folder, error.message());
  return paths;
}

void remove_file(const fs::path& path) {
  std::error_code error;
  fs::remove(path, error);
  if (error) throw WorldError("remove", path, error.message());
}

/// Removes what was exported into a folder as `kind`, and the folder where nothing else is in it.
void remove_export(const fs::path& folder, const std::string& kind) {
  for (const auto& path : entries(folder)) {
    const std::string file = path.filename().string();
    if (is_measured_folder(kind) && file == "charts" && fs::is_directory(path) && !fs::is_symlink(path))
      remove_export(path, file);
    else if (is_export(kind, file) && !fs::is_directory(path))
      remove_file(path);
  }
  if (entries(folder).empty()) remove_file(folder);
}

/// Removes a former run and its exports, and nothing else.
void remove_run(const fs::path& folder) {
  for (const auto& path : entries(folder)) {
    const auto name = path.filename().string();
    if (is_run_file(name) && !fs::is_directory(path)) remove_file(path);
    if (is_export_folder(name) && fs::is_directory(path) && !fs::is_symlink(path)) remove_export(path, name);
  }
}

void try_to_write(const fs::path& folder) {
  const auto probe = folder / ".rift_probe.part";
  std::error_code nothing_to_remove;
  fs::remove(probe, nothing_to_remove);
  try {
    AppendFile file(probe);
    file.append("rift");
    file.close();
  } catch (const WorldError& failure) {
    fs::remove(probe, nothing_to_remove);
    throw WorldError("write into", folder, failure.what());
  }
  remove_file(probe);
}

}  // namespace

void remove_measured(const fs::path& folder) {
  for (const auto& path : entries(folder)) {
    const std::string file = path.filename().string();
    if (file == "charts" && fs::is_directory(path) && !fs::is_symlink(path)) remove_export(path, file);
    if (is_export("measure", file) && file != "field.csv.part" && !fs::is_directory(path)) remove_file(path);
  }
}

std::vector<fs::path> claim_run_folder(const fs::path& folder, bool force) {
  std::vector<fs::path> made;
  std::error_code error;
  for (fs::path p = folder; !p.empty() && !fs::exists(p, error); p = p.parent_path()) made.push_back(p);
  fs::create_directories(folder, error);
  if (error) throw WorldError("create the folder", folder, error.message());
  if (!fs::is_directory(folder)) throw WorldError("create the folder", folder, "a file of that name exists");

  bool empty = true;
  bool holds_run = false;
  for (const auto& path : entries(folder)) {
    empty = false;
    holds_run = holds_run || is_run_file(path.filename().string());
  }
  if (!empty && !force)
    throw FolderExists(
        fmt::format("{} exists and is not empty; --force replaces a run in it", folder.string()));
  if (!empty && !holds_run)
    throw FolderExists(
        fmt::format("{} holds other files and no run; --force replaces only runs", folder.string()));
  try_to_write(folder);
  return made;
}

void create_run_folder(const fs::path& folder, bool force) {
  claim_run_folder(folder, force);
  remove_run(folder);
}

ClaimedFolder::ClaimedFolder(fs::path folder, bool force)
    : folder_(std::move(folder)), force_(force), made_(claim_run_folder(folder_, force)) {}

ClaimedFolder::~ClaimedFolder() {
  std::error_code ignored;  // removes nothing but empty folders
  if (!kept_)
    for (const fs::path& made : made_) fs::remove(made, ignored);
}

const fs::path& ClaimedFolder::keep() {
  create_run_folder(folder_, force_);
  kept_ = true;
  return folder_;
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
    if (state.reason.empty()) state.reason = "the run has not ended: stopped, killed or still going on";
  }
  return state;
}

}  // namespace rift::results

#include "engine/study/status.hpp"

#include "engine/base/claim.hpp"
#include "engine/base/files.hpp"
#include "engine/results/json_input.hpp"
#include "engine/scene/issue.hpp"
#include "engine/study/store.hpp"

#include <algorithm>
#include <chrono>
#include <map>
#include <set>
#include <system_error>
#include <tuple>

namespace rift::study {
namespace {

namespace fs = std::filesystem;
using FileTime = fs::file_time_type;

/// The results in a folder by their names, and when each was written.
std::map<std::string, FileTime> results_in(const fs::path& folder) {
  std::map<std::string, FileTime> found;
  std::error_code none;  // no folder, no results
  for (const auto& entry : fs::directory_iterator(folder, none))
    if (entry.path().extension() == ".json") found[entry.path().stem().string()] = entry.last_write_time();
  return found;
}

/// At the pace of the last results, or nothing where there are too few.
double left_s(std::vector<FileTime> written, int left) {
  constexpr std::size_t looked_at = 32, least = 3;
  if (written.size() < least) return std::numeric_limits<double>::quiet_NaN();
  std::sort(written.begin(), written.end());
  const std::size_t from = written.size() - std::min(written.size(), looked_at);
  const auto counted = static_cast<double>(written.size() - 1 - from);
  const double lasted = std::chrono::duration<double>(FileTime::clock::now() - written[from]).count();
  return left * std::max(0.0, lasted) / counted;
}

/// Names of the study's scenarios, as those of their results.
std::vector<std::string> names_of(const fs::path& folder, std::string& preset) {
  const fs::path file = folder / study_name;
  const auto manifest = results::json_or_discarded(base::read_whole_file(file));
  const bool sound =
      manifest.is_object() && manifest.contains("scenarios") && manifest["scenarios"].is_array();
  if (!sound) throw scene::InputError({scene::Issue{.file = file.string(), .key = {}, .text = "is damaged"}});
  if (manifest.contains("preset") && manifest["preset"].is_string()) preset = manifest["preset"];
  std::vector<std::string> names;
  for (const auto& scenario : manifest["scenarios"])
    names.push_back(fs::path(scenario.value("file", std::string())).stem().string());
  return names;
}

}  // namespace

StudyStatus status_of(const fs::path& folder) {
  StudyStatus status;
  const std::vector<std::string> names = names_of(folder, status.preset);
  const auto done = results_in(folder / "runs"), not_made = results_in(folder / "not_made");
  const auto holders = base::Claims::holders(folder / "claims");
  status.scenarios = static_cast<int>(names.size());
  std::map<std::tuple<std::string, int, std::string>, Worker> workers;
  const auto worker_of = [&](const base::ClaimHolder& holder) -> Worker& {
    Worker& worker = workers[{holder.host, holder.process, holder.label}];
    worker.host = holder.host, worker.process = holder.process, worker.label = holder.label;
    worker.silent_s = holder.silent_s, worker.lives = holder.lives;
    return worker;
  };
  std::vector<FileTime> written;
  std::set<std::string> counted;  // two scenarios may be one
  for (const std::string& name : names) {
    const auto result = done.find(name);
    const auto holder = holders.find(name);
    if (result != done.end()) {
      ++status.done;
      if (counted.insert(name).second) written.push_back(result->second);
    } else if (not_made.contains(name)) {
      ++status.not_made;
    } else if (holder != holders.end()) {
      ++(holder->second.lives ? status.running : status.lost);
      ++worker_of(holder->second).scenarios;
    }
  }
  for (const auto& [name, holder] : holders)
    if (name.starts_with("specimen-")) worker_of(holder).prepares = true;
  for (const auto& [who, worker] : workers) status.workers.push_back(worker);
  if (status.running > 0)
    status.left_s = left_s(std::move(written), status.scenarios - status.done - status.not_made);
  return status;
}

}  // namespace rift::study

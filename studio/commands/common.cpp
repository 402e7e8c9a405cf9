#include "studio/commands/common.hpp"

#include "engine/base/files.hpp"
#include "engine/ensemble/instruction_set.hpp"
#include "engine/results/archive.hpp"
#include "engine/results/run_folder.hpp"
#include "engine/scene/issue.hpp"
#include "engine/study/store.hpp"

#include <CLI/CLI.hpp>
#include <fmt/format.h>
#include <unistd.h>

#include <cstdlib>
#include <set>
#include <stdexcept>
#include <system_error>
#include <vector>

namespace rift::studio {
namespace fs = std::filesystem;
namespace {

// An empty variable counts as unset, as https://no-color.org asks for its own.
std::string environment(const char* name) {
  const char* value = std::getenv(name);
  return value == nullptr ? "" : value;
}

std::vector<std::string> preset_names() {
  std::vector<std::string> names;
  std::error_code ignored;  // no folder, no names to suggest
  for (const auto& entry : fs::directory_iterator(presets_folder(), ignored))
    if (entry.path().extension() == ".toml") names.push_back(entry.path().stem().string());
  return names;
}

[[noreturn]] void refuse_preset(const std::string& preset) {
  std::error_code ignored;
  std::string text;
  if (fs::is_directory(preset, ignored)) {
    text = fmt::format("'{}' is a folder, not a preset", scene::printable(preset));
  } else {
    const std::string nearest = scene::nearest_name(fs::path(preset).stem().string(), preset_names());
    text = fmt::format("no such preset '{}'", scene::printable(preset));
    if (!nearest.empty()) text += fmt::format(", did you mean '{}'?", nearest);
  }
  text += fmt::format(" ('rift list' shows those in {})", presets_folder().string());
  refuse("rift", text);
}

/// Files of all kinds of reports, beside their charts.
const std::set<std::string>& report_files() {
  static const std::set<std::string> names{"report.html",
                                           "summary.json",
                                           "table.csv",
                                           "claims.csv",
                                           "material.toml",
                                           "elements.csv",
                                           "stress_intensity.csv",
                                           "field.csv",
                                           "toughness_position.csv",
                                           "toughness_velocity.csv"};
  return names;
}

/// Whether the folder holds nothing but what a report of this kind leaves that was killed before its end.
bool is_cut_off(const fs::path& folder, ReportKind kind) {
  bool begun = false;
  for (const auto& entry : fs::directory_iterator(folder)) {
    const std::string name = base::target_name(entry.path().filename().string());
    const bool run = kind.has_run && (name == "run" || name == "parts") && entry.is_directory();
    if (kind.has_run && name == "experiment.json") continue;  // beside parts/ and run/: what is under way
    if (!run && name != "charts" && (!report_files().contains(name) || name == "report.html")) return false;
    begun = begun || run || name == "charts" || name == "summary.json";
  }
  return begun;
}

}  // namespace

std::optional<std::string> mistake_in_variables() try {
  (void)ensemble::instruction_set();
  return {};
} catch (const std::invalid_argument& error) {
  return error.what();
}

fs::path presets_folder() {
  const std::string chosen = environment("RIFT_PRESETS");
  if (!chosen.empty()) return chosen;
  std::error_code ignored;
  const fs::path program = fs::read_symlink("/proc/self/exe", ignored);
  const fs::path installed = program.parent_path().parent_path() / "share" / "rift" / "presets";
  return fs::is_directory(installed, ignored) ? installed : fs::path(RIFT_SOURCE_PRESETS);
}

fs::path own_presets_folder() {
  if (const fs::path data = environment("XDG_DATA_HOME"); data.is_absolute())
    return data / "rift" / "presets";
  return fs::path(environment("HOME")) / ".local" / "share" / "rift" / "presets";
}

std::optional<fs::path> find_preset(const std::string& preset) {
  std::error_code ignored;
  const fs::file_status status = fs::status(preset, ignored);  // a pipe or /dev/stdin will do
  if (fs::exists(status) && !fs::is_directory(status)) return preset;
  if (!preset.empty() && !fs::path(preset).has_parent_path()) {
    for (const fs::path& folder : {presets_folder(), own_presets_folder()})
      for (const std::string ending : {"", ".toml"}) {
        const fs::path candidate = folder / (preset + ending);
        if (fs::is_regular_file(candidate, ignored)) return candidate;
      }
  }
  return std::nullopt;
}

fs::path resolve_preset(const std::string& preset) {
  const std::optional<fs::path> found = find_preset(preset);
  if (!found) refuse_preset(preset);
  return *found;
}

void check_is_run(const fs::path& folder) {
  std::error_code ignored;
  const fs::path below = folder / "run";
  if (fs::exists(folder / results::journal_name, ignored)) return;
  if (fs::exists(folder / study::study_name, ignored))
    refuse(folder.string(),
           fmt::format("holds a study, not a run: 'rift compare {0}' shows its scenarios, 'rift study PRESET "
                       "--out {0}' verifies and completes them",
                       folder.string()));
  if (fs::exists(below / results::journal_name, ignored))
    refuse(folder.string(), fmt::format("holds an experiment, not a run: its run is {}", below.string()));
}

void check_report(const fs::path& folder, bool force, ReportKind kind) {
  if (fs::is_empty(folder)) return;
  const bool report =
      fs::exists(folder / "summary.json") && fs::exists(folder / "charts") && fs::exists(folder / kind.own);
  const bool cut_off = !report && is_cut_off(folder, kind);
  if ((report || cut_off) && force) return;
  if (cut_off)
    throw results::FolderExists(fmt::format("{} holds {} that was interrupted; --force starts it again",
                                            folder.string(), kind.has_run ? "an experiment" : "a report"));
  throw results::FolderExists(fmt::format("{} exists and is not empty; --force replaces an earlier report{}",
                                          folder.string(), report ? "" : ", and the folder holds none"));
}

ReportFolder::ReportFolder(const fs::path& folder, bool force, ReportKind kind)
    : owned_(folder, [&](const fs::path& there) { check_report(there, force, kind); }) {}

const fs::path& ReportFolder::keep() {
  results::remove_report(owned_.path(), report_files());
  owned_.keep();
  return owned_.path();
}

void add_color_option(CLI::App& command, std::string& when) {
  when = "auto";
  command.add_option("--color", when, "Colours: auto (on a terminal, unless NO_COLOR is set), always, never")
      ->type_name("WHEN")
      ->check(CLI::IsMember({"auto", "always", "never"}))
      ->capture_default_str();
}

bool wants_color(std::string_view when, std::FILE* stream) {
  if (when != "auto") return when == "always";
  return environment("NO_COLOR").empty() && isatty(fileno(stream)) != 0;
}

void refuse(const std::string& file, const std::string& text) {
  refuse(scene::Issue{.file = file, .key = {}, .text = text});
}

void refuse(scene::Issue issue) { throw scene::InputError({std::move(issue)}); }

}  // namespace rift::studio

#pragma once

#include "engine/base/ownership.hpp"
#include "engine/scene/issue.hpp"
#include "studio/commands/version.hpp"
#include "studio/text/table.hpp"

#include <CLI/App.hpp>

#include <cstdio>
#include <filesystem>
#include <optional>
#include <string>
#include <string_view>

namespace rift::studio {

/// What the process returns.   [interface.md "Exit codes"]
enum class ExitCode {
  done = 0,
  world_failed = 1,
  bad_input = 2,
  diverged = 3,
  budget_ran_out = 4,
  not_whole = 6
};

/// What is wrong with a variable of the environment that every command reads.
std::optional<std::string> mistake_in_variables();

/// Where the presets are: $RIFT_PRESETS if set, else those installed beside the program
/// (../share/rift/presets), else those of the source tree. The folder need not exist.
std::filesystem::path presets_folder();

/// Where presets of the user's own are: $XDG_DATA_HOME/rift/presets, else ~/.local/share/rift/presets. It
/// need not exist.
std::filesystem::path own_presets_folder();

/// The preset that the user means, or nothing where there is none.
std::optional<std::filesystem::path> find_preset(const std::string& preset);

/// The preset that the user means: a path to a file, or the bare name of one in the presets folder
/// ("quickstart") or among the user's own. Throws InputError, with the nearest name, where there is none.
std::filesystem::path resolve_preset(const std::string& preset);

/// Throws InputError where the folder is a study, or keeps its run in a folder below, and says so: for
/// commands that want a run. What else may be wrong with it is theirs to say.
void check_is_run(const std::filesystem::path& folder);

/// What distinguishes a kind of report.
struct ReportKind {
  const char* own = "";  // a file that only they have; empty where there is none
  bool has_run = false;  // a run is recorded below, before the report is written
};

/// Throws results::FolderExists unless a report may be written into this folder: it is empty, or holds an
/// earlier report of the same kind, or what is left of one that was cut off, and `force` says to replace
/// that.
void check_report(const std::filesystem::path& folder, bool force, ReportKind kind = {});

/// The folder of a report: made and owned before the work, removed again if the work fails.
class ReportFolder {
 public:
  /// Throws as check_report(), and WorldError where it cannot be made or written to or another process writes
  /// into it.
  ReportFolder(const std::filesystem::path& folder, bool force, ReportKind kind = {});

  /// The report is there and is about to be written: removes the files and charts of an earlier one.
  const std::filesystem::path& keep();

 private:
  base::OwnedFolder owned_;
};

/// Adds --color auto|always|never to a command; `when` starts as and defaults to "auto".
void add_color_option(CLI::App& command, std::string& when);

/// Whether to write colours to `stream`: "always" and "never" decide; "auto" wants a terminal and no
/// $NO_COLOR.
bool wants_color(std::string_view when, std::FILE* stream);

/// Throws InputError with one mistake. @param file  what it is about: a preset's name, a command
[[noreturn]] void refuse(const std::string& file, const std::string& text);
[[noreturn]] void refuse(scene::Issue issue);

}  // namespace rift::studio

#include "studio/commands/common.hpp"

#include "engine/ensemble/instruction_set.hpp"
#include "engine/results/run_folder.hpp"
#include "engine/scene/issue.hpp"
#include "engine/scene/wording.hpp"

#include <CLI/CLI.hpp>
#include <fmt/format.h>
#include <unistd.h>

#include <cstdlib>
#include <system_error>
#include <vector>

namespace rift::studio {
namespace fs = std::filesystem;
namespace {

#ifdef NDEBUG
constexpr std::string_view build = "optimised, asserts off";
#else
constexpr std::string_view build = "asserts on";
#endif

#ifdef __clang__
constexpr std::string_view compiler = "Clang " __clang_version__;
#else
constexpr std::string_view compiler = "GCC " __VERSION__;
#endif

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
    text = fmt::format("'{}' is a folder, not a preset", printable(preset));
  } else {
    const std::string nearest = nearest_name(fs::path(preset).stem().string(), preset_names());
    text = fmt::format("no such preset '{}'", printable(preset));
    if (!nearest.empty()) text += fmt::format(", did you mean '{}'?", nearest);
  }
  text += fmt::format(" ('rift list' shows those in {})", presets_folder().string());
  throw InputError({Issue{.file = "rift", .key = {}, .text = text}});
}

}  // namespace

BuildInfo build_info() { return {RIFT_VERSION, std::string(compiler)}; }

std::string version_text() {
  return fmt::format("rift {} ({}; {}; {})", RIFT_VERSION, build, compiler, name_of(instruction_set()));
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

fs::path resolve_preset(const std::string& preset) {
  std::error_code ignored;
  if (fs::is_regular_file(preset, ignored)) return preset;
  if (!preset.empty() && !fs::path(preset).has_parent_path()) {
    for (const fs::path& folder : {presets_folder(), own_presets_folder()})
      for (const std::string ending : {"", ".toml"}) {
        const fs::path candidate = folder / (preset + ending);
        if (fs::is_regular_file(candidate, ignored)) return candidate;
      }
  }
  refuse_preset(preset);
}

void check_report_folder(const std::filesystem::path& folder, bool force, const char* own) {
  namespace fs = std::filesystem;
  std::error_code ignored;
  if (!fs::exists(folder, ignored) || fs::is_empty(folder, ignored)) return;
  const bool report = fs::exists(folder / "summary.json", ignored) &&
                      fs::exists(folder / "charts", ignored) && fs::exists(folder / own, ignored);
  if (report && force) return;
  throw results::FolderExists(fmt::format("{} exists and is not empty; --force replaces an earlier report{}",
                                          folder.string(), report ? "" : ", and this is none"));
}

void add_color_option(CLI::App& command, std::string& when) {
  when = "auto";
  command.add_option("--color", when, "Colours: auto (on a terminal, unless NO_COLOR is set), always, never")
      ->check(CLI::IsMember({"auto", "always", "never"}))
      ->capture_default_str();
}

bool wants_color(std::string_view when, std::FILE* stream) {
  if (when != "auto") return when == "always";
  return environment("NO_COLOR").empty() && isatty(fileno(stream)) != 0;
}

}  // namespace rift::studio

#include "engine/base/console.hpp"
#include "engine/base/text.hpp"
#include "studio/commands/commands.hpp"
#include "studio/text/catalogue.hpp"

#include <CLI/CLI.hpp>
#include <fmt/format.h>
#include <nlohmann/json.hpp>
#include <unistd.h>

#include <cmath>
#include <filesystem>
#include <limits>
#include <memory>
#include <sstream>
#include <string>
#include <utility>
#include <vector>

namespace rift::studio {
namespace {

struct ListOptions {
  bool json = false, names = false;
  std::string color;
};

/// A preset with what is to be read in it.
struct ListedPreset : PresetEntry {
  std::string command;
  double disk_bytes = 0;
  bool own = false;
};

/// Of the user's own presets, where it is there, and of those that came with the program.
std::vector<std::filesystem::path> folders() {
  std::error_code none;
  const std::filesystem::path own = own_presets_folder();
  if (!std::filesystem::is_directory(own, none)) return {presets_folder()};
  return {own, presets_folder()};
}

std::vector<ListedPreset> all_presets() {
  std::vector<ListedPreset> all;
  for (const std::filesystem::path& folder : folders())
    for (PresetEntry& entry : preset_entries(folder)) {
      const scene::Preset preset = scene::read_preset(entry.path);
      const bool sound = preset.issues.empty();
      all.push_back({std::move(entry), command_for(preset),
                     sound ? expected_disk_bytes(preset) : std::numeric_limits<double>::quiet_NaN(),
                     folder == own_presets_folder()});
    }
  return all;
}

void print_json(const std::vector<ListedPreset>& presets) {
  nlohmann::ordered_json all = nlohmann::ordered_json::array();
  for (const ListedPreset& e : presets)
    all.push_back({{"name", e.name},
                   {"path", e.path.string()},
                   {"own", e.own},
                   {"command", e.command},
                   {"shows", e.shows},
                   {"cost", e.cost},
                   {"disk_estimate_bytes", e.disk_bytes}});
  base::print_text(base::json_text(all, 2) + "\n");
}

/// What is said of a preset in a line.
std::string shown(const ListedPreset& e) { return e.own ? "(own) " + e.shows : e.shows; }

/// On a terminal that is too narrow for a table a preset has its line, and under it what it shows.
std::string in_paragraphs(const std::vector<ListedPreset>& presets, const Table& table, bool color,
                          std::size_t width) {
  constexpr std::size_t indent = 4;
  std::istringstream lines(plain_table(table, color));
  std::string line, text;
  std::getline(lines, line);
  text = line + "\n";
  for (const ListedPreset& e : presets) {
    std::getline(lines, line);
    text += line + "\n";
    for (const std::string& part : wrapped(base::escaped(shown(e)), width - indent))
      text += std::string(indent, ' ') + part + "\n";
  }
  return text;
}

void print_table(const std::vector<ListedPreset>& presets, bool color) {
  constexpr std::size_t wide = 130;
  Table table{{"preset", "command", "cost", "disk"}, {}};
  for (const ListedPreset& e : presets)
    table.rows.push_back({e.name, e.command.empty() ? "has mistakes" : e.command, e.cost,
                          std::isnan(e.disk_bytes) ? "" : fmt::format("{:.0f} MB", 1e-6 * e.disk_bytes)});
  const std::size_t width = base::terminal_width(STDOUT_FILENO);
  if (width > 0 && width < wide) {
    base::print_text(in_paragraphs(presets, table, color, width));
    return;
  }
  table.head.emplace_back("shows");
  for (std::size_t k = 0; k < presets.size(); ++k) table.rows[k].push_back(shown(presets[k]));
  base::print_text(plain_table(table, color, width));
}

void list(const ListOptions& options) {
  if (options.names) {
    for (const std::filesystem::path& folder : folders())
      for (const PresetEntry& e : preset_entries(folder)) base::print("{}\n", e.name);
    return;
  }
  const std::vector<ListedPreset> presets = all_presets();
  if (options.json)
    print_json(presets);
  else
    print_table(presets, wants_color(options.color, stdout));
}

}  // namespace

void add_list(CLI::App& app, ExitCode& exit_code) {
  CLI::App& command = *app.add_subcommand(
      "list", "Presets, your own first: the command that takes each, its cost, what it shows");
  const auto options = std::make_shared<ListOptions>();
  command.add_flag("-j,--json", options->json,
                   "A JSON array of name, path, own, command, shows, cost, disk_estimate_bytes");
  command.add_flag("--names", options->names, "The names alone, one a line")->excludes("--json");
  add_color_option(command, options->color);
  command.callback([options, &exit_code] {
    list(*options);
    exit_code = ExitCode::done;
  });
}

}  // namespace rift::studio

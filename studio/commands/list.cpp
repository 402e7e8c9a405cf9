#include "studio/commands/commands.hpp"

#include <CLI/CLI.hpp>
#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <memory>
#include <stdexcept>
#include <string>
#include <string_view>
#include <system_error>
#include <vector>

namespace rift::studio {
namespace fs = std::filesystem;
namespace {

struct ListOptions {
  bool json = false;
  std::string color;
};

/// A preset as its opening comment tells it; texts it does not tell are empty.
struct Entry {
  std::string name;
  fs::path path;
  std::string shows, cost;
};

// A preset opens with two comment lines: "# <what it shows>" and "# Cost: <text>".
Entry read_entry(const fs::path& path) {
  Entry entry{.name = path.stem().string(), .path = path, .shows = {}, .cost = {}};
  std::ifstream file(path);
  if (!file) throw std::runtime_error(fmt::format("cannot read the preset {}", path.string()));
  constexpr std::string_view mark = "Cost: ";
  for (std::string line; std::getline(file, line) && line.starts_with('#');) {
    while (!line.empty() && (line.back() == '\r' || line.back() == ' ')) line.pop_back();
    line.erase(0, std::min(line.find_first_not_of("# "), line.size()));
    if (line.starts_with(mark)) {
      entry.cost = line.substr(mark.size());
    } else if (entry.shows.empty()) {
      entry.shows = line;
    }
  }
  return entry;
}

std::vector<Entry> read_entries(const fs::path& folder) {
  std::error_code error;
  std::vector<Entry> entries;
  for (const auto& file : fs::directory_iterator(folder, error))
    if (file.path().extension() == ".toml") entries.push_back(read_entry(file.path()));
  if (error)
    throw std::runtime_error(
        fmt::format("cannot list the presets in {}: {}", folder.string(), error.message()));
  std::ranges::sort(entries, {}, &Entry::name);
  return entries;
}

void print_json(const std::vector<Entry>& entries) {
  nlohmann::ordered_json all = nlohmann::ordered_json::array();
  for (const Entry& e : entries)
    all.push_back({{"name", e.name}, {"path", e.path.string()}, {"shows", e.shows}, {"cost", e.cost}});
  fmt::print("{}\n", all.dump(2));
}

void print_table(const std::vector<Entry>& entries, bool color) {
  const Entry titles{.name = "preset", .path = {}, .shows = "shows", .cost = "cost"};
  std::size_t name_width = titles.name.size(), cost_width = titles.cost.size();
  for (const Entry& e : entries) {
    name_width = std::max(name_width, e.name.size());
    cost_width = std::max(cost_width, e.cost.size());
  }
  const auto row = [&](const Entry& e) {
    return fmt::format("{:<{}}  {:<{}}  {}", e.name, name_width, e.cost, cost_width, e.shows);
  };
  fmt::print("{}\n", heading(row(titles), color));
  for (const Entry& e : entries) fmt::print("{}\n", row(e));
}

void list(const ListOptions& options) {
  const std::vector<Entry> entries = read_entries(presets_folder());
  if (options.json) {
    print_json(entries);
  } else {
    print_table(entries, wants_color(options.color, stdout));
  }
}

}  // namespace

void add_list(CLI::App& app, ExitCode& exit_code) {
  CLI::App& command = *app.add_subcommand("list", "Presets, with one line and the cost of each");
  const auto options = std::make_shared<ListOptions>();
  command.add_flag("--json", options->json, "A JSON array of name, path, shows, cost");
  add_color_option(command, options->color);
  command.callback([options, &exit_code] {
    list(*options);
    exit_code = ExitCode::done;
  });
}

}  // namespace rift::studio

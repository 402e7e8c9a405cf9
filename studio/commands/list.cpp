#include "engine/base/console.hpp"
#include "engine/base/text.hpp"
#include "studio/commands/commands.hpp"
#include "studio/text/catalogue.hpp"

#include <CLI/CLI.hpp>
#include <nlohmann/json.hpp>

#include <memory>
#include <string>
#include <vector>

namespace rift::studio {
namespace {

struct ListOptions {
  bool json = false;
  std::string color;
};

void print_json(const std::vector<PresetEntry>& entries) {
  nlohmann::ordered_json all = nlohmann::ordered_json::array();
  for (const PresetEntry& e : entries)
    all.push_back({{"name", e.name}, {"path", e.path.string()}, {"shows", e.shows}, {"cost", e.cost}});
  base::print_text(base::json_text(all, 2) + "\n");
}

void list(const ListOptions& options) {
  const std::vector<PresetEntry> entries = preset_entries(presets_folder());
  if (options.json) {
    print_json(entries);
  } else {
    Table table{{"preset", "cost", "shows"}, {}};
    for (const PresetEntry& e : entries) table.rows.push_back({e.name, e.cost, e.shows});
    base::print_text(plain_table(table, wants_color(options.color, stdout)));
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

#include "studio/commands/help.hpp"

#include "engine/base/console.hpp"
#include "engine/scene/issue.hpp"
#include "studio/commands/commands.hpp"
#include "studio/text/table.hpp"

#include <CLI/CLI.hpp>
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <sstream>
#include <utility>

namespace rift::studio {
namespace {

constexpr std::size_t page_width = 80, options_width = 26;

constexpr std::array<Explained, 7> code_table{
    {{"0", "The command has done what was asked for."},
     {"1", "The disk, the network, a library or another program has failed."},
     {"2", "The input is wrong: a preset, an option, a file."},
     {"3", "A computation has diverged."},
     {"4", "The time of --budget is over; the same command goes on."},
     {"6", "Some scenarios of a study are missing or could not be made; it says which and why. The others are there."},
     {"128+n", "Signal n has stopped the command."}}};

constexpr std::array<Explained, 6> variable_table{
    {{"NO_COLOR", "If set, there are no colours but those of --color always."},
     {"RIFT_GRAPHICS",
      "How pictures reach the terminal, in place of what it answers: auto, kitty, sixel, iterm, symbols or "
      "cells."},
     {"RIFT_PRESETS", "The folder of presets, in place of the one that was installed."},
     {"RIFT_SIMD",
      "The instruction set of the kernels, baseline, AVX2 or AVX-512, in place of the widest that the processor "
      "has."},
     {"XDG_CACHE_HOME", "Packings and static solutions are kept in its folder rift (~/.cache/rift)."},
     {"XDG_DATA_HOME",
      "Presets of your own are kept in its folder rift/presets (~/.local/share/rift/presets)."}}};

// A line each, of the command that stands in it.
constexpr std::string_view examples = R"(rift studio quickstart
rift studio --lesson node-release
rift run quickstart
rift run plate_pnrt --print-config > mine.toml
rift resume runs/plate_pnrt
rift resume runs/plate_pnrt --budget '2 h'
rift render runs/quickstart
rift render runs/quickstart --at 0.6 --picture crack.png
rift view runs/quickstart
rift view runs/quickstart --graphics symbols --field v
rift watch runs/plate_pnrt
rift watch runs/plate_pnrt --color never
rift study study_release
rift study study_release --slurm --tasks 4 --time 00:30:00
rift reproduce fig07 fig13 --quick
rift reproduce beyond -o beyond
rift validate --quick
rift validate borden_branching -o validation
rift experiment experiment_polymer
rift experiment experiment_polymer --resamples 4 --specimens 1
rift accuracy quickstart --quick
rift accuracy plate_pnrt --goal 0.005 --yes
rift stability --quick
rift stability --only density -o stability
rift calibrate --young '3.2 GPa' --poisson 0.31
rift calibrate fig17_calibration -o calibration
rift pack --set specimen.elements=5000
rift pack quickstart -o packing
rift check plate_pnrt --set specimen.elements=80000
rift check study_release -j
rift compare runs/plate_snrt runs/plate_pnrt
rift compare studies/study_release --csv > table.csv
rift list
rift list --names
rift theory --v 0.3 --v 0.5
rift theory --steps 50 --csv > theory.csv
rift measure runs/plate_pnrt
rift measure runs/plate_pnrt --against camera.csv
rift export runs/quickstart --to csv
rift export runs/quickstart --to pvd
rift verify runs/quickstart
rift verify runs/quickstart --check-only -j
rift bench --elements 20000
rift bench --needs -j > needs.json
rift manual run | man -l -
rift manual --into share
source <(rift completion bash)
rift completion zsh > _rift
rift help study
rift help
)";

/// A text beside what it explains, in the columns of a page.
std::string beside(const std::string& left, const std::string& text) {
  std::string out = "  " + left, gap(options_width, ' ');
  std::size_t at = width_of(out);
  if (at + 2 > options_width && !text.empty()) out += "\n", at = 0;
  for (const std::string& line : wrapped(text, page_width - options_width)) {
    out += gap.substr(at) + line + "\n";
    at = 0;
  }
  return out.ends_with('\n') ? out : out + "\n";
}

std::string paragraph(const std::string& text) {
  return fmt::format("{}\n", fmt::join(wrapped(text, page_width), "\n"));
}

class HelpLayout : public CLI::Formatter {
 public:
  std::string make_description(const CLI::App* app) const override {
    return paragraph(app->get_description()) + "\n";
  }
  std::string make_subcommand(const CLI::App* sub) const override {
    return beside(sub->get_name(), sub->get_description());
  }
  std::string make_option(const CLI::Option* option, bool is_positional) const override {
    const OptionType type = type_of(*option);
    std::string left = make_option_name(option, is_positional), text = option->get_description();
    if (option->get_items_expected_max() > 0) left += " " + type.word;
    std::vector<std::string> also;
    if (!type.choices.empty()) also.push_back(fmt::format("{}", fmt::join(type.choices, ", ")));
    if (!type.range.empty()) also.push_back("in " + type.range);
    if (!option->get_default_str().empty()) also.push_back("default " + option->get_default_str());
    if (!also.empty()) text += fmt::format(" ({})", fmt::join(also, "; "));
    return beside(left, text);
  }
};

std::string list_of(std::string_view title, std::span<const Explained> words) {
  std::string text = fmt::format("\n{}:\n", title);
  for (const Explained& e : words) text += beside(e.word, e.meaning);
  return text;
}

std::vector<std::string> names_of_commands(const CLI::App& app) {
  std::vector<std::string> names;
  for (const CLI::App* command : commands_of(app)) names.push_back(command->get_name());
  return names;
}

}  // namespace

std::span<const Explained> exit_codes() { return code_table; }
std::span<const Explained> environment_variables() { return variable_table; }

std::vector<std::string> examples_of(std::string_view command) {
  const std::string call = fmt::format("rift {}", command);
  std::vector<std::string> found;
  std::istringstream lines{std::string(examples)};
  for (std::string line; std::getline(lines, line);) {
    const std::size_t at = line.find(call), end = at + call.size();
    if (at != std::string::npos && (end == line.size() || line[end] == ' ')) found.push_back(line);
  }
  return found;
}

std::shared_ptr<CLI::FormatterBase> help_layout() { return std::make_shared<HelpLayout>(); }

void add_footers(CLI::App& app) {
  const std::string after = list_of("Exit codes", code_table) + list_of("Environment", variable_table);
  for (const CLI::App* command : commands_of(app)) {
    std::string text = "Examples:\n";
    for (const std::string& example : examples_of(command->get_name())) text += "  " + example + "\n";
    app.get_subcommand(command->get_name())->footer(text + after);
  }
  app.footer(fmt::format("Examples:\n  rift list\n  rift help run\n{}", after));
}

std::vector<const CLI::App*> commands_of(const CLI::App& app) {
  return app.get_subcommands([](const CLI::App* command) { return !command->get_name().empty(); });
}

const CLI::App& command_named(const CLI::App& app, const std::string& name, const std::string& who) {
  const std::vector<std::string> names = names_of_commands(app);
  if (std::find(names.begin(), names.end(), name) != names.end()) return *app.get_subcommand(name);
  const std::string nearest = scene::nearest_name(name, names);
  refuse(who, fmt::format("no such command '{}'{}", scene::printable(name),
                          nearest.empty() ? "" : ", did you mean '" + nearest + "'?"));
}

std::string help_of(const CLI::App& app, const std::string& command) {
  // App::help() would be that of the command which runs.
  const auto layout = app.get_formatter();
  if (command.empty()) return layout->make_help(&app, app.get_name(), CLI::AppFormatMode::Normal);
  return layout->make_help(&command_named(app, command, "rift help"), app.get_name() + " " + command,
                           CLI::AppFormatMode::Normal);
}

std::string nearest_option(const CLI::App& command, const std::string& name) {
  std::vector<std::string> names;
  for (const CLI::Option* option : command.get_options())
    for (const std::string& known : option->get_lnames()) names.push_back(known);
  const bool known = std::find(names.begin(), names.end(), name) != names.end();
  const std::string nearest = known ? name : scene::nearest_name(name, names);
  return nearest.empty() ? nearest : "--" + nearest;
}

namespace {

/// "--elements=3" as its name and its value.
std::pair<std::string, std::string> parted(const std::string& option) {
  const std::size_t name = option.find_first_not_of('-'), equals = option.find('=');
  if (name == std::string::npos) return {};
  return {option.substr(name, equals - name), equals == std::string::npos ? "" : option.substr(equals + 1)};
}

/// An option that the command has not: its nearest one, or the parameter that --set sets.
std::string unknown_option(const CLI::App& chosen, const std::string& option) {
  const auto [name, value] = parted(option);
  const std::string text = fmt::format("there is no option '{}'", scene::printable(option)),
                    near = nearest_option(chosen, name), key = scene::nearest_key(name);
  if (!near.empty()) return fmt::format("{}, did you mean '{}'?", text, near);
  if (key.empty() || chosen.get_option_no_throw("--set") == nullptr) return text;
  return fmt::format("{}: --set {}={} sets this parameter", text, key,
                     value.empty() ? "VALUE" : scene::printable(value));
}

}  // namespace

std::vector<std::string> unexpected_arguments(const CLI::App& chosen,
                                              const std::vector<std::string>& arguments) {
  std::vector<std::string> texts;
  bool may_be_value = false;  // of the unknown option before it
  for (const std::string& argument : arguments) {
    const bool option = argument.size() > 1 && argument.starts_with('-');
    const bool assignment = !option && argument.find('=') != std::string::npos;
    if (option) {
      texts.push_back(unknown_option(chosen, argument));
    } else if (assignment && chosen.get_option_no_throw("--set") != nullptr) {
      texts.push_back(
          fmt::format("'{0}' is not expected, did you mean '--set {0}'?", scene::printable(argument)));
    } else if (!may_be_value) {
      const std::string near = scene::nearest_name(argument, names_of_commands(chosen));
      texts.push_back(fmt::format("'{}' is not expected{}", scene::printable(argument),
                                  near.empty() ? "" : fmt::format(", did you mean '{}'?", near)));
    }
    may_be_value = option && argument.find('=') == std::string::npos;
  }
  return texts;
}

void add_help(CLI::App& app, ExitCode& exit_code) {
  CLI::App& command = *app.add_subcommand("help", "The same as --help, of rift or of one of its commands");
  const auto name = std::make_shared<std::string>();
  command.add_option("command", *name, "The command")->type_name("NAME");
  command.callback([&app, name, &exit_code] {
    base::print_text(help_of(app, *name));
    exit_code = ExitCode::done;
  });
}

OptionType type_of(const CLI::Option& option) {
  const std::string type = option.get_type_name();
  OptionType found{.word = type.substr(0, type.find_first_of(":{ ")), .choices = {}, .range = {}};
  if (const std::size_t open = type.find('{'), close = type.find('}');
      open != std::string::npos && close != std::string::npos) {
    std::string word;
    for (const char letter : type.substr(open + 1, close - open - 1) + ",") {
      if (letter == ',')
        found.choices.push_back(std::exchange(word, {}));
      else
        word += letter;
    }
  }
  if (const std::size_t range = type.find('['); range != std::string::npos)
    found.range = type.substr(range, type.find(']', range) + 1 - range);
  return found;
}

}  // namespace rift::studio

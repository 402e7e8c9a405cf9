#include "engine/base/console.hpp"
#include "engine/base/files.hpp"
#include "studio/commands/commands.hpp"
#include "studio/commands/help.hpp"

#include <CLI/CLI.hpp>
#include <fmt/format.h>

#include <filesystem>
#include <memory>
#include <span>
#include <string>
#include <utility>
#include <vector>

/// Man pages and completions of the shells, made from the commands' own options.
namespace rift::studio {
namespace {

/// An option as people see it.
struct OptionText {
  std::vector<std::string> names;  // with their dashes; empty for a positional argument
  std::string argument;            // "FOLDER", "INT"; empty for a flag
  std::vector<std::string> choices;
  std::string description;
};

OptionText text_of(const CLI::Option& option) {
  OptionText text;
  for (const std::string& name : option.get_snames()) text.names.push_back("-" + name);
  for (const std::string& name : option.get_lnames()) text.names.push_back("--" + name);
  OptionType type = type_of(option);
  if (option.get_items_expected_max() > 0) text.argument = type.word;
  if (text.names.empty()) text.argument = option.get_name();
  text.choices = std::move(type.choices);
  text.description = option.get_description();
  return text;
}

std::vector<OptionText> options_of(const CLI::App& command) {
  std::vector<OptionText> options;
  for (const CLI::Option* option : command.get_options()) options.push_back(text_of(*option));
  return options;
}

/// Text of a man page: what starts a line with a dot, or a backslash or a dash, is text.
std::string roff(const std::string& text) {
  std::string out;
  for (const char letter : text) {
    if (letter == '\\')
      out += "\\e";
    else if (letter == '-')
      out += "\\-";
    else
      out += letter;
  }
  return out.starts_with('.') || out.starts_with('\'') ? "\\&" + out : out;
}

std::string roff_of(const OptionText& option) {
  std::string head;
  for (const std::string& name : option.names)
    head += (head.empty() ? "\\fB" : ", \\fB") + roff(name) + "\\fR";
  if (!option.argument.empty()) head += (head.empty() ? "\\fI" : " \\fI") + roff(option.argument) + "\\fR";
  return fmt::format(".TP\n{}\n{}\n", head, roff(option.description));
}

std::string rows_of(const char* title, std::span<const Explained> words) {
  std::string rows = fmt::format(".SH {}\n", title);
  for (const Explained& e : words) rows += fmt::format(".TP\n{}\n{}\n", roff(e.word), roff(e.meaning));
  return rows;
}

/// The page of one command: rift-COMMAND(1), after man-pages(7).
std::string man_page(const CLI::App& command) {
  const std::string name = "rift-" + command.get_name();
  std::string page = fmt::format(
      ".TH {} 1 \"\" \"rift {}\" \"Commands\"\n.SH NAME\n{} \\- {}\n.SH SYNOPSIS\n\\fBrift {}\\fR "
      "[\\fIOPTIONS\\fR]",
      roff(name), RIFT_VERSION, roff(name), roff(command.get_description()), command.get_name());
  std::string rows;
  for (const OptionText& option : options_of(command)) {
    if (option.names.empty()) page += fmt::format(" \\fI{}\\fR", roff(option.argument));
    rows += roff_of(option);
  }
  page += "\n.SH OPTIONS\n" + rows + ".SH EXAMPLES\n";
  for (const std::string& example : examples_of(command.get_name()))
    page += fmt::format(".TP\n\\fB{}\\fR\n", roff(example));
  return page + rows_of("EXIT STATUS", exit_codes()) + ".SH SEE ALSO\n\\fBrift\\fR(1)\n";
}

/// The page of the program: rift(1).
std::string man_page_of_all(const CLI::App& app) {
  std::string page = fmt::format(
      ".TH rift 1 \"\" \"rift {}\" \"Commands\"\n.SH NAME\nrift \\- {}\n.SH SYNOPSIS\n\\fBrift\\fR "
      "[\\fICOMMAND\\fR [\\fIOPTIONS\\fR]]\n"
      ".SH DESCRIPTION\nWithout a command the workbench opens in the terminal.\n.SH COMMANDS\n",
      RIFT_VERSION, roff(app.get_description()));
  for (const CLI::App* command : commands_of(app))
    page += fmt::format(".TP\n\\fBrift\\-{}\\fR(1)\n{}\n", roff(command->get_name()),
                        roff(command->get_description()));
  return page + rows_of("EXIT STATUS", exit_codes()) + rows_of("ENVIRONMENT", environment_variables());
}

std::string joined(const std::vector<std::string>& words) {
  std::string text;
  for (const std::string& word : words) text += (text.empty() ? "" : " ") + word;
  return text;
}

std::string names_of(const std::vector<OptionText>& options) {
  std::vector<std::string> names;
  for (const OptionText& option : options)
    names.insert(names.end(), option.names.begin(), option.names.end());
  return joined(names);
}

std::string names_of(const std::vector<const CLI::App*>& commands) {
  std::vector<std::string> names;
  for (const CLI::App* command : commands) names.push_back(command->get_name());
  return joined(names);
}

/// Options after a dash, the choices of an option after its name, else presets and files.
std::string bash_completion(const CLI::App& app) {
  std::string options, choices;
  for (const CLI::App* command : commands_of(app)) {
    const std::vector<OptionText> texts = options_of(*command);
    options += fmt::format("    {}) options='{}' ;;\n", command->get_name(), names_of(texts));
    for (const OptionText& option : texts)
      if (!option.choices.empty() && !option.names.empty())
        choices += fmt::format("    {}:{}) COMPREPLY=($(compgen -W '{}' -- \"$word\")); return ;;\n",
                               command->get_name(), option.names.back(), joined(option.choices));
  }
  return fmt::format(R"sh(# bash completion of rift, made by 'rift completion bash'
_rift() {{
  local word=${{COMP_WORDS[COMP_CWORD]}} before=${{COMP_WORDS[COMP_CWORD-1]}} command=${{COMP_WORDS[1]}} options
  if [ "$COMP_CWORD" -eq 1 ]; then
    COMPREPLY=($(compgen -W '{} --help --version -V' -- "$word"))
    return
  fi
  case "$command:$before" in
{}  esac
  case "$command" in
{}  esac
  if [[ $word == -* ]]; then
    COMPREPLY=($(compgen -W "$options" -- "$word"))
  else
    COMPREPLY=($(compgen -W "$("${{COMP_WORDS[0]}}" list --names 2>/dev/null)" -- "$word") $(compgen -f -- "$word"))
  fi
}}
complete -o filenames -F _rift rift
)sh",
                     names_of(commands_of(app)), choices, options);
}

/// Text between brackets of zsh's _arguments.
std::string zsh_text(const std::string& text) {
  std::string out;
  for (const char letter : text) {
    if (letter == '\'')
      out += "'\\''";
    else if (letter == '[' || letter == ']' || letter == ':' || letter == '\\')
      out += std::string("\\") + letter;
    else
      out += letter;
  }
  return out;
}

std::string zsh_completion(const CLI::App& app) {
  std::string commands, arguments;
  for (const CLI::App* command : commands_of(app)) {
    commands += fmt::format("    '{}:{}'\n", command->get_name(), zsh_text(command->get_description()));
    arguments += fmt::format("    {}) _arguments -s", command->get_name());
    for (const OptionText& option : options_of(*command)) {
      const std::string action = option.choices.empty() ? "_files" : "(" + joined(option.choices) + ")";
      for (const std::string& name : option.names)
        arguments += fmt::format(" \\\n      '*{}[{}]{}'", name, zsh_text(option.description),
                                 option.argument.empty() ? "" : ":" + option.argument + ":" + action);
    }
    arguments += " \\\n      '*:preset or file:_rift_names' ;;\n";
  }
  return fmt::format(R"sh(#compdef rift
# zsh completion of rift, made by 'rift completion zsh'
_rift_names() {{ compadd -- $(rift list --names 2>/dev/null); _files }}
_rift() {{
  local -a commands=(
{}  )
  if (( CURRENT == 2 )); then
    _describe command commands
    return
  fi
  local command=$words[2]
  shift words
  (( CURRENT-- ))
  case $command in
{}  esac
}}
_rift "$@"
)sh",
                     commands, arguments);
}

std::string fish_text(const std::string& text) {
  std::string out;
  for (const char letter : text)
    out += letter == '\'' || letter == '\\' ? std::string("\\") + letter : std::string(1, letter);
  return out;
}

std::string fish_completion(const CLI::App& app) {
  std::string out = "# fish completion of rift, made by 'rift completion fish'\n";
  for (const CLI::App* command : commands_of(app)) {
    out += fmt::format("complete -c rift -n __fish_use_subcommand -f -a {} -d '{}'\n", command->get_name(),
                       fish_text(command->get_description()));
    const std::string here =
        fmt::format("complete -c rift -n '__fish_seen_subcommand_from {}'", command->get_name());
    for (const OptionText& option : options_of(*command)) {
      std::string names;
      for (const std::string& name : option.names)
        names += name.starts_with("--") ? " -l " + name.substr(2) : " -s " + name.substr(1);
      if (names.empty()) continue;
      if (!option.argument.empty()) names += " -r";
      if (!option.choices.empty()) names += fmt::format(" -f -a '{}'", joined(option.choices));
      out += fmt::format("{}{} -d '{}'\n", here, names, fish_text(option.description));
    }
  }
  return out + "complete -c rift -n 'not __fish_use_subcommand' -a '(rift list --names 2>/dev/null)'\n";
}

}  // namespace

namespace {

std::string page_of(const CLI::App& app, const std::string& command) {
  if (command.empty()) return man_page_of_all(app);
  return man_page(command_named(app, command, "rift manual"));
}

/// All pages and completions as an installation wants them.
void write_all(const CLI::App& app, const std::filesystem::path& folder) {
  const auto write = [&](const std::filesystem::path& file, const std::string& text) {
    std::filesystem::create_directories((folder / file).parent_path());
    base::write_whole_file(folder / file, text);
  };
  write("man1/rift.1", man_page_of_all(app));
  for (const CLI::App* command : commands_of(app))
    write("man1/rift-" + command->get_name() + ".1", man_page(*command));
  write("bash/rift", bash_completion(app));
  write("zsh/_rift", zsh_completion(app));
  write("fish/rift.fish", fish_completion(app));
}

}  // namespace

void add_manual(CLI::App& app, ExitCode& exit_code) {
  struct ManualOptions {
    std::string command, folder;
  };
  CLI::App& command = *app.add_subcommand(
      "manual", "The man page of rift or of one of its commands, to be read by 'man -l -'");
  const auto options = std::make_shared<ManualOptions>();
  command.add_option("command", options->command, "The command; without it the page of the program")
      ->type_name("NAME");
  command
      .add_option("--into", options->folder,
                  "Write all pages, and the completions of all shells, into this folder")
      ->type_name("FOLDER");
  command.callback([&app, options, &exit_code] {
    if (options->folder.empty())
      base::print_text(page_of(app, options->command));
    else
      write_all(app, options->folder);
    exit_code = ExitCode::done;
  });
}

void add_completion(CLI::App& app, ExitCode& exit_code) {
  CLI::App& command = *app.add_subcommand("completion", "The completion script of a shell");
  const auto shell = std::make_shared<std::string>();
  command.add_option("shell", *shell, "bash, zsh or fish")
      ->type_name("SHELL")
      ->required()
      ->check(CLI::IsMember({"bash", "zsh", "fish"}));
  command.callback([&app, shell, &exit_code] {
    base::print_text(*shell == "bash"  ? bash_completion(app)
                     : *shell == "zsh" ? zsh_completion(app)
                                       : fish_completion(app));
    exit_code = ExitCode::done;
  });
}

}  // namespace rift::studio

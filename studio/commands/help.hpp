#pragma once

#include <CLI/App.hpp>

#include <memory>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace rift::studio {

/// A word that help and man pages explain: an exit code, a variable of the environment.
struct Explained {
  const char* word;
  const char* meaning;
};

/// What the process returns   [interface.md "Exit codes"].
std::span<const Explained> exit_codes();

/// What it reads of the environment.
std::span<const Explained> environment_variables();

/// Command lines that show what a command does: two of each.
std::vector<std::string> examples_of(std::string_view command);

/// Lays --help out in 80 columns. To be given to the program before its commands are added, which take it
/// over.
std::shared_ptr<CLI::FormatterBase> help_layout();

/// Adds examples, exit codes and variables to the help of the program and of each of its commands.
void add_footers(CLI::App& app);

/// The help of the program or of a command. Throws InputError, with the nearest name, of an unknown one.
std::string help_of(const CLI::App& app, const std::string& command);

/// The commands with a name, in the order in which they were added.
std::vector<const CLI::App*> commands_of(const CLI::App& app);

/// The command of a name. Throws InputError, with the nearest name, where there is none.
/// @param[in] who  says so: "rift help"
const CLI::App& command_named(const CLI::App& app, const std::string& name, const std::string& who);

/// What is wrong with arguments that were not expected, a text each, with what may have been meant: a
/// command, an option of `chosen`, a parameter for its --set.
std::vector<std::string> unexpected_arguments(const CLI::App& chosen,
                                              const std::vector<std::string>& arguments);

/// The option of a command that may be meant by a name ("budgt"), with its dashes; empty where none is near.
std::string nearest_option(const CLI::App& command, const std::string& name);

/// What an option's value is: its type's word ("FOLDER"), its allowed words, its range ("[1 - 1024]").
struct OptionType {
  std::string word;
  std::vector<std::string> choices;
  std::string range;
};
OptionType type_of(const CLI::Option& option);

}  // namespace rift::studio

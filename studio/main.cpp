#include "engine/base/console.hpp"
#include "engine/base/files.hpp"
#include "engine/results/run_folder.hpp"
#include "engine/scene/issue.hpp"
#include "studio/commands/commands.hpp"
#include "studio/commands/common.hpp"
#include "studio/commands/help.hpp"
#include "studio/commands/stop_signal.hpp"

#include <CLI/CLI.hpp>
#include <fmt/format.h>

#include <cerrno>
#include <exception>
#include <sstream>
#include <string>
#include <system_error>

namespace {

using rift::studio::ExitCode;

// CLI11 reports --help and --version as exceptions too: those with code 0.
ExitCode report(const CLI::App& app, const CLI::ParseError& error) {
  if (error.get_exit_code() == 0) {
    std::ostringstream text;
    app.exit(error, text, text);
    rift::base::print_text(text.str());
    return ExitCode::done;
  }
  std::string command = "rift";
  const CLI::App* chosen = &app;
  for (const CLI::App* one : app.get_subcommands()) command += " " + one->get_name(), chosen = one;
  const std::vector<std::string> unexpected =
      rift::studio::unexpected_arguments(*chosen, app.remaining(true));
  for (const std::string& text : unexpected) rift::base::message("{}: {}\n", command, text);
  if (unexpected.empty()) rift::base::message("{}: {}\n", command, error.what());
  rift::base::message("Try '{} --help'.\n", command);
  return ExitCode::bad_input;
}

ExitCode run(int argc, char** argv) {
  if (const auto mistake = rift::studio::mistake_in_variables()) {
    rift::base::message("rift: {}\n", *mistake);
    return ExitCode::bad_input;
  }
  CLI::App app("Dynamic fracture on a discrete-element beam lattice.", "rift");
  app.formatter(rift::studio::help_layout());
  app.set_version_flag("-V,--version", rift::studio::version_and_libraries_text());
  app.require_subcommand(0, 1);
  ExitCode exit_code = ExitCode::done;
  for (const auto add_command : rift::studio::all_commands) add_command(app, exit_code);
  rift::studio::add_footers(app);
  try {
    app.parse(argc, argv);
  } catch (const CLI::ParseError& error) {
    return report(app, error);
  }
  if (app.get_subcommands().empty()) return rift::studio::open_studio();
  return exit_code;
}

}  // namespace

int main(int argc, char** argv) {
  rift::base::secure_standard_streams();
  rift::studio::let_large_writes_fail();
  ExitCode code = ExitCode::done;
  try {
    code = run(argc, argv);
  } catch (const rift::scene::InputError& error) {
    for (const rift::scene::Issue& issue : error.issues)
      rift::base::message("{}\n", rift::scene::to_text(issue));
    code = ExitCode::bad_input;
  } catch (const rift::results::FolderExists& error) {
    rift::base::message("rift: {}\n", error.what());
    code = ExitCode::bad_input;
  } catch (const std::exception& error) {
    rift::base::message("rift: {}\n", rift::base::plain_text(error));
    code = ExitCode::world_failed;
  }
  if (const int failure = rift::base::printing_failure(); failure != 0) {
    if (failure != EPIPE)  // `rift list | head` is no mistake: its reader has what it wants
      rift::base::message("rift: cannot write to standard output: {}\n", rift::base::reason_of(failure));
    if (code == ExitCode::done) code = ExitCode::world_failed;
  }
  return static_cast<int>(code);
}

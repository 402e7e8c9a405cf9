#include "engine/base/text.hpp"
#include "studio/commands/commands.hpp"
#include "studio/commands/session.hpp"
#include "studio/reports/comparison_report.hpp"
#include "studio/reports/study_report.hpp"

#include <CLI/CLI.hpp>
#include <fmt/format.h>
#include <nlohmann/json.hpp>
#include <unistd.h>

#include <filesystem>
#include <memory>
#include <optional>

namespace rift::studio {
namespace {

struct CompareOptions : SessionOptions {
  std::vector<std::string> folders;
  std::string out;
  bool csv = false, force = false;
};

std::string command_text(const CompareOptions& options) {
  return fmt::format("rift compare {}", fmt::join(options.folders, " "));
}

ExitCode compare(const CompareOptions& options) {
  constexpr std::size_t without_terminal = 100;
  const std::vector<ComparedScenario> scenarios =
      compared_scenarios({options.folders.begin(), options.folders.end()});
  if (scenarios.empty()) refuse("rift compare", "nothing is computed yet in any of these folders");
  std::optional<ReportFolder> folder;
  if (!options.out.empty()) folder.emplace(options.out, options.force);
  Session session("rift compare", options);
  ExitCode code = ExitCode::done;
  if (folder)
    code = session.write_or_say([&] {
      write_comparison_report({command_text(options), build_info(), scenarios}, folder->keep());
    });
  session.line.clear();
  const std::vector<nlohmann::ordered_json> rows = comparison_rows(scenarios);
  if (options.csv) {
    base::print_text(rows_csv(rows));
    return code;
  }
  session.print_result({{"scenarios", rows}}, [&] {
    const std::size_t width = base::terminal_width(STDOUT_FILENO);
    base::print_text(comparison_text(scenarios, width > 0 ? width : without_terminal, session.color()));
    if (folder) base::print("\n{}/  report.html, table.csv, summary.json, charts\n", options.out);
  });
  return code;
}

}  // namespace

void add_compare(CLI::App& app, ExitCode& exit_code) {
  CLI::App& command = *app.add_subcommand(
      "compare", "Scenarios of runs and studies side by side: a table; with --out charts and a page too");
  const auto options = std::make_shared<CompareOptions>();
  command.add_option("runs", options->folders, "Folders of runs that have ended, and of studies")
      ->type_name("FOLDER")
      ->required();
  command.add_option("-o,--out", options->out, "Folder for report.html, table.csv, summary.json and charts")
      ->type_name("FOLDER");
  command.add_flag("-f,--force", options->force, "Replace the comparison that is in the folder");
  add_quiet(command, *options);
  add_json(command, *options);
  command.add_flag("--csv", options->csv, "All columns of the summaries as CSV on stdout")
      ->excludes("--json");
  add_color_option(command, options->color);
  command.callback([options, &exit_code] { exit_code = compare(*options); });
}

}  // namespace rift::studio

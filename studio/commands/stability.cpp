#include "engine/stability/suite.hpp"
#include "studio/commands/commands.hpp"
#include "studio/commands/session.hpp"
#include "studio/reports/stability_report.hpp"

#include <CLI/CLI.hpp>
#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <memory>
#include <optional>

namespace rift::studio {
namespace {

struct StabilityOptions : SessionOptions {
  stability::SuiteOptions suite;
  std::string out;
  bool force = false;
};

ExitCode stability(const StabilityOptions& options) {
  const std::vector<stability::StabilityCase> cases = stability::stability_cases(options.suite);
  if (cases.empty())
    refuse("rift stability", fmt::format("no family of cases has '{}' in its name", options.suite.only));
  std::optional<ReportFolder> folder;
  if (!options.out.empty()) folder.emplace(options.out, options.force);
  Session session("rift stability", options);
  StabilityReport report{.rows = {}, .growth = {}, .build = build_info(), .wall_s = 0};
  for (const stability::StabilityCase& one : cases) {
    session.progress(one.family, static_cast<double>(report.rows.size()) / static_cast<double>(cases.size()),
                     one.name);
    report.rows.push_back(stability::try_case(one));
    if (!session.goes_on()) break;
  }
  if (folder && session.goes_on()) report.growth = stability::growth_around_the_limit();
  session.line.clear();
  report.wall_s = session.seconds();
  session.print_result(stability_json(report),
                       [&] { base::print_text(stability_text(report, session.color())); });
  if (!session.goes_on()) return session.stopped();
  if (folder) {
    session.write([&] { write_stability_report(report, folder->keep()); });
    if (!options.json)
      base::print("{}/  report.html, table.csv, claims.csv, summary.json, charts\n", options.out);
  }
  const bool all = std::all_of(report.rows.begin(), report.rows.end(),
                               [](const stability::StabilityRow& row) { return row.as_expected; });
  return all ? ExitCode::done : ExitCode::diverged;
}

}  // namespace

void add_stability(CLI::App& app, ExitCode& exit_code) {
  CLI::App& command = *app.add_subcommand(
      "stability", "Suite of stiff and extreme cases: the expected and the observed outcome of each");
  const auto options = std::make_shared<StabilityOptions>();
  command.add_flag("--quick", options->suite.quick,
                   "10,000 steps of free vibration in place of a million, and no cracks below 0.01 c_R");
  command.add_option("--only", options->suite.only, "Families whose name contains this")->type_name("NAME");
  command
      .add_option("-o,--out", options->out,
                  "Folder for report.html, table.csv, claims.csv, summary.json and charts")
      ->type_name("FOLDER");
  command.add_flag("-f,--force", options->force, "Replace the report that is in the folder");
  add_quiet(command, *options);
  add_json(command, *options);
  add_color_option(command, options->color);
  command.callback([options, &exit_code] { exit_code = stability(*options); });
}

}  // namespace rift::studio

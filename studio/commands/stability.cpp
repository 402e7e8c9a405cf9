#include "engine/base/console.hpp"
#include "engine/base/text.hpp"
#include "engine/stability/suite.hpp"
#include "studio/commands/commands.hpp"
#include "studio/commands/scene_options.hpp"
#include "studio/reports/stability_report.hpp"

#include <CLI/CLI.hpp>
#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <chrono>
#include <memory>
#include <optional>

namespace rift::studio {
namespace {

using Clock = std::chrono::steady_clock;

struct StabilityOptions {
  stability::SuiteOptions suite;
  std::string out, color;
  bool force = false, quiet = false, json = false;
};

ExitCode stability(const StabilityOptions& options) {
  const std::vector<stability::StabilityCase> cases = stability::stability_cases(options.suite);
  if (cases.empty())
    throw scene::InputError(
        {scene::Issue{.file = "rift stability",
                      .key = {},
                      .text = fmt::format("no family of cases has '{}' in its name", options.suite.only)}});
  std::optional<ReportFolder> folder;
  if (!options.out.empty()) folder.emplace(options.out, options.force);
  const auto start = Clock::now();
  const StopSignal stop;
  ProgressLine line(progress_style(options.quiet, options.json));
  StabilityReport report{.rows = {}, .growth = {}, .build = build_info(), .wall_s = 0};
  for (const stability::StabilityCase& one : cases) {
    line.tell(one.family, static_cast<double>(report.rows.size()) / static_cast<double>(cases.size()),
              one.name);
    report.rows.push_back(stability::try_case(one));
    if (stop.received() != 0) break;
  }
  if (!options.out.empty() && stop.received() == 0) report.growth = stability::growth_around_the_limit();
  line.clear();
  report.wall_s = std::chrono::duration<double>(Clock::now() - start).count();
  if (options.json)
    base::print_text(base::json_text(stability_json(report), 2) + "\n");
  else
    base::print_text(stability_text(report, wants_color(options.color, stdout)));
  if (stop.received() != 0) return static_cast<ExitCode>(128 + stop.received());
  if (!options.out.empty()) {
    line.tell("report", 0.0);
    write_stability_report(report, folder->keep());
    line.clear();
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
      "stability", "The suite of stiff and extreme cases: what each must come to, and what it comes to");
  const auto options = std::make_shared<StabilityOptions>();
  command.add_flag("--quick", options->suite.quick,
                   "10,000 steps of free vibration in place of a million, and no cracks below 0.01 c_r");
  command.add_option("--only", options->suite.only, "Families whose name contains this");
  command.add_option("--out", options->out,
                     "Folder for report.html, table.csv, claims.csv, summary.json and charts");
  command.add_flag("--force", options->force, "Replace the report that is in the folder");
  command.add_flag("--quiet", options->quiet, "No progress on stderr");
  command.add_flag("--json", options->json, "Progress as JSON lines on stderr, the result as JSON on stdout");
  add_color_option(command, options->color);
  command.callback([options, &exit_code] { exit_code = stability(*options); });
}

}  // namespace rift::studio

#include "engine/results/verify.hpp"

#include "engine/base/console.hpp"
#include "engine/base/text.hpp"
#include "studio/commands/commands.hpp"
#include "studio/text/progress.hpp"
#include "studio/text/table.hpp"

#include <CLI/CLI.hpp>
#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <memory>
#include <string>

namespace rift::studio {
namespace {

struct VerifyOptions {
  std::string run, color;
  bool check_only = false, json = false;
};

std::string verdict(const results::Verification& v, const std::string& run) {
  if (v.running)
    return fmt::format("{} is still being computed: it was checked, and nothing was changed", run);
  if (!results::is_whole(v)) return fmt::format("{} has lost data or files; all undamaged data is kept", run);
  if (v.run.condition == results::RunCondition::unfinished)
    return fmt::format("{} is undamaged and unfinished: 'rift resume {}' continues it", run, run);
  return fmt::format("every file of {} is intact", run);
}

ExitCode verify(const VerifyOptions& options) {
  check_is_run(options.run);
  ProgressLine line(progress_style(false, options.json));
  line.show("verify", 0.0);
  const results::Verification v = results::verify_run(options.run, !options.check_only);
  line.clear();
  if (options.json) {
    nlohmann::ordered_json files = nlohmann::ordered_json::array();
    for (const results::Finding& f : v.files)
      files.push_back({{"file", f.file}, {"found", results::name_of(f.found)}, {"text", f.text}});
    const nlohmann::ordered_json all{{"run", options.run},     {"whole", results::is_whole(v)},
                                     {"running", v.running},   {"samples", v.run.samples},
                                     {"frames", v.run.frames}, {"last_step", v.run.last_step},
                                     {"files", files}};
    base::print_text(base::json_text(all, 2) + "\n");
  } else {
    Table table{{"file", "state", ""}, {}};
    for (const results::Finding& f : v.files)
      table.rows.push_back({f.file, results::name_of(f.found), f.text});
    base::print_text(plain_table(table, wants_color(options.color, stdout)) + "\n");
    base::print("{}\n", verdict(v, options.run));
  }
  return results::is_whole(v) ? ExitCode::done : ExitCode::world_failed;
}

}  // namespace

void add_verify(CLI::App& app, ExitCode& exit_code) {
  CLI::App& command = *app.add_subcommand(
      "verify", "Verify the checksums of every file of a run; repair or rebuild damaged files");
  const auto options = std::make_shared<VerifyOptions>();
  command.add_option("run", options->run, "Folder of the run")->type_name("FOLDER")->required();
  command.add_flag("--check-only", options->check_only, "Report only, change nothing");
  command.add_flag("-j,--json", options->json, "The result as JSON on stdout");
  add_color_option(command, options->color);
  command.callback([options, &exit_code] { exit_code = verify(*options); });
}

}  // namespace rift::studio

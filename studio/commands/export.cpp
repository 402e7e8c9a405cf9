#include "engine/results/export.hpp"

#include "studio/commands/commands.hpp"

#include <CLI/CLI.hpp>
#include <fmt/format.h>

#include <memory>

namespace rift::studio {
namespace {

struct ExportOptions {
  std::string run, to;
};

void export_run(const ExportOptions& options) {
  if (options.to == "csv") {
    fmt::print("{}\n", results::export_csv(options.run).string());
  } else {
    fmt::print("{}\n", results::export_pvd(options.run).string());
  }
}

}  // namespace

void add_export(CLI::App& app, ExitCode& exit_code) {
  CLI::App& command = *app.add_subcommand("export", "A run in other programs' formats");
  const auto options = std::make_shared<ExportOptions>();
  command.add_option("run", options->run, "Folder of the run")->required();
  command.add_option("--to", options->to, "csv: tables; pvd: a series of .vtp files for any ParaView")
      ->required()
      ->check(CLI::IsMember({"csv", "pvd"}));
  command.callback([options, &exit_code] {
    export_run(*options);
    exit_code = ExitCode::done;
  });
}

}  // namespace rift::studio

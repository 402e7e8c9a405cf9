#include "engine/results/export.hpp"

#include "engine/base/console.hpp"
#include "studio/commands/commands.hpp"
#include "studio/text/progress.hpp"

#include <CLI/CLI.hpp>

#include <map>
#include <memory>
#include <string>

namespace rift::studio {
namespace {

struct ExportOptions {
  std::string run, to;
};

using Export = std::filesystem::path (*)(const std::filesystem::path& run_folder);

const std::map<std::string, Export> exports{{"csv", results::export_csv},
                                            {"ovito", results::export_ovito},
                                            {"paraview", results::export_vtkhdf},
                                            {"pvd", results::export_pvd}};

}  // namespace

void add_export(CLI::App& app, ExitCode& exit_code) {
  CLI::App& command = *app.add_subcommand("export", "A run in other programs' formats");
  const auto options = std::make_shared<ExportOptions>();
  command.add_option("run", options->run, "Folder of the run")->type_name("FOLDER")->required();
  command
      .add_option("--to", options->to,
                  "csv: tables; paraview: run.vtkhdf, for ParaView 5.12 or later; pvd: a series of .vtp "
                  "files for any ParaView; ovito: LAMMPS dumps of elements and beams")
      ->type_name("FORMAT")
      ->required()
      ->check(CLI::IsMember({"csv", "paraview", "pvd", "ovito"}));
  command.callback([options, &exit_code] {
    check_is_run(options->run);
    ProgressLine line(progress_style(false, false));
    line.show("export", 0.0);
    const std::filesystem::path made = exports.at(options->to)(options->run);
    line.clear();
    base::print_path(made);
    exit_code = ExitCode::done;
  });
}

}  // namespace rift::studio

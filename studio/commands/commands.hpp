#pragma once

#include "studio/commands/common.hpp"

#include <CLI/App.hpp>

#include <array>

namespace rift::studio {

// One function and one file per subcommand: it adds the subcommand with its options to `app`. When the user
// calls the subcommand, its exit code is stored in `exit_code`, which outlives `app`; bad input may also
// leave as InputError and a failure of the world as any other exception, which main turns into exit codes 2
// and 1.
void add_accuracy(CLI::App& app, ExitCode& exit_code);
void add_bench(CLI::App& app, ExitCode& exit_code);
void add_calibrate(CLI::App& app, ExitCode& exit_code);
void add_check(CLI::App& app, ExitCode& exit_code);
void add_compare(CLI::App& app, ExitCode& exit_code);
void add_completion(CLI::App& app, ExitCode& exit_code);
void add_experiment(CLI::App& app, ExitCode& exit_code);
void add_export(CLI::App& app, ExitCode& exit_code);
void add_help(CLI::App& app, ExitCode& exit_code);
void add_list(CLI::App& app, ExitCode& exit_code);
void add_manual(CLI::App& app, ExitCode& exit_code);
void add_measure(CLI::App& app, ExitCode& exit_code);
void add_pack(CLI::App& app, ExitCode& exit_code);
void add_render(CLI::App& app, ExitCode& exit_code);
void add_reproduce(CLI::App& app, ExitCode& exit_code);
void add_resume(CLI::App& app, ExitCode& exit_code);
void add_run(CLI::App& app, ExitCode& exit_code);
void add_stability(CLI::App& app, ExitCode& exit_code);
void add_studio(CLI::App& app, ExitCode& exit_code);
void add_study(CLI::App& app, ExitCode& exit_code);
void add_theory(CLI::App& app, ExitCode& exit_code);
void add_validate(CLI::App& app, ExitCode& exit_code);
void add_verify(CLI::App& app, ExitCode& exit_code);
void add_view(CLI::App& app, ExitCode& exit_code);
void add_watch(CLI::App& app, ExitCode& exit_code);

/// What `rift` alone does.
ExitCode open_studio();

/// All subcommands, in the order of `rift --help`.
inline constexpr std::array all_commands = {
    add_studio,    add_run,      add_resume,     add_render,    add_view,      add_watch,     add_study,
    add_reproduce, add_validate, add_experiment, add_accuracy,  add_stability, add_calibrate, add_pack,
    add_check,     add_compare,  add_list,       add_theory,    add_measure,   add_export,    add_verify,
    add_bench,     add_help,     add_manual,     add_completion};

}  // namespace rift::studio

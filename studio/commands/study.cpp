#include "engine/base/files.hpp"
#include "engine/base/text.hpp"
#include "engine/study/plan.hpp"
#include "engine/study/runner.hpp"
#include "engine/study/store.hpp"
#include "studio/commands/commands.hpp"
#include "studio/commands/planned.hpp"
#include "studio/commands/session.hpp"
#include "studio/commands/study_command.hpp"
#include "studio/reports/study_report.hpp"
#include "studio/reports/work_precision.hpp"

#include <CLI/CLI.hpp>
#include <fmt/format.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <charconv>
#include <cstdlib>
#include <filesystem>
#include <memory>
#include <optional>
#include <set>
#include <system_error>

namespace rift::studio {
namespace fs = std::filesystem;
namespace {

using Json = nlohmann::ordered_json;

struct Shard {
  int index = 1, of = 1;
};

Shard read_shard(const std::string& text) {
  if (text.empty()) return {};
  Shard shard;
  const char *at = text.data(), *end = at + text.size();
  auto [slash, error] = std::from_chars(at, end, shard.index);
  bool valid = error == std::errc() && slash != end && *slash == '/';
  if (valid) {
    const auto last = std::from_chars(slash + 1, end, shard.of);
    valid = last.ec == std::errc() && last.ptr == end;
  }
  if (!valid) refuse("rift study", fmt::format("--shard {}: expected i/n, such as 2/8", text));
  if (shard.of < 1) refuse("rift study", fmt::format("--shard {}: there must be at least 1 part", text));
  if (shard.index < 1 || shard.index > shard.of)
    refuse("rift study", fmt::format("--shard {}: the index must lie in 1 to {}", text, shard.of));
  return shard;
}

/// Seconds that what is missing of this part takes, roughly.
double estimated_seconds(const scene::Preset& preset, const study::StudyOptions& options,
                         const simulation::BuildInfo& build) {
  std::vector<study::StudyItem> missing =
      study::part_of(study::plan_study(preset, build.version), options.shard, options.shards);
  std::erase_if(missing, [&](const study::StudyItem& item) {
    return fs::exists(study::result_file(options.folder, item.key));
  });
  return study::estimated_seconds(missing);
}

std::size_t scenarios_not_made(const study::StudyResult& result) {
  std::size_t count = 0;
  for (const study::NotMade& one : result.not_made) count += one.rows.size();
  return count;
}

std::size_t scenarios_missing(const study::StudyResult& result) {
  const auto missing = static_cast<std::size_t>(
      std::count_if(result.rows.begin(), result.rows.end(), [](const auto& row) { return !row; }));
  return missing - std::min(missing, scenarios_not_made(result));
}

/// "0.700 ± 0.161 along the window"
std::string scatter_text(const study::SummaryRow& row) {
  const std::string cell = scatter_cell(row.ratio, row.ratio_scatter);
  return cell.find("±") == std::string::npos ? cell : cell + " along the window";
}

std::string finished_text(const study::SummaryRow& row, int done, int of) {
  const Table table = scenario_table({row});
  std::string text = fmt::format("[{}/{}]", done, of);
  const std::size_t axes = row.axes.size();
  for (std::size_t k = 0; k < axes; ++k)
    if (table.rows[0][k] != "-")
      text += fmt::format(" {} {}", table.head[k], table.rows[0][k]) + (k + 1 < axes ? "," : ":");
  text += fmt::format("  ratio {}  {:.2f} s", scatter_text(row), study::marching_time(row));
  const Json where = row.outcome_where.empty() ? Json(nullptr) : Json(row.outcome_where);
  return row.outcome == "finished" ? text : text + "  " + row.outcome + ": " + base::json_text(where);
}

void show_finished(Session& session, const study::SummaryRow& row, int done, int of) {
  session.line.clear();
  if (session.options.quiet) return;
  const Json json{{"finished", row.row}, {"axes", to_json(row).at("axes")}, {"done", done}, {"of", of}};
  base::message("{}\n", session.options.json ? base::json_text(json) : finished_text(row, done, of));
}

/// What a study has left in its folder so far.
std::string files_in(const fs::path& folder) {
  std::string names;
  for (const char* name : {"table.csv", "report.html", "charts", "runs"})
    if (fs::exists(folder / name)) names += (names.empty() ? "" : ", ") + std::string(name);
  return names;
}

void print_not_made(const study::StudyResult& result, const scene::Preset& preset, bool color) {
  const Table table = not_made_table(result, preset);
  if (table.rows.empty()) return;
  const std::size_t width = base::terminal_width(STDOUT_FILENO);
  base::print_text(heading("could not be made", color) + "\n" + plain_table(table, color, width) + "\n");
}

/// One of several calls that compute a study, which writes no report.
bool is_a_part(const StudyCommand& command) {
  return !command.shard.empty() || command.claim || command.prepare;
}

void print_tables(const StudyCommand& command, const scene::Preset& preset, const study::StudyResult& result,
                  const fs::path& folder, bool color) {
  if (command.prepare) {
    print_not_made(result, preset, color);
    return base::print("the specimens of {} are packed and pre-stressed, {} in total\n",
                       base::counted(static_cast<std::int64_t>(result.rows.size()), "scenario"),
                       duration_text(result.wall_s));
  }
  const Table table = scenario_table(result.rows), by_specimen = seed_table(result.rows);
  if (!table.rows.empty()) base::print_text(plain_table(table, color) + "\n");
  if (!by_specimen.rows.empty())
    base::print_text("mean ± scatter between specimens\n" + plain_table(by_specimen, color) + "\n");
  if (!table.rows.empty()) base::print("left out: {}\n", left_out_text(result.rows));
  print_not_made(result, preset, color);
  if (const std::size_t missing = scenarios_missing(result); missing > 0)
    base::print("{} of {} scenarios are not computed yet{}\n", missing, result.rows.size(),
                result.elsewhere > 0 ? "; other processes are at them" : "");
  const std::string lanes = result.lane_room > 0
                                ? fmt::format(", {:.0f} % of the lanes' steps used",
                                              100.0 * static_cast<double>(result.lane_steps) /
                                                  static_cast<double>(result.lane_room))
                                : "";
  base::print("{} computed, {} reused, {} in total{}; {}/  {}\n", result.computed, result.found,
              duration_text(result.wall_s), lanes, folder.string(), files_in(folder));
  if (is_a_part(command))
    base::print(
        "when all parts have ended, 'rift study' with --gather writes the table, charts and report\n");
}

std::string command_text(const StudyCommand& command) {
  std::string text = command_with_preset("rift study", command);
  return command.out.empty() ? text : text + " --out " + command.out;
}

/// table.csv always; charts and report unless the user wants to be let go. A part of a study leaves all of
/// them to the call that gathers the parts.
ExitCode write_files(const StudyCommand& command, const scene::Preset& preset,
                     const study::StudyResult& result, const fs::path& folder, Session& session) {
  const std::string csv = is_a_part(command) ? "" : study_csv(to_json(result.rows));
  if (csv.empty()) return ExitCode::done;
  base::write_whole_file(folder / "table.csv", csv);
  if (result.outcome == simulation::Outcome::stopped) return ExitCode::done;
  const StudyCall call{command_text(command), build_info(), session.seconds()};
  return session.write_or_say([&] { write_study_report(preset, call, result, folder); });
}

/// "technique = progressive, seed = 3", of the scenarios that are not there.
void list_missing(const Session& session, const scene::Preset& preset, const study::StudyResult& result) {
  if (session.options.quiet) return;
  std::set<int> impossible;
  for (const study::NotMade& one : result.not_made) impossible.insert(one.rows.begin(), one.rows.end());
  std::size_t listed = 0;
  for (std::size_t k = 0; k < result.rows.size(); ++k) {
    if (result.rows[k] || impossible.contains(static_cast<int>(k))) continue;
    if (++listed > scene::most_issues_shown) continue;
    std::string values;
    for (const auto& [name, text] : preset.study[k].axes)
      values += fmt::format("{}{} = {}", values.empty() ? "" : ", ", name, text);
    base::message("missing: {}\n", values);
  }
  if (listed > scene::most_issues_shown)
    base::message("missing: {} more\n", listed - scene::most_issues_shown);
}

/// How the call ends that was to leave the study whole.
ExitCode end_of_whole(const fs::path& folder, const scene::Preset& preset, const study::StudyResult& result,
                      Session& session) {
  if (const std::size_t missing = scenarios_missing(result); missing > 0) {
    list_missing(session, preset, result);
    session.message(fmt::format("{} of {} scenarios are missing; 'rift study' without --gather computes them",
                                missing, result.rows.size()));
    return ExitCode::not_whole;
  }
  std::error_code stays;  // what tasks have packed is of no use any more
  fs::remove_all(folder / "cache", stays);
  if (result.not_made.empty()) return session.ended(result.outcome);
  session.message(
      fmt::format("{} of {} scenarios could not be made", scenarios_not_made(result), result.rows.size()));
  return ExitCode::not_whole;
}

ExitCode compute(const StudyCommand& command, const scene::Preset& preset, const study::StudyOptions& options,
                 std::optional<double> budget) {
  Session session("rift study", command, budget);
  const fs::path shared_cache = options.folder / "cache";  // of tasks on nodes that share nothing else
  if (!command.no_cache && (command.claim || command.prepare || fs::exists(shared_cache)))
    session.cache.folder = shared_cache;
  study::StudyObserver observer;
  observer.progress = [&](std::string_view stage, double done) {
    return session.progress("study", done, stage);
  };
  observer.finished = [&](const study::SummaryRow& row, int done, int of) {
    show_finished(session, row, done, of);
  };
  study::StudyResult result = study::run_study(preset, options, session.cache, build_info(), observer);
  result.rows = with_converged_errors(std::move(result.rows));
  session.line.clear();
  for (const std::string& note : session.cache.notes) base::message("note: {}\n", note);
  const ExitCode files = write_files(command, preset, result, options.folder, session);
  session.print_result(Json{{"preset", preset.name},
                            {"scenarios", to_json(result.rows)},
                            {"not_made", study::to_json(result.not_made, preset)}},
                       [&] { print_tables(command, preset, result, options.folder, session.color()); });
  if (result.outcome == simulation::Outcome::stopped) {
    session.message(fmt::format("{}; the same command continues from here",
                                session.ran_out_of_budget() ? "the budget ran out" : "stopped"));
    return session.stopped();
  }
  if (files != ExitCode::done) return files;
  return is_a_part(command) ? session.ended(result.outcome)
                            : end_of_whole(options.folder, preset, result, session);
}

/// What tells this call from others that work on the same study.
std::string own_label() {
  const auto variable = [](const char* name) {
    const char* value = std::getenv(name);
    return std::string(value == nullptr ? "" : value);
  };
  if (const std::string job = variable("SLURM_ARRAY_JOB_ID"); !job.empty())
    return job + "_" + variable("SLURM_ARRAY_TASK_ID");
  for (const char* name : {"SLURM_JOB_ID", "PBS_JOBID"})
    if (std::string job = variable(name); !job.empty()) return job;
  return {};
}

study::StudyWork work_of(const StudyCommand& command) {
  return command.prepare  ? study::StudyWork::preparation
         : command.claim  ? study::StudyWork::share
         : command.gather ? study::StudyWork::gathering
                          : study::StudyWork::everything;
}

/// Throws InputError where there is no study in the folder to be gathered or looked at.
void check_has_begun(const fs::path& folder) {
  if (!fs::exists(folder / study::study_name))
    refuse(folder.string(), "holds no study yet: 'rift study' without --gather and --status begins it");
}

/// How many tasks share a study where nobody says it.
constexpr int usual_tasks = 8;

ExitCode study(const StudyCommand& command) {
  const Shard shard = read_shard(command.shard);
  const std::optional<double> budget = read_budget("rift study", command.budget);
  const scene::Preset preset = read_scene(command);
  if (prints_config(command, preset)) return ExitCode::done;
  check_holds_study(preset);
  study::StudyOptions options;
  options.folder = command.out.empty() ? study_folder(command.preset) : fs::path(command.out);
  options.threads = command.threads;
  options.shard = shard.index;
  options.shards = shard.of;
  options.work = work_of(command);
  options.tasks = command.tasks > 0 ? command.tasks : usual_tasks;
  options.label = own_label();
  if (command.gather || command.status) check_has_begun(options.folder);
  if (command.status) return print_status(command, options.folder);
  if (command.slurm) return submit_study(command, preset, options.folder);
  if (command.gather || command.prepare) return compute(command, preset, options, budget);
  const double seconds = estimated_seconds(preset, options, build_info());
  if (seconds > long_work_s && !command.yes && !budget)
    refuse("rift study", fmt::format("the missing scenarios take about {} (at 100 M beam-steps/s, lanes side "
                                     "by side): --yes starts them, --budget TIME computes what fits",
                                     duration_text(seconds)));
  return compute(command, preset, options, budget);
}

}  // namespace

void add_study(CLI::App& app, ExitCode& exit_code) {
  CLI::App& command = *app.add_subcommand("study",
                                          "Compute the scenarios of a preset's [study]: table, charts, "
                                          "report; an interrupted study is continued");
  const auto options = std::make_shared<StudyCommand>();
  add_scene_options(command, *options);
  command
      .add_option("-o,--out", options->out,
                  "Folder of the study (default: studies/NAME); one that holds the same study is continued")
      ->type_name("FOLDER");
  CLI::Option* const shard =
      command
          .add_option("--shard", options->shard,
                      "i/n: compute only the i-th of n parts; a call without --shard gathers all parts")
          ->type_name("I/N");
  CLI::Option* const claim =
      command.add_flag("--claim", options->claim,
                       "Compute what no other call has taken, until none is left: for many tasks at once");
  CLI::Option* const prepare =
      command.add_flag("--prepare", options->prepare, "Only pack and pre-stress the specimens, for --claim");
  CLI::Option* const gather =
      command.add_flag("--gather", options->gather,
                       "Compute nothing: table, charts and report of what is there; 6 if not all is");
  CLI::Option* const status = command.add_flag("--status", options->status,
                                               "Show what is done, running, lost and waiting, also in Slurm");
  CLI::Option* const slurm = command.add_flag("--slurm", options->slurm,
                                              "Submit to Slurm: preparation, an array of tasks, the report");
  const std::array one_of{shard, claim, prepare, gather, status, slurm};
  for (CLI::Option* a : one_of)
    for (CLI::Option* b : one_of)
      if (a != b) a->excludes(b);
  command.add_option("--tasks", options->tasks, "How many tasks share the work (default: 8)")
      ->type_name("N")
      ->check(CLI::Range(1, 100000));
  command.add_option("--time", options->time, "Slurm's limit of each job (default: 01:00:00)")
      ->type_name("LIMIT")
      ->needs(slurm);
  command.add_option("--partition", options->partition, "Slurm's partition")->type_name("NAME")->needs(slurm);
  command.add_option("--sbatch", options->sbatch, "More options of sbatch, such as \"--cpus-per-task=4\"")
      ->type_name("OPTIONS")
      ->needs(slurm);
  command.add_flag("--dry-run", options->dry_run, "Print the scripts for Slurm and submit nothing")
      ->needs(slurm);
  command
      .add_option("--budget", options->budget,
                  "Stop after this time (\"10 min\"); the same command continues")
      ->type_name("TIME");
  command.add_flag("--yes", options->yes, "Start even a study of more than 10 minutes");
  command.callback([options, &exit_code] { exit_code = study(*options); });
}

}  // namespace rift::studio

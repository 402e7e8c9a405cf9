#include "engine/base/console.hpp"
#include "engine/base/files.hpp"
#include "engine/base/text.hpp"
#include "engine/base/world_error.hpp"
#include "engine/ensemble/instruction_set.hpp"
#include "engine/results/json_input.hpp"
#include "engine/study/plan.hpp"
#include "engine/study/runner.hpp"
#include "engine/study/status.hpp"
#include "studio/commands/stop_signal.hpp"
#include "studio/commands/study_command.hpp"
#include "studio/slurm/queue.hpp"
#include "studio/slurm/scripts.hpp"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <cstdlib>
#include <filesystem>
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace rift::studio {
namespace {

namespace fs = std::filesystem;
using Json = nlohmann::ordered_json;

/// Numbers apart by ':' or nothing where the text is not of that form.
std::optional<std::vector<double>> clock_numbers(std::string_view text) {
  std::vector<double> all;
  for (std::size_t from = 0; from <= text.size();) {
    const std::size_t to = std::min(text.find(':', from), text.size());
    int value = 0;
    const auto [at, error] = std::from_chars(text.data() + from, text.data() + to, value);
    if (error != std::errc() || at != text.data() + to || value < 0) return std::nullopt;
    all.push_back(value);
    from = to + 1;
  }
  return all;
}

/// By one of Slurm's forms: minutes, minutes:seconds, hours:minutes:seconds, days-hours, days-hours:minutes
/// and days-hours:minutes:seconds   [sbatch(1), --time].
std::optional<double> seconds_by_slurm(std::string_view text) {
  constexpr double minute = 60, hour = 3600, day = 86400;
  if (const std::size_t dash = text.find('-'); dash != text.npos) {
    const auto days = clock_numbers(text.substr(0, dash)), rest = clock_numbers(text.substr(dash + 1));
    if (!days || days->size() != 1 || !rest || rest->size() > 3) return std::nullopt;
    constexpr std::array unit{hour, minute, 1.0};
    double seconds = day * days->front();
    for (std::size_t k = 0; k < rest->size(); ++k) seconds += unit[k] * (*rest)[k];
    return seconds;
  }
  const auto parts = clock_numbers(text);
  if (!parts || parts->size() > 3) return std::nullopt;
  if (parts->size() == 3) return hour * (*parts)[0] + minute * (*parts)[1] + (*parts)[2];
  return minute * (*parts)[0] + (parts->size() == 2 ? (*parts)[1] : 0.0);
}

/// The seconds of a limit, in one of Slurm's forms ("90", which are minutes, "1:30:00", "2-12") or as rift
/// has times ("90 min"). Throws InputError where it is neither, or too short to compute anything.
double time_limit_s(const std::string& text) {
  std::optional<double> seconds = seconds_by_slurm(text);
  if (!seconds) try {
      seconds = read_budget("rift study", text);
    } catch (const scene::InputError&) {
      seconds.reset();
    }
  if (!seconds)
    refuse("rift study",
           fmt::format("--time {}: expected a limit as Slurm has it, such as 01:30:00 or 2-12:00, or "
                       "\"90 min\"",
                       text));
  constexpr double least = time_to_stop_s + 30;  // between two checkpoints
  if (*seconds < least)
    refuse(
        "rift study",
        fmt::format(
            "--time {}: a job stops {} before its limit and needs as long as lies between two checkpoints, "
            "{}: give it at least {}",
            text, duration_text(time_to_stop_s), duration_text(least - time_to_stop_s), slurm_time(least)));
  return *seconds;
}

// The jobs of a study: FOLDER/slurm/jobs.json, {"prepare": "12", "compute": "13", "report": "14"}.

constexpr std::array stages{"prepare", "compute", "report"};

fs::path jobs_file(const fs::path& folder) { return folder / "slurm" / "jobs.json"; }

/// By their numbers, the stage of each; none where nothing was submitted.
std::map<std::string, std::string> submitted_jobs(const fs::path& folder) {
  std::map<std::string, std::string> jobs;
  if (!fs::exists(jobs_file(folder))) return jobs;
  const Json kept = results::json_or_discarded(base::read_whole_file(jobs_file(folder)));
  for (const char* stage : stages)
    if (kept.is_object() && kept.contains(stage) && kept[stage].is_string()) jobs[kept[stage]] = stage;
  return jobs;
}

std::vector<std::string> numbers_of(const std::map<std::string, std::string>& jobs) {
  std::vector<std::string> numbers;
  for (const auto& [number, stage] : jobs) numbers.push_back(number);
  return numbers;
}

/// What Slurm says of the study's jobs; none where it was never submitted.
std::vector<JobState> states_of(const std::map<std::string, std::string>& jobs) {
  if (jobs.empty()) return {};
  std::vector<JobState> states = jobs_in_queue(numbers_of(jobs));
  const std::vector<JobState> ended = ended_jobs(numbers_of(jobs));
  states.insert(states.end(), ended.begin(), ended.end());
  std::stable_sort(states.begin(), states.end(), [](const JobState& a, const JobState& b) {
    return std::atol(a.job.c_str()) < std::atol(b.job.c_str());
  });
  return states;
}

Json to_json(const study::StudyStatus& status, const std::map<std::string, std::string>& jobs,
             const std::vector<JobState>& states) {
  Json workers = Json::array(), slurm = Json::array();
  for (const study::Worker& worker : status.workers)
    workers.push_back({{"host", worker.host},
                       {"process", worker.process},
                       {"job", worker.label.empty() ? Json(nullptr) : Json(worker.label)},
                       {"scenarios", worker.scenarios},
                       {"prepares", worker.prepares},
                       {"silent_s", worker.silent_s},
                       {"lives", worker.lives}});
  for (const JobState& job : states)
    slurm.push_back({{"stage", jobs.at(job.job)},
                     {"job", job.job},
                     {"tasks", job.tasks},
                     {"state", job.state},
                     {"reason", job.reason.empty() ? Json(nullptr) : Json(job.reason)}});
  return {{"preset", status.preset},
          {"scenarios", status.scenarios},
          {"done", status.done},
          {"running", status.running},
          {"waiting", status.waiting()},
          {"lost", status.lost},
          {"not_made", status.not_made},
          {"left_s", std::isfinite(status.left_s) ? Json(status.left_s) : Json(nullptr)},
          {"workers", workers},
          {"slurm", slurm}};
}

std::string counts_text(const study::StudyStatus& status) {
  std::string text = fmt::format("{} of {} scenarios done", status.done, status.scenarios);
  const auto add = [&](int count, const char* what) {
    if (count > 0) text += fmt::format(", {} {}", count, what);
  };
  add(status.running, "running");
  add(status.waiting(), "waiting");
  add(status.lost, "lost by a process that is gone: the next one takes them");
  add(status.not_made, "that cannot be made");
  if (std::isfinite(status.left_s)) text += fmt::format("; about {} left", duration_text(status.left_s));
  return text;
}

Table workers_table(const study::StudyStatus& status) {
  Table table{{"node", "process", "job", "at", "last sign of life"}, {}};
  for (const study::Worker& worker : status.workers)
    table.rows.push_back({worker.host, std::to_string(worker.process),
                          worker.label.empty() ? "-" : worker.label,
                          worker.prepares ? "a specimen" : base::counted(worker.scenarios, "scenario"),
                          worker.lives ? duration_text(worker.silent_s) + " ago" : "gone"});
  return table;
}

Table jobs_table(const std::map<std::string, std::string>& jobs, const std::vector<JobState>& states) {
  Table table{{"stage", "job", "tasks", "state", "why"}, {}};
  for (const JobState& job : states)
    table.rows.push_back({jobs.at(job.job), job.job, std::to_string(job.tasks), job.state,
                          job.reason.empty() ? "-" : job.reason});
  return table;
}

// Submission.

constexpr std::array<std::string_view, 3> instruction_sets{"baseline", "AVX2", "AVX-512"};

std::size_t rank_of(std::string_view set) {
  return static_cast<std::size_t>(std::find(instruction_sets.begin(), instruction_sets.end(), set) -
                                  instruction_sets.begin());
}

/// The instruction set of all jobs: the user's, else the lowest of this machine and the partition's nodes, as
/// far as these name theirs.
std::string common_instruction_set(const StudyCommand& command) {
  std::string own(ensemble::name_of(ensemble::instruction_set()));
  const char* wanted = std::getenv("RIFT_SIMD");
  if (wanted != nullptr && *wanted != '\0') return own;
  std::optional<std::string> lowest;
  try {
    lowest = lowest_instruction_set(command.partition);
  } catch (const base::WorldError&) {
    if (!command.dry_run) throw;
  }
  if (!lowest) {
    base::message(
        "note: the nodes do not name their instruction sets; all jobs use this machine's, {}: "
        "where a node "
        "has a lower one, submit with RIFT_SIMD\n",
        own);
    return own;
  }
  return rank_of(*lowest) < rank_of(own) ? *lowest : own;
}

SlurmStudy jobs_of(const StudyCommand& command, const scene::Preset& preset, const fs::path& folder) {
  std::error_code none;
  SlurmStudy jobs;
  jobs.command = {fs::read_symlink("/proc/self/exe", none).string(), "study",
                  fs::absolute(resolve_preset(command.preset)).string()};
  for (const std::string& text : command.overrides) jobs.command.insert(jobs.command.end(), {"--set", text});
  jobs.name = fs::path(preset.name).stem().string();
  jobs.folder = fs::absolute(folder);
  jobs.tasks = std::max(1, command.tasks);
  jobs.limit_s = time_limit_s(command.time);
  jobs.partition = command.partition;
  jobs.extra = command.sbatch;
  jobs.instruction_set = common_instruction_set(command);
  return jobs;
}

std::string script_of(const SlurmStudy& jobs, std::string_view stage) {
  return stage == "prepare"   ? preparation_script(jobs)
         : stage == "compute" ? tasks_script(jobs)
                              : report_script(jobs);
}

/// As many tasks as there is work for: what fills the lanes of each once.
int tasks_for(const std::vector<study::StudyItem>& missing) {
  constexpr int most = 16;
  const int lanes = missing.empty() ? 1 : study::lanes_of_many(missing.front().scene.solver.precision);
  return std::clamp((static_cast<int>(missing.size()) + lanes - 1) / lanes, 1, most);
}

void print_scripts(const SlurmStudy& jobs) {
  for (const char* stage : stages)
    base::print_text(
        fmt::format("# {}\n{}\n", (jobs.folder / "slurm" / stage).string() + ".sh", script_of(jobs, stage)));
  base::print_text("# the array waits for the preparation (afterok), the report for the array (afterany)\n");
}

/// One after the other, each waits for the one before.
Json submit(const SlurmStudy& jobs) {
  base::make_folder(jobs.folder / "slurm");
  Json numbers = Json::object();
  std::string before;
  for (const std::string stage : stages) {
    const fs::path script = jobs.folder / "slurm" / (stage + ".sh");
    base::write_whole_file(script, script_of(jobs, stage));
    const std::string dependency =
        before.empty() ? "" : (stage == "report" ? "afterany:" : "afterok:") + before;
    numbers[stage] = before = submit_job(script, dependency);
    base::write_whole_file(jobs_file(jobs.folder), base::json_text(numbers, 2) + "\n");
  }
  return numbers;
}

}  // namespace

ExitCode print_status(const StudyCommand& command, const fs::path& folder) {
  const Session session("rift study", command);
  const study::StudyStatus status = study::status_of(folder);
  const std::map<std::string, std::string> jobs = submitted_jobs(folder);
  const std::vector<JobState> states = states_of(jobs);
  session.print_result(to_json(status, jobs, states), [&] {
    base::print("{}: {}\n", folder.string(), counts_text(status));
    for (const Table& table : {workers_table(status), jobs_table(jobs, states)})
      if (!table.rows.empty()) base::print_text("\n" + plain_table(table, session.color()));
  });
  return ExitCode::done;
}

ExitCode submit_study(const StudyCommand& command, const scene::Preset& preset, const fs::path& folder) {
  SlurmStudy jobs = jobs_of(command, preset, folder);
  ::setenv("RIFT_SIMD", jobs.instruction_set.c_str(), 1);  // what the folder holds is known by it
  if (command.dry_run) {
    print_scripts(jobs);
    return ExitCode::done;
  }
  const std::map<std::string, std::string> before = submitted_jobs(folder);
  if (!before.empty() && !jobs_in_queue(numbers_of(before)).empty()) {
    base::message("rift study: the study is under way in Slurm; nothing was submitted\n");
    return print_status(command, folder);
  }
  Session session("rift study", command);
  study::StudyOptions gathering;
  gathering.folder = folder;
  gathering.work = study::StudyWork::gathering;
  const study::StudyResult found = study::run_study(preset, gathering, session.cache, build_info(), {});
  std::vector<study::StudyItem> missing = study::plan_study(preset, build_info().version);
  std::erase_if(missing, [&](const study::StudyItem& item) { return found.rows[item.row].has_value(); });
  if (missing.empty() && fs::exists(folder / "report.html")) {
    session.message("nothing is missing; nothing was submitted");
    return ExitCode::done;
  }
  if (command.tasks == 0) jobs.tasks = tasks_for(missing);
  const Json numbers = submit(jobs);
  session.print_result(numbers, [&] {
    base::print(
        "{} of {} scenarios are missing: job {} prepares, {} computes in {}, {} writes the report\n"
        "'rift study {} --status' shows how far they are; logs are in {}/slurm\n",
        missing.size(), found.rows.size(), numbers["prepare"].get<std::string>(),
        numbers["compute"].get<std::string>(), base::counted(jobs.tasks, "task"),
        numbers["report"].get<std::string>(),
        command.preset + (command.out.empty() ? "" : " --out " + command.out), folder.string());
  });
  return ExitCode::done;
}

}  // namespace rift::studio

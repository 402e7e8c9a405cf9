#include "engine/base/console.hpp"
#include "engine/base/files.hpp"
#include "engine/base/interrupted.hpp"
#include "engine/base/text.hpp"
#include "engine/base/world_error.hpp"
#include "engine/results/archive.hpp"
#include "engine/results/run_folder.hpp"
#include "engine/scene/issue.hpp"
#include "engine/simulation/record.hpp"
#include "studio/commands/commands.hpp"
#include "studio/commands/run_ending.hpp"
#include "studio/commands/scene_options.hpp"
#include "studio/reports/instruments_report.hpp"

#include <CLI/CLI.hpp>
#include <fmt/format.h>

#include <cmath>
#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace rift::studio {
namespace fs = std::filesystem;
namespace {

constexpr std::size_t fields_kept = 12;  // of the way, for the maps

struct MeasureCommand {
  std::string run, out, color;
  std::vector<std::string> against;
  measurement::InstrumentOptions wishes;
  bool force = false, json = false, quiet = false;
};

std::string command_text(const MeasureCommand& command) {
  std::string text = "rift measure " + command.run;
  if (command.wishes.lane > 0) text += fmt::format(" --lane {}", command.wishes.lane);
  for (const std::string& file : command.against) text += " --against " + file;
  return text;
}

/// In the run's folder, anew each time, or elsewhere, where nothing else may be.
fs::path folder_of(const MeasureCommand& command) {
  if (!command.out.empty()) return command.out;
  return fs::path(command.run) / (command.wishes.lane > 0 ? fmt::format("measure_lane{}", command.wishes.lane)
                                                          : std::string("measure"));
}

void check(const measurement::InstrumentOptions& w) {
  for (const auto& [option, value] :
       {std::pair{"--grid", w.grid}, {"--subset", w.subset}, {"--inner", w.inner}, {"--outer", w.outer}})
    if (!std::isfinite(value))
      throw scene::InputError(
          {scene::Issue{.file = "rift measure", .key = option, .text = "must be a finite number"}});
  if (w.inner >= w.outer)
    throw scene::InputError({scene::Issue{.file = "rift measure",
                                          .key = "--inner",
                                          .text = fmt::format("must lie below --outer = {:g}", w.outer),
                                          .value = fmt::format("{:g}", w.inner)}});
}

/// field.csv, which is there only when all of it is; nothing is left of one that was given up.
class FieldFile {
 public:
  explicit FieldFile(base::OwnedFolder& folder)
      : folder_(folder), pending_(folder.path() / "field.csv"), file_(pending_.temporary(), 0) {
    file_.append(field_csv_header());
  }

  void append(const std::string& rows) { file_.append(rows); }
  /// Takes the place of what was measured there before.
  void keep() {
    file_.close();
    results::remove_report(folder_.path(),
                           {"report.html", "summary.json", "field.csv", "stress_intensity.csv"});
    folder_.keep();
    pending_.commit();
  }

 private:
  base::OwnedFolder& folder_;
  base::PendingFile pending_;
  base::AppendFile file_;
};

/// Reads the run, its fields into a file as they come; keeps one wherever the tip has run a step of the way
/// on.
void read_run(const MeasureCommand& command, InstrumentsReport& report, FieldFile& file, ProgressLine& line,
              const StopSignal& stop) {
  double next_tip = 0.0;
  report.seen = measurement::read_instruments(
      command.run, command.wishes,
      [&](double done) {
        line.tell("frames", done);
        return stop.received() == 0;
      },
      [&](const measurement::Grid& grid, const measurement::SeenField& field) {
        file.append(field_csv_rows(grid, field));
        if (field.tip < next_tip) return;
        report.field.push_back(field);
        next_tip = field.tip + grid.point.back().x() / fields_kept;
      });
  line.clear();
}

void lay_over(InstrumentsReport& report, const std::vector<std::string>& files) {
  for (const std::string& file : files)
    for (measurement::Trace& trace : measurement::read_traces(file, report.trace)) {
      for (const measurement::Trace& other : report.measured)
        if (other.name == trace.name)
          throw scene::InputError(
              {scene::Issue{.file = file, .key = {}, .text = trace.name + " is in an earlier file too"}});
      report.measured.push_back(std::move(trace));
    }
}

ExitCode finish(const MeasureCommand& command, const InstrumentsReport& report, const fs::path& folder,
                ProgressLine& line) {
  ExitCode code = ExitCode::done;
  try {
    line.tell("report", 0.0);
    write_instruments_report(report, folder);
  } catch (const base::WorldError& error) {
    base::message("rift measure: {}\n", error.what());
    code = ExitCode::world_failed;
  }
  line.clear();
  if (command.json) {
    base::print_text(base::json_text(instruments_json(report), 2) + "\n");
  } else {
    base::print_text(instruments_text(report, wants_color(command.color, stdout)));
    base::print("{}/  report.html, stress_intensity.csv, field.csv, charts\n", folder.string());
  }
  return code;
}

/// An experiment keeps its run in a folder below.
void check_run(const std::string& run) {
  const fs::path below = fs::path(run) / "run";
  if (!fs::exists(fs::path(run) / results::journal_name) && fs::exists(below / results::journal_name))
    throw scene::InputError(
        {scene::Issue{.file = run, .key = {}, .text = "holds no run: did you mean " + below.string() + "?"}});
  if (!fs::exists(fs::path(run) / results::journal_name)) (void)simulation::preset_of_run(run);  // says why
}

ExitCode measure(const MeasureCommand& command) {
  check(command.wishes);
  check_run(command.run);
  base::OwnedFolder owned(folder_of(command), [&](const fs::path& there) {
    if (!command.out.empty()) check_report(there, command.force, {.own = "stress_intensity.csv"});
  });
  const fs::path& folder = owned.path();
  const StopSignal stop;
  ProgressLine line(progress_style(command.quiet, command.json));
  InstrumentsReport report;
  report.run = command.run, report.command = command_text(command), report.version = build_info().version;
  report.lane = command.wishes.lane;
  try {
    FieldFile file(owned);
    read_run(command, report, file, line, stop);
    report.trace = measurement::traces_of(report.seen);
    lay_over(report, command.against);
    file.keep();
  } catch (const base::Interrupted& interrupted) {
    line.clear();
    base::message("rift measure: {}; nothing was kept\n", interrupted.what());
    return stopped_by(stop);
  }
  return finish(command, report, folder, line);
}

}  // namespace

void add_measure(CLI::App& app, ExitCode& exit_code) {
  CLI::App& command = *app.add_subcommand(
      "measure",
      "What a test's instruments would have shown of a run: grip force, gauges, a camera's fields, K");
  const auto options = std::make_shared<MeasureCommand>();
  measurement::InstrumentOptions& wishes = options->wishes;
  command.add_option("run", options->run, "Folder of the run, unfinished ones too")->required();
  command.add_option(
      "--against", options->against,
      "Measured curves to lay over: a CSV file such as \"time [us];grip_force [N]\" (repeatable)");
  command.add_option("--lane", wishes.lane, "Which lane")
      ->check(CLI::NonNegativeNumber)
      ->capture_default_str();
  const auto radii = CLI::Range(0.5, 1000.0);
  command.add_option("--grid", wishes.grid, "Distance of the camera's points, in mean radii")
      ->check(radii)
      ->capture_default_str();
  command.add_option("--subset", wishes.subset, "Radius that each point is read over, in mean radii")
      ->check(radii)
      ->capture_default_str();
  command.add_option("--inner", wishes.inner, "Inner radius of the ring that K is fitted to, in mean radii")
      ->check(radii)
      ->capture_default_str();
  command.add_option("--outer", wishes.outer, "Its outer radius, in mean radii")
      ->check(radii)
      ->capture_default_str();
  command.add_option("--out", options->out, "Folder of the results (default: RUN/measure)");
  command.add_flag("--force", options->force, "Replace the results that are in --out");
  command.add_flag("--quiet", options->quiet, "No progress");
  command.add_flag("--json", options->json, "The result as JSON on stdout");
  add_color_option(command, options->color);
  command.callback([options, &exit_code] { exit_code = measure(*options); });
}

}  // namespace rift::studio

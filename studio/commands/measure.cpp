#include "engine/base/files.hpp"
#include "engine/results/run_folder.hpp"
#include "engine/scene/units.hpp"
#include "engine/simulation/record.hpp"
#include "studio/commands/commands.hpp"
#include "studio/commands/session.hpp"
#include "studio/reports/instruments_report.hpp"

#include <CLI/CLI.hpp>
#include <fmt/format.h>

#include <cmath>
#include <filesystem>
#include <memory>
#include <string>
#include <utility>
#include <vector>

namespace rift::studio {
namespace fs = std::filesystem;
namespace {

constexpr std::size_t fields_kept = 12;  // of the way, for the maps

struct MeasureOptions : SessionOptions {
  std::string run, out;
  std::vector<std::string> against;
  std::string offset = "0 s";  // of the measured curves' clock
  measurement::InstrumentOptions instruments;
  bool force = false;
};

/// What is added to the times of measured curves [s].
double offset_of(const MeasureOptions& options) {
  const scene::Parsed<double> read = scene::read_quantity(options.offset, scene::Dimension::time);
  constexpr double largest = 1e6;  // [s]
  std::string problem = read.problem;
  if (read.value && !(std::abs(*read.value) <= largest)) problem = "must lie within ±1e6 s";
  if (!problem.empty())
    refuse({.file = "rift measure", .key = "--offset", .text = problem, .value = options.offset});
  return *read.value;
}

std::string command_text(const MeasureOptions& options) {
  std::string text = "rift measure " + options.run;
  if (options.instruments.lane > 0) text += fmt::format(" --lane {}", options.instruments.lane);
  for (const std::string& file : options.against) text += " --against " + file;
  if (offset_of(options) != 0.0)
    text += fmt::format(" --offset '{}'", scene::quantity_text(offset_of(options), scene::Dimension::time));
  return text;
}

/// In the run's folder, where it is replaced each time, or in a folder of its own.
fs::path folder_of(const MeasureOptions& options) {
  if (!options.out.empty()) return options.out;
  return fs::path(options.run) / (options.instruments.lane > 0
                                      ? fmt::format("measure_lane{}", options.instruments.lane)
                                      : std::string("measure"));
}

void check(const measurement::InstrumentOptions& w) {
  for (const auto& [option, value] :
       {std::pair{"--grid", w.grid}, {"--subset", w.subset}, {"--inner", w.inner}, {"--outer", w.outer}})
    if (!std::isfinite(value))
      refuse({.file = "rift measure", .key = option, .text = "must be a finite number"});
  if (w.inner >= w.outer)
    refuse({.file = "rift measure",
            .key = "--inner",
            .text = fmt::format("must lie below --outer = {:g}", w.outer),
            .value = fmt::format("{:g}", w.inner)});
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
void read_run(const MeasureOptions& options, InstrumentsReport& report, FieldFile& file, Session& session) {
  double next_tip = 0.0;
  report.seen = measurement::read_instruments(
      options.run, options.instruments, session.cache, session.progress_of_stages(),
      [&](const measurement::Grid& grid, const measurement::SeenField& field) {
        file.append(field_csv_rows(grid, field));
        if (field.tip < next_tip) return;
        report.field.push_back(field);
        next_tip = field.tip + grid.point.back().x() / fields_kept;
      });
  session.line.clear();
}

void lay_over(InstrumentsReport& report, const std::vector<std::string>& files) {
  for (const std::string& file : files)
    for (measurement::Trace& trace : measurement::read_traces(file, report.trace)) {
      for (double& time : trace.time) time += report.offset;
      for (const measurement::Trace& other : report.measured)
        if (other.name == trace.name) refuse(file, trace.name + " is already given by an earlier file");
      report.measured.push_back(std::move(trace));
    }
}

ExitCode measure(const MeasureOptions& options) {
  check(options.instruments);
  const double offset = offset_of(options);
  check_is_run(options.run);
  (void)simulation::preset_of_run(options.run);  // a folder without a run is refused before one is made in it
  base::OwnedFolder owned(folder_of(options), [&](const fs::path& there) {
    if (!options.out.empty()) check_report(there, options.force, {.own = "stress_intensity.csv"});
  });
  Session session("rift measure", options);
  InstrumentsReport report;
  report.run = options.run, report.command = command_text(options), report.build = build_info();
  report.lane = options.instruments.lane, report.offset = offset;
  const auto work = [&] {
    FieldFile file(owned);
    read_run(options, report, file, session);
    const scene::Preset preset = simulation::preset_of_run(options.run);
    report.scenes = {preset.lanes.empty() ? preset.scene
                                          : preset.lanes.at(static_cast<std::size_t>(report.lane))};
    report.trace = measurement::traces_of(report.seen);
    lay_over(report, options.against);
    file.keep();
    return ExitCode::done;
  };
  if (const ExitCode code = session.until_stopped(work, "; nothing was stored"); code != ExitCode::done)
    return code;
  const ExitCode code = session.write_or_say([&] { write_instruments_report(report, owned.path()); });
  session.print_result(instruments_json(report), [&] {
    base::print_text(instruments_text(report, session.color()));
    base::print("{}/  report.html, stress_intensity.csv, field.csv, charts\n", owned.path().string());
  });
  const std::string none = no_intensity_text(report.seen, options.instruments);
  if (none.empty()) return code;
  session.message(none);
  return code == ExitCode::done ? ExitCode::bad_input : code;
}

}  // namespace

void add_measure(CLI::App& app, ExitCode& exit_code) {
  CLI::App& command = *app.add_subcommand(
      "measure", "Virtual instruments of a run: grip force, gauges, camera fields, stress intensity factors");
  const auto options = std::make_shared<MeasureOptions>();
  measurement::InstrumentOptions& instruments = options->instruments;
  command.add_option("run", options->run, "Folder of the run, which may be unfinished")
      ->type_name("FOLDER")
      ->required();
  command
      .add_option(
          "--against", options->against,
          "Measured curves to compare with: a CSV file such as \"time [us];grip_force [N]\" (repeatable)")
      ->type_name("FILE");
  command
      .add_option("--offset", options->offset,
                  "Time added to those of the measured curves, where the recorder's clock is not the run's, "
                  "such as \"-12.5 us\"")
      ->type_name("TIME")
      ->capture_default_str();
  command.add_option("--lane", instruments.lane, "Lane that is read")
      ->check(CLI::NonNegativeNumber)
      ->capture_default_str();
  const auto radii = CLI::Range(0.5, 1000.0);
  command.add_option("--grid", instruments.grid, "Distance of the camera's points, in mean radii")
      ->check(radii)
      ->capture_default_str();
  command.add_option("--subset", instruments.subset, "Radius of the subset around each point, in mean radii")
      ->check(radii)
      ->capture_default_str();
  command
      .add_option("--inner", instruments.inner, "Inner radius of the ring that K is fitted to, in mean radii")
      ->check(radii)
      ->capture_default_str();
  command.add_option("--outer", instruments.outer, "Outer radius of that ring, in mean radii")
      ->check(radii)
      ->capture_default_str();
  command.add_option("-o,--out", options->out, "Folder of the results (default: RUN/measure)")
      ->type_name("FOLDER");
  command.add_flag("-f,--force", options->force, "Replace the results that are in --out");
  command.add_flag("-q,--quiet", options->quiet, "No progress");
  command.add_flag("-j,--json", options->json, "The result as JSON on stdout");
  add_color_option(command, options->color);
  command.callback([options, &exit_code] { exit_code = measure(*options); });
}

}  // namespace rift::studio

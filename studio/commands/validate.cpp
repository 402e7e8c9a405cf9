#include "engine/scene/preset.hpp"
#include "engine/validation/problems.hpp"
#include "studio/commands/commands.hpp"
#include "studio/commands/session.hpp"
#include "studio/reports/validation_report.hpp"

#include <CLI/CLI.hpp>
#include <fmt/format.h>

#include <algorithm>
#include <memory>
#include <optional>

namespace rift::studio {
namespace {

struct ValidateOptions : SessionOptions {
  std::vector<std::string> problems;
  bool quick = false, fine = false, force = false;
  std::string out;
};

/// Elements of the quick form are so much fewer.
constexpr int quick_share = 4;

std::vector<const validation::Problem*> chosen(const ValidateOptions& options) {
  std::vector<const validation::Problem*> problems;
  for (const validation::Problem& problem : validation::problems())
    if (options.problems.empty() ||
        std::count(options.problems.begin(), options.problems.end(), problem.name))
      problems.push_back(&problem);
  for (const std::string& name : options.problems)
    if (std::none_of(problems.begin(), problems.end(), [&](const auto* p) { return p->name == name; })) {
      std::string known;
      for (const validation::Problem& problem : validation::problems())
        known += (known.empty() ? "" : ", ") + problem.name;
      refuse("rift validate", fmt::format("'{}' is no problem; there are {}", name, known));
    }
  return problems;
}

std::vector<int> sizes_of(const validation::Problem& problem, const ValidateOptions& options) {
  if (options.quick) return {problem.elements / quick_share};
  std::vector<int> sizes{problem.elements};
  if (options.fine) sizes.insert(sizes.end(), problem.finer.begin(), problem.finer.end());
  return sizes;
}

std::string command_text(const ValidateOptions& options) {
  std::string text = "rift validate";
  for (const std::string& problem : options.problems) text += " " + problem;
  return text + (options.quick ? " --quick" : "") + (options.fine ? " --fine" : "");
}

/// Computes and judges one size. `done` and `all` are elements of realisations, for the line of progress.
ValidatedSize compute(const validation::Problem& problem, int elements, Session& session, double& done,
                      double all) {
  const std::filesystem::path file = resolve_preset(problem.name);
  ValidatedSize size{
      .elements = elements,
      .scene =
          without_mistakes(scene::read_preset(file, {fmt::format("specimen.elements={}", elements)})).scene,
      .cracks = {},
      .findings = {}};
  for (const validation::Realisation& realisation : validation::realisations_of(problem, elements)) {
    const scene::Preset preset =
        without_mistakes(scene::read_preset(file, validation::overrides_of(size.scene, realisation)));
    const auto progress = [&](std::string_view stage, double) {
      return session.progress(problem.name, done / all, stage);
    };
    const bool exact = problem.kind == validation::Problem::Kind::wave_loaded;
    size.cracks.push_back(validation::run_free_cracks(preset, {preset.scene}, realisation, exact,
                                                      session.cache, progress, session.options.threads)
                              .front());
    done += elements;
  }
  size.findings = validation::judge(problem, size.scene, size.cracks);
  return size;
}

ExitCode validate(const ValidateOptions& options) {
  const std::vector<const validation::Problem*> problems = chosen(options);
  std::optional<ReportFolder> folder;
  if (!options.out.empty()) folder.emplace(options.out, options.force);
  Session session("rift validate", options);
  double all = 0.0, done = 0.0;
  for (const validation::Problem* problem : problems)
    for (const int elements : sizes_of(*problem, options))
      all += static_cast<double>(elements) * static_cast<double>(realisations_of(*problem, elements).size());
  const auto work = [&] {
    ValidationReport report{
        .problems = {}, .build = build_info(), .wall_s = 0, .command = command_text(options)};
    for (const validation::Problem* problem : problems) {
      report.problems.push_back({problem, {}});
      for (const int elements : sizes_of(*problem, options))
        report.problems.back().sizes.push_back(compute(*problem, elements, session, done, all));
    }
    session.line.clear();
    session.print_notes();
    report.wall_s = session.seconds();
    ExitCode code = ExitCode::done;
    if (folder) code = session.write_or_say([&] { write_validation_report(report, folder->keep()); });
    session.print_result(validation_json(report), [&] {
      base::print_text(validation_text(report, session.color()));
      if (folder) base::print("{}/  report.html, table.csv, summary.json, charts\n", options.out);
    });
    return code;
  };
  return session.until_stopped(work, "; packings are in the cache");
}

}  // namespace

void add_validate(CLI::App& app, ExitCode& exit_code) {
  CLI::App& command = *app.add_subcommand(
      "validate", "Free cracks against an exact solution and published benchmarks, judged by fixed rules");
  const auto options = std::make_shared<ValidateOptions>();
  command.add_option("problems", options->problems, "Which of them (default: all)")->type_name("NAME");
  CLI::Option* quick = command.add_flag(
      "--quick", options->quick,
      "A quarter of the elements, which are then larger than the rules ask for: nothing is judged");
  command
      .add_flag("--fine", options->fine,
                "With elements of half the size, too, by the same constants (three times as long or more)")
      ->excludes(quick);
  command.add_option("-o,--out", options->out, "Folder for report.html, table.csv, summary.json and charts")
      ->type_name("FOLDER");
  command.add_flag("-f,--force", options->force, "Replace the report that is in the folder");
  add_threads(command, *options);
  add_no_cache(command, *options);
  add_quiet(command, *options);
  add_json(command, *options);
  add_color_option(command, options->color);
  command.callback([options, &exit_code] { exit_code = validate(*options); });
}

}  // namespace rift::studio

#include "engine/base/console.hpp"
#include "engine/base/interrupted.hpp"
#include "engine/base/text.hpp"
#include "engine/packing/packing.hpp"
#include "engine/packing/specimen.hpp"
#include "engine/scene/derived.hpp"
#include "studio/commands/commands.hpp"
#include "studio/commands/scene_options.hpp"
#include "studio/reports/packing_report.hpp"

#include <CLI/CLI.hpp>
#include <fmt/format.h>

#include <chrono>
#include <memory>
#include <optional>

namespace rift::studio {
namespace {

using Clock = std::chrono::steady_clock;

scene::Preset preset_for(const SceneOptions& options) {
  if (!options.preset.empty()) return read_scene(options);
  scene::Preset preset = scene::read_preset_text("", "rift pack", options.overrides);
  if (!preset.issues.empty()) throw scene::InputError(preset.issues);
  return preset;
}

PackedSpecimen packed(const ReportOptions& options, const scene::Preset& preset, base::Cache& cache,
                      const base::FractionTold& progress) {
  const auto start = Clock::now();
  const scene::Scene& scene = preset.scene;
  PackedSpecimen specimen{.scene = scene, .build = build_info(), .box = scene::box_of(scene), .packing = {}};
  try {
    specimen.packing = packing::cached_packing(scene::request_of(scene), cache, specimen.from_cache, progress,
                                               options.scene.threads);
    specimen.wall_s = std::chrono::duration<double>(Clock::now() - start).count();
    const packing::Specimen whole =
        packing::make_free_specimen(specimen.packing, specimen.box, scene.specimen.contact_tolerance);
    specimen.rattlers = whole.rattlers;
    specimen.beams = whole.beam.size();
  } catch (const packing::PackingError& error) {
    throw scene::InputError({scene::issue_at(
        preset, scene.specimen.solid_fraction ? "specimen.solid_fraction" : "specimen.coordination",
        error.what())});
  }
  return specimen;
}

ExitCode pack_specimen(const ReportOptions& options) {
  const scene::Preset preset = preset_for(options.scene);
  if (options.scene.print_config) {
    base::print_text(scene::preset_text(preset));
    return ExitCode::done;
  }
  const bool report = !options.out.empty();
  std::optional<ReportFolder> folder;
  if (report) folder.emplace(options.out, options.force);
  const StopSignal stop;
  ProgressLine line(progress_style(options.scene.quiet, options.scene.json));
  base::Cache cache = cache_for(options.scene);
  try {
    const PackedSpecimen specimen = packed(options, preset, cache, [&](double done) {
      line.tell("packing", done);
      return stop.received() == 0;
    });
    line.clear();
    print_notes(cache);
    const nlohmann::ordered_json summary = packing_json(specimen);
    if (report) {
      line.tell("report", 0.0);
      write_packing_report(specimen, summary, folder->keep());
      line.clear();
    }
    if (options.scene.json) {
      base::print_text(base::json_text(summary, 2) + "\n");
    } else {
      base::print_text(packing_text(summary, wants_color(options.scene.color, stdout)));
      if (report) base::print("{}/  report.html, summary.json, elements.csv, charts\n", options.out);
    }
  } catch (const base::Interrupted& interrupted) {
    line.clear();
    base::message("rift pack: {}\n", interrupted.what());
    return static_cast<ExitCode>(128 + stop.received());
  }
  return ExitCode::done;
}

}  // namespace

void add_pack(CLI::App& app, ExitCode& exit_code) {
  CLI::App& command = *app.add_subcommand(
      "pack", "Fill a plate, block, cylinder, sphere or periodic box with elements, and show how they lie");
  const auto options = std::make_shared<ReportOptions>();
  add_report_options(command, *options, "statistics, charts and the elements as a table");
  command.callback([options, &exit_code] { exit_code = pack_specimen(*options); });
}

}  // namespace rift::studio

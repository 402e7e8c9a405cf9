#include "engine/packing/packing.hpp"
#include "engine/packing/specimen.hpp"
#include "engine/scene/derived.hpp"
#include "engine/scene/layers_note.hpp"
#include "studio/commands/commands.hpp"
#include "studio/commands/session.hpp"
#include "studio/reports/packing_report.hpp"

#include <CLI/CLI.hpp>

#include <memory>
#include <optional>

namespace rift::studio {
namespace {

scene::Preset preset_for(const SceneOptions& options) {
  if (!options.preset.empty()) return read_scene(options);
  return without_mistakes(scene::read_preset_text("", "rift pack", options.overrides));
}

PackedSpecimen packed(const ReportOptions& options, const scene::Preset& preset, Session& session) {
  const base::Clock::time_point start = base::Clock::now();
  const scene::Scene& scene = preset.scene;
  PackedSpecimen specimen{.command = command_with_preset("rift pack", options) +
                                     (options.out.empty() ? "" : " --out " + options.out),
                          .scene = scene,
                          .build = build_info(),
                          .box = scene::box_of(scene),
                          .packing = {}};
  try {
    specimen.packing = packing::cached_packing(scene::request_of(scene), session.cache, specimen.from_cache,
                                               session.progress_of("packing"), options.threads);
    specimen.wall_s = base::seconds_since(start);
    const packing::Specimen whole =
        packing::make_free_specimen(specimen.packing, specimen.box, scene.specimen.contact_tolerance);
    specimen.rattlers = whole.rattlers;
    specimen.beams = whole.beam.size();
  } catch (const packing::PackingError& error) {
    refuse(scene::packing_issue(preset, error));
  }
  return specimen;
}

ExitCode pack_specimen(const ReportOptions& options) {
  const scene::Preset preset = preset_for(options);
  if (prints_config(options, preset)) return ExitCode::done;
  std::optional<ReportFolder> folder;
  if (!options.out.empty()) folder.emplace(options.out, options.force);
  Session session("rift pack", options);
  return session.until_stopped([&] {
    const PackedSpecimen specimen = packed(options, preset, session);
    session.line.clear();
    session.print_notes();
    const nlohmann::ordered_json summary = packing_json(specimen);
    if (folder) session.write([&] { write_packing_report(specimen, summary, folder->keep()); });
    session.print_result(summary, [&] {
      base::print_text(packing_text(summary, session.color()));
      if (folder) base::print("{}/  report.html, summary.json, elements.csv, charts\n", options.out);
    });
    return ExitCode::done;
  });
}

}  // namespace

void add_pack(CLI::App& app, ExitCode& exit_code) {
  CLI::App& command = *app.add_subcommand("pack",
                                          "Fill a plate, block, cylinder, sphere or periodic box with "
                                          "elements, and report the structure of the packing");
  const auto options = std::make_shared<ReportOptions>();
  add_report_options(command, *options, "statistics, charts and the elements as a table");
  command.callback([options, &exit_code] { exit_code = pack_specimen(*options); });
}

}  // namespace rift::studio

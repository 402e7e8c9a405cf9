#include "engine/calibration/calibrate.hpp"

#include "engine/lattice/statics.hpp"
#include "engine/scene/layers_note.hpp"
#include "studio/commands/calibrate_toughness.hpp"
#include "studio/commands/commands.hpp"
#include "studio/commands/session.hpp"
#include "studio/reports/calibration_report.hpp"

#include <CLI/CLI.hpp>

#include <memory>

namespace rift::studio {
namespace {

struct CalibrateOptions : ReportOptions {
  std::string young, poisson;
  bool toughness = false;
};

/// The preset, or without one cylinders of the defaults; the material as the options say.
scene::Preset preset_for(const CalibrateOptions& options) {
  if (options.preset.empty() && (options.young.empty() || options.poisson.empty()))
    refuse({.file = "rift calibrate",
            .key = options.young.empty() ? "--young" : "--poisson",
            .text = "is needed where no preset names the material: rift calibrate --young \"3.2 GPa\" "
                    "--poisson 0.31"});
  std::vector<std::string> overrides = options.overrides;
  if (!options.young.empty()) overrides.push_back("material.young_modulus=" + options.young);
  if (!options.poisson.empty()) overrides.push_back("material.poisson_ratio=" + options.poisson);
  constexpr const char* cylinders =
      "[specimen]\nshape = \"cylinder\"\nlength = \"20 mm\"\nheight = \"40 mm\"\n";
  scene::Preset preset = without_mistakes(
      options.preset.empty() ? scene::read_preset_text(cylinders, "rift calibrate", overrides)
                             : scene::read_preset(resolve_preset(options.preset), overrides));
  if (preset.scene.specimen.shape != packing::Shape::cylinder)
    refuse(scene::issue_at(preset, "specimen.shape", "must be \"cylinder\", the shape that is compressed"));
  return preset;
}

std::string command_text(const CalibrateOptions& options) {
  std::string text = command_with_preset("rift calibrate", options);
  if (!options.young.empty()) text += fmt::format(" --young '{}'", options.young);
  if (!options.poisson.empty()) text += " --poisson " + options.poisson;
  return text + " --out " + options.out;
}

Calibration compute(const CalibrateOptions& options, const scene::Preset& preset, Session& session) {
  Calibration calibration{.command = command_text(options),
                          .scene = preset.scene,
                          .build = build_info(),
                          .beams = {},
                          .study = {}};
  const scene::Scene::Material& m = preset.scene.material;
  if (!options.out.empty())
    calibration.study = calibration::study_calibration(preset.scene, session.cache,
                                                       session.progress_of_stages(), options.threads);
  calibration.beams = calibration::calibrate(preset.scene, m.young_modulus, m.poisson_ratio, session.cache,
                                             session.progress_of("beams"), options.threads);
  calibration.wall_s = session.seconds();
  return calibration;
}

ExitCode calibrate_material(const CalibrateOptions& options) {
  const scene::Preset preset = preset_for(options);
  if (prints_config(options, preset)) return ExitCode::done;
  std::optional<ReportFolder> folder;
  if (!options.out.empty()) folder.emplace(options.out, options.force);
  Session session("rift calibrate", options);
  const auto work = [&] {
    const Calibration calibration = compute(options, preset, session);
    session.line.clear();
    session.print_notes();
    if (folder) session.write([&] { write_calibration_report(calibration, folder->keep()); });
    session.print_result(calibration_json(calibration), [&] {
      base::print_text(calibration_text(calibration, session.color()));
      if (folder) base::print("\n{}/  report.html, table.csv, material.toml, charts\n", options.out);
    });
    return ExitCode::done;
  };
  try {
    return session.until_stopped(work, "; the finished parts are in the cache");
  } catch (const calibration::OutOfReach& error) {
    refuse(scene::issue_at(preset, "material.poisson_ratio", error.what()));
  } catch (const packing::PackingError& error) {
    refuse(scene::packing_issue(preset, error));
  }
}

}  // namespace

void add_calibrate(CLI::App& app, ExitCode& exit_code) {
  CLI::App& command = *app.add_subcommand(
      "calibrate", "Beam parameters of a material of given E and ν, from cylinders in compression");
  const auto options = std::make_shared<CalibrateOptions>();
  add_report_options(command, *options, "convergence, scans, periodic boxes, charts and material.toml");
  command.add_option("--young", options->young, "Young's modulus E, such as \"3.2 GPa\"")
      ->type_name("MODULUS");
  command.add_option("--poisson", options->poisson, "Poisson's ratio")->type_name("NUMBER");
  command
      .add_flag("--toughness", options->toughness,
                "The constant kappa of the cohesive law instead, from free cracks in the plate of the preset "
                "(default: freund_wave)")
      ->excludes(command.get_option("--young"), command.get_option("--poisson"), command.get_option("--out"));
  command.callback([options, &exit_code] {
    exit_code = options->toughness ? calibrate_toughness(*options) : calibrate_material(*options);
  });
}

}  // namespace rift::studio

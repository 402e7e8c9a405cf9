#include "engine/calibration/calibrate.hpp"

#include "engine/base/console.hpp"
#include "engine/base/files.hpp"
#include "engine/base/interrupted.hpp"
#include "engine/base/text.hpp"
#include "engine/lattice/lattice.hpp"
#include "engine/lattice/statics.hpp"
#include "engine/scene/units.hpp"
#include "studio/commands/commands.hpp"
#include "studio/commands/scene_options.hpp"
#include "studio/reports/calibration_report.hpp"

#include <CLI/CLI.hpp>
#include <fmt/format.h>

#include <memory>

namespace rift::studio {
namespace fs = std::filesystem;
namespace {

struct CalibrateOptions : ReportOptions {
  std::string young, poisson;
};

scene::Issue issue(const std::string& key, std::string text) {
  return {.file = "rift calibrate", .key = key, .text = std::move(text)};
}

/// The preset, or without one cylinders of the defaults; the material as the options say.
scene::Preset preset_for(const CalibrateOptions& options) {
  if (options.scene.preset.empty() && (options.young.empty() || options.poisson.empty()))
    throw scene::InputError(
        {issue(options.young.empty() ? "--young" : "--poisson",
               "is needed where no preset names the material: rift calibrate --young \"3.2 GPa\" "
               "--poisson 0.31")});
  std::vector<std::string> overrides = options.scene.overrides;
  if (!options.young.empty()) overrides.push_back("material.young_modulus=" + options.young);
  if (!options.poisson.empty()) overrides.push_back("material.poisson_ratio=" + options.poisson);
  constexpr const char* cylinders =
      "[specimen]\nshape = \"cylinder\"\nlength = \"20 mm\"\nheight = \"40 mm\"\n";
  scene::Preset preset = options.scene.preset.empty()
                             ? scene::read_preset_text(cylinders, "rift calibrate", overrides)
                             : scene::read_preset(resolve_preset(options.scene.preset), overrides);
  if (!preset.issues.empty()) throw scene::InputError(preset.issues);
  if (preset.scene.specimen.shape != packing::Shape::cylinder)
    throw scene::InputError(
        {scene::issue_at(preset, "specimen.shape", "must be \"cylinder\": that is what is pressed")});
  return preset;
}

Calibration compute(const CalibrateOptions& options, const scene::Preset& preset, base::Cache& cache,
                    ProgressLine& line, const StopSignal& stop) {
  Calibration calibration{.scene = preset.scene, .build = build_info(), .beams = {}, .study = {}};
  const auto tell = [&](const char* stage, double done) {
    line.tell(stage, done);
    return stop.received() == 0;
  };
  const scene::Scene::Material& m = preset.scene.material;
  if (!options.out.empty())
    calibration.study = calibration::study_calibration(preset.scene, cache, tell, options.scene.threads);
  calibration.beams = calibration::calibrate(
      preset.scene, m.young_modulus, m.poisson_ratio, cache, [&](double done) { return tell("beams", done); },
      options.scene.threads);
  return calibration;
}

ExitCode calibrate_material(const CalibrateOptions& options) {
  const scene::Preset preset = preset_for(options);
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
    const Calibration calibration = compute(options, preset, cache, line, stop);
    line.clear();
    print_notes(cache);
    if (report) {
      line.tell("report", 0.0);
      write_calibration_report(calibration, folder->keep());
      line.clear();
    }
    if (options.scene.json) {
      base::print_text(base::json_text(calibration_json(calibration), 2) + "\n");
    } else {
      base::print_text(calibration_text(calibration, wants_color(options.scene.color, stdout)));
      if (report) base::print("\n{}/  report.html, table.csv, material.toml, charts\n", options.out);
    }
  } catch (const base::Interrupted& interrupted) {
    line.clear();
    base::message("rift calibrate: {}; what was computed is in the cache\n", interrupted.what());
    return static_cast<ExitCode>(128 + stop.received());
  } catch (const calibration::OutOfReach& error) {
    throw scene::InputError({scene::issue_at(preset, "material.poisson_ratio", error.what())});
  } catch (const packing::PackingError& error) {
    throw scene::InputError({scene::issue_at(preset, "specimen.coordination", error.what())});
  }
  return ExitCode::done;
}

}  // namespace

void add_calibrate(CLI::App& app, ExitCode& exit_code) {
  CLI::App& command = *app.add_subcommand(
      "calibrate", "The beams that make a material of given E and nu, by cylinders in compression");
  const auto options = std::make_shared<CalibrateOptions>();
  add_report_options(command, *options, "convergence, scans, periodic boxes, charts and material.toml");
  command.add_option("--young", options->young, "Young's modulus E, such as \"3.2 GPa\"");
  command.add_option("--poisson", options->poisson, "Poisson's ratio");
  command.callback([options, &exit_code] { exit_code = calibrate_material(*options); });
}

}  // namespace rift::studio

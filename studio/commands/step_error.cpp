#include "studio/commands/step_error.hpp"

#include "engine/accuracy/cases.hpp"
#include "engine/base/files.hpp"
#include "engine/results/archive.hpp"
#include "engine/results/json_input.hpp"
#include "engine/scene/derived.hpp"
#include "engine/study/store.hpp"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <cmath>
#include <limits>

namespace rift::studio {
namespace fs = std::filesystem;
namespace {

using Json = nlohmann::ordered_json;

constexpr double largest_step_error = 0.01;  // the goal of rift accuracy

/// The error that was measured of the scene as it is; NaN where none was.
double measured_error(const scene::Preset& preset, const fs::path& folder) try {
  const Json mark = results::json_or_discarded(base::read_whole_file(folder / "accuracy.json"));
  if (!mark.is_object() || mark.value("scene", "") != accuracy_mark(preset).at("scene"))
    return std::numeric_limits<double>::quiet_NaN();
  const fs::path file = folder / results::summary_name;
  const Json result = results::read_json(base::read_whole_file(file), file);
  // --quick tries another plate.
  if (result.at("scenarios").at(0).at("elements") != preset.scene.specimen.elements)
    return std::numeric_limits<double>::quiet_NaN();
  for (const Json& line : result.at("lines"))
    if (line.at("knob") == accuracy::name_of(accuracy::Factor::scene)) return line.at("error").get<double>();
  return std::numeric_limits<double>::quiet_NaN();
} catch (const std::exception&) {  // no such folder, or a damaged one
  return std::numeric_limits<double>::quiet_NaN();
}

}  // namespace

fs::path accuracy_folder(const std::string& preset) { return fs::path(preset).stem().string() + "_accuracy"; }

Json accuracy_mark(const scene::Preset& preset) {
  const std::string text = scene::preset_text(preset.scene);
  return {{"accuracy_of", preset.name}, {"scene", study::hash_text(text)}, {"preset_text", text}};
}

std::string step_error_text(const SceneOptions& options, const scene::Preset& preset) {
  if (!preset.lanes.empty() || !preset.study.empty() || !scene::keeps_its_velocity(preset.scene)) return {};
  const fs::path folder = accuracy_folder(options.preset);
  const double error = measured_error(preset, folder);
  if (!std::isfinite(error))
    return "the error of the step is not measured: " + command_with_preset("rift accuracy", options);
  return fmt::format(
      "the step adds {:+.4f} to G_ID/G_I0, {} ({}/)", error,
      std::abs(error) > largest_step_error
          ? fmt::format("above {:g}: 'rift accuracy' names a step that does not", largest_step_error)
          : fmt::format("within {:g}", largest_step_error),
      folder.string());
}

}  // namespace rift::studio

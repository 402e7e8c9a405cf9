#include "studio/workbench/screen.hpp"

#include "engine/scene/issue.hpp"
#include "engine/scene/preset.hpp"
#include "engine/study/store.hpp"
#include "studio/workbench/compare_screen.hpp"
#include "studio/workbench/form_screen.hpp"
#include "studio/workbench/lesson_screen.hpp"
#include "studio/workbench/panel_screen.hpp"
#include "studio/workbench/study_screen.hpp"

#include <fmt/format.h>

namespace rift::studio {

RunRequest request_for(const AppContext& context, scene::Preset preset, std::filesystem::path folder) {
  return {.preset = std::move(preset),
          .folder = std::move(folder),
          .threads = context.threads,
          .cache = context.cache,
          .build = context.build};
}

std::filesystem::path free_folder(const std::filesystem::path& folder, const std::string& name) {
  std::filesystem::path path = folder / name;
  for (int k = 2; std::filesystem::exists(path); ++k) path = folder / fmt::format("{}-{}", name, k);
  return path;
}

namespace fs = std::filesystem;

std::unique_ptr<Screen> form_of_preset(AppContext& context, const fs::path& preset) {
  return std::make_unique<FormScreen>(context, preset);
}

std::unique_ptr<Screen> screen_of_preset(AppContext& context, const fs::path& path) {
  return screen_of_preset(context, scene::read_preset(path), path.stem().string(), false);
}

std::unique_ptr<Screen> screen_of_preset(AppContext& context, const scene::Preset& preset,
                                         const std::string& name, bool changed) {
  if (!preset.issues.empty()) throw scene::InputError(preset.issues);
  if (!preset.study.empty()) {
    // A folder that holds the same study is continued; a changed one gets a folder of its own.
    const fs::path folder = changed ? free_folder(context.studies, name) : context.studies / name;
    return std::make_unique<StudyScreen>(context, preset, folder);
  }
  return std::make_unique<RunScreen>(context, request_for(context, preset, free_folder(context.runs, name)));
}

std::unique_ptr<Screen> screen_of_run(AppContext& context, const fs::path& run) {
  if (fs::exists(run / study::study_name))
    return std::make_unique<StudyScreen>(context, study::read_study(run), run);
  return std::make_unique<WatchScreen>(context, run);
}

std::unique_ptr<Screen> resumption_of(AppContext& context, const fs::path& run) {
  if (fs::exists(run / study::study_name))
    return std::make_unique<StudyScreen>(context, study::read_study(run).preset, run);
  if (simulation::complete_end(run) || simulation::has_ended(run))
    throw scene::InputError({scene::Issue{
        .file = run.string(), .key = {}, .text = "is already finished; there is nothing to resume"}});
  RunRequest request = request_for(context, simulation::preset_of_run(run), run);
  request.resume = true;
  return std::make_unique<RunScreen>(context, std::move(request));
}

std::unique_ptr<Screen> comparison_of(AppContext& context, const std::vector<fs::path>& runs) {
  return std::make_unique<CompareScreen>(context, runs);
}

std::unique_ptr<Screen> lesson_screen(AppContext& context, const std::string& name) {
  return std::make_unique<LessonScreen>(context, lesson_of(name));
}

}  // namespace rift::studio

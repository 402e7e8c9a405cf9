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

std::filesystem::path free_folder(const std::filesystem::path& folder, const std::string& name) {
  std::filesystem::path path = folder / name;
  for (int k = 2; std::filesystem::exists(path); ++k) path = folder / fmt::format("{}-{}", name, k);
  return path;
}

namespace fs = std::filesystem;

std::unique_ptr<Screen> form_of_preset(Workshop& workshop, const fs::path& preset) {
  return std::make_unique<FormScreen>(workshop, preset);
}

std::unique_ptr<Screen> screen_of_preset(Workshop& workshop, const fs::path& path,
                                         const std::vector<std::string>& overrides) {
  const scene::Preset preset = scene::read_preset(path, overrides);
  if (!preset.issues.empty()) throw scene::InputError(preset.issues);
  const std::string name = path.stem().string();
  if (!preset.study.empty()) {
    // A folder that holds the same study is continued; a changed one gets a folder of its own.
    const fs::path folder = overrides.empty() ? workshop.studies / name : free_folder(workshop.studies, name);
    return std::make_unique<StudyScreen>(workshop, preset, folder);
  }
  RunRequest wish{.preset = preset, .folder = free_folder(workshop.runs, name)};
  wish.threads = workshop.threads;
  wish.cache = workshop.cache;
  wish.build = workshop.build;
  return std::make_unique<RunScreen>(workshop, std::move(wish));
}

std::unique_ptr<Screen> screen_of_run(Workshop& workshop, const fs::path& run) {
  if (fs::exists(run / study::study_name))
    return std::make_unique<StudyScreen>(workshop, study::read_study(run), run);
  return std::make_unique<WatchScreen>(workshop, run);
}

std::unique_ptr<Screen> resumption_of(Workshop& workshop, const fs::path& run) {
  if (fs::exists(run / study::study_name))
    return std::make_unique<StudyScreen>(workshop, study::read_study(run).preset, run);
  if (simulation::complete_end(run) || simulation::has_ended(run))
    throw scene::InputError({scene::Issue{
        .file = run.string(), .key = {}, .text = "has come to its end: nothing is left of it"}});
  RunRequest wish{.preset = simulation::preset_of_run(run), .folder = run};
  wish.resume = true;
  wish.threads = workshop.threads;
  wish.cache = workshop.cache;
  wish.build = workshop.build;
  return std::make_unique<RunScreen>(workshop, std::move(wish));
}

std::unique_ptr<Screen> comparison_of(Workshop&, const std::vector<fs::path>& runs) {
  return std::make_unique<CompareScreen>(runs);
}

std::unique_ptr<Screen> lesson_screen(Workshop& workshop, const std::string& name) {
  return std::make_unique<LessonScreen>(workshop, lesson_of(name));
}

}  // namespace rift::studio

#include "studio/workbench/specimen_preview.hpp"

#include "engine/scene/issue.hpp"

namespace rift::studio {
namespace {

scene::Preset specimen_of(const std::filesystem::path& path) {
  scene::Preset preset = scene::read_preset(path, {"output.fields=[\"displacement\"]"});
  if (!preset.issues.empty()) throw scene::InputError(preset.issues);
  if (!preset.lanes.empty()) preset.scene = preset.lanes.front();
  if (!preset.study.empty()) preset.scene = preset.study.front().scene;
  preset.lanes.clear(), preset.study.clear(), preset.grid.clear();
  return preset;
}

}  // namespace

SpecimenPreview::SpecimenPreview(const AppContext& context, const std::filesystem::path& preset)
    : folder_("preview") {
  run_.emplace(request_for(context, specimen_of(preset), folder_.path() / "run"));
  run_->pause(true);
  run_->store_frame();
}

void SpecimenPreview::look() { run_->look(live_, {0}); }

std::string SpecimenPreview::state() {
  if (run_->stage() != LiveRun::Stage::ended) return there() ? std::string() : live_.state;
  try {
    (void)run_->result();
  } catch (const std::exception& error) {
    return error.what();
  }
  return {};
}

}  // namespace rift::studio

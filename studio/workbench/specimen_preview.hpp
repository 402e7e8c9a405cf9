#pragma once

#include "engine/base/private_folder.hpp"
#include "studio/screen/live.hpp"
#include "studio/workbench/live_run.hpp"
#include "studio/workbench/screen.hpp"

#include <filesystem>
#include <optional>
#include <string>

namespace rift::studio {

/// The specimen of a preset, loaded as the crack finds it: packed and pre-stressed in the background as for a
/// run, which stands before its first step in a folder that goes with the object. Of a study and of lanes it
/// is that of the first scenario.
class SpecimenPreview {
 public:
  /// Throws InputError where the preset has mistakes, WorldError where there is no room for the folder.
  SpecimenPreview(const AppContext& context, const std::filesystem::path& preset);

  /// Looks how far it is.
  void look();
  /// "packing 40 %", or why there is none; nothing when it is there.
  [[nodiscard]] std::string state();
  /// For its plate in cells; without geometry before it is there.
  [[nodiscard]] const Live& live() const { return live_; }
  /// The folder of a run, for its picture.
  [[nodiscard]] const std::filesystem::path& run() const { return run_->folder(); }
  [[nodiscard]] bool there() const { return run_->stage() != LiveRun::Stage::preparing; }
  /// Gives up; it may be destroyed without waiting when it has ended.
  void stop() { run_->stop(); }
  [[nodiscard]] bool ended() const { return run_->stage() == LiveRun::Stage::ended; }

 private:
  base::PrivateFolder folder_;
  std::optional<LiveRun> run_;
  Live live_;
};

}  // namespace rift::studio

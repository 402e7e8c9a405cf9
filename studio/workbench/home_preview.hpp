#pragma once

#include "studio/screen/live_of_run.hpp"
#include "studio/workbench/plate_switch.hpp"
#include "studio/workbench/screen.hpp"
#include "studio/workbench/specimen_preview.hpp"

#include <chrono>
#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace rift::studio {

/// The plate of what is chosen on the first screen: the loaded specimen of a preset, the last stored moment of
/// a run. As a picture where the terminal shows one, else in cells.
class HomePreview {
 public:
  /// @param context  outlives it
  explicit HomePreview(const AppContext& context) : context_(context), plate_(context.plate_picture) {}

  void toggle();
  [[nodiscard]] bool on() const { return on_; }
  /// Nothing is prepared any more until it is looked at again.
  void let_go();
  /// What is chosen; another one is shown when it has been chosen for a moment. @param is_run  else a preset;
  /// an empty path is neither
  void look(const std::filesystem::path& chosen, bool is_run);
  void draw(Canvas& canvas, const Area& area, Glyphs glyphs);

  void take_room(const PictureRoom& room) { plate_.take_room(room); }
  [[nodiscard]] std::optional<ScreenPicture> picture() const { return plate_.picture(); }
  [[nodiscard]] int descriptor() const { return plate_.descriptor(); }

 private:
  using Clock = std::chrono::steady_clock;
  void take_away();
  void begin(bool is_run);
  [[nodiscard]] const Live* live() const;

  const AppContext& context_;
  bool on_ = false, begun_ = false;
  std::filesystem::path chosen_;
  Clock::time_point since_{};
  PlateSwitch plate_;
  std::unique_ptr<SpecimenPreview> specimen_;
  std::vector<std::unique_ptr<SpecimenPreview>> given_up_;  // until they have ended
  std::optional<LiveOfRun> run_;
  std::string trouble_;
  Area place_;  // of the plate
};

}  // namespace rift::studio

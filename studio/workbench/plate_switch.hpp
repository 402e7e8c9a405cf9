#pragma once

#include "studio/screen/canvas.hpp"
#include "studio/workbench/plate_picture.hpp"

#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace rift::studio {

/// Plates on a screen that a key switches between cells and picture.
class PlateSwitch {
 public:
  explicit PlateSwitch(MakePlatePicture make) : make_(std::move(make)) {}

  /// @return what to say
  std::string toggle(const std::vector<std::filesystem::path>& runs);
  /// Shows a picture of these runs from now on. @return why it cannot; empty where it can
  std::string show(const std::vector<std::filesystem::path>& runs);
  void show_cells() { picture_.reset(); }
  /// Whether this program can draw at all.
  [[nodiscard]] bool can() const { return static_cast<bool>(make_); }
  /// Whether a picture is wanted in the place of the cells.
  [[nodiscard]] bool on() const { return picture_ != nullptr; }
  /// Whether it is one, in a terminal that shows pictures.
  [[nodiscard]] bool in_pixels() const { return on() && room_.pictures; }

  void take_room(const PictureRoom& room) { room_ = room; }
  [[nodiscard]] const PictureRoom& room() const { return room_; }
  void look(const Area& place, const PlateView& view);
  [[nodiscard]] std::optional<ScreenPicture> picture() const;
  [[nodiscard]] int descriptor() const { return picture_ ? picture_->descriptor() : -1; }
  /// In the place of a picture that is not there, why.
  void draw_trouble(Canvas& canvas, const Area& place) const;

 private:
  MakePlatePicture make_;
  std::unique_ptr<PlatePicture> picture_;
  PictureRoom room_;
};

}  // namespace rift::studio

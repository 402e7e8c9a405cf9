#include "studio/workbench/plate_switch.hpp"

#include <exception>

namespace rift::studio {

std::string PlateSwitch::toggle(const std::vector<std::filesystem::path>& runs) {
  if (picture_) {
    picture_.reset();
    return "plate: cells";
  }
  const std::string trouble = show(runs);
  return trouble.empty() ? "plate: picture of the last stored moment" : trouble;
}

std::string PlateSwitch::show(const std::vector<std::filesystem::path>& runs) try {
  if (!make_) return "this rift was built without its renderer: the plate stays in cells";
  picture_ = make_(runs);
  return {};
} catch (const std::exception& error) {
  return error.what();
}

void PlateSwitch::look(const Area& place, const PlateView& view) {
  if (picture_ && room_.pictures) picture_->look(place, room_, view);
}

std::optional<ScreenPicture> PlateSwitch::picture() const {
  return picture_ ? picture_->picture() : std::nullopt;
}

void PlateSwitch::draw_trouble(Canvas& canvas, const Area& place) const {
  if (!picture_ || place.empty() || picture_->picture()) return;
  const std::string trouble =
      !room_.pictures ? "this terminal gets no pictures: p shows cells" : picture_->trouble();
  canvas.text(place.x + 1, place.y + place.height / 2, trouble, {Ink::dim}, place.width - 1);
}

}  // namespace rift::studio

#include "studio/view/camera.hpp"
#include "studio/view/view_screen.hpp"

#include <algorithm>
#include <numbers>

/// What moves the camera, and what is pointed at.
namespace rift::studio {
namespace {

constexpr double zoom_step = 1.25, pan_step = 0.1, turn_step = std::numbers::pi / 18;

}  // namespace

viz::View ViewScreen::view_now() const {
  if (server_.answer().width == 0) return plan_.job.look.view;
  return view_of(plan_.job.look, server_.answer().pane[0].window);
}

void ViewScreen::look_by(const viz::View& view) {
  if (server_.answer().width == 0) return;  // nothing is seen yet that could be moved
  request_.view = view;
  plan_.job.look.camera = viz::Camera::free;
  plan_.job.look.view = view;
}

/// @param pixel  that stays where it is, or none for the middle
void ViewScreen::zoom(double factor, std::optional<std::array<double, 2>> pixel) {
  const viz::Answer& answer = server_.answer();
  const viz::PaneAnswer* pane = &answer.pane[0];
  for (std::int32_t k = 0; pixel && k < answer.panes; ++k)
    if (viz::holds(answer.pane[k].picture, *pixel)) pane = &answer.pane[k];
  const viz::Box& box = pane->picture;
  look_by(zoomed(view_now(), factor, box,
                 pixel.value_or(std::array{0.5 * (box.x0 + box.x1), 0.5 * (box.y0 + box.y1)})));
}

bool ViewScreen::act_on_camera(Action action) {
  const auto turned = [&](double turn, double tilt) {
    viz::View view = view_now();
    view.turn += turn, view.tilt += tilt;
    look_by(view);
  };
  switch (action) {
    case Action::next_camera:
      next_camera();
      return true;
    case Action::zoom_in:
      zoom(1 / zoom_step, {});
      return true;
    case Action::zoom_out:
      zoom(zoom_step, {});
      return true;
    case Action::pan_left:
      look_by(panned(view_now(), pan_step, 0));
      return true;
    case Action::pan_right:
      look_by(panned(view_now(), -pan_step, 0));
      return true;
    case Action::pan_up:
      look_by(panned(view_now(), 0, -pan_step));
      return true;
    case Action::pan_down:
      look_by(panned(view_now(), 0, pan_step));
      return true;
    case Action::turn_left:
      turned(-turn_step, 0);
      return true;
    case Action::turn_right:
      turned(turn_step, 0);
      return true;
    case Action::tilt_up:
      turned(0, -turn_step);
      return true;
    case Action::tilt_down:
      turned(0, turn_step);
      return true;
    case Action::reset:
      change([](viz::Request& request) { request.view.reset(), request.camera = "plate"; });
      return true;
    default:
      return false;
  }
}

void ViewScreen::next_camera() {
  if (plan_.job.look.camera == viz::Camera::side) return look_by(view_now());
  const std::string next = plan_.job.look.camera == viz::Camera::plate ? "tip"
                           : plan_.job.look.camera == viz::Camera::tip ? "side"
                                                                       : "plate";
  change([&](viz::Request& request) { request.view.reset(), request.camera = next; });
  message_ = "camera: " + next;
}

void ViewScreen::ask_at(const std::array<double, 2>& fraction) {
  if (number_ == 0) return;
  asked_ = fraction;
  player_.go_to(player_.moment());  // pauses
}

/// Of the first pane, as a fraction of the picture; its box's middle where the camera does not see that point.
std::array<double, 2> ViewScreen::middle_of_plate() const {
  const viz::Answer& answer = server_.answer();
  if (answer.width == 0) return {0.5, 0.5};
  const viz::PaneAnswer& pane = answer.pane[0];
  const nlohmann::ordered_json& header = shown_.front().header;
  const double middle = 0.5 * (header.value("height_m", 0.0) +
                               plan_.job.look.magnification * header.value("displacement_m", 0.0));
  std::array<double, 2> at = viz::to_pixels(viz::axes_of(plan_.job.look), pane.window, pane.picture,
                                            {0.5 * header.value("length_m", 0.0), middle, 0});
  if (!viz::holds(pane.picture, at))
    at = {0.5 * (pane.picture.x0 + pane.picture.x1), 0.5 * (pane.picture.y0 + pane.picture.y1)};
  return {at[0] / answer.width, at[1] / answer.height};
}

bool ViewScreen::move_crosshair(const KeyEvent& event) {
  constexpr double step = 0.01;
  std::array<double, 2>& at = *crosshair_;
  switch (event.key) {
    case key_left:
      at[0] = std::max(0.0, at[0] - step);
      break;
    case key_right:
      at[0] = std::min(1.0, at[0] + step);
      break;
    case key_up:
      at[1] = std::min(1.0, at[1] + step);
      break;
    case key_down:
      at[1] = std::max(0.0, at[1] - step);
      break;
    case key_enter:
      ask_at(at);
      return true;
    default:
      return false;
  }
  show_crosshair();
  return true;
}

void ViewScreen::press_mouse(const KeyEvent& event) {
  const Area& area = layout_.picture;
  const int x = event.x - area.x, y = event.y - area.y;
  const bool inside = x >= 0 && y >= 0 && x < area.width && y < area.height && number_ > 0;
  const viz::Answer& answer = server_.answer();
  const auto pixel = pixel_of_cell(x, y, area.width, area.height, answer.width, answer.height);
  if (event.key == key_wheel_up && inside) zoom(1 / zoom_step, pixel);
  if (event.key == key_wheel_down && inside) zoom(zoom_step, pixel);
  if (event.key == key_click && inside) pressed_ = {x, y}, dragged_ = false;
  if (event.key == key_drag && pressed_ && (x != (*pressed_)[0] || y != (*pressed_)[1])) {
    const viz::Box& box = answer.pane[0].picture;
    const double cell_width = static_cast<double>(answer.width) / area.width;
    const double cell_height = static_cast<double>(answer.height) / area.height;
    look_by(panned(view_now(), (x - (*pressed_)[0]) * cell_width / box.height(),
                   -(y - (*pressed_)[1]) * cell_height / box.height()));
    pressed_ = {x, y}, dragged_ = true;
  }
  if (event.key != key_release || !pressed_) return;
  if (!dragged_) ask_at({pixel[0] / answer.width, pixel[1] / answer.height});
  pressed_.reset();
}

}  // namespace rift::studio

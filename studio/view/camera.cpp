#include "studio/view/camera.hpp"

namespace rift::studio {
namespace {

/// The middle moves by so many metres in the picture. Exact while the plate faces the camera; a turned plate
/// moves along its own plane.
viz::View moved(viz::View view, double right_m, double up_m) {
  viz::Look look;
  look.camera = viz::Camera::free;
  look.view = view;
  const viz::Axes axes = viz::axes_of(look);
  view.x += right_m * axes.right[0] + up_m * axes.up[0];
  view.y += right_m * axes.right[1] + up_m * axes.up[1];
  return view;
}

}  // namespace

viz::View view_of(const viz::Look& look, const viz::Window& shown) {
  if (look.camera == viz::Camera::free) return look.view;
  return {shown.x, shown.y, shown.height, 0, look.camera == viz::Camera::side ? viz::side_tilt : 0};
}

viz::View panned(const viz::View& view, double right, double up) {
  return moved(view, -right * view.height, -up * view.height);
}

viz::View zoomed(const viz::View& view, double factor, const viz::Box& picture,
                 const std::array<double, 2>& pixel) {
  const double metres_per_pixel = view.height / picture.height(), less = 1 - factor;
  const double right = (pixel[0] - 0.5 * (picture.x0 + picture.x1)) * metres_per_pixel * less;
  const double up = (pixel[1] - 0.5 * (picture.y0 + picture.y1)) * metres_per_pixel * less;
  viz::View closer = moved(view, right, up);
  closer.height *= factor;
  return closer;
}

std::array<double, 2> pixel_of_cell(int x, int y, int columns, int rows, int width, int height) {
  return {(x + 0.5) / columns * width, (1 - (y + 0.5) / rows) * height};
}

}  // namespace rift::studio

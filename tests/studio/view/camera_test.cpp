#include "studio/view/camera.hpp"

#include <gtest/gtest.h>

namespace rift::studio {
namespace {

constexpr viz::Box box{10, 20, 410, 220};

viz::Look free_look(const viz::View& view) {
  viz::Look look;
  look.camera = viz::Camera::free;
  look.view = view;
  return look;
}

std::array<double, 2> pixel_of(const viz::View& view, const std::array<double, 3>& point) {
  const viz::Look look = free_look(view);
  return viz::to_pixels(viz::axes_of(look), viz::window_of(look, box, {}, {}), box, point);
}

TEST(ViewCamera, AZoomKeepsWhatIsUnderThePointer) {
  const viz::View view{0.1, 0.02, 0.05, 0, 0};
  const std::array<double, 3> point{0.11, 0.03, 0};
  const auto pixel = pixel_of(view, point);
  for (const double factor : {0.5, 0.8, 1.25, 3.0}) {
    const viz::View closer = zoomed(view, factor, box, pixel);
    EXPECT_DOUBLE_EQ(closer.height, factor * view.height);
    EXPECT_NEAR(pixel_of(closer, point)[0], pixel[0], 1e-9) << factor;
    EXPECT_NEAR(pixel_of(closer, point)[1], pixel[1], 1e-9) << factor;
  }
}

TEST(ViewCamera, PanningMovesThePictureByItsHeights) {
  const viz::View view{0.1, 0.02, 0.05, 0, 0};
  const std::array<double, 3> point{0.11, 0.03, 0};
  const auto before = pixel_of(view, point), after = pixel_of(panned(view, 0.1, -0.2), point);
  EXPECT_NEAR(after[0] - before[0], 0.1 * box.height(), 1e-9);
  EXPECT_NEAR(after[1] - before[1], -0.2 * box.height(), 1e-9);
}

TEST(ViewCamera, TheFreeCameraBeginsWithWhatIsSeen) {
  viz::Look look;
  look.camera = viz::Camera::side;
  const viz::Window shown{0.1, 0.02, 0.2, 0.1};
  const viz::View view = view_of(look, shown);
  for (int axis = 0; axis < 3; ++axis)
    EXPECT_EQ(viz::axes_of(free_look(view)).up[axis], viz::axes_of(look).up[axis]);
  EXPECT_EQ(view.height, shown.height);
  look.camera = viz::Camera::tip;
  EXPECT_EQ(view_of(look, shown), (viz::View{0.1, 0.02, 0.1, 0, 0}));
}

TEST(ViewCamera, ACellsMiddleIsAPixelFromBelow) {
  EXPECT_EQ(pixel_of_cell(0, 0, 80, 20, 800, 400), (std::array{5.0, 390.0}));
  EXPECT_NEAR(pixel_of_cell(79, 19, 80, 20, 800, 400)[0], 795, 1e-9);
  EXPECT_NEAR(pixel_of_cell(79, 19, 80, 20, 800, 400)[1], 10, 1e-9);
}

}  // namespace
}  // namespace rift::studio

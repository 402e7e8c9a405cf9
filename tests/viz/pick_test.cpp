#include "viz/pick.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numeric>
#include <random>

namespace rift::viz {
namespace {

/// Spheres anywhere in a box, displaced.
struct Heap {
  results::Geometry geometry;
  std::vector<std::array<float, 3>> displacement;
};

Heap heap(int elements, std::mt19937& random) {
  std::uniform_real_distribution<float> place(0, 1), size(0.01F, 0.04F), moved(-0.02F, 0.02F);
  Heap h;
  for (int k = 0; k < elements; ++k) {
    h.geometry.position.push_back({place(random), 0.3F * place(random), 0.2F * place(random)});
    h.geometry.radius.push_back(size(random));
    h.displacement.push_back({moved(random), moved(random), moved(random)});
  }
  return h;
}

/// Marches from the eye in small steps along the line of sight until it is in a sphere.
std::int32_t by_marching(const Standing& s, std::span<const std::int32_t> shown, float scale,
                         const std::array<double, 2>& pixel) {
  const double right = s.window.width * ((pixel[0] - s.box.x0) / s.box.width() - 0.5);
  const double up = s.window.height * ((pixel[1] - s.box.y0) / s.box.height() - 0.5);
  std::int32_t best = -1;
  double nearest = -1e9;
  for (const std::int32_t i : shown) {
    std::array<double, 3> centre{}, foot{s.window.x, s.window.y, 0};
    for (int axis = 0; axis < 3; ++axis) {
      centre[axis] = s.geometry.position[i][axis] + s.magnification[axis] * s.displacement[i][axis];
      foot[axis] += right * s.axes.right[axis] + up * s.axes.up[axis];
    }
    // The ray foot + t out meets the sphere: a quadratic equation in t, whose larger root is in front.
    double b = 0, c = 0;
    for (int axis = 0; axis < 3; ++axis) {
      const double d = foot[axis] - centre[axis];
      b += 2 * d * s.axes.out[axis], c += d * d;
    }
    c -= std::pow(static_cast<double>(scale) * s.geometry.radius[i], 2);
    const double discriminant = b * b - 4 * c;
    if (discriminant < 0) continue;
    const double t = 0.5 * (-b + std::sqrt(discriminant));
    if (t > nearest) nearest = t, best = i;
  }
  return best;
}

TEST(Pick, NamesWhatABruteForceSearchFindsInEachOf1000Clicks) {
  std::mt19937 random(7);
  const Heap h = heap(3000, random);
  std::vector<std::int32_t> shown(3000);
  std::iota(shown.begin(), shown.end(), 0);
  std::uniform_real_distribution<double> x(0, 640), y(0, 360), angle(-1.2, 1.2);
  int hits = 0, right = 0;
  for (int click = 0; click < 1000; ++click) {
    Look look;
    look.camera = Camera::free;
    look.view = {0.5, 0.15, 0.5, angle(random), angle(random)};
    const Box box{0, 0, 640, 360};
    const Standing standing{
        h.geometry, h.displacement, {2, 2, 2}, axes_of(look), window_of(look, box, {}, {}), box};
    const std::array<double, 2> pixel{x(random), y(random)};
    const std::int32_t expected = by_marching(standing, shown, 1.15F, pixel);
    const auto found = element_at(standing, shown, 1.15F, pixel);
    right += found.value_or(-1) == expected ? 1 : 0;
    hits += expected >= 0 ? 1 : 0;
  }
  EXPECT_EQ(right, 1000);
  EXPECT_GT(hits, 300);
  EXPECT_LT(hits, 1000);
}

TEST(Pick, TheNearestGaugeIsReadAtTheMoment) {
  const auto row = [](double time_s, int gauge, double x_m, double uy_m) {
    return results::GaugeRow{.time_s = time_s, .gauge = gauge, .x_m = x_m, .uy_m = uy_m};
  };
  const std::vector<results::GaugeRow> rows{row(0, 0, 0.01, 1), row(0, 1, 0.03, 2), row(1, 0, 0.01, 3),
                                            row(1, 1, 0.03, 4), row(2, 0, 0.01, 5), row(2, 1, 0.03, 6)};
  EXPECT_EQ(nearest_gauge(rows, {0.022, 0, 0}, 1.5)->uy_m, 4);
  EXPECT_EQ(nearest_gauge(rows, {0.018, 0, 0.5}, 2)->uy_m, 5);
  EXPECT_FALSE(nearest_gauge(rows, {0.018, 0, 0}, -1));
  EXPECT_FALSE(nearest_gauge({}, {0, 0, 0}, 1));
}

TEST(Pick, AnElementIsFoundWhereItsMiddleIsDrawn) {
  Heap h;
  h.geometry.position = {{0.2F, 0.1F, 0}, {0.2F, 0.1F, 0.1F}};
  h.geometry.radius = {0.02F, 0.01F};
  h.displacement = {{0, 0.05F, 0}, {0, 0.05F, 0}};
  Look look;
  look.camera = Camera::free;
  look.view = {0.2, 0.1, 0.4, 0, 0};
  const Box box{10, 20, 210, 120};
  const Standing standing{h.geometry, h.displacement, {1, 1, 1}, axes_of(look), window_of(look, box, {}, {}),
                          box};
  const std::vector<std::int32_t> both{0, 1}, back{0};
  const auto at = to_pixels(standing.axes, standing.window, box, {0.2, 0.15, 0.1});
  EXPECT_EQ(element_at(standing, both, 1, at), 1);
  EXPECT_EQ(element_at(standing, back, 1, at), 0) << "what is not drawn hides nothing";
  EXPECT_EQ(element_at(standing, both, 1, {at[0] + 0.015 / 0.4 * 100, at[1]}), 0) << "beside the smaller one";
  EXPECT_EQ(element_at(standing, both, 1, {at[0] + 0.025 / 0.4 * 100, at[1]}), std::nullopt);
}

}  // namespace
}  // namespace rift::viz

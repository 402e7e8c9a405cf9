#pragma once

#include "engine/results/schema.hpp"
#include "viz/job.hpp"
#include "viz/layout.hpp"

#include <array>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

/// What stands at a pixel of a picture, by the same arithmetic that draws it.
namespace rift::viz {

/// How the elements of a pane stand in its picture.
struct Standing {
  const results::Geometry& geometry;
  std::span<const std::array<float, 3>> displacement;  // N [m], or none
  std::array<float, 3> magnification{};
  Axes axes;
  Window window;
  Box box;
};

/// By how much elements are drawn larger than they are. Where every beam is drawn, elements are small balls
/// between them; seen from far they are drawn a little larger, so that the gaps between them do not glitter.
[[nodiscard]] float sphere_scale(const Look& look);

/// The side camera magnifies what leaves the plane and nothing else.
[[nodiscard]] std::array<float, 3> magnification_of(const Look& look);

/// The elements that are drawn, ascending: those that are not hidden, or none.
[[nodiscard]] std::vector<std::int32_t> elements_shown(const Look& look, const results::Geometry& geometry);

/// The nearest of the spheres that cover a pixel. Cost O(shown).
[[nodiscard]] std::optional<std::int32_t> element_at(const Standing& standing,
                                                     std::span<const std::int32_t> shown, float scale,
                                                     const std::array<double, 2>& pixel);

/// The beam whose line passes nearest to a pixel, within three pixels. Cost O(beams).
[[nodiscard]] std::optional<std::int32_t> beam_at(const Standing& standing, Beams shown,
                                                  const std::array<double, 2>& pixel);

/// What the gauge nearest to a point of the unloaded plate showed last until a time.
/// @param rows  of one lane, in the order of time. Cost O(rows).
[[nodiscard]] std::optional<results::GaugeRow> nearest_gauge(std::span<const results::GaugeRow> rows,
                                                             const std::array<double, 3>& point,
                                                             double time_s);

}  // namespace rift::viz

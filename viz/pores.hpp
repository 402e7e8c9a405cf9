#pragma once

#include "engine/results/schema.hpp"

#include <array>
#include <cstdint>
#include <vector>

namespace rift::viz {

/// A ball as it is drawn: an element, or what closes a pore beside it, which moves with it and has its
/// colour.
struct Ball {
  std::int32_t element = 0;
  std::array<float, 3> place{};  // in the unloaded plate [m]
  float radius = 0;
};

/// Balls behind the elements, one for each pore of the packing, so that the background does not show through.
/// Openings in which an element has room stay open, and pores that the crack cuts, whose filler would stand
/// in its opening. Cost O(elements).
/// @param shown    the elements that are drawn;  @param scale  of their radii
/// @param stretch  by how much the load draws the plate along y as it is drawn, 1 for none
[[nodiscard]] std::vector<Ball> pore_fillers(const results::Geometry& geometry,
                                             const std::vector<std::int32_t>& shown, float scale,
                                             double stretch);

}  // namespace rift::viz

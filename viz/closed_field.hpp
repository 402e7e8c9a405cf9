#pragma once

#include "engine/results/schema.hpp"

#include <cstdint>
#include <vector>

namespace rift::viz {

/// The radii with which elements are drawn so that no pore of the packing shows the background: `scale` times
/// their own, and more beside a pore, up to its middle. Openings in which an element has room stay open, and
/// pores that the crack cuts: what closes them would hide its opening.
/// @param shown    the elements that are drawn, whose radii these are
/// @param stretch  by how much the load draws the plate along y as it is drawn, 1 for none. Cost O(elements).
[[nodiscard]] std::vector<float> radii_without_pores(const results::Geometry& geometry,
                                                     const std::vector<std::int32_t>& shown, float scale,
                                                     double stretch);

}  // namespace rift::viz

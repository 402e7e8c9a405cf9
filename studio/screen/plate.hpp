#pragma once

#include "engine/results/schema.hpp"
#include "studio/screen/canvas.hpp"

#include <array>
#include <span>

namespace rift::studio {

/// The plate as its front looks in a terminal: vertical displacement or velocity in half blocks of colour,
/// the tip marked.
struct PlateLook {
  double length = 0, height = 0;  // [m]
  double pulled = 0;              // displacement of the upper grip [m]; the colours run from 0 to it
  std::span<const std::array<double, 2>> tips;  // [m]
  /// N [m/s]; where given, the colours are of its y, from -fastest to fastest
  std::span<const std::array<float, 3>> velocity = {};
  double fastest = 0;
};

/// Draws the elements where they are, by their mean over what each half of a cell covers; in ASCII by a
/// letter of their displacement, from '.' to '#'. Halves that hold no element stay empty: the open crack.
/// @param displacement  N [m]; empty: the plate is drawn unloaded and without colours
void draw_plate(Canvas& canvas, const Area& area, const results::Geometry& geometry,
                std::span<const std::array<float, 3>> displacement, const PlateLook& look, Glyphs glyphs);

/// The scale of a plate's colours from least to most in one line of `shade_steps` cells.
void draw_scale(Canvas& canvas, int x, int y, Glyphs glyphs);

}  // namespace rift::studio

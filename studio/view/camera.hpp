#pragma once

#include "viz/job.hpp"
#include "viz/layout.hpp"
#include "viz/order.hpp"

#include <array>

/// How the free camera moves: pure arithmetic.
namespace rift::studio {

/// The free camera that shows what another one shows now.
[[nodiscard]] viz::View view_of(const viz::Look& look, const viz::Window& shown);

/// Moves what is seen by so many heights of the picture to the right and up.
[[nodiscard]] viz::View panned(const viz::View& view, double right, double up);

/// Shows `factor` times as much, while what is at a pixel of the picture's box stays there.
[[nodiscard]] viz::View zoomed(const viz::View& view, double factor, const viz::Box& picture,
                               const std::array<double, 2>& pixel);

/// The middle of a cell of the picture's area, as a pixel of a picture of this size, from the lower left
/// corner.
[[nodiscard]] std::array<double, 2> pixel_of_cell(int x, int y, int columns, int rows, int width, int height);

}  // namespace rift::studio

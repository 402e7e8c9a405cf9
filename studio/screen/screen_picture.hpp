#pragma once

#include "studio/screen/canvas.hpp"

#include <cstdint>
#include <span>

namespace rift::studio {

/// Whether a terminal shows pictures, and how large its cells are.
struct PictureRoom {
  bool pictures = false;
  bool symbols = false;  // each cell is one letter of two colours: texts within a picture cannot be read
  int cell_width = 8, cell_height = 16;  // [px]
  int most_width = 0, most_height = 0;   // [px] of a picture; 0 where not limited
  double bytes_per_s = 0;                // that the terminal takes, as last measured; 0 where not yet
  double bytes_per_pixel = 0;            // of the last picture
  std::uint64_t shown = 0;               // the number of the last picture that it was sent
  bool rough = false;  // it moved and was sent in letters, on a slow line, or in coarser colours
};

/// A picture in a rectangle of cells, which the screen leaves blank.
struct ScreenPicture {
  Area area;
  int width = 0, height = 0;          // [px]
  std::span<const std::uint8_t> rgb;  // rows from the top
  std::uint64_t number = 0;           // another one with each picture
  bool moves = false;                 // it will be over soon: better rough than late
};

}  // namespace rift::studio

#pragma once

#include <cstdint>
#include <vector>

namespace rift::viz {

/// A picture of bytes, rows from the top.
struct Image {
  int width = 0, height = 0;
  std::vector<std::uint8_t> rgb;  // width · height · 3
};

}  // namespace rift::viz

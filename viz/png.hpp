#pragma once

#include <cstdint>
#include <filesystem>
#include <vector>

namespace rift::viz {

/// A picture of bytes, rows from the top.
struct Image {
  int width = 0, height = 0;
  std::vector<std::uint8_t> rgb;  // width · height · 3
};

/// The file appears whole or not at all. Throws WorldError.
void write_png(const std::filesystem::path& path, const Image& image);

/// Throws WorldError.
[[nodiscard]] Image read_png(const std::filesystem::path& path);

}  // namespace rift::viz

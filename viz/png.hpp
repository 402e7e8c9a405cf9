#pragma once

#include "viz/image.hpp"

#include <filesystem>

namespace rift::viz {

/// The file appears whole or not at all. Throws WorldError.
void write_png(const std::filesystem::path& path, const Image& image);

/// Throws WorldError.
[[nodiscard]] Image read_png(const std::filesystem::path& path);

}  // namespace rift::viz

#pragma once

#include <filesystem>
#include <string>

namespace rift::scene {

/// The text of a file, or why there is none ("no such file", "is a directory", "cannot be read: ...").
struct PresetFile {
  std::string text;
  std::string problem;
};

/// Reads a file, a pipe or a device, once and from its begin; at most one byte more than `largest`, so that a
/// device without end does no harm and the reader sees that it is too large.
PresetFile read_preset_file(const std::filesystem::path& path, std::size_t largest);

}  // namespace rift::scene

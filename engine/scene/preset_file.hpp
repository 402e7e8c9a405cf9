#pragma once

#include <filesystem>
#include <string>

namespace rift {

/// The text of a file, or why there is none ("no such file", "is a directory", "cannot be read: ...").
struct PresetFile {
  std::string text;
  std::string problem;
};

/// Reads at most a little more than a preset may hold, so that a device without end does no harm.
PresetFile read_preset_file(const std::filesystem::path& path);

}  // namespace rift

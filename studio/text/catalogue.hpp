#pragma once

#include "engine/scene/preset.hpp"

#include <filesystem>
#include <string>
#include <vector>

namespace rift::studio {

// What there is to choose from: presets, and what has been computed.

/// A preset as its opening comment describes it; texts that it lacks are empty.
struct PresetEntry {
  std::string name;
  std::filesystem::path path;
  std::string shows, cost;
};

/// The presets of a folder by name. Throws where it cannot be read.
std::vector<PresetEntry> preset_entries(const std::filesystem::path& folder);

/// The command that takes a preset: "study", "calibrate" (of a cylinder), "pack" (of what has no grips),
/// "experiment" (of a measured crack), else "run"; empty of one with mistakes.
std::string command_for(const scene::Preset& preset);

/// Bytes that it leaves on the disk, at most, as `rift check` tells them; NaN where nothing is kept but in
/// the cache.
double expected_disk_bytes(const scene::Preset& preset);

/// A folder with a run or a study in it.
struct RunEntry {
  std::string name;
  std::filesystem::path path;
  std::string outcome;  // "finished", "stopped", "diverged", "unfinished", "study", "damaged"
  std::string result;   // "0.519", "8 lanes", "12 of 30"
  std::filesystem::file_time_type when;
};

/// The runs and studies of a folder, the latest first; none where there is no such folder.
std::vector<RunEntry> run_entries(const std::filesystem::path& folder);

}  // namespace rift::studio

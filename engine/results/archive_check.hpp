#pragma once

#include <cstdint>
#include <filesystem>
#include <map>
#include <string>
#include <vector>

namespace rift::results {

/// What an archive is found to hold.
struct ArchiveCheck {
  std::vector<std::string> problems;            // for people; none where it is sound
  std::map<std::string, std::uint64_t> digest;  // of each dataset that could be read, by its path
  std::int64_t moments = 0, samples = 0, events = 0, elements = 0, beams = 0;
};

/// Reads every dataset of a `run.vtkhdf` once and holds it against what docs/results-format.md says: that it
/// can be read, that sizes agree with one another, that offsets and indices point into what they index. Bad
/// archives are problems, never exceptions. Memory O(geometry + samples).
///
/// The HDF5 library may crash or hang on a file that is damaged or not ours: see check_archive_in_child().
[[nodiscard]] ArchiveCheck check_archive(const std::filesystem::path& path);

/// The same in a process of its own with bounds of memory and time, whose death is a problem as well.
/// @param seconds  that it may take
[[nodiscard]] ArchiveCheck check_archive_in_child(const std::filesystem::path& path, unsigned seconds = 600);

}  // namespace rift::results

#pragma once

#include <filesystem>
#include <stdexcept>
#include <string>
#include <system_error>

namespace rift::base {

/// What the system says of an errno: "No space left on device".
inline std::string reason_of(int error) { return std::generic_category().message(error); }

/// The world failed (disk, HDF5): `what()` reads "cannot <attempt> <path>: <reason>". Commands exit with 1.
class WorldError : public std::runtime_error {
 public:
  WorldError(const std::string& attempt, const std::filesystem::path& path, const std::string& reason)
      : std::runtime_error("cannot " + attempt + " " + path.string() + ": " + reason), path_(path) {}

  [[nodiscard]] const std::filesystem::path& path() const { return path_; }

 private:
  std::filesystem::path path_;
};

}  // namespace rift::base

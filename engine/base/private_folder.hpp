#pragma once

#include <filesystem>
#include <string>

namespace rift::base {

/// A folder for what is thrown away, which nobody else may look into or has prepared. It goes with the
/// object.
class PrivateFolder {
 public:
  /// @param purpose  part of its name. Throws WorldError where it cannot be made.
  explicit PrivateFolder(const std::string& purpose);
  ~PrivateFolder();
  PrivateFolder(const PrivateFolder&) = delete;
  PrivateFolder& operator=(const PrivateFolder&) = delete;
  [[nodiscard]] const std::filesystem::path& path() const { return path_; }

 private:
  std::filesystem::path path_;
};

}  // namespace rift::base

#include "engine/base/private_folder.hpp"

#include "engine/base/world_error.hpp"

#include <stdlib.h>

#include <cerrno>
#include <system_error>

namespace rift::base {

PrivateFolder::PrivateFolder(const std::string& purpose) {
  std::error_code error;
  const std::filesystem::path base = std::filesystem::temp_directory_path(error);
  if (error) throw WorldError("find the folder for temporary files", "TMPDIR", error.message());
  std::string name = (base / ("rift_" + purpose + "_XXXXXX")).string();
  if (::mkdtemp(name.data()) == nullptr)
    throw WorldError("create a folder in", base, reason_of(errno));
  path_ = name;
}

PrivateFolder::~PrivateFolder() {
  std::error_code ignored;
  std::filesystem::remove_all(path_, ignored);
}

}  // namespace rift::base

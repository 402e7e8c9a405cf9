#include "studio/workbench/screen.hpp"

#include <fmt/format.h>

namespace rift::studio {

std::filesystem::path free_folder(const std::filesystem::path& folder, const std::string& name) {
  std::filesystem::path path = folder / name;
  for (int k = 2; std::filesystem::exists(path); ++k) path = folder / fmt::format("{}-{}", name, k);
  return path;
}

}  // namespace rift::studio

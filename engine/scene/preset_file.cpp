#include "engine/scene/preset_file.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cerrno>
#include <cstdio>
#include <cstring>
#include <memory>
#include <system_error>
#include <utility>
#include <vector>

namespace rift::scene {

PresetFile read_preset_file(const std::filesystem::path& path, std::size_t largest) {
  std::error_code error;
  const std::filesystem::file_status status = std::filesystem::status(path, error);
  if (status.type() == std::filesystem::file_type::not_found) return {"", "no such file"};
  if (std::filesystem::is_directory(status)) return {"", "is a directory"};

  struct Close {
    void operator()(std::FILE* file) const { std::fclose(file); }
  };
  const std::unique_ptr<std::FILE, Close> file(std::fopen(path.c_str(), "rb"));
  if (!file) return {"", fmt::format("cannot be read: {}", std::strerror(errno))};
  std::string text;
  std::vector<char> buffer(std::size_t{1} << 16);
  while (text.size() <= largest) {
    const std::size_t most = std::min(buffer.size(), largest + 1 - text.size());
    const std::size_t count = std::fread(buffer.data(), 1, most, file.get());
    if (std::ferror(file.get()) != 0) return {"", fmt::format("cannot be read: {}", std::strerror(errno))};
    if (count == 0) break;
    text.append(buffer.data(), count);
  }
  return {std::move(text), ""};
}

}  // namespace rift::scene

#include "engine/scene/preset_file.hpp"

#include <fmt/format.h>

#include <cerrno>
#include <cstdio>
#include <cstring>
#include <memory>
#include <system_error>
#include <vector>

namespace rift {

PresetFile read_preset_file(const std::filesystem::path& path) {
  std::error_code error;
  const std::filesystem::file_status status = std::filesystem::status(path, error);
  if (status.type() == std::filesystem::file_type::not_found) return {"", "no such file"};
  if (std::filesystem::is_directory(status)) return {"", "is a directory"};

  struct Close {
    void operator()(std::FILE* file) const { std::fclose(file); }
  };
  const std::unique_ptr<std::FILE, Close> file(std::fopen(path.c_str(), "rb"));
  if (!file) return {"", fmt::format("cannot be read: {}", std::strerror(errno))};
  std::vector<char> buffer((std::size_t{1} << 20) +
                           1);  // one byte more than a preset may hold: read_toml refuses it
  const std::size_t count = std::fread(buffer.data(), 1, buffer.size(), file.get());
  if (std::ferror(file.get()) != 0) return {"", fmt::format("cannot be read: {}", std::strerror(errno))};
  return {std::string(buffer.data(), count), ""};
}

}  // namespace rift

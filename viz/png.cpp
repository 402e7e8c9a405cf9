#include "viz/png.hpp"

#include "engine/base/files.hpp"
#include "engine/base/world_error.hpp"

#include <png.h>

#include <cstring>
#include <string>
#include <string_view>

namespace rift::viz {
namespace {

png_image header_of(const Image& image) {
  png_image header;
  std::memset(&header, 0, sizeof(header));
  header.version = PNG_IMAGE_VERSION;
  header.width = static_cast<png_uint_32>(image.width);
  header.height = static_cast<png_uint_32>(image.height);
  header.format = PNG_FORMAT_RGB;
  return header;
}

}  // namespace

void write_png(const std::filesystem::path& path, const Image& image) {
  png_image header = header_of(image);
  png_alloc_size_t size = PNG_IMAGE_PNG_SIZE_MAX(header);
  std::string bytes(size, '\0');
  if (png_image_write_to_memory(&header, bytes.data(), &size, 0, image.rgb.data(), 0, nullptr) == 0)
    throw base::WorldError("make the picture", path, header.message);
  base::write_whole_file(path, std::string_view(bytes).substr(0, size));
}

Image read_png(const std::filesystem::path& path) {
  png_image header = header_of({});
  if (png_image_begin_read_from_file(&header, path.c_str()) == 0)
    throw base::WorldError("read", path, header.message);
  header.format = PNG_FORMAT_RGB;
  Image image{static_cast<int>(header.width), static_cast<int>(header.height), {}};
  image.rgb.resize(PNG_IMAGE_SIZE(header));
  if (png_image_finish_read(&header, nullptr, image.rgb.data(), 0, nullptr) == 0)
    throw base::WorldError("read", path, header.message);
  return image;
}

}  // namespace rift::viz

#include "viz/png.hpp"

#include "engine/results/files.hpp"
#include "engine/results/world_error.hpp"

#include <png.h>

#include <cstring>

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
  results::PendingFile file(path);
  png_image header = header_of(image);
  if (png_image_write_to_file(&header, file.temporary().c_str(), 0, image.rgb.data(), 0, nullptr) == 0)
    throw results::WorldError("write", path, header.message);
  file.commit();
}

Image read_png(const std::filesystem::path& path) {
  png_image header = header_of({});
  if (png_image_begin_read_from_file(&header, path.c_str()) == 0)
    throw results::WorldError("read", path, header.message);
  header.format = PNG_FORMAT_RGB;
  Image image{static_cast<int>(header.width), static_cast<int>(header.height), {}};
  image.rgb.resize(PNG_IMAGE_SIZE(header));
  if (png_image_finish_read(&header, nullptr, image.rgb.data(), 0, nullptr) == 0)
    throw results::WorldError("read", path, header.message);
  return image;
}

}  // namespace rift::viz

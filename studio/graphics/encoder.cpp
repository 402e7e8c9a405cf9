#include "studio/graphics/encoder.hpp"

#include "studio/graphics/canvas_bytes.hpp"

#include <fmt/format.h>

#include <algorithm>

namespace rift::studio {
namespace {

constexpr const char* keep_cursor = "\0337";
constexpr const char* cursor_back = "\0338";

std::string kitty_delete(int image) { return fmt::format("\033_Ga=d,d=I,i={},q=2\033\\", image); }

std::vector<std::string> lines_of(const std::string& text) {
  std::vector<std::string> lines;
  std::size_t from = 0;
  while (from < text.size()) {
    const std::size_t end = std::min(text.find('\n', from), text.size());
    lines.push_back(text.substr(from, end - from));
    from = end + 1;
  }
  return lines;
}

bool same_place(const Area& a, const Area& b) {
  return a.x == b.x && a.y == b.y && a.width == b.width && a.height == b.height;
}

}  // namespace

std::string at_cell(int x, int y) { return fmt::format("\033[{};{}H", y + 1, x + 1); }

PictureEncoder::PictureEncoder(Graphics graphics, const TerminalKind& kind, int cell_width, int cell_height)
    : graphics_(graphics), kind_(kind), cell_width_(cell_width), cell_height_(cell_height) {}

bool PictureEncoder::there() { return canvas_bytes_there(); }

std::string PictureEncoder::show(const ScreenPicture& picture) {
  if (picture.area.empty() || picture.width <= 0 || picture.height <= 0) return {};
  const std::string body = graphics_ == Graphics::symbols ? show_symbols(picture) : show_pixels(picture);
  shown_ = picture.area;
  return body.empty() ? body : keep_cursor + body + cursor_back;
}

/// kitty keeps two images in turn: the new one is there before the old one goes.
std::string PictureEncoder::show_pixels(const ScreenPicture& picture) {
  const int before = image_;
  image_ = 3 - image_;
  std::string bytes = at_cell(picture.area.x, picture.area.y) +
                      canvas_bytes(picture, {graphics_, kind_, cell_width_, cell_height_, image_});
  if (graphics_ == Graphics::kitty) bytes += kitty_delete(before);
  return bytes;
}

std::string PictureEncoder::show_symbols(const ScreenPicture& picture) {
  if (!same_place(picture.area, shown_)) rows_.clear();
  rows_.resize(static_cast<std::size_t>(picture.area.height));
  const std::vector<std::string> lines =
      lines_of(canvas_bytes(picture, {graphics_, kind_, cell_width_, cell_height_, image_}));
  SymbolChanges changes;
  for (std::size_t y = 0; y < std::min(lines.size(), rows_.size()); ++y) {
    std::vector<SymbolCell> row = cells_of(lines[y]);
    if (picture.moves) std::for_each(row.begin(), row.end(), make_coarse);
    changes.add(picture.area.x, picture.area.y + static_cast<int>(y), rows_[y], row);
    rows_[y] = std::move(row);
  }
  return changes.codes();
}

std::string PictureEncoder::clear(const Area& area) {
  rows_.clear();
  shown_ = {};
  std::string bytes = keep_cursor;
  if (graphics_ == Graphics::kitty) bytes += kitty_delete(1) + kitty_delete(2);
  bytes += "\033[0m";
  for (int y = area.y; y < area.y + area.height; ++y)
    bytes += at_cell(area.x, y) + std::string(static_cast<std::size_t>(area.width), ' ');
  return bytes + cursor_back;
}

// ESC \ ends a picture that was cut off in its middle, and is nothing otherwise.
std::string PictureEncoder::restore() const {
  return graphics_ == Graphics::kitty ? "\033\\" + kitty_delete(1) + kitty_delete(2) : "\033\\";
}

}  // namespace rift::studio

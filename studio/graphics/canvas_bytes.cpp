#include "studio/graphics/canvas_bytes.hpp"

#include <chafa.h>
#include <fmt/format.h>

#include <algorithm>
#include <memory>
#include <vector>

namespace rift::studio {
namespace {

template <auto Release>
struct Releasing {
  template <typename T>
  void operator()(T* object) const {
    Release(object);
  }
};
using Config = std::unique_ptr<ChafaCanvasConfig, Releasing<chafa_canvas_config_unref>>;
using Symbols = std::unique_ptr<ChafaSymbolMap, Releasing<chafa_symbol_map_unref>>;
using ChafaPicture = std::unique_ptr<ChafaCanvas, Releasing<chafa_canvas_unref>>;
using Info = std::unique_ptr<ChafaTermInfo, Releasing<chafa_term_info_unref>>;

ChafaPixelMode mode_of(Graphics graphics) {
  switch (graphics) {
    case Graphics::sixel:
      return CHAFA_PIXEL_MODE_SIXELS;
    case Graphics::kitty:
      return CHAFA_PIXEL_MODE_KITTY;
    case Graphics::iterm:
      return CHAFA_PIXEL_MODE_ITERM2;
    default:
      return CHAFA_PIXEL_MODE_SYMBOLS;
  }
}

ChafaCanvasMode mode_of(Colours colours) {
  switch (colours) {
    case Colours::all:
      return CHAFA_CANVAS_MODE_TRUECOLOR;
    case Colours::many:
      return CHAFA_CANVAS_MODE_INDEXED_240;
    case Colours::sixteen:
      return CHAFA_CANVAS_MODE_INDEXED_16;
    case Colours::eight:
      return CHAFA_CANVAS_MODE_INDEXED_8;
    case Colours::two:
      break;
  }
  return CHAFA_CANVAS_MODE_FGBG;
}

Config config_of(const ScreenPicture& picture, const CanvasKind& kind) {
  Config config(chafa_canvas_config_new());
  const bool symbols = kind.graphics == Graphics::symbols;
  int cell_width = kind.cell_width, cell_height = kind.cell_height;
  if (kind.graphics == Graphics::kitty) {  // the terminal enlarges what has fewer pixels than its rectangle
    cell_width = std::max(1, std::min(cell_width, picture.width / picture.area.width));
    cell_height = std::max(1, std::min(cell_height, picture.height / picture.area.height));
  }
  chafa_canvas_config_set_geometry(config.get(), picture.area.width, picture.area.height);
  chafa_canvas_config_set_cell_geometry(config.get(), cell_width, cell_height);
  chafa_canvas_config_set_pixel_mode(config.get(), mode_of(kind.graphics));
  chafa_canvas_config_set_canvas_mode(config.get(),
                                      symbols ? mode_of(kind.terminal.colours) : CHAFA_CANVAS_MODE_TRUECOLOR);
  chafa_canvas_config_set_dither_mode(config.get(), CHAFA_DITHER_MODE_NONE);
  chafa_canvas_config_set_preprocessing_enabled(config.get(), FALSE);
  chafa_canvas_config_set_work_factor(config.get(), 0.5F);
  // A letter that is repeated by a code (REP) is not repeated by every terminal.
  chafa_canvas_config_set_optimizations(config.get(), CHAFA_OPTIMIZATION_REUSE_ATTRIBUTES);
  const Symbols map(chafa_symbol_map_new());
  // Half blocks are in every font with any blocks at all.
  const auto blocks = static_cast<ChafaSymbolTags>(CHAFA_SYMBOL_TAG_SPACE | CHAFA_SYMBOL_TAG_SOLID |
                                                   CHAFA_SYMBOL_TAG_HALF | CHAFA_SYMBOL_TAG_STIPPLE);
  chafa_symbol_map_add_by_tags(map.get(), kind.terminal.unicode ? blocks : CHAFA_SYMBOL_TAG_ASCII);
  chafa_canvas_config_set_symbol_map(config.get(), map.get());
  return config;
}

/// A terminal that knows xterm's codes, and the protocol that was chosen. Images of kitty have numbers, so
/// that they can be taken away, and it does not answer.
Info info_of(const CanvasKind& kind) {
  char* none[] = {nullptr};
  Info info(chafa_term_db_detect(chafa_term_db_get_default(), none));
  Info all(chafa_term_db_get_fallback_info(chafa_term_db_get_default()));
  chafa_term_info_supplement(info.get(), all.get());
  const auto set = [&](ChafaTermSeq name, const std::string& text) {
    chafa_term_info_set_seq(info.get(), name, text.c_str(), nullptr);
  };
  set(CHAFA_TERM_SEQ_BEGIN_SIXELS, "\033P%1;%2;%3q");
  set(CHAFA_TERM_SEQ_END_SIXELS, "\033\\");
  set(CHAFA_TERM_SEQ_BEGIN_KITTY_IMMEDIATE_IMAGE_V1,
      fmt::format("\033_Ga=T,i={},p=1,q=2,C=1,f=%1,s=%2,v=%3,c=%4,r=%5,m=1\033\\", kind.image));
  set(CHAFA_TERM_SEQ_END_KITTY_IMAGE, "\033_Gm=0\033\\");
  set(CHAFA_TERM_SEQ_BEGIN_KITTY_IMAGE_CHUNK, "\033_Gm=1;");
  set(CHAFA_TERM_SEQ_END_KITTY_IMAGE_CHUNK, "\033\\");
  set(CHAFA_TERM_SEQ_BEGIN_ITERM2_IMAGE, "\033]1337;File=inline=1;width=%1;height=%2;preserveAspectRatio=0:");
  set(CHAFA_TERM_SEQ_END_ITERM2_IMAGE, "\a");
  return info;
}

/// libchafa takes rows of whole words only.
std::vector<std::uint8_t> with_alpha(std::span<const std::uint8_t> rgb) {
  std::vector<std::uint8_t> rgba(rgb.size() / 3 * 4, 255);
  for (std::size_t k = 0; k < rgb.size() / 3; ++k)
    std::copy_n(rgb.begin() + 3 * static_cast<std::ptrdiff_t>(k), 3,
                rgba.begin() + 4 * static_cast<std::ptrdiff_t>(k));
  return rgba;
}

}  // namespace

bool canvas_bytes_there() { return true; }

std::string canvas_bytes(const ScreenPicture& picture, const CanvasKind& kind) {
  const Config config = config_of(picture, kind);
  const ChafaPicture canvas(chafa_canvas_new(config.get()));
  const std::vector<std::uint8_t> rgba = with_alpha(picture.rgb);
  chafa_canvas_draw_all_pixels(canvas.get(), CHAFA_PIXEL_RGBA8_UNASSOCIATED, rgba.data(), picture.width,
                               picture.height, 4 * picture.width);
  const Info info = info_of(kind);
  GString* text = chafa_canvas_print(canvas.get(), info.get());
  std::string bytes(text->str, text->len);
  g_string_free(text, TRUE);
  return bytes;
}

}  // namespace rift::studio

#include "studio/commands/graphics_options.hpp"

#include "studio/commands/common.hpp"

#include <CLI/CLI.hpp>
#include <fmt/format.h>

#include <cstdlib>

namespace rift::studio {

void add_graphics_options(CLI::App& command, GraphicsOptions& options) {
  const std::string group = "Terminal";
  command
      .add_option("--graphics", options.graphics,
                  "How pictures reach the terminal (default: $RIFT_GRAPHICS, or what the terminal answers)")
      ->type_name("NAME")
      ->check(CLI::IsMember({"auto", "kitty", "sixel", "iterm", "symbols", "cells"}))
      ->group(group);
  command
      .add_option("--bandwidth", options.bandwidth_kb,
                  "Most kilobytes of pictures a second (default: as fast as the terminal takes them)")
      ->check(CLI::Range(1.0, 1e9))
      ->group(group);
}

GraphicsWish graphics_wish(const std::string& command, const GraphicsOptions& options) {
  const char* variable = std::getenv("RIFT_GRAPHICS");
  const bool by_option = !options.graphics.empty();
  const std::string word = by_option ? options.graphics : variable == nullptr ? "" : variable;
  GraphicsWish wish{graphics_named(word), 1e3 * options.bandwidth_kb};
  if (word.empty() || word == "auto") return wish;
  const std::string named = by_option ? "--graphics " + word : "RIFT_GRAPHICS=" + word;
  if (!wish.asked)
    refuse(command, fmt::format("{}: must be auto, kitty, sixel, iterm, symbols or cells", named));
  if (*wish.asked != Graphics::cells && !PictureEncoder::there())
    refuse(command,
           fmt::format("{}: this rift was built without libchafa, and shows plates in cells; build it with "
                       "-DRIFT_TERMINAL_GRAPHICS=ON",
                       named));
  return wish;
}

}  // namespace rift::studio

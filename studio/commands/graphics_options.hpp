#pragma once

#include "studio/terminal/pictures.hpp"

#include <CLI/App.hpp>

#include <string>

namespace rift::studio {

/// How a terminal is given pictures, as options say it.
struct GraphicsOptions {
  std::string graphics;     // empty: as $RIFT_GRAPHICS says, or auto
  double bandwidth_kb = 0;  // kB/s; 0: what the terminal takes
};

void add_graphics_options(CLI::App& command, GraphicsOptions& options);

/// What the options and the environment ask for. Throws InputError where a word is wrong, or where this build
/// cannot do what was asked for by name.
[[nodiscard]] GraphicsWish graphics_wish(const std::string& command, const GraphicsOptions& options);

}  // namespace rift::studio

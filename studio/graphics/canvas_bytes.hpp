#pragma once

#include "studio/graphics/protocol.hpp"
#include "studio/screen/screen_picture.hpp"

#include <string>

namespace rift::studio {

// libchafa, nowhere else.

struct CanvasKind {
  Graphics graphics;
  const TerminalKind& terminal;
  int cell_width, cell_height;  // [px]
  int image;                    // kitty's number of it
};

/// Whether this build has libchafa.
[[nodiscard]] bool canvas_bytes_there();

/// The picture as control codes that begin at the cursor; symbols as a line for each row.
[[nodiscard]] std::string canvas_bytes(const ScreenPicture& picture, const CanvasKind& kind);

}  // namespace rift::studio

#include "studio/graphics/canvas_bytes.hpp"

/// What a build without libchafa (-DRIFT_TERMINAL_GRAPHICS=OFF) has in place of canvas_bytes.cpp.
namespace rift::studio {

bool canvas_bytes_there() { return false; }

std::string canvas_bytes(const ScreenPicture&, const CanvasKind&) { return {}; }

}  // namespace rift::studio

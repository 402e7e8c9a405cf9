#pragma once

#include "studio/workbench/plate_picture.hpp"

namespace rift::studio {

/// How panels make pictures of plates; empty in a build without the renderer.
[[nodiscard]] MakePlatePicture plate_pictures();

}  // namespace rift::studio

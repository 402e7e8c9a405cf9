#pragma once

#include "studio/workbench/plate_picture.hpp"

namespace rift::studio {

/// How panels make pictures of plates; empty in a build without the renderer.
/// @param programs  the folder of the programs that draw
[[nodiscard]] MakePlatePicture plate_pictures(const std::filesystem::path& programs);

}  // namespace rift::studio

#pragma once

#include "studio/workbench/plate_picture.hpp"

#include <filesystem>
#include <memory>

namespace rift::studio {

/// The plate of a run as `rift render` draws it, without its chart; drawn when nobody else wants the
/// processor.
/// @param programs  the folder of the programs that draw
[[nodiscard]] std::unique_ptr<PlatePicture> plate_of_run(const std::filesystem::path& run,
                                                         const std::filesystem::path& programs);

}  // namespace rift::studio

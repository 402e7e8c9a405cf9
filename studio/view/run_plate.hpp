#pragma once

#include "studio/workbench/plate_picture.hpp"

#include <filesystem>
#include <memory>
#include <vector>

namespace rift::studio {

/// The plates of runs as `rift render` draws them, without its chart; drawn when nobody else wants the
/// processor.
/// @param programs  the folder of the programs that draw
[[nodiscard]] std::unique_ptr<PlatePicture> plate_of_runs(const std::vector<std::filesystem::path>& runs,
                                                          const std::filesystem::path& programs);

}  // namespace rift::studio

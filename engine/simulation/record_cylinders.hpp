#pragma once

#include "engine/base/cache.hpp"
#include "engine/calibration/cylinders.hpp"
#include "engine/scene/preset.hpp"
#include "engine/simulation/record.hpp"

#include <filesystem>

namespace rift::simulation {

/// Presses the first packing of each size of the preset's [calibration] until it is 1 % shorter, and writes
/// the cylinders side by side into a run's folder, as one frame that `rift render` can draw.
/// @param[in] folder  made by create_run_folder()
void record_cylinders(const scene::Preset& preset, const std::filesystem::path& folder,
                      const BuildInfo& build, base::Cache& cache,
                      const base::ProgressCallback& progress = {});

}  // namespace rift::simulation

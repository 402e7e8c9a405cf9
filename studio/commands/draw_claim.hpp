#pragma once

#include "engine/base/cache.hpp"
#include "studio/reports/reproduction.hpp"

#include <filesystem>
#include <functional>

namespace rift::studio {

/// Draws a claim that is a picture: runs its preset in FOLDER/pictures/PRESET, where it is not there yet, and
/// puts the pictures beside the charts. A build without the renderer says so in the claim instead.
/// @param elements  of the plate, at most
/// @param go_on     told what is being done and how far it is; false throws Interrupted
void draw_claim(JudgedClaim& claim, const std::filesystem::path& folder, int elements, base::Cache& cache,
                int threads, const std::function<bool(std::string_view stage, double done)>& go_on);

}  // namespace rift::studio

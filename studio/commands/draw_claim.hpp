#pragma once

#include "studio/commands/session.hpp"
#include "studio/reports/reproduction.hpp"

#include <filesystem>

namespace rift::studio {

/// Draws a claim that is a picture: runs its preset in FOLDER/pictures/PRESET, where it is not there yet, and
/// puts the pictures beside the charts. A build without the renderer says so in the claim instead.
/// @param elements  of the plate, at most. Throws Interrupted.
void draw_claim(JudgedClaim& claim, const std::filesystem::path& folder, int elements, Session& session);

}  // namespace rift::studio

#pragma once

#include "studio/reports/reproduction.hpp"

#include <filesystem>
#include <vector>

namespace rift::studio {

/// Draws the figures of a finding beyond the paper; none where there is nothing to draw.
std::vector<Figure> draw_beyond(const claims::Claim& claim, const claims::Evidence& evidence,
                                const std::filesystem::path& folder);

}  // namespace rift::studio

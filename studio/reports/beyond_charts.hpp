#pragma once

#include "studio/reports/reproduction.hpp"

#include <filesystem>
#include <vector>

namespace rift::studio {

/// Draws the figures of a finding beyond the paper; none where there is nothing to draw.
std::vector<Figure> draw_beyond(const study::Claim& claim, const study::Evidence& evidence,
                                const std::filesystem::path& folder);

}  // namespace rift::studio

#pragma once

#include "studio/reports/reproduction.hpp"

#include <filesystem>
#include <vector>

namespace rift::studio {

/// Draws a claim's charts for one stiffness into `folder`, none where there is nothing to draw: ratio against
/// velocity with error bars over the specimens and Broberg's, Freund's and the strip's curves, ratio against
/// tip position of the first specimen, energies against time.
/// @param stiffness  "bulk" or "in-situ", in titles and file names
std::vector<Figure> draw_figures(const claims::Claim& claim, const claims::Evidence& evidence,
                                 const std::string& stiffness, const std::filesystem::path& folder);

/// The ratio of progressive and simple release against the velocity over the specimen's own Rayleigh speed;
/// none where there are no results.
/// @param nominal_over_own  c_r of the material over the measured c_R
std::vector<Figure> draw_against_own_speed(const claims::Evidence& evidence, const std::string& stiffness,
                                           double nominal_over_own, const std::filesystem::path& folder);

}  // namespace rift::studio

#pragma once

#include "engine/claims/claims.hpp"

#include <string>
#include <vector>

namespace rift::studio {

/// Where `rift reproduce` works by default.
inline constexpr const char* reproduction_folder = "reproduction";

/// Whether `rift reproduce` knows the name as one of claims: a claim's, "all", "beyond"; not "readings", which
/// judges them all.
bool is_claim_name(const std::string& name);

/// The claims of the names, in the table's order; for none or "all" all of the paper's, for "beyond" the
/// others. Throws InputError, with the nearest name, of an unknown one.
std::vector<const claims::Claim*> chosen_claims(const std::vector<std::string>& names);

/// The scenarios that these claims look at, as one study. Throws InputError with the mistakes of all presets.
claims::PaperStudy paper_study(const std::vector<const claims::Claim*>& chosen, claims::Effort effort);

/// The scene of a claim about cylinders as it is calibrated: what --quick leaves are two packings of the
/// cylinders below the size of the quick plate.
scene::Scene calibration_scene(const claims::Claim& claim, claims::Effort effort);

}  // namespace rift::studio

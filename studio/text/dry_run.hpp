#pragma once

#include "engine/simulation/prepare.hpp"

#include <nlohmann/json.hpp>

#include <string>
#include <utility>
#include <vector>

namespace rift::studio {

/// What follows from a prepared scene before it runs: derived numbers, the cost by the speed of this machine
/// now (which takes a third of a second to measure), and what is left out.
nlohmann::ordered_json dry_run(const simulation::Prepared& prepared, int threads);

/// The same as lines of a label (which may be empty) and a text.
std::vector<std::pair<std::string, std::string>> dry_run_rows(const nlohmann::ordered_json& numbers);

}  // namespace rift::studio

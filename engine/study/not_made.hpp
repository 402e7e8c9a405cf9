#pragma once

#include "engine/scene/preset.hpp"
#include "engine/study/plan.hpp"

#include <nlohmann/json.hpp>

#include <vector>

namespace rift::study {

/// Scenarios that could not be made, all for the same reason.
struct NotMade {
  std::vector<int> rows;  // of the study
  std::vector<scene::Issue> issues;
};

/// Adds scenarios, to those of which the same was found before.
void add_not_made(std::vector<NotMade>& all, const std::vector<StudyItem>& items,
                  const std::vector<scene::Issue>& issues);

/// {"rows": [0, 1], "axes": {name: [texts]}, "why": [lines]} of each.
nlohmann::ordered_json to_json(const std::vector<NotMade>& not_made, const scene::Preset& preset);

}  // namespace rift::study

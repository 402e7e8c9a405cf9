#pragma once

#include <string>
#include <vector>

namespace rift::scene {

/// In what two texts of presets differ, which may end with lines of a name and a value: "specimen.elements
/// was 3000, is now 5000", one for each; "crack.history differs" where both values are too long to be shown.
std::vector<std::string> text_differences(const std::string& before, const std::string& now);

/// The first four of them as the end of a message, ": specimen.elements was 3000, is now 5000; and 2 more";
/// empty where there is none.
std::string differences_text(const std::string& before, const std::string& now);

}  // namespace rift::scene

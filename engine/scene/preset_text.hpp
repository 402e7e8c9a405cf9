#pragma once

#include <string>

namespace rift::scene {

/// The reference page docs/parameters.md, made from the parameter table; a test keeps the file equal to it.
std::string parameters_markdown();

}  // namespace rift::scene

#pragma once

#include <string>

namespace rift::simulation {

/// Which program made a result.
struct BuildInfo {
  std::string version;  // "0.1.0"
  std::string compiler;
};

}  // namespace rift::simulation

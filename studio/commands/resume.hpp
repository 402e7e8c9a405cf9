#pragma once

#include "studio/commands/common.hpp"

#include <string>

namespace rift::studio {

/// What `rift resume` is asked for.
struct ResumeOptions {
  std::string run, color, budget;
  int threads = 0;
  bool quiet = false, json = false, plain = false, no_cache = false;
};

/// Goes on with the run in a folder, as `rift resume` does. Throws InputError and WorldError.
ExitCode resume(const ResumeOptions& options);

}  // namespace rift::studio

#pragma once

#include "engine/simulation/march.hpp"

#include <filesystem>
#include <optional>
#include <string>

namespace rift::simulation {

/// Where a march that is not recorded as a run keeps how far it is: a pass of a study, a specimen of an
/// experiment.
struct MarchKeeping {
  std::filesystem::path folder;
  std::string identity;    // of all that the march depends on
  bool result_too = true;  // what it came to is kept as well, so that the next call finds it
  double taken_before_s =
      0;  // by the same work, before this march goes on: the checkpoint's taken_s() counts it
};

/// Where the march that the folder keeps goes on, or what it came to; none where there is no march of this
/// identity.
/// @param[out] note  why what is kept is of no use, such as its damage; may be empty
std::optional<Resumption> kept_march(const MarchKeeping& keeping, std::string& note);

/// As march(), with a checkpoint in the folder every options.checkpoint_s seconds, at a stop and, where the
/// result is kept too, at the end. Where `from` is of another march, the march begins anew. Throws WorldError
/// where the folder cannot be written, otherwise as march().
/// @param[in] from   what kept_march() has found; null to begin at the beginning
/// @param[out] note  why `from` was of no use
RunResult march_and_keep(const Prepared& prepared, const Observer& observer, const MarchOptions& options,
                         const MarchKeeping& keeping, const Resumption* from, std::string& note);

/// The identity of the march that the folder keeps; empty where it keeps none that is whole.
std::string kept_identity(const std::filesystem::path& folder);

/// Removes what is kept, and the folder.
void forget_march(const std::filesystem::path& folder);

}  // namespace rift::simulation

#pragma once

#include "engine/scene/preset.hpp"
#include "studio/commands/session.hpp"

#include <filesystem>
#include <string>

namespace rift::studio {

/// What `rift study` takes.
struct StudyCommand : SceneOptions {
  std::string out, shard, budget;
  bool yes = false;
  bool claim = false, prepare = false, gather = false, status = false;
  int tasks = 0;  // 0: not said
  bool slurm = false, dry_run = false;
  std::string time = "01:00:00", partition, sbatch;
};

/// Prints how far the study in the folder is, and what Slurm says of its jobs.
ExitCode print_status(const StudyCommand& command, const std::filesystem::path& folder);

/// Hands a study to Slurm: jobs that prepare, compute and report; only what is missing.
ExitCode submit_study(const StudyCommand& command, const scene::Preset& preset,
                      const std::filesystem::path& folder);

}  // namespace rift::studio

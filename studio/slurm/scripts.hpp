#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace rift::studio {

/// A study for Slurm: three jobs, one after the other.
struct SlurmStudy {
  std::vector<std::string> command;  // "rift", "study", the preset and its overrides
  std::string name;                  // of the study, in the jobs' names
  std::filesystem::path folder;      // of the study
  int tasks = 1;
  double limit_s = 0;            // of each job, by Slurm
  std::string partition, extra;  // of sbatch; empty for Slurm's own choice
  std::string instruction_set;   // of all nodes
};

/// How long before Slurm's limit a job stops by itself and is put into the queue again [s].
inline constexpr double time_to_stop_s = 90;

/// "#!/bin/bash" to the last line: packs and pre-stresses each specimen; computes scenarios, as an array;
/// computes what is left and writes the report.
std::string preparation_script(const SlurmStudy& study);
std::string tasks_script(const SlurmStudy& study);
std::string report_script(const SlurmStudy& study);

/// The limit as sbatch takes it, "1-02:30:00".
std::string slurm_time(double seconds);

}  // namespace rift::studio

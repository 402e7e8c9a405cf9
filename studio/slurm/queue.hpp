#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

namespace rift::studio {

// Slurm's own commands: sbatch, squeue, scontrol, sacct and sinfo.

/// Hands in a script. @param dependency  "afterok:12", or empty. @return the job's number
/// Throws WorldError with what Slurm said.
std::string submit_job(const std::filesystem::path& script, const std::string& dependency);

/// A job, or tasks of an array, of one state.
struct JobState {
  std::string job;     // its number, "12"
  std::string state;   // as Slurm has it: "RUNNING", "PENDING", "FAILED"
  std::string reason;  // why it waits; empty where Slurm says none
  int tasks = 1;       // of an array in this state
};

/// What Slurm's queue says of these jobs; those that have ended are not in it. Throws WorldError.
std::vector<JobState> jobs_in_queue(const std::vector<std::string>& jobs);

/// How jobs that have ended did, by the accounting where there is one, else by what Slurm still remembers.
std::vector<JobState> ended_jobs(const std::vector<std::string>& jobs);

/// Of the features that a partition's nodes name, the lowest instruction set; none where a node names none.
/// @param partition  empty for all. Throws InputError where there is no such partition.
std::optional<std::string> lowest_instruction_set(const std::string& partition);

}  // namespace rift::studio

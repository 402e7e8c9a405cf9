#pragma once

#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>

/// What this process may use of the machine: a batch system, a container or `taskset` may give it less than
/// there is.
namespace rift::base {

/// CPUs that the quotas of the process's control groups pay for; none where nothing limits them.
/// @param root  the folder that holds proc/self/cgroup and sys/fs/cgroup
std::optional<double> cpu_quota(const std::filesystem::path& root = "/");

/// CPUs that the process may run on: those of its affinity, at most as many as the quotas of its control
/// groups (versions 1 and 2) pay for, rounded up; at least 1.
/// @param root  as above
int available_cpus(const std::filesystem::path& root = "/");

/// The user's number of threads where it is above 0, else one for each available CPU.
int threads_or_all_cpus(int threads);

/// Memory that the process may use [bytes]: the machine's, at most what its control groups and `ulimit -v`
/// allow.
/// @param root  as above
std::uint64_t available_memory_bytes(const std::filesystem::path& root = "/");

/// The model of the processor as the system names it, "AMD EPYC"; empty where it does not.
/// @param root  as above
std::string processor_text(const std::filesystem::path& root = "/");

/// The machine in words: "node12, Intel(R) Xeon(R) CPU @ 2.20GHz, 2 CPUs".
/// @param root  as above
std::string machine_text(const std::filesystem::path& root = "/");

}  // namespace rift::base

#include "engine/base/process_limits.hpp"

#include <sched.h>
#include <sys/resource.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <fstream>
#include <optional>
#include <sstream>
#include <string>
#include <string_view>
#include <vector>

namespace rift::base {
namespace {

namespace fs = std::filesystem;

/// A line of /proc/self/cgroup: "4:cpu,cpuacct:/a/b", or "0::/a/b" of version 2.
struct ControlGroup {
  std::string controllers;
  fs::path path;
};

std::vector<ControlGroup> control_groups(const fs::path& root) {
  std::ifstream file(root / "proc/self/cgroup");
  std::vector<ControlGroup> groups;
  for (std::string line; std::getline(file, line);) {
    const std::size_t first = line.find(':'), second = line.find(':', first + 1);
    if (second == std::string::npos) continue;
    groups.push_back({line.substr(first + 1, second - first - 1), line.substr(second + 1)});
  }
  return groups;
}

bool names_controller(const std::string& controllers, std::string_view controller) {
  std::istringstream list(controllers);
  for (std::string name; std::getline(list, name, ',');)
    if (name == controller) return true;
  return false;
}

/// The folders in which limits of a controller may stand: the process's group and all above it. A container
/// may show its group as the topmost one, so that folders of the path need not exist.
std::vector<fs::path> limit_folders(const fs::path& root, std::string_view controller) {
  const fs::path mounted = root / "sys/fs/cgroup";
  std::vector<fs::path> folders;
  for (const ControlGroup& group : control_groups(root)) {
    std::vector<fs::path> mounts;
    if (group.controllers.empty())
      mounts = {mounted, mounted / "unified"};
    else if (names_controller(group.controllers, controller))
      mounts = {mounted / group.controllers, mounted / controller};
    for (const fs::path& mount : mounts)
      for (fs::path at = (fs::path("/") / group.path).lexically_normal();; at = at.parent_path()) {
        folders.push_back(mount / at.relative_path());
        if (!at.has_relative_path()) break;
      }
  }
  return folders;
}

std::string first_line(const fs::path& path) {
  std::ifstream file(path);
  std::string line;
  std::getline(file, line);
  return line;
}

/// The numbers of a file such as cpu.max ("200000 100000"), none where it is absent or says "max".
std::vector<double> limit_numbers(const fs::path& path) {
  std::istringstream text(first_line(path));
  std::vector<double> numbers;
  for (double number = 0.0; text >> number;) numbers.push_back(number);
  return numbers;
}

int cpus_of_affinity() {
  for (int most = 1024; most <= 1 << 20; most *= 2) {
    cpu_set_t* const set = CPU_ALLOC(most);
    const std::size_t bytes = CPU_ALLOC_SIZE(most);
    const bool known = sched_getaffinity(0, bytes, set) == 0;
    const int count = known ? CPU_COUNT_S(bytes, set) : 0;
    CPU_FREE(set);
    if (known) return std::max(1, count);  // else the machine may have more CPUs than the set holds
  }
  return 1;
}

}  // namespace

std::optional<double> cpu_quota(const fs::path& root) {
  std::optional<double> least;
  const auto limit = [&](double quota, double period) {
    if (quota > 0.0 && period > 0.0) least = std::min(least.value_or(quota / period), quota / period);
  };
  for (const fs::path& folder : limit_folders(root, "cpu")) {
    if (const auto both = limit_numbers(folder / "cpu.max"); both.size() == 2) limit(both[0], both[1]);
    const auto quota = limit_numbers(folder / "cpu.cfs_quota_us"),
               period = limit_numbers(folder / "cpu.cfs_period_us");
    if (quota.size() == 1 && period.size() == 1) limit(quota[0], period[0]);  // a quota of -1 is none
  }
  return least;
}

int available_cpus(const fs::path& root) {
  const int cpus = cpus_of_affinity();
  const std::optional<double> quota = cpu_quota(root);
  return quota && *quota < cpus ? std::max(1, static_cast<int>(std::ceil(*quota))) : cpus;
}

int threads_or_all_cpus(int threads) { return threads > 0 ? threads : available_cpus(); }

std::uint64_t available_memory_bytes(const fs::path& root) {
  double least = static_cast<double>(sysconf(_SC_PHYS_PAGES)) * static_cast<double>(sysconf(_SC_PAGESIZE));
  for (const fs::path& folder : limit_folders(root, "memory"))
    for (const char* file : {"memory.max", "memory.limit_in_bytes"})
      if (const auto limit = limit_numbers(folder / file); limit.size() == 1 && limit[0] > 0.0)
        least = std::min(least, limit[0]);
  rlimit address_space{};
  if (getrlimit(RLIMIT_AS, &address_space) == 0 && address_space.rlim_cur != RLIM_INFINITY)
    least = std::min(least, static_cast<double>(address_space.rlim_cur));
  return static_cast<std::uint64_t>(least);
}

std::string processor_text(const fs::path& root) {
  std::ifstream processors(root / "proc/cpuinfo");
  for (std::string line; std::getline(processors, line);)
    if (line.starts_with("model name")) return line.substr(std::min(line.size(), line.find(':') + 2));
  return "";
}

std::string machine_text(const fs::path& root) {
  std::array<char, 256> host{};
  std::string text = gethostname(host.data(), host.size() - 1) == 0 ? host.data() : "";
  const std::string processor = processor_text(root);
  if (!processor.empty()) text += (text.empty() ? "" : ", ") + processor;
  const int cpus = available_cpus(root);
  return text + (text.empty() ? "" : ", ") + std::to_string(cpus) + (cpus == 1 ? " CPU" : " CPUs");
}

}  // namespace rift::base

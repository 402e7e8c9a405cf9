#include "engine/base/process_limits.hpp"

#include "engine/base/thread_pool.hpp"
#include "tests/temporary_folder.hpp"

#include <gtest/gtest.h>
#include <sched.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <atomic>
#include <chrono>
#include <functional>
#include <set>
#include <string>
#include <thread>
#include <vector>

namespace rift::base {
namespace {

namespace fs = std::filesystem;

/// A folder that stands for "/": what /proc/self/cgroup says, and files below /sys/fs/cgroup.
struct FakeRoot {
  TemporaryFolder folder;
  explicit FakeRoot(const std::string& groups) {
    fs::create_directories(folder.path() / "proc/self");
    write_text(folder.path() / "proc/self/cgroup", groups);
  }
  void limit(const std::string& file, const std::string& text) const {
    const fs::path path = folder.path() / "sys/fs/cgroup" / file;
    fs::create_directories(path.parent_path());
    write_text(path, text + "\n");
  }
  const fs::path& path() const { return folder.path(); }
};

/// What `value` is in a child process that `change` has changed first.
int in_a_child(const std::function<void()>& change, const std::function<int()>& value) {
  const pid_t child = fork();
  if (child == 0) {
    change();
    _exit(value());
  }
  int status = 0;
  waitpid(child, &status, 0);
  return WIFEXITED(status) ? WEXITSTATUS(status) : -1;
}

void keep_one_cpu() {
  cpu_set_t set;
  sched_getaffinity(0, sizeof set, &set);
  bool kept = false;
  for (int cpu = 0; cpu < CPU_SETSIZE; ++cpu) {
    if (kept) CPU_CLR(cpu, &set);
    kept = kept || CPU_ISSET(cpu, &set);
  }
  sched_setaffinity(0, sizeof set, &set);
}

TEST(ProcessLimits, CpusAreThoseOfTheAffinity) {
  const FakeRoot free("0::/\n");
  EXPECT_EQ(in_a_child(keep_one_cpu, [&] { return available_cpus(free.path()); }), 1);
  cpu_set_t set;
  ASSERT_EQ(sched_getaffinity(0, sizeof set, &set), 0);
  EXPECT_EQ(available_cpus(free.path()), CPU_COUNT(&set));
}

TEST(ProcessLimits, AQuotaOfTheGroupOrOfOneAboveItLimitsTheCpus) {
  const FakeRoot two("0::/job_7/step_0\n");  // version 2
  two.limit("job_7/step_0/cpu.max", "max 100000");
  EXPECT_FALSE(cpu_quota(two.path()));
  two.limit("job_7/cpu.max", "50000 100000");
  EXPECT_DOUBLE_EQ(cpu_quota(two.path()).value(), 0.5);
  EXPECT_EQ(available_cpus(two.path()), 1);  // rounded up

  const FakeRoot one("5:memory:/elsewhere\n4:cpu,cpuacct:/job_7\n0::/\n");  // version 1
  one.limit("cpu,cpuacct/job_7/cpu.cfs_period_us", "100000");
  one.limit("cpu,cpuacct/job_7/cpu.cfs_quota_us", "-1");
  EXPECT_FALSE(cpu_quota(one.path()));
  one.limit("cpu,cpuacct/job_7/cpu.cfs_quota_us", "150000");
  EXPECT_DOUBLE_EQ(cpu_quota(one.path()).value(), 1.5);
}

TEST(ProcessLimits, AContainerThatShowsItsGroupAsTheTopmostIsUnderstood) {
  const FakeRoot root("4:cpu:/docker/0123\n3:memory:/docker/0123\n");  // which is not below the mount
  root.limit("cpu/cpu.cfs_period_us", "100000");
  root.limit("cpu/cpu.cfs_quota_us", "25000");
  root.limit("memory/memory.limit_in_bytes", "1048576");
  EXPECT_DOUBLE_EQ(cpu_quota(root.path()).value(), 0.25);
  EXPECT_EQ(available_memory_bytes(root.path()), 1048576U);
}

TEST(ProcessLimits, MemoryIsTheLeastOfTheLimits) {
  const FakeRoot free("0::/job\n");
  const std::uint64_t all = available_memory_bytes(free.path());
  EXPECT_GT(all, std::uint64_t{64} << 20);
  free.limit("job/memory.max", "max");
  EXPECT_EQ(available_memory_bytes(free.path()), all);
  free.limit("job/memory.max", std::to_string(64 << 20));
  EXPECT_EQ(available_memory_bytes(free.path()), std::uint64_t{64} << 20);
  const FakeRoot old("4:memory:/job\n");
  old.limit("memory/job/memory.limit_in_bytes", "9223372036854771712");  // which is none
  EXPECT_EQ(available_memory_bytes(old.path()), all);
#ifndef __SANITIZE_ADDRESS__  // whose shadow needs more address space than any limit
  const auto limit = [] {
    const rlimit few{rlim_t{16} << 30, rlim_t{16} << 30};
    setrlimit(RLIMIT_AS, &few);
  };
  EXPECT_LE(in_a_child(limit, [&] { return static_cast<int>(available_memory_bytes(free.path()) >> 30); }),
            16);
#endif
}

TEST(ThreadPool, OfMoreThreadsThanCpusDoesEveryTaskOnce) {
  for (int round = 0; round < 2; ++round) {
    ThreadPool pool(9, 100);
    std::vector<int> done(100);
    for (int k = 0; k < 50; ++k) pool.run(100, [&](int task) { ++done[task]; });
    EXPECT_EQ(std::set<int>(done.begin(), done.end()), std::set<int>{50});
  }
}

// Of the helper's two tasks the first waits for the second: the caller, who has done its own, must take that.
TEST(ThreadPool, TheCallerDoesWhatAHelperHasNotBegun) {
  if (available_cpus() < 2) return;  // no helper then
  using Clock = std::chrono::steady_clock;
  ThreadPool pool(2, 4);
  for (int k = 0; k < 20; ++k) {
    std::atomic<bool> last_done = false;
    std::atomic<int> waited_in_vain = 0;
    pool.run(4, [&](int task) {
      const auto start = Clock::now();
      while (task == 2 && !last_done && Clock::now() - start < std::chrono::seconds(5)) {
      }
      if (task == 2 && !last_done) ++waited_in_vain;
      if (task == 3) last_done = true;
    });
    ASSERT_EQ(waited_in_vain, 0);
  }
}

TEST(ThreadPool, DoesEveryTaskOnceWhateverTheirNumber) {
  ThreadPool pool(4, 100);
  for (const int tasks : {0, 1, 2, 3, 5, 31, 33, 1000})
    for (int k = 0; k < 200; ++k) {
      std::vector<int> done(tasks);
      pool.run(tasks, [&](int task) { ++done[task]; });
      ASSERT_EQ(std::count(done.begin(), done.end(), 1), tasks);
    }
}

/// Processor time of the process so far [s].
double processor_time() {
  rusage usage{};
  getrusage(RUSAGE_SELF, &usage);
  return static_cast<double>(usage.ru_utime.tv_sec) + 1e-6 * static_cast<double>(usage.ru_utime.tv_usec);
}

TEST(ThreadPool, ThreadsThatShareACpuDoNotLookForWorkWhileOneOfThemWorks) {
  // 15 helpers that each look 2,000 times a round, some 50 us, would take 400 x 15 x 50 us = 300 ms; asleep,
  // they take no time of the user's but for some calls a round.
  const auto used = [] {
    ThreadPool pool(16, 16);
    const double before = processor_time();
    for (int k = 0; k < 400; ++k) pool.run(16, [](int) {});
    return std::min(200, static_cast<int>(1e3 * (processor_time() - before)));  // [ms]
  };
  EXPECT_LT(in_a_child(keep_one_cpu, used), 100);
}

}  // namespace
}  // namespace rift::base

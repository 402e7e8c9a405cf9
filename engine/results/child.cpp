#include "engine/results/child.hpp"

#include <fmt/format.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <csignal>
#include <cstring>
#include <exception>
#include <fstream>

namespace rift::results {
namespace {

constexpr rlim_t more_memory = rlim_t{4} << 30;
constexpr int threw = 9;  // exit code: the text is what an exception said

rlim_t memory_now() {
  std::ifstream statm("/proc/self/statm");
  rlim_t pages = 0;
  statm >> pages;
  return pages * static_cast<rlim_t>(sysconf(_SC_PAGESIZE));
}

void write_all(int descriptor, const std::string& text) {
  std::size_t done = 0;
  while (done < text.size()) {
    const ssize_t count = ::write(descriptor, text.data() + done, text.size() - done);
    if (count > 0) done += static_cast<std::size_t>(count);
    if (count < 0 && errno != EINTR) return;
  }
}

/// Signals do again what they do by default, but for those that are ignored: what handles them is of the
/// parent.
void forget_handlers() {
  for (int number = 1; number < NSIG; ++number) {
    struct sigaction now {};
    if (sigaction(number, nullptr, &now) == 0 && now.sa_handler != SIG_IGN && now.sa_handler != SIG_DFL)
      std::signal(number, SIG_DFL);
  }
  std::signal(SIGALRM, SIG_DFL);
}

[[noreturn]] void be_the_child(const std::function<std::string()>& work, unsigned seconds, int out) {
  forget_handlers();
  const rlimit memory{memory_now() + more_memory, memory_now() + more_memory}, no_core{0, 0};
  (void)setrlimit(RLIMIT_AS, &memory);
  (void)setrlimit(RLIMIT_CORE, &no_core);
  alarm(seconds);
  int code = 0;
  try {
    write_all(out, work());
  } catch (const std::exception& error) {
    write_all(out, error.what());
    code = threw;
  }
  _exit(code);
}

std::string read_all(int descriptor) {
  std::string text;
  std::array<char, 65536> buffer;
  for (;;) {
    const ssize_t count = ::read(descriptor, buffer.data(), buffer.size());
    if (count > 0) text.append(buffer.data(), static_cast<std::size_t>(count));
    if (count == 0 || (count < 0 && errno != EINTR)) return text;
  }
}

}  // namespace

Told told_by_child(const std::function<std::string()>& work, unsigned seconds) {
  std::array<int, 2> pipe{};
  if (::pipe(pipe.data()) != 0) return {{}, std::strerror(errno)};
  const pid_t child = fork();
  if (child < 0) return {{}, std::strerror(errno)};
  if (child == 0) {
    ::close(pipe[0]);
    be_the_child(work, seconds, pipe[1]);
  }
  ::close(pipe[1]);
  std::string text = read_all(pipe[0]);
  ::close(pipe[0]);
  int status = 0;
  while (waitpid(child, &status, 0) < 0 && errno == EINTR) {
  }
  if (WIFEXITED(status) && WEXITSTATUS(status) == 0) return {std::move(text), {}};
  if (WIFEXITED(status) && WEXITSTATUS(status) == threw) return {{}, std::move(text)};
  if (WIFSIGNALED(status) && WTERMSIG(status) == SIGALRM)
    return {{}, fmt::format("it did not come to an end in {} s", seconds)};
  if (WIFSIGNALED(status)) return {{}, fmt::format("it died of signal {}", WTERMSIG(status))};
  return {{}, fmt::format("it ended with code {}", WEXITSTATUS(status))};
}

}  // namespace rift::results

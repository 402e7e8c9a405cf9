#include "engine/base/child_process.hpp"

#include <fcntl.h>
#include <fmt/format.h>
#include <sched.h>
#include <signal.h>
#include <spawn.h>
#include <sys/mman.h>
#include <sys/resource.h>
#include <sys/socket.h>
#include <sys/stat.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <cstring>
#include <exception>
#include <fstream>
#include <limits>
#include <system_error>
#include <thread>

namespace rift::base {
namespace {

void close_if_open(int& descriptor) {
  if (descriptor >= 0) ::close(descriptor);
  descriptor = -1;
}

int status_at_end(pid_t child) {
  int status = 0;
  while (waitpid(child, &status, 0) < 0 && errno == EINTR) {
  }
  return status;
}

/// Signals as a program expects them, in a group of its own.
struct Attributes {
  posix_spawnattr_t value;
  Attributes() {
    posix_spawnattr_init(&value);
    sigset_t none, all;
    sigemptyset(&none);
    sigfillset(&all);
    posix_spawnattr_setsigmask(&value, &none);
    posix_spawnattr_setsigdefault(&value, &all);
    posix_spawnattr_setpgroup(&value, 0);
    posix_spawnattr_setflags(&value, POSIX_SPAWN_SETSIGMASK | POSIX_SPAWN_SETSIGDEF | POSIX_SPAWN_SETPGROUP);
  }
  ~Attributes() { posix_spawnattr_destroy(&value); }
};

constexpr int first_shared = STDERR_FILENO + 1;

/// What becomes its standard input, output and error and what it shares, all else being closed; and its
/// folder.
struct FileActions {
  posix_spawn_file_actions_t value;
  FileActions(int in, int out, int error, int shared, const std::filesystem::path& folder) {
    posix_spawn_file_actions_init(&value);
    if (in < 0)
      posix_spawn_file_actions_addopen(&value, STDIN_FILENO, "/dev/null", O_RDONLY, 0);
    else
      posix_spawn_file_actions_adddup2(&value, in, STDIN_FILENO);
    posix_spawn_file_actions_adddup2(&value, out, STDOUT_FILENO);
    posix_spawn_file_actions_adddup2(&value, error, STDERR_FILENO);
    if (shared >= 0) posix_spawn_file_actions_adddup2(&value, shared, first_shared);
    posix_spawn_file_actions_addclosefrom_np(&value, shared >= 0 ? first_shared + 1 : first_shared);
    if (!folder.empty()) posix_spawn_file_actions_addchdir_np(&value, folder.c_str());
  }
  ~FileActions() { posix_spawn_file_actions_destroy(&value); }
};

/// The last line that is not empty.
std::string last_line(const std::string& text) {
  const std::size_t end = text.find_last_not_of("\n\r ");
  if (end == std::string::npos) return {};
  const std::size_t before = text.find_last_of("\n\r", end);
  const std::size_t start = before == std::string::npos ? 0 : before + 1;
  return text.substr(start, end + 1 - start);
}

/// The last bytes of a file in memory, so many at most.
std::string end_of_file(int descriptor, off_t most) {
  struct stat file {};
  if (fstat(descriptor, &file) != 0) return "";
  std::string text(static_cast<std::size_t>(std::min(file.st_size, most)), '\0');
  if (pread(descriptor, text.data(), text.size(), std::max<off_t>(0, file.st_size - most)) < 0) return "";
  return text;
}

}  // namespace

StartError::StartError(const std::string& program, int why)
    : WorldError("start", program, reason_of(why)), error(why) {}

ChildProcess::ChildProcess(std::vector<std::string> command, const ChildOptions& options)
    : outlives_(options.outlives) {
  // A socket and not a pipe for its input, so that writing to a program that has ended is an error and not a
  // signal.
  std::array<int, 2> in{-1, -1}, out{-1, -1};
  errors_ = memfd_create("errors", MFD_CLOEXEC);
  int error = errors_ < 0 ? errno : 0;
  if (error == 0 && options.piped &&
      (socketpair(AF_UNIX, SOCK_STREAM | SOCK_CLOEXEC, 0, in.data()) != 0 ||
       pipe2(out.data(), O_CLOEXEC) != 0))
    error = errno;
  input_ = in[0];
  output_ = out[0];
  if (error == 0) {
    std::vector<char*> arguments;
    for (std::string& argument : command) arguments.push_back(argument.data());
    arguments.push_back(nullptr);
    const Attributes attributes;
    const FileActions actions(in[1], options.piped ? out[1] : errors_, errors_, options.shared,
                              options.folder);
    error = posix_spawnp(&pid_, arguments[0], &actions.value, &attributes.value, arguments.data(), environ);
  }
  close_if_open(in[1]);
  close_if_open(out[1]);
  if (error != 0) {
    for (int* descriptor : {&input_, &output_, &errors_}) close_if_open(*descriptor);
    throw StartError(command.front(), error);
  }
  const sched_param lowest{};
  if (options.idle) sched_setscheduler(pid_, SCHED_IDLE, &lowest);
}

ChildProcess::~ChildProcess() {
  if (!end_ && outlives_ && !has_ended()) {
    std::thread([pid = pid_] { status_at_end(pid); }).detach();
  } else if (!end_) {
    kill(pid_, SIGKILL);
    wait();
  }
  for (int* descriptor : {&input_, &output_, &errors_}) close_if_open(*descriptor);
}

bool ChildProcess::write(std::span<const std::uint8_t> bytes) {
  while (!bytes.empty()) {
    const ssize_t sent = send(input_, bytes.data(), bytes.size(), MSG_NOSIGNAL);
    if (sent < 0 && errno == EINTR) continue;
    if (sent < 0) return false;
    bytes = bytes.subspan(static_cast<std::size_t>(sent));
  }
  return true;
}

std::size_t ChildProcess::read(std::span<std::uint8_t> bytes) {
  std::size_t got = 0;
  while (got < bytes.size()) {
    const ssize_t more = ::read(output_, bytes.data() + got, bytes.size() - got);
    if (more < 0 && errno == EINTR) continue;
    if (more <= 0) break;
    got += static_cast<std::size_t>(more);
  }
  return got;
}

void ChildProcess::close_input() { close_if_open(input_); }

const ChildProcess::End& ChildProcess::wait() {
  if (end_) return *end_;
  close_input();
  note_end(status_at_end(pid_));
  return *end_;
}

bool ChildProcess::has_ended() {
  int status = 0;
  if (!end_ && waitpid(pid_, &status, WNOHANG) != 0) note_end(status);
  return end_.has_value();
}

void ChildProcess::note_end(int status) {
  End end;
  if (WIFSIGNALED(status)) {
    end.signal = WTERMSIG(status);
    end.code = 128 + end.signal;
    end.text = fmt::format("was killed by signal {} ({})", end.signal, strsignal(end.signal));
  } else {
    end.code = WEXITSTATUS(status);
    end.text = fmt::format("ended with code {}", end.code);
  }
  end.words = last_line(said());
  if (!end.words.empty()) end.text += ": " + end.words;
  end_ = std::move(end);
}

std::string ChildProcess::said() const { return end_of_file(errors_, 65536); }

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
      ::signal(number, SIG_DFL);
  }
  ::signal(SIGALRM, SIG_DFL);
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

}  // namespace

SandboxResult run_in_sandbox(const std::function<std::string()>& work, unsigned seconds) {
  const int out = memfd_create("result", MFD_CLOEXEC);
  const pid_t child = out < 0 ? -1 : fork();
  if (child == 0) be_the_child(work, seconds, out);
  const int error = errno, status = child < 0 ? 0 : status_at_end(child);
  std::string text = end_of_file(out, std::numeric_limits<off_t>::max());
  if (out >= 0) ::close(out);
  if (child < 0) return {{}, std::strerror(error)};
  if (WIFEXITED(status) && WEXITSTATUS(status) == 0) return {std::move(text), {}};
  if (WIFEXITED(status) && WEXITSTATUS(status) == threw) return {{}, std::move(text)};
  if (WIFSIGNALED(status) && WTERMSIG(status) == SIGALRM)
    return {{}, fmt::format("it did not end within {} s", seconds)};
  if (WIFSIGNALED(status)) return {{}, fmt::format("it was killed by signal {}", WTERMSIG(status))};
  return {{}, fmt::format("it ended with code {}", WEXITSTATUS(status))};
}

}  // namespace rift::base

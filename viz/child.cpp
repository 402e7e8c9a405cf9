#include "viz/child.hpp"

#include "engine/base/world_error.hpp"

#include <fcntl.h>
#include <fmt/format.h>
#include <sched.h>
#include <signal.h>
#include <spawn.h>
#include <sys/mman.h>
#include <sys/socket.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <system_error>

namespace rift::viz {
namespace {

std::string error_text(int error) { return std::generic_category().message(error); }

void close_if_open(int& descriptor) {
  if (descriptor >= 0) ::close(descriptor);
  descriptor = -1;
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

/// What becomes its standard input, output and error.
struct Descriptors {
  posix_spawn_file_actions_t value;
  Descriptors(int in, int out, int error) {
    posix_spawn_file_actions_init(&value);
    posix_spawn_file_actions_adddup2(&value, in, 0);
    posix_spawn_file_actions_adddup2(&value, out, 1);
    posix_spawn_file_actions_adddup2(&value, error, 2);
  }
  ~Descriptors() { posix_spawn_file_actions_destroy(&value); }
};

}  // namespace

Child::Child(std::vector<std::string> command, bool idle) : name_(command.front()) {
  // A socket and not a pipe for its input, so that writing to a program that has ended is an error and not a
  // signal.
  std::array<int, 2> in{-1, -1}, out{-1, -1};
  errors_ = memfd_create("errors", MFD_CLOEXEC);
  if (errors_ < 0 || socketpair(AF_UNIX, SOCK_STREAM | SOCK_CLOEXEC, 0, in.data()) != 0 ||
      pipe2(out.data(), O_CLOEXEC) != 0)
    throw base::WorldError("start", name_, error_text(errno));
  input_ = in[0];
  output_ = out[0];
  std::vector<char*> arguments;
  for (std::string& argument : command) arguments.push_back(argument.data());
  arguments.push_back(nullptr);
  const Attributes attributes;
  const Descriptors descriptors(in[1], out[1], errors_);
  const int error =
      posix_spawnp(&pid_, name_.c_str(), &descriptors.value, &attributes.value, arguments.data(), environ);
  ::close(in[1]);
  ::close(out[1]);
  if (error != 0) {
    for (int* descriptor : {&input_, &output_, &errors_}) close_if_open(*descriptor);
    throw base::WorldError("start", name_, error_text(error));
  }
  const sched_param lowest{};
  if (idle) sched_setscheduler(pid_, SCHED_IDLE, &lowest);
}

Child::~Child() {
  if (!ended_) kill(pid_, SIGKILL);
  wait();
  for (int* descriptor : {&input_, &output_, &errors_}) close_if_open(*descriptor);
}

bool Child::write(std::span<const std::uint8_t> bytes) {
  while (!bytes.empty()) {
    const ssize_t sent = send(input_, bytes.data(), bytes.size(), MSG_NOSIGNAL);
    if (sent < 0 && errno == EINTR) continue;
    if (sent < 0) return false;
    bytes = bytes.subspan(static_cast<std::size_t>(sent));
  }
  return true;
}

std::size_t Child::read(std::span<std::uint8_t> bytes) {
  std::size_t got = 0;
  while (got < bytes.size()) {
    const ssize_t more = ::read(output_, bytes.data() + got, bytes.size() - got);
    if (more < 0 && errno == EINTR) continue;
    if (more <= 0) break;
    got += static_cast<std::size_t>(more);
  }
  return got;
}

void Child::close_input() { close_if_open(input_); }

const Child::End& Child::wait() {
  if (ended_) return end_;
  close_input();
  int status = 0;
  while (waitpid(pid_, &status, 0) < 0 && errno == EINTR) {
  }
  ended_ = true;
  if (WIFSIGNALED(status)) {
    end_.code = 128 + WTERMSIG(status);
    end_.text = fmt::format("was killed by signal {} ({})", WTERMSIG(status), strsignal(WTERMSIG(status)));
  } else {
    end_.code = WEXITSTATUS(status);
    end_.text = fmt::format("ended with code {}", end_.code);
  }
  end_.words = last_words();
  if (!end_.words.empty()) end_.text += ": " + end_.words;
  return end_;
}

/// The last line that it wrote to its standard error.
std::string Child::last_words() const {
  constexpr off_t enough = 4096;
  const off_t size = lseek(errors_, 0, SEEK_END);
  std::string text(static_cast<std::size_t>(std::clamp<off_t>(size, 0, enough)), '\0');
  if (pread(errors_, text.data(), text.size(), std::max<off_t>(0, size - enough)) < 0) return "";
  while (!text.empty() && (text.back() == '\n' || text.back() == '\r')) text.pop_back();
  return text.substr(text.rfind('\n') + 1);
}

}  // namespace rift::viz

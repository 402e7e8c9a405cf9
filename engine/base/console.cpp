#include "engine/base/console.hpp"

#include <fcntl.h>
#include <poll.h>
#include <sys/ioctl.h>
#include <unistd.h>

#include <algorithm>
#include <atomic>
#include <climits>
#include <csignal>
#include <cstdio>

namespace rift::base {
namespace {

int first_failure = 0;  // of standard output, an errno

/// Whether standard error takes as much as a pipe takes at once, within a second. One that did not, such as a
/// terminal that Ctrl-S holds, is not waited for again until it does: a computation goes on.
bool takes_more() {
  constexpr int patience_ms = 1000;
  static std::atomic<bool> held = false;
  pollfd stream{STDERR_FILENO, POLLOUT, 0};
  held = ::poll(&stream, 1, held ? 0 : patience_ms) == 0;
  return !held;
}

}  // namespace

void secure_standard_streams() noexcept {
  for (const int descriptor : {STDIN_FILENO, STDOUT_FILENO, STDERR_FILENO}) {
    const bool closed = ::fcntl(descriptor, F_GETFD) < 0 && errno == EBADF;
    if (closed && ::open("/dev/null", O_RDWR) != descriptor) ::_exit(1);  // nobody could be told why
  }
  for (const int signal : {SIGPIPE, SIGTTOU, SIGTTIN}) std::signal(signal, SIG_IGN);
}

void message_text(std::string_view text) noexcept {
  while (!text.empty() && takes_more()) {
    const ssize_t count = ::write(STDERR_FILENO, text.data(), std::min<std::size_t>(text.size(), PIPE_BUF));
    if (count > 0)
      text.remove_prefix(static_cast<std::size_t>(count));
    else if (count == 0 || (errno != EINTR && errno != EAGAIN))
      return;
  }
}

void print_text(std::string_view text) noexcept {
  if (std::fwrite(text.data(), 1, text.size(), stdout) != text.size()) note_printing_failure(errno);
}

void print_path(const std::filesystem::path& path) noexcept {
  if (::isatty(STDOUT_FILENO) == 1) return print("{}\n", path.native());
  print_text(path.native());
  print_text("\n");
}

int printing_failure() noexcept {
  if (std::fflush(stdout) != 0) note_printing_failure(errno);
  if (std::ferror(stdout) != 0) note_printing_failure(EIO);
  return first_failure;
}

void note_printing_failure(int error) noexcept {
  if (first_failure == 0) first_failure = error;
}

bool in_foreground(int descriptor) noexcept { return ::tcgetpgrp(descriptor) == ::getpgrp(); }

std::size_t terminal_width(int descriptor) noexcept {
  winsize size{};
  return ::ioctl(descriptor, TIOCGWINSZ, &size) == 0 ? size.ws_col : 0;
}

}  // namespace rift::base

#include "studio/graphics/ask.hpp"

#include "studio/graphics/write_whole.hpp"

#include <poll.h>
#include <sys/ioctl.h>
#include <termios.h>
#include <unistd.h>

#include <array>
#include <cerrno>

namespace rift::studio {
namespace {

using Clock = std::chrono::steady_clock;

/// No echo and no lines while it lives.
class QuietModes {
 public:
  explicit QuietModes(int descriptor)
      : descriptor_(descriptor), known_(tcgetattr(descriptor, &before_) == 0) {
    if (!known_) return;
    termios quiet = before_;
    quiet.c_lflag &= ~static_cast<tcflag_t>(ICANON | ECHO);
    quiet.c_cc[VMIN] = 0, quiet.c_cc[VTIME] = 0;
    tcsetattr(descriptor, TCSANOW, &quiet);
  }
  ~QuietModes() {
    if (known_) tcsetattr(descriptor_, TCSANOW, &before_);
  }
  QuietModes(const QuietModes&) = delete;
  QuietModes& operator=(const QuietModes&) = delete;

 private:
  int descriptor_;
  termios before_{};
  bool known_;
};

void read_answers(int in, TerminalAnswers& answers, Clock::time_point until) {
  std::array<char, 512> buffer{};
  while (!answers.complete()) {
    const auto left = std::chrono::duration_cast<std::chrono::milliseconds>(until - Clock::now()).count();
    pollfd one{in, POLLIN, 0};
    if (left <= 0) return;
    const int ready = poll(&one, 1, static_cast<int>(left));
    if (ready < 0 && errno == EINTR) continue;  // another size, say
    if (ready <= 0) return;
    const ssize_t count = ::read(in, buffer.data(), buffer.size());
    if (count > 0) answers.take({buffer.data(), static_cast<std::size_t>(count)});
    if (count == 0 || (count < 0 && errno != EINTR && errno != EAGAIN)) return;
  }
}

}  // namespace

Asked ask_terminal(int in, int out, const TerminalKind& kind, std::chrono::milliseconds patience) {
  winsize size{};
  (void)ioctl(out, TIOCGWINSZ, &size);
  TerminalAnswers answers(size.ws_col, size.ws_row);
  const QuietModes quiet(in);
  if (write_whole(out, question_for(kind), patience)) read_answers(in, answers, Clock::now() + patience);
  Capabilities found = answers.capabilities();
  found.iterm = kind.iterm;
  if (found.cell_width == 0 && size.ws_col > 0 && size.ws_row > 0) {
    const int width = size.ws_xpixel / size.ws_col, height = size.ws_ypixel / size.ws_row;
    if (is_cell(width, height)) found.cell_width = width, found.cell_height = height;
  }
  return {found, answers.complete(), answers.typed()};
}

}  // namespace rift::studio

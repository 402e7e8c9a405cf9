#include "studio/graphics/write_whole.hpp"

#include <fcntl.h>
#include <poll.h>
#include <unistd.h>

#include <array>
#include <cerrno>

namespace rift::studio {
namespace {

using Clock = std::chrono::steady_clock;

/// The terminal opened once more: to write there never blocks, and who shares the descriptor does not notice.
class Opened {
 public:
  explicit Opened(int descriptor) : given_(descriptor) {
    std::array<char, 256> name{};
    if (ttyname_r(descriptor, name.data(), name.size()) == 0)
      opened_ = open(name.data(), O_WRONLY | O_NOCTTY | O_NONBLOCK | O_CLOEXEC);
  }
  ~Opened() {
    if (opened_ >= 0) close(opened_);
  }
  Opened(const Opened&) = delete;
  Opened& operator=(const Opened&) = delete;
  [[nodiscard]] int descriptor() const { return opened_ >= 0 ? opened_ : given_; }

 private:
  int given_, opened_ = -1;
};

}  // namespace

bool write_whole(int descriptor, std::string_view bytes, std::chrono::milliseconds patience) {
  const Opened terminal(descriptor);
  Clock::time_point until = Clock::now() + patience;
  while (!bytes.empty()) {
    const ssize_t count = ::write(terminal.descriptor(), bytes.data(), bytes.size());
    if (count > 0) {
      bytes.remove_prefix(static_cast<std::size_t>(count));
      until = Clock::now() + patience;
      continue;
    }
    if (count == 0 || (errno != EINTR && errno != EAGAIN)) return false;
    const auto left = std::chrono::duration_cast<std::chrono::milliseconds>(until - Clock::now()).count();
    if (left <= 0) return false;
    pollfd one{terminal.descriptor(), POLLOUT, 0};
    (void)poll(&one, 1, static_cast<int>(left));
  }
  return true;
}

}  // namespace rift::studio

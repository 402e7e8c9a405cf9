#include "viz/frame_server.hpp"

#include <poll.h>

#include <array>
#include <cstring>
#include <exception>
#include <span>

namespace rift::viz {
namespace {

constexpr auto between_starts = std::chrono::seconds(1);

bool has_something(int descriptor) {
  pollfd one{descriptor, POLLIN, 0};
  return poll(&one, 1, 0) > 0;
}

}  // namespace

FrameServer::FrameServer(Gl gl, std::filesystem::path programs) : gl_(gl), programs_(std::move(programs)) {}

void FrameServer::want(Order order) {
  wanted_ = std::move(order);
  send();
}

int FrameServer::descriptor() const { return program_ && sent_ ? program_->child().output() : -1; }

bool FrameServer::look() try {
  bool is_new = false;
  if (sent_ && has_something(descriptor())) {
    std::array<std::uint8_t, 1> done{};
    is_new = program_->child().read(done) == 1;
    if (is_new)
      take();
    else
      note_end();
  }
  send();
  return is_new;
} catch (const std::exception& error) {  // the picture cannot be read
  trouble_ = error.what();
  sent_.reset();
  return false;
}

void FrameServer::take() {
  const Job& job = sent_->job;
  answer_ = shared_.answer(job.width, job.height);
  const auto pixels = shared_.pixels(job.width, job.height);
  image_.width = job.width, image_.height = job.height;
  image_.rgb.assign(pixels.begin(), pixels.end());
  answered_ = std::move(*sent_);
  sent_.reset();
  trouble_.clear();
  program_->works();
}

/// The order that was sent is wanted again, unless there is a newer one.
void FrameServer::note_end() try {
  if (!wanted_) wanted_ = std::move(sent_);
  sent_.reset();
  program_->go_on_after_end();
} catch (const std::exception& error) {
  trouble_ = error.what();
  program_.reset();
}

void FrameServer::start() try {
  if (!program_) begin();
} catch (const std::exception& error) {
  trouble_ = error.what();
}

/// Unless it is too soon after the last time.
void FrameServer::begin() {
  if (Clock::now() - started_ < between_starts) return;
  started_ = Clock::now();
  program_.emplace(gl_, programs_, serve_option,
                   base::ChildOptions{.piped = true, .shared = shared_.descriptor()});
}

void FrameServer::send() try {
  if (sent_ || !wanted_) return;
  if (!program_) begin();
  if (!program_) return;
  shared_.make_room(wanted_->job.width, wanted_->job.height);
  const std::string line = to_json(*wanted_) + "\n";
  sent_ = std::move(wanted_);
  wanted_.reset();
  // Where it has ended, its output ends too, and look() sees that.
  (void)program_->child().write({reinterpret_cast<const std::uint8_t*>(line.data()), line.size()});
} catch (const std::exception& error) {
  trouble_ = error.what();
}

}  // namespace rift::viz

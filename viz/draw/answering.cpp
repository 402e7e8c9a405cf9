#include "viz/draw/answering.hpp"

#include "viz/draw/offscreen.hpp"
#include "viz/draw/picture.hpp"
#include "viz/shared_frame.hpp"

#include <algorithm>
#include <charconv>
#include <chrono>
#include <cstdio>
#include <iostream>
#include <memory>
#include <string>
#include <vector>

namespace rift::viz {
namespace {

double time_of(const std::string& line) {
  double time = 0;
  const auto [end, error] = std::from_chars(line.data(), line.data() + line.size(), time);
  if (error != std::errc{} || end != line.data() + line.size())
    throw std::invalid_argument("not a time: " + line);
  return time;
}

/// @return whether somebody takes it
bool write_out(std::span<const std::uint8_t> bytes) {
  return std::fwrite(bytes.data(), 1, bytes.size(), stdout) == bytes.size() && std::fflush(stdout) == 0;
}

/// A picture of one size with its context.
struct Stage {
  explicit Stage(const Job& job)
      : width(job.width), height(job.height), context(width, height), picture(job) {}
  ~Stage() { context.make_current(); }
  Stage(const Stage&) = delete;
  Stage& operator=(const Stage&) = delete;

  int width, height;
  OffscreenContext context;
  Picture picture;
};

/// Pictures of the last few sizes, the newest last: when something begins to move or rests, the size changes
/// and no scene is built for it.
class Stages {
 public:
  Picture& picture_of(const Job& job) {
    const auto at = std::find_if(stages_.begin(), stages_.end(), [&](const auto& stage) {
      return stage->width == job.width && stage->height == job.height;
    });
    if (at == stages_.end()) {
      if (stages_.size() == most) stages_.erase(stages_.begin());
      stages_.push_back(std::make_unique<Stage>(job));
    } else {
      std::rotate(at, at + 1, stages_.end());
      stages_.back()->context.make_current();
      stages_.back()->picture.change(job);
    }
    return stages_.back()->picture;
  }

 private:
  static constexpr std::size_t most = 3;
  std::vector<std::unique_ptr<Stage>> stages_;
};

}  // namespace

void answer_times() {
  std::string line;
  if (!std::getline(std::cin, line)) throw std::invalid_argument("no job on the input");
  const Job job = job_from_json(line);
  OffscreenContext context(job.width, job.height);
  Picture picture(job);
  std::vector<std::uint8_t> frame(std::size_t{3} * job.width * job.height);
  while (std::getline(std::cin, line)) {
    picture.draw(time_of(line), frame);
    if (!write_out(frame)) return;
  }
}

void answer_orders() {
  SharedFrame shared(shared_descriptor);
  Stages stages;
  for (std::string line; std::getline(std::cin, line);) {
    const auto start = std::chrono::steady_clock::now();
    const Order order = order_from_json(line);
    Picture& picture = stages.picture_of(order.job);
    picture.draw(order.time_s, shared.pixels(order.job.width, order.job.height));
    Answer answer = picture.answer();
    if (order.asked) answer.picked = picture.at(*order.asked);
    answer.seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
    shared.answer(order.job.width, order.job.height) = answer;
    constexpr std::uint8_t done = '.';
    if (!write_out({&done, 1})) return;
  }
}

}  // namespace rift::viz

#include "engine/base/console.hpp"
#include "viz/draw/offscreen.hpp"
#include "viz/draw/picture.hpp"

#include <charconv>
#include <cstdio>
#include <iostream>
#include <new>
#include <string>
#include <vector>

/// Draws what it is told: a job on the first line of its input, then a time [s] a line, each answered with a
/// frame of raw bytes (viz/job.hpp). A process of its own, so that what goes wrong in OpenGL never takes a
/// run with it.
namespace {

constexpr int failed = 1, no_opengl = 3;

double time_of(const std::string& line) {
  double time = 0;
  const auto [end, error] = std::from_chars(line.data(), line.data() + line.size(), time);
  if (error != std::errc{} || end != line.data() + line.size())
    throw std::invalid_argument("not a time: " + line);
  return time;
}

void answer_times(const rift::viz::Job& job) {
  rift::viz::OffscreenContext context(job.width, job.height);
  rift::viz::Picture picture(job);
  std::vector<std::uint8_t> frame(std::size_t{3} * job.width * job.height);
  for (std::string line; std::getline(std::cin, line);) {
    picture.draw(time_of(line), frame);
    if (std::fwrite(frame.data(), 1, frame.size(), stdout) != frame.size() || std::fflush(stdout) != 0)
      return;
  }
}

}  // namespace

int main() try {
  rift::base::secure_standard_streams();
  std::string line;
  if (!std::getline(std::cin, line)) throw std::invalid_argument("no job on the input");
  answer_times(rift::viz::job_from_json(line));
  return 0;
} catch (const rift::viz::NoOpenGl& error) {
  rift::base::message("{}\n", error.what());
  return no_opengl;
} catch (const std::bad_alloc&) {
  rift::base::message_text("not enough memory for such a frame\n");
  return failed;
} catch (const std::exception& error) {
  rift::base::message("{}\n", error.what());
  return failed;
}

#include "viz/renderer.hpp"

#include <fmt/format.h>

#include <string>

namespace rift::viz {
namespace {

std::span<const std::uint8_t> bytes_of(const std::string& text) {
  return {reinterpret_cast<const std::uint8_t*>(text.data()), text.size()};
}

}  // namespace

Renderer::Renderer(Job job, Gl gl, bool idle, std::filesystem::path programs)
    : job_(std::move(job)), program_(gl, std::move(programs), "", {.piped = true, .idle = idle}) {
  send_job();
}

// Where the program has ended, next() says so.
void Renderer::send_job() { (void)program_.child().write(bytes_of(to_json(job_) + "\n")); }
void Renderer::send(double time_s) { (void)program_.child().write(bytes_of(fmt::format("{}\n", time_s))); }

void Renderer::ask(double time_s) {
  asked_.push_back(time_s);
  send(time_s);
}

Image Renderer::next() {
  Image image{job_.width, job_.height, std::vector<std::uint8_t>(std::size_t{3} * job_.width * job_.height)};
  if (program_.child().read(image.rgb) == image.rgb.size()) {
    asked_.pop_front();
    program_.works();
    return image;
  }
  program_.go_on_after_end();
  send_job();
  for (const double time_s : asked_) send(time_s);
  return next();
}

}  // namespace rift::viz

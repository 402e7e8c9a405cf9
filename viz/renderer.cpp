#include "viz/renderer.hpp"

#include "engine/base/world_error.hpp"

#include <fmt/format.h>

#include <string>

namespace rift::viz {
namespace {

constexpr int no_opengl = 3;     // viz/draw/main.cpp
constexpr int no_library = 127;  // of the loader, where a library is gone: OSMesa's, on a newer system

std::span<const std::uint8_t> bytes_of(const std::string& text) {
  return {reinterpret_cast<const std::uint8_t*>(text.data()), text.size()};
}

}  // namespace

std::filesystem::path own_folder() { return std::filesystem::canonical("/proc/self/exe").parent_path(); }

Renderer::Renderer(Job job, Gl gl, bool idle, std::filesystem::path programs)
    : job_(std::move(job)), idle_(idle), may_turn_to_egl_(gl == Gl::any), programs_(std::move(programs)) {
  const bool only_egl = gl == Gl::any && !std::filesystem::exists(programs_ / "rift-frames-osmesa");
  start(gl == Gl::egl || only_egl ? "egl" : "osmesa");
}

void Renderer::start(const std::string& gl) {
  program_ = programs_ / ("rift-frames-" + gl);
  child_ = std::make_unique<base::ChildProcess>(std::vector{program_.string()},
                                                base::ChildOptions{.piped = true, .idle = idle_});
  (void)child_->write(bytes_of(to_json(job_) + "\n"));  // where it has ended, next() tells
}

void Renderer::send(double time_s) { (void)child_->write(bytes_of(fmt::format("{}\n", time_s))); }

void Renderer::ask(double time_s) {
  asked_.push_back(time_s);
  send(time_s);
}

Image Renderer::next() {
  Image image{job_.width, job_.height, std::vector<std::uint8_t>(std::size_t{3} * job_.width * job_.height)};
  if (child_->read(image.rgb) == image.rgb.size()) {
    asked_.pop_front();
    may_turn_to_egl_ = false;
    return image;
  }
  const base::ChildProcess::End end = child_->wait();
  if ((end.code != no_opengl && end.code != no_library) || !may_turn_to_egl_)
    throw base::WorldError("draw with", program_, "it " + end.text);
  may_turn_to_egl_ = false;
  start("egl");
  for (const double time_s : asked_) send(time_s);
  return next();
}

}  // namespace rift::viz

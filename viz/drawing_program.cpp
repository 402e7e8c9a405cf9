#include "viz/drawing_program.hpp"

#include "engine/base/world_error.hpp"

#include <vector>

namespace rift::viz {
namespace {

constexpr int no_opengl = 3;     // viz/draw/main.cpp
constexpr int no_library = 127;  // of the loader, where a library is gone: OSMesa's, on a newer system

}  // namespace

std::filesystem::path own_folder() { return std::filesystem::canonical("/proc/self/exe").parent_path(); }

DrawingProgram::DrawingProgram(Gl gl, std::filesystem::path programs, std::string argument,
                               base::ChildOptions options)
    : may_turn_to_egl_(gl == Gl::any),
      programs_(std::move(programs)),
      argument_(std::move(argument)),
      options_(std::move(options)) {
  const bool only_egl = gl == Gl::any && !std::filesystem::exists(programs_ / "rift-frames-osmesa");
  start(gl == Gl::egl || only_egl ? "egl" : "osmesa");
}

void DrawingProgram::start(const std::string& gl) {
  program_ = programs_ / ("rift-frames-" + gl);
  std::vector<std::string> command{program_.string()};
  if (!argument_.empty()) command.push_back(argument_);
  child_ = std::make_unique<base::ChildProcess>(std::move(command), options_);
}

void DrawingProgram::go_on_after_end() {
  const base::ChildProcess::End end = child_->wait();
  if ((end.code != no_opengl && end.code != no_library) || !may_turn_to_egl_)
    throw base::WorldError("draw with", program_, "it " + end.text);
  may_turn_to_egl_ = false;
  start("egl");
}

}  // namespace rift::viz

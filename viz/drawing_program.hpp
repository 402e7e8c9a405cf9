#pragma once

#include "engine/base/child_process.hpp"

#include <cstdint>
#include <filesystem>
#include <memory>
#include <string>

namespace rift::viz {

/// The way to OpenGL; any: OSMesa, and EGL where that is not to be had.
enum class Gl : std::uint8_t { any, osmesa, egl };

/// The folder of the running program, where the programs that draw are.
[[nodiscard]] std::filesystem::path own_folder();

/// One of the two programs that draw, at work.
class DrawingProgram {
 public:
  /// @param argument  that it is started with, or none
  DrawingProgram(Gl gl, std::filesystem::path programs, std::string argument, base::ChildOptions options);

  [[nodiscard]] base::ChildProcess& child() const { return *child_; }
  /// It has ended. Where it found no OpenGL and the other way may be tried, that has begun when this comes
  /// back; all that was written must be written again. Else throws WorldError with its last words.
  void go_on_after_end();
  /// It has drawn: the way that works is kept.
  void works() { may_turn_to_egl_ = false; }

 private:
  void start(const std::string& gl);

  bool may_turn_to_egl_;
  std::filesystem::path programs_, program_;
  std::string argument_;
  base::ChildOptions options_;
  std::unique_ptr<base::ChildProcess> child_;
};

}  // namespace rift::viz

#pragma once

#include "engine/base/child_process.hpp"
#include "viz/job.hpp"
#include "viz/png.hpp"

#include <deque>
#include <filesystem>
#include <memory>

namespace rift::viz {

/// The way to OpenGL; any: OSMesa, and EGL where that is not to be had.
enum class Gl : std::uint8_t { any, osmesa, egl };

/// The folder of the running program, where the programs that draw are.
[[nodiscard]] std::filesystem::path own_folder();

/// A program that draws, at work: it is asked for times and gives their frames in the same order, and draws
/// on while its frames are looked at.
class Renderer {
 public:
  Renderer(Job job, Gl gl, bool idle = false, std::filesystem::path programs = own_folder());

  /// Asks for the frame of a time since the crack's start [s]. Ask for a few before the first is taken.
  void ask(double time_s);
  /// The frame of the oldest time that was asked for. Throws WorldError, with its last words, where the
  /// program has ended.
  [[nodiscard]] Image next();
  [[nodiscard]] std::size_t waiting() const { return asked_.size(); }

 private:
  void start(const std::string& gl);
  void send(double time_s);

  Job job_;
  bool idle_, may_turn_to_egl_;
  std::filesystem::path programs_, program_;
  std::unique_ptr<base::ChildProcess> child_;
  std::deque<double> asked_;
};

}  // namespace rift::viz

#pragma once

#include "viz/drawing_program.hpp"
#include "viz/job.hpp"
#include "viz/png.hpp"

#include <deque>
#include <filesystem>

namespace rift::viz {

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
  void send_job();
  void send(double time_s);

  Job job_;
  DrawingProgram program_;
  std::deque<double> asked_;
};

}  // namespace rift::viz

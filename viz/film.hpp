#pragma once

#include "engine/base/child_process.hpp"
#include "engine/base/files.hpp"
#include "viz/png.hpp"

#include <filesystem>
#include <memory>
#include <stdexcept>
#include <string>

namespace rift::viz {

/// The film could not be made, as distinct from its frames: they may still be kept as pictures.
struct FilmFailed : std::runtime_error {
  using std::runtime_error::runtime_error;
};

/// The endings that a film may have: ".mp4" (H.264), ".webm" (VP9), ".gif".
[[nodiscard]] bool is_film_name(const std::filesystem::path& path);

/// Frames of one size, encoded by ffmpeg. The file appears under its name only when it is complete, and
/// nothing is left of a film that was not finished. Memory does not grow with its length.
class Film {
 public:
  /// @param width, height  even. Throws FilmFailed where there is no ffmpeg, WorldError where the file cannot
  /// be made.
  Film(const std::filesystem::path& path, int width, int height, double frames_per_second, bool idle = false);

  /// Throws FilmFailed where ffmpeg no longer takes frames.
  void add(const Image& frame);
  /// Throws FilmFailed where ffmpeg did not end well or left nothing.
  void finish();

 private:
  [[noreturn]] void fail();

  base::PendingFile file_;
  std::unique_ptr<base::ChildProcess> ffmpeg_;
};

}  // namespace rift::viz

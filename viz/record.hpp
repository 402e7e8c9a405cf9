#pragma once

#include "viz/film.hpp"
#include "viz/renderer.hpp"

#include <atomic>
#include <filesystem>
#include <functional>
#include <span>

/// Frames made one after the other, into a film or into pictures.
namespace rift::viz {

/// The user asked to stop; nothing half-made is left.
struct Stopped {};

/// How frames are made.
struct Making {
  Gl gl = Gl::any;
  bool idle = false;  // only take the time that nobody else wants
  /// Asked before each frame; false throws Stopped.
  std::function<bool(std::size_t done, std::size_t all)> go_on{};
  std::filesystem::path programs = own_folder();  // that draw
};

/// Draws the frame of each time and hands it over, in order; the next ones are drawn meanwhile.
void draw_each(const Job& job, std::span<const double> times_s, const Making& making,
               const std::function<void(const Image&)>& take);

/// A film, see viz/film.hpp. Throws FilmFailed, WorldError or Stopped.
void make_film(const Job& job, std::span<const double> times_s, double frames_per_second,
               const std::filesystem::path& path, const Making& making);

/// frame_000000.png and so on in a folder, which is made. Throws WorldError or Stopped.
void make_pictures(const Job& job, std::span<const double> times_s, const std::filesystem::path& folder,
                   const Making& making);

/// One picture. Throws WorldError.
void make_picture(const Job& job, double time_s, const std::filesystem::path& path, const Making& making);

/// A film of one lane of a run that goes on: a frame for each moment as soon as it is stored, until
/// `run_ended` and all are drawn.
void follow_film(const Job& job, double frames_per_second, const std::filesystem::path& path,
                 const Making& making, const std::atomic<bool>& run_ended);

}  // namespace rift::viz

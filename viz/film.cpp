#include "viz/film.hpp"

#include "engine/base/world_error.hpp"

#include <fmt/format.h>

#include <system_error>

namespace rift::viz {
namespace {

using Words = std::vector<std::string>;

/// How ffmpeg is to encode, by the ending of the name. A GIF has a palette for each frame, so that
/// no frames wait.
Words encoder(const std::string& ending) {
  if (ending == ".webm")
    return {"-c:v", "libvpx-vp9", "-deadline", "realtime", "-cpu-used", "6",       "-row-mt", "1",
            "-crf", "32",         "-b:v",      "0",        "-pix_fmt",  "yuv420p", "-f",      "webm"};
  if (ending == ".gif")
    return {"-vf", "split[a][b];[a]palettegen=stats_mode=single[p];[b][p]paletteuse=new=1:dither=none", "-f",
            "gif"};
  return {"-c:v",     "libx264", "-preset",   "veryfast",   "-crf", "23",
          "-pix_fmt", "yuv420p", "-movflags", "+faststart", "-f",   "mp4"};
}

Words command_for(const std::filesystem::path& target, const std::string& ending, int width, int height,
                  double rate) {
  Words words{"ffmpeg",
              "-v",
              "error",
              "-nostdin",
              "-y",
              "-f",
              "rawvideo",
              "-pix_fmt",
              "rgb24",
              "-s",
              fmt::format("{}x{}", width, height),
              "-r",
              fmt::format("{}", rate),
              "-i",
              "pipe:0"};
  for (std::string& word : encoder(ending)) words.push_back(std::move(word));
  words.push_back("file:" + target.string());
  return words;
}

}  // namespace

bool is_film_name(const std::filesystem::path& path) {
  const auto ending = path.extension();
  return ending == ".mp4" || ending == ".webm" || ending == ".gif";
}

Film::Film(const std::filesystem::path& path, int width, int height, double frames_per_second, bool idle)
    : file_(path) {
  try {
    ffmpeg_ = std::make_unique<base::ChildProcess>(
        command_for(file_.temporary(), path.extension().string(), width, height, frames_per_second),
        base::ChildOptions{.piped = true, .idle = idle});
  } catch (const base::WorldError& error) {
    throw FilmFailed(error.what());
  }
}

void Film::add(const Image& frame) {
  if (!ffmpeg_->write(frame.rgb)) fail();
}

void Film::finish() {
  ffmpeg_->close_input();
  // ffmpeg also ends with 0 where it could not write the file's end; at this level it only speaks of errors.
  const base::ChildProcess::End& end = ffmpeg_->wait();
  if (end.code != 0 || !end.words.empty()) fail();
  std::error_code error;
  if (std::filesystem::file_size(file_.temporary(), error) == 0 || error)
    throw FilmFailed("ffmpeg wrote no data");
  file_.commit();
}

void Film::fail() { throw FilmFailed("ffmpeg " + ffmpeg_->wait().text); }

}  // namespace rift::viz

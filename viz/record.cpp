#include "viz/record.hpp"

#include "engine/base/files.hpp"
#include "engine/base/ownership.hpp"
#include "engine/results/archive.hpp"
#include "engine/results/journal_index.hpp"
#include "viz/png.hpp"

#include <fmt/format.h>

#include <chrono>
#include <string>
#include <thread>
#include <vector>

namespace rift::viz {
namespace {

constexpr std::size_t ahead = 3;  // frames that are drawn while one is looked at

void ask_whether_to_go_on(const Making& making, std::size_t done, std::size_t all) {
  if (making.go_on && !making.go_on(done, all)) throw Stopped{};
}

/// What an earlier film has left in a folder of frames.
void remove_frames(const std::filesystem::path& folder) {
  std::vector<std::filesystem::path> frames;
  for (const auto& entry : std::filesystem::directory_iterator(folder)) {
    const std::string name = entry.path().filename().string();
    if (name.starts_with("frame_") && name.ends_with(".png")) frames.push_back(entry.path());
  }
  for (const auto& frame : frames) std::filesystem::remove(frame);
}

}  // namespace

void draw_each(const Job& job, std::span<const double> times_s, const Making& making,
               const std::function<void(const Image&)>& take) {
  Renderer renderer(job, making.gl, making.idle, making.programs);
  std::size_t asked = 0;
  for (std::size_t done = 0; done < times_s.size(); ++done) {
    ask_whether_to_go_on(making, done, times_s.size());
    while (asked < times_s.size() && asked < done + ahead) renderer.ask(times_s[asked++]);
    take(renderer.next());
  }
}

void make_film(const Job& job, std::span<const double> times_s, double frames_per_second,
               const std::filesystem::path& path, const Making& making) {
  Film film(path, job.width, job.height, frames_per_second, making.idle);
  draw_each(job, times_s, making, [&](const Image& frame) { film.add(frame); });
  film.finish();
}

void make_pictures(const Job& job, std::span<const double> times_s, const std::filesystem::path& folder,
                   const Making& making) {
  const base::OwnedFolder owned(folder);
  int number = 0;
  draw_each(job, times_s, making, [&](const Image& frame) {
    if (number == 0) remove_frames(folder);
    write_png(folder / fmt::format("frame_{:06}.png", number++), frame);
  });
}

void make_picture(const Job& job, double time_s, const std::filesystem::path& path, const Making& making) {
  draw_each(job, std::span(&time_s, 1), making, [&](const Image& frame) { write_png(path, frame); });
}

void follow_film(const Job& job, double frames_per_second, const std::filesystem::path& path,
                 const Making& making, const std::atomic<bool>& run_ended) {
  const Pane& pane = job.panes.front();
  results::JournalIndex journal(pane.run / results::journal_name);
  Renderer renderer(job, making.gl, making.idle, making.programs);
  Film film(path, job.width, job.height, frames_per_second, making.idle);
  std::size_t asked = 0, done = 0;
  for (;;) {
    const bool last_look = run_ended;
    journal.extend();
    const auto& frames = journal.frames(pane.lane);
    while (done < frames.size()) {
      ask_whether_to_go_on(making, done, frames.size());
      while (asked < frames.size() && asked < done + ahead)
        renderer.ask(frames[asked++].time_s - frames.front().time_s);
      film.add(renderer.next());
      ++done;
    }
    if (last_look) break;
    ask_whether_to_go_on(making, done, frames.size());
    std::this_thread::sleep_for(std::chrono::milliseconds(200));
  }
  film.finish();
}

}  // namespace rift::viz

#pragma once

#include "engine/results/run_folder.hpp"
#include "engine/simulation/record.hpp"
#include "studio/screen/live.hpp"

#include <nlohmann/json.hpp>

#include <atomic>
#include <chrono>
#include <condition_variable>
#include <cstdint>
#include <exception>
#include <filesystem>
#include <functional>
#include <mutex>
#include <optional>
#include <string>
#include <thread>
#include <vector>

namespace rift::studio {

/// What is to run, and where it is kept.
struct RunRequest {
  scene::Preset preset;  // without issues, no study
  std::filesystem::path folder;
  bool force = false;   // replace the run that is in the folder
  bool resume = false;  // go on with the run that is in the folder
  int threads = 0;
  double checkpoint_s = 30;  // between two checkpoints
  base::Cache cache = {};
  simulation::BuildInfo build = {};
  std::function<void(const std::filesystem::path&)> began = {};  // the folder is there; on the run's thread
};

/// A run that marches in a thread of its own while a panel looks on and steers. The panel never waits for the
/// engine, nor the engine for the panel but where it was asked to.
class LiveRun {
 public:
  /// Claims the folder of a new run, then starts. Throws as results::ClaimedFolder, InputError for a study.
  explicit LiveRun(RunRequest request);
  /// Stops the run, keeping what there is, and waits for its end.
  ~LiveRun();
  LiveRun(const LiveRun&) = delete;
  LiveRun& operator=(const LiveRun&) = delete;

  enum class Stage : std::uint8_t { preparing, running, ended };

  /// Brings what the panel shows up to date. @param plates  the lanes whose plates are shown, by velocity or
  /// not; others keep theirs
  void look(Live& live, const std::vector<int>& plates, bool velocity = false);

  [[nodiscard]] Stage stage() const { return stage_; }
  [[nodiscard]] const std::filesystem::path& folder() const { return request_.folder; }
  [[nodiscard]] bool paused() const { return paused_; }
  /// The lane's scenario with the changes so far.
  [[nodiscard]] scene::Scene scene(int lane) const;

  void pause(bool wanted) {
    order([&] { paused_ = wanted; });
  }
  void single_step() {
    order([&] { paused_ = true, ++steps_wanted_; });
  }
  void change_speed(int by);  // one slower is -1, one faster 1
  /// One that would change nothing is no change: it is said, and neither made nor kept.
  void change(scene::Change change);
  /// Nobody is there to end a pause or slow motion.
  void go_on_alone() {
    order([&] { paused_ = false, steps_wanted_ = 0, speed_ = 0; });
  }
  /// Of all lanes, into the journal.
  void store_frame() {
    order([&] { ++frames_wanted_; });
  }
  /// Again and again; the first and the last moment are always there.
  void store_frames(bool wanted) {
    order([&] { storing_ = wanted, next_stored_ = 0, ++frames_wanted_; });
  }
  [[nodiscard]] bool storing() const { return storing_; }
  /// Whether a frame that was asked for has come into the journal since the last question, or never will.
  [[nodiscard]] bool stored();
  void stop() {
    order([&] { stop_ = true; });
  }

  /// How it ended; rethrows what went wrong. Nothing where it was stopped before its first step.
  [[nodiscard]] std::optional<simulation::Recorded> result();

 private:
  using Clock = std::chrono::steady_clock;
  /// Changes what the run's thread reads, and wakes it.
  template <class Change>
  void order(const Change& change) {
    const std::lock_guard lock(mutex_);
    change();
    news_.notify_all();
  }
  void work();
  void run();
  simulation::SteeringCommands steer(const simulation::RunSnapshot& moment);
  void take_changed(const scene::Change& change, const std::string& refused);
  void show_plates(const simulation::RunSnapshot& moment);
  void show_plate(const simulation::RunSnapshot& moment, int lane, bool velocity, bool with_sample);
  [[nodiscard]] bool at_rest() const { return paused_ && steps_wanted_ == 0; }
  [[nodiscard]] std::string state() const;

  RunRequest request_;
  std::optional<results::ClaimedFolder> claim_;  // of a new run
  std::vector<scene::Scene> scenes_;
  std::atomic<Stage> stage_ = Stage::preparing;
  std::exception_ptr failure_;
  std::optional<simulation::Recorded> recorded_;
  std::optional<simulation::Prepared> prepared_;
  results::Geometry geometry_;
  nlohmann::ordered_json header_;

  // What both threads touch, under the mutex.
  mutable std::mutex mutex_;
  std::condition_variable_any news_;
  std::string doing_ = "packing";
  double doing_done_ = 0;
  simulation::Progress progress_;
  std::vector<std::vector<results::Sample>> books_;   // by lane, not yet looked at
  std::vector<std::optional<results::Sample>> now_;   // by lane, between two samples
  std::vector<std::optional<results::Frame>> plate_;  // by lane
  std::vector<std::string> said_;
  std::vector<int> plates_wanted_;
  std::vector<scene::Change> changes_wanted_;
  std::vector<scene::Scene> scene_now_;
  std::vector<double> tip_;  // by lane, at its last sample [m]
  int frames_wanted_ = 0;
  std::int64_t steps_wanted_ = 0, next_stored_ = 0;
  bool paused_ = false, stop_ = false, storing_ = false, looked_ = true;
  bool frame_ordered_ = false, frame_stored_ = false, velocity_wanted_ = false;
  std::size_t lanes_ended_ = 0;
  int speed_ = 0;  // 0: as fast as can be

  // The panel's own.
  bool described_ = false;
  double steps_per_s_ = 0;
  std::int64_t step_before_ = 0;
  Clock::time_point before_ = Clock::now();

  std::jthread thread_;
};

/// Which steps a second slow motion makes, the fastest first; one slower than the last is not there.
[[nodiscard]] const std::vector<double>& slow_motions();

}  // namespace rift::studio

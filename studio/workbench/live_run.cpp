#include "studio/workbench/live_run.hpp"

#include "engine/base/interrupted.hpp"
#include "engine/results/records.hpp"
#include "engine/scene/scenarios.hpp"
#include "engine/simulation/summary.hpp"
#include "studio/screen/live_of_run.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <utility>

namespace rift::studio {
namespace {

/// The scenes of a run, one lane each.
std::vector<scene::Scene> scenes_of(const scene::Preset& preset) {
  if (!preset.study.empty())
    throw scene::InputError(
        {scene::Issue{.file = preset.name, .key = {}, .text = "holds a study, not a run"}});
  return preset.lanes.empty() ? std::vector<scene::Scene>{preset.scene} : preset.lanes;
}

/// Whether the change leaves the scene as it is from the tip on: a velocity takes the place of all that are
/// still to come.
bool changes_nothing(const scene::Scene& scene, const scene::Change& change, double tip) {
  const scene::Axis& axis = *scene::find_axis(change.axis);
  const scene::Parameter& row = scene::parameter_of(axis);
  scene::Scene wished = scene;
  if (!scene::applies(scene, axis) ||
      !scene::assign(wished, row, scene::value_from_text(change.value)).empty())
    return false;
  if (change.axis != "crack_velocity") return scene::toml_value(wished, row) == scene::toml_value(scene, row);
  return scene.crack.history.empty() && wished.crack.velocity.size() == 1 &&
         std::all_of(scene.crack.velocity.begin(), scene.crack.velocity.end(),
                     [&](const scene::VelocityPiece& piece) {
                       const bool passed = piece.until && *piece.until <= tip;
                       return passed || piece.speed == wished.crack.velocity.front().speed;
                     });
}

constexpr double stored_moments = 120;  // of a film over the whole run

}  // namespace

const std::vector<double>& slow_motions() {
  static const std::vector<double> steps_per_s{400, 100, 25, 5};
  return steps_per_s;
}

LiveRun::LiveRun(RunRequest request)
    : request_(std::move(request)),
      scenes_(scenes_of(request_.preset)),
      books_(scenes_.size()),
      now_(scenes_.size()),
      plate_(scenes_.size()),
      plates_wanted_{0},
      scene_now_(scenes_),
      tip_(scenes_.size()) {
  if (!request_.resume) claim_.emplace(request_.folder, request_.force);
  thread_ = std::jthread([this] { work(); });
}

LiveRun::~LiveRun() { stop(); }

void LiveRun::work() {
  try {
    run();
  } catch (const base::Interrupted&) {
    // nothing was written, nothing is to be said
  } catch (...) {
    failure_ = std::current_exception();
  }
  claim_.reset();  // others may write into the folder from here on
  stage_ = Stage::ended;
}

void LiveRun::run() {
  const auto start = Clock::now();
  simulation::Prepared& p = prepared_.emplace(simulation::prepare(
      request_.preset, scenes_, request_.cache, [this](std::string_view stage, double done) {
        const std::lock_guard lock(mutex_);
        doing_ = stage, doing_done_ = done;
        return !stop_;
      }));
  simulation::check_grip(p);
  if (claim_) {
    claim_->keep();
    const std::lock_guard lock(mutex_);
    if (!claim_->has_locks()) said_.push_back(simulation::no_locks_note(request_.folder));
  }
  if (request_.began) request_.began(request_.folder);
  geometry_ = simulation::geometry_of(p);
  header_ = simulation::header_of(p, request_.build);
  simulation::Observer beside;
  beside.sample = [this](const results::Sample& s) {
    const std::lock_guard lock(mutex_);
    books_[s.lane].push_back(s);
    tip_[s.lane] = s.tip_m;
  };
  beside.ended = [this](int, const simulation::RunResult&) {
    const std::lock_guard lock(mutex_);
    ++lanes_ended_;
  };
  beside.steer = [this](const simulation::RunSnapshot& moment) { return steer(moment); };
  // Whatever is looked at now: it can be asked for when the march is over.
  beside.last_moment = [this](const simulation::RunSnapshot& moment, int lane) {
    show_plate(moment, lane, true, false);
  };
  beside.changed = [this](const scene::Change& change, const std::string& refused) {
    take_changed(change, refused);
  };
  stage_ = Stage::running;
  const double preparation_s = std::chrono::duration<double>(Clock::now() - start).count();
  const simulation::MarchOptions options{.threads = request_.threads, .checkpoint_s = request_.checkpoint_s};
  std::string note;
  recorded_ =
      request_.resume
          ? simulation::resume_run(p, request_.folder, request_.build, beside, note, options, preparation_s)
          : simulation::record_run(p, request_.folder, request_.build, beside, options, preparation_s);
}

/// On the run's thread, between two steps.
simulation::SteeringCommands LiveRun::steer(const simulation::RunSnapshot& moment) {
  std::unique_lock lock(mutex_);
  progress_ = moment.progress;
  frame_stored_ = frame_stored_ || std::exchange(frame_ordered_, false);
  if (speed_ > 0 && !paused_)
    news_.wait_for(lock, std::chrono::milliseconds(50), [this] { return stop_ || paused_; });
  for (;;) {
    if (looked_) {
      lock.unlock();
      show_plates(moment);
      lock.lock();
    }
    if (!at_rest() || stop_ || !changes_wanted_.empty() || frames_wanted_ > 0) break;
    news_.wait_for(lock, std::chrono::milliseconds(50));
  }
  simulation::SteeringCommands orders;
  orders.stop = stop_;
  orders.changes = std::exchange(changes_wanted_, {});
  const bool due = storing_ && progress_.step >= next_stored_;
  if (due)
    next_stored_ =
        progress_.step + static_cast<std::int64_t>(static_cast<double>(progress_.total) / stored_moments);
  if (frames_wanted_ > 0 || due)
    for (int k = 0; k < static_cast<int>(scenes_.size()); ++k) orders.frames.push_back(k);
  frame_ordered_ = frame_ordered_ || frames_wanted_ > 0;
  frames_wanted_ = 0;
  orders.wait = at_rest();
  if (steps_wanted_ > 0 && !orders.wait) {
    --steps_wanted_;
    orders.steps = 1;
  } else if (speed_ > 0) {
    orders.steps = std::max<std::int64_t>(1, static_cast<std::int64_t>(slow_motions()[speed_ - 1] / 20));
  }
  return orders;
}

/// What the panel wants to see of this moment, once for each look.
void LiveRun::show_plates(const simulation::RunSnapshot& moment) {
  std::vector<int> wanted;
  bool slow = false, velocity = false;
  {
    const std::lock_guard lock(mutex_);
    wanted = plates_wanted_, velocity = velocity_wanted_;
    slow = paused_ || speed_ > 0;
    looked_ = false;
  }
  for (const int k : wanted) show_plate(moment, k, velocity, slow);
}

void LiveRun::show_plate(const simulation::RunSnapshot& moment, int lane, bool velocity, bool with_sample) {
  auto frame = moment.frame(lane, velocity);
  auto sample = with_sample ? moment.sample(lane) : std::nullopt;
  const std::lock_guard lock(mutex_);
  if (frame) plate_[lane] = std::move(frame);
  if (sample) now_[lane] = sample;
}

void LiveRun::take_changed(const scene::Change& change, const std::string& refused) {
  const std::lock_guard lock(mutex_);
  const std::string what =
      fmt::format("lane {}, step {}: {} = {}", change.lane + 1, change.step, change.axis, change.value);
  said_.push_back(refused.empty() ? what + "; kept in steering.toml" : what + " is refused: " + refused);
  if (refused.empty()) (void)rift::scene::steer(scene_now_[change.lane], change, 0.0);
}

void LiveRun::look(Live& live, const std::vector<int>& plates, bool velocity) {
  const std::lock_guard lock(mutex_);
  if (!described_ && stage_ != Stage::preparing && !header_.empty()) {
    live = live_of_header(header_, request_.folder);
    live.geometry = &geometry_;
    described_ = true;
  }
  live.name = request_.folder.filename().string();
  live.state = state();
  if (!said_.empty()) live.message = std::exchange(said_, {}).back();
  plates_wanted_ = plates, velocity_wanted_ = velocity;
  looked_ = true;
  if (!described_) {
    live.done = doing_done_;
    return;
  }
  for (std::size_t k = 0; k < live.lanes.size(); ++k) {
    LiveLane& lane = live.lanes[k];
    bool fresh = false;
    for (const results::Sample& s : std::exchange(books_[k], {}))
      if (s.phase == results::Phase::fracture) lane.samples.push_back(s), fresh = true;
    if (now_[k] && now_[k]->phase == results::Phase::fracture &&
        (lane.samples.empty() || now_[k]->step > lane.samples.back().step))
      lane.samples.push_back(*now_[k]), fresh = true;
    now_[k].reset();
    if (fresh && lane.samples.size() > 2) lane.rates = fracture::rate_curve(lane.samples, lane.scale);
    if (!plate_[k]) continue;
    lane.displacement = std::move(plate_[k]->displacement);
    lane.velocity = std::move(plate_[k]->velocity);
    lane.tips = results::tips_at(header_, plate_[k]->tip_m);
    plate_[k].reset();
  }
  live.step = progress_.step, live.steps = progress_.total;
  live.done =
      progress_.total > 0 ? static_cast<double>(progress_.step) / static_cast<double>(progress_.total) : 0;
  const auto now = Clock::now();
  const double seconds = std::chrono::duration<double>(now - before_).count();
  if (seconds > 0.4) {
    const double speed = static_cast<double>(progress_.step - step_before_) / seconds;
    steps_per_s_ = steps_per_s_ > 0 ? 0.5 * (steps_per_s_ + speed) : speed;
    step_before_ = progress_.step, before_ = now;
  }
  const bool going = stage_ == Stage::running && !paused_;
  live.steps_per_s = going ? steps_per_s_ : 0;
  live.seconds_left =
      going && steps_per_s_ > 0 ? static_cast<double>(live.steps - live.step) / steps_per_s_ : -1;
  if (stage_ != Stage::ended || !recorded_) return;
  take_results(live, recorded_->summary);
  if (recorded_->result.outcome == simulation::Outcome::finished) live.done = 1, live.step = live.steps;
}

std::string LiveRun::state() const {
  if (stage_ == Stage::preparing) return fmt::format("{} {:.0f} %", doing_, 100 * doing_done_);
  if (stage_ == Stage::ended) {
    if (failure_) return "failed";
    return recorded_ ? simulation::name_of(recorded_->result.outcome) : "stopped";
  }
  if (lanes_ended_ == scenes_.size()) return "writing the archive";
  if (paused_) return "paused";
  return speed_ > 0 ? fmt::format("{:g} steps/s", slow_motions()[speed_ - 1]) : "running";
}

scene::Scene LiveRun::scene(int lane) const {
  const std::lock_guard lock(mutex_);
  return scene_now_[lane];
}

void LiveRun::change(scene::Change change) {
  order([&] {
    if (changes_nothing(scene_now_[change.lane], change, tip_[change.lane]))
      said_.push_back(fmt::format("lane {}: {} is {} already", change.lane + 1, change.axis, change.value));
    else
      changes_wanted_.push_back(std::move(change));
  });
}

void LiveRun::change_speed(int by) {
  order([&] { speed_ = std::clamp(speed_ - by, 0, static_cast<int>(slow_motions().size())); });
}

bool LiveRun::stored() {
  const std::lock_guard lock(mutex_);
  return std::exchange(frame_stored_, false) || stage_ == Stage::ended;
}

std::optional<simulation::Recorded> LiveRun::result() {
  if (thread_.joinable()) thread_.join();
  if (failure_) std::rethrow_exception(failure_);
  return recorded_;
}

}  // namespace rift::studio

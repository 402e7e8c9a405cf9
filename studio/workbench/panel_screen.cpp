#include "studio/workbench/panel_screen.hpp"

#include "engine/results/run_folder.hpp"
#include "engine/scene/scenarios.hpp"
#include "studio/screen/canvas.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <utility>

namespace rift::studio {

void PanelScreen::draw(Canvas& canvas, Glyphs glyphs) {
  width_ = canvas.width(), height_ = canvas.height();
  LiveLook look = look_of_panel();
  const std::string foot = foot_of(where(), canvas.width());
  look.foot = foot;
  draw_live(canvas, live(), look, glyphs);
  plate_.draw_trouble(canvas, place_of_plates(live(), look, width_, height_));
  draw_question(canvas, glyphs);
}

LiveLook PanelScreen::look_of_panel() const {
  return {
      .shown = shown_, .beside = beside_, .velocity = velocity_, .picture = plate_.on(), .foot = {}};
}

void PanelScreen::take_room(const PictureRoom& room) {
  plate_.take_room(room);
  if (live().lanes.empty()) return;
  PlateView view{.lanes = {shown_}, .velocity = velocity_};
  if (beside_ >= 0) view.lanes.push_back(beside_);
  plate_.look(place_of_plates(live(), look_of_panel(), width_, height_), view);
}

std::optional<ScreenPicture> PanelScreen::picture() const {
  return typing() ? std::nullopt : plate_.picture();
}

bool PanelScreen::choose(const KeyEvent& event) {
  const int count = lanes();
  if (count == 0) return false;
  const int asked = event.key - '1';
  const Action action = action_of(where(), event.key);
  if (asked >= 0 && asked < std::min(count, 8)) {
    shown_ = asked;
  } else if (action == Action::lane || action == Action::down) {
    shown_ = (shown_ + 1) % count;
  } else if (action == Action::up) {
    shown_ = (shown_ + count - 1) % count;
  } else if (action == Action::velocity) {
    velocity_ = !velocity_;
  } else if (action == Action::beside) {
    beside_ = beside_ >= 0 ? -1 : count > 1 ? (shown_ + 1) % count : -1;
  } else {
    return false;
  }
  if (beside_ == shown_) beside_ = (shown_ + 1) % count;
  return true;
}

WatchScreen::WatchScreen(AppContext& context, const std::filesystem::path& run)
    : PanelScreen(context), folder_(run), run_(std::in_place, run), live_(run_->live()) {}

Navigation WatchScreen::press(const KeyEvent& event) {
  if (choose(event)) return {};
  switch (action_of(Where::watch, event.key)) {
    case Action::picture:
      live_.message = plate_.toggle({folder_});
      return {};
    case Action::frame:
      live_.message = jobs_.picture(folder_, shown_);
      return {};
    case Action::film:
      live_.message = jobs_.film(folder_, {});
      return {};
    case Action::export_tables:
      live_.message = jobs_.tables(folder_);
      return {};
    case Action::back:
      return {Navigation::To::back, nullptr};
    default:
      return {};
  }
}

Navigation WatchScreen::look() {
  const std::string message = live_.message, news = jobs_.report_ended();
  live_.message = news.empty() ? message : news;
  try {
    if (!run_)
      open_again();
    else if (run_->look())
      live_ = run_->live(), live_.message = news.empty() ? message : news;
  } catch (const results::RunReplaced&) {
    run_.reset();
    live_.geometry = nullptr;
    live_.state = "replaced";
    live_.message = "another process has replaced or removed this run";
  }
  return {};
}

/// The run that has taken the place of the one that was shown, as soon as it can be read.
void WatchScreen::open_again() try {
  run_.emplace(folder_);
  live_ = run_->live();
  live_.message = "another run has replaced the one that was shown";
  shown_ = 0, beside_ = -1;
} catch (const base::WorldError&) {
  // its journal holds no geometry yet
}

RunScreen::RunScreen(AppContext& context, RunRequest request, bool leave_at_end)
    : PanelScreen(context),
      run_(std::make_shared<LiveRun>(std::move(request))),
      leave_at_end_(leave_at_end) {}

Navigation RunScreen::look() {
  std::vector<int> plates{shown_};
  if (beside_ >= 0) plates.push_back(beside_);
  const std::string message = live_.message;
  run_->look(live_, plates, velocity_);
  if (live_.message.empty()) live_.message = message;
  if (!seen_ && lanes() > 0) {
    seen_ = true;
    since_ = std::chrono::steady_clock::now();
    if (lanes() > 1) beside_ = 1;  // an ensemble begins as a comparison
  }
  if (const std::string news = jobs_.report_ended(); !news.empty()) say(news);
  send_what_is_due();
  const bool ended = run_->stage() == LiveRun::Stage::ended;
  if (!ended) return {};
  if (leaving_ || (leave_at_end_ && seen_for_a_while())) return {Navigation::To::back, nullptr};
  if (!end_said_) {
    end_said_ = true;
    try {
      if (const auto recorded = run_->result())
        say(fmt::format("{}: {}",
                        recorded->result.outcome == simulation::Outcome::stopped
                            ? "stopped; 'rift resume' continues it"
                            : "done",
                        run_->folder().string()));
    } catch (const std::exception& error) {
      say(error.what());
    }
  }
  return {};
}

void RunScreen::send_what_is_due() {
  if ((!picture_due_ && !film_due_) || !run_->stored()) return;
  if (std::exchange(picture_due_, false)) say(jobs_.picture(run_->folder(), shown_));
  if (!std::exchange(film_due_, false)) return;
  std::vector<int> lanes{shown_};
  if (beside_ >= 0) lanes.push_back(beside_);
  say(jobs_.film(run_->folder(), lanes, film_from_us_, time_us() + 1));
}

/// A run of half a second is no flicker then; one that showed nothing is not waited for.
bool RunScreen::seen_for_a_while() const {
  return !seen_ || std::chrono::steady_clock::now() - since_ > std::chrono::seconds(2);
}

double RunScreen::time_us() const {
  if (live_.lanes.empty() || live_.lanes[shown_].samples.empty()) return 0;
  const auto& samples = live_.lanes[shown_].samples;
  return 1e6 * (samples.back().time_s - samples.front().time_s);
}

Navigation RunScreen::press(const KeyEvent& event) {
  if (value_.typing()) {
    if (value_.press(event) == Prompt::State::entered)
      run_->change({shown_, 0, std::string(scene::steerable_axes()[axis_]), value_.text()});
    return {};
  }
  if (choosing_) {
    choose_change(event);
    return {};
  }
  if (choose(event)) return {};
  return act(action_of(Where::live, event.key));
}

Navigation RunScreen::act(Action action) {
  const bool running = run_->stage() == LiveRun::Stage::running;
  switch (action) {
    case Action::pause:
      run_->pause(!run_->paused());
      return {};
    case Action::step:
      run_->single_step();
      return {};
    case Action::slower:
      run_->change_speed(-1);
      return {};
    case Action::faster:
      run_->change_speed(1);
      return {};
    case Action::change:
      begin_change();
      return {};
    case Action::picture:
      say(plate_.toggle({run_->folder()}));
      return {};
    case Action::frame:
      take_frame();
      return {};
    case Action::film:
      toggle_film();
      return {};
    case Action::export_tables:
      say(jobs_.tables(run_->folder()));
      return {};
    case Action::stop:
      run_->stop();
      return {};
    case Action::back:
      if (run_->stage() == LiveRun::Stage::ended) return {Navigation::To::back, nullptr};
      run_->stop();
      leaving_ = true;
      say(running ? "stopping; the results so far are kept" : "stopping");
      return {};
    default:
      return {};
  }
}

void RunScreen::begin_change() {
  if (run_->stage() != LiveRun::Stage::running) {
    say("nothing can be changed: the crack is not running");
    return;
  }
  choosing_ = true;
}

void RunScreen::choose_change(const KeyEvent& event) {
  const int count = static_cast<int>(scene::steerable_axes().size());
  const Action action = action_of(Where::anywhere, event.key);
  if (action == Action::up) axis_ = (axis_ + count - 1) % count;
  if (action == Action::down) axis_ = (axis_ + 1) % count;
  if (action == Action::back) choosing_ = false;
  const int asked = event.key - '1';
  if (asked >= 0 && asked < count) ask_value(asked);
  if (event.key == key_enter) ask_value(axis_);
}

void RunScreen::ask_value(int axis) {
  axis_ = axis;
  choosing_ = false;
  value_ = Prompt(fmt::format("{} of lane {}", scene::steerable_axes()[axis], shown_ + 1), value_now(axis));
}

std::string RunScreen::value_now(int axis) const {
  scene::Scene scene = run_->scene(shown_);
  if (scene.crack.velocity.size() > 1) {  // the last piece is the one that holds
    scene.crack.velocity = {scene.crack.velocity.back()};
    scene.crack.velocity.front().until.reset();
  }
  return scene::axis_text(scene, *scene::find_axis(scene::steerable_axes()[axis]));
}

void RunScreen::draw_question(Canvas& canvas, Glyphs glyphs) {
  if (value_.typing()) {
    value_.draw(canvas, {0, canvas.height() - 1, canvas.width(), 1});
    return;
  }
  if (!choosing_) return;
  const auto axes = scene::steerable_axes();
  const Area inside = draw_box(canvas, 46, static_cast<int>(axes.size()),
                               fmt::format("change lane {} from now on", shown_ + 1), glyphs);
  for (int k = 0; k < inside.height; ++k) {
    const Style style{Ink::plain, false, k == axis_};
    clear(canvas, {inside.x, inside.y + k, inside.width, 1}, style);
    canvas.text(inside.x + 1, inside.y + k, fmt::format("{} {:<20}{}", k + 1, axes[k], value_now(k)), style,
                inside.width - 1);
  }
}

void RunScreen::take_frame() {
  if (run_->stage() == LiveRun::Stage::running) {
    run_->store_frame();
    picture_due_ = true;
    say("frame: storing this moment");
  } else {
    say(jobs_.picture(run_->folder(), shown_));
  }
}

void RunScreen::toggle_film() {
  if (run_->stage() != LiveRun::Stage::running && !run_->storing()) {
    say(jobs_.film(run_->folder(), {}));
  } else if (run_->storing()) {
    run_->store_frames(false);
    film_due_ = true;
  } else {
    run_->store_frames(true);
    film_from_us_ = time_us();
    say("film: storing from now on; m again ends it");
  }
}

std::string RunScreen::last_words() const {
  return fmt::format(
      "the run is stored in {0}, complete up to its last flush; 'rift resume {0}' continues it\n",
      run_->folder().string());
}

}  // namespace rift::studio

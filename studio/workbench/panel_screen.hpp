#pragma once

#include "studio/screen/live_of_run.hpp"
#include "studio/screen/prompt.hpp"
#include "studio/workbench/background_jobs.hpp"
#include "studio/workbench/live_run.hpp"
#include "studio/workbench/plate_switch.hpp"
#include "studio/workbench/screen.hpp"

#include <chrono>
#include <memory>
#include <optional>
#include <string>

namespace rift::studio {

/// What the panels of runs have in common: which lanes they show, and what they ask for of the run's folder.
class PanelScreen : public Screen {
 public:
  void draw(Canvas& canvas, Glyphs glyphs) override;
  [[nodiscard]] virtual const Live& live() const = 0;
  void show_velocity(bool wanted) { velocity_ = wanted; }
  [[nodiscard]] bool wants_picture() const override { return plate_.on(); }
  void take_room(const PictureRoom& room) override;
  [[nodiscard]] std::optional<ScreenPicture> picture() const override;
  [[nodiscard]] int wakened_by() const override { return plate_.descriptor(); }

 protected:
  explicit PanelScreen(AppContext& context) : jobs_(context.program), plate_(context.plate_picture) {}
  /// Drawn over the last line where something is asked.
  virtual void draw_question(Canvas&, Glyphs) {}
  /// @return whether the key was about what is shown
  bool choose(const KeyEvent& event);
  [[nodiscard]] int lanes() const { return static_cast<int>(live().lanes.size()); }

  BackgroundJobs jobs_;
  PlateSwitch plate_;
  int shown_ = 0, beside_ = -1;
  bool velocity_ = false;

 private:
  [[nodiscard]] LiveLook look_of_panel() const;

  int width_ = 0, height_ = 0;
};

/// The panel of a run that goes on elsewhere, or has ended: read only.
class WatchScreen : public PanelScreen {
 public:
  WatchScreen(AppContext& context, const std::filesystem::path& run);
  Navigation press(const KeyEvent& event) override;
  Navigation look() override;
  [[nodiscard]] Where where() const override { return Where::watch; }

  [[nodiscard]] const Live& live() const override { return live_; }

 private:
  void open_again();

  std::filesystem::path folder_;
  std::optional<LiveOfRun> run_;  // none between a run that was replaced and the one in its place
  Live live_;
};

/// The panel of a run that marches here, and is steered from here.
class RunScreen : public PanelScreen {
 public:
  /// @param leave_at_end  the screen goes when the run has ended and it could be seen for two seconds
  RunScreen(AppContext& context, RunRequest request, bool leave_at_end = false);

  Navigation press(const KeyEvent& event) override;
  Navigation look() override;
  [[nodiscard]] bool typing() const override { return value_.typing() || choosing_; }
  [[nodiscard]] Where where() const override { return Where::live; }
  [[nodiscard]] std::string last_words() const override;
  /// The plate is a picture from now on, if that can be.
  void show_picture() { (void)plate_.show({run_->folder()}); }
  /// Outlives the screen where somebody wants its result.
  [[nodiscard]] std::shared_ptr<LiveRun> run() const { return run_; }

  [[nodiscard]] const Live& live() const override { return live_; }

 private:
  void draw_question(Canvas& canvas, Glyphs glyphs) override;
  void choose_change(const KeyEvent& event);
  void begin_change();
  void ask_value(int axis);
  void take_frame();
  void toggle_film();
  [[nodiscard]] bool seen_for_a_while() const;
  [[nodiscard]] double time_us() const;  // since the crack's start
  void send_what_is_due();
  void say(std::string text) { live_.message = std::move(text); }
  Navigation act(Action action);
  [[nodiscard]] std::string value_now(int axis) const;

  std::shared_ptr<LiveRun> run_;
  Live live_;
  bool leave_at_end_, choosing_ = false, leaving_ = false, end_said_ = false, seen_ = false;
  std::chrono::steady_clock::time_point since_ = std::chrono::steady_clock::now();
  int axis_ = 0;
  Prompt value_;
  bool picture_due_ = false, film_due_ = false;  // as soon as the journal holds their frames
  double film_from_us_ = 0;
};

}  // namespace rift::studio

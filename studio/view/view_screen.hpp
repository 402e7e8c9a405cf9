#pragma once

#include "studio/screen/prompt.hpp"
#include "studio/view/player.hpp"
#include "studio/view/view_layout.hpp"
#include "studio/workbench/background_jobs.hpp"
#include "studio/workbench/screen.hpp"
#include "viz/frame_server.hpp"
#include "viz/plan.hpp"

#include <array>
#include <chrono>
#include <cstdint>
#include <functional>
#include <optional>
#include <string>
#include <vector>

namespace rift::studio {

/// The pictures of `rift render`, held in one's hands: played, turned, zoomed, and asked.
class ViewScreen : public Screen {
 public:
  /// @param request  what is shown at first;  @param program  rift, for films
  /// Throws viz::BadRequest, and WorldError where a run cannot be read.
  ViewScreen(viz::Request request, viz::Gl gl, std::filesystem::path program);

  void draw(Canvas& canvas, Glyphs glyphs) override;
  Navigation press(const KeyEvent& event) override;
  Navigation look() override;
  [[nodiscard]] bool typing() const override { return prompt_.typing(); }
  [[nodiscard]] Where where() const override { return Where::view; }
  [[nodiscard]] bool wants_picture() const override { return true; }
  void take_room(const PictureRoom& room) override;
  [[nodiscard]] std::optional<ScreenPicture> picture() const override;
  [[nodiscard]] bool wants_drags() const override { return true; }
  [[nodiscard]] int patience_ms() const override;
  [[nodiscard]] int wakened_by() const override { return server_.descriptor(); }

  /// Where the `rift render` commands go that are asked for; it outlives the screen.
  void commands_go_to(std::vector<std::string>& commands) { commands_ = &commands; }

 private:
  using Clock = std::chrono::steady_clock;

  // view_screen.cpp: the picture
  void take_news();
  void follow_runs();
  void order();
  [[nodiscard]] bool moves_now() const;
  [[nodiscard]] double share_now() const;
  [[nodiscard]] viz::Job job_of_size(double share) const;
  void take_picture();
  void take_answer();
  void show_crosshair();
  void show_at_rest();
  void draw_cells(Canvas& canvas, Glyphs glyphs);

  // view_keys.cpp: what keys do
  void act(Action action);
  bool act_on_time(Action action);
  bool act_on_look(Action action);
  bool act_on_files(Action action);
  void take_typed();
  void jump(const std::string& text);
  bool change(const std::function<void(viz::Request&)>& what);
  void next_field();
  void next_range();
  [[nodiscard]] viz::Job saved_job() const;
  [[nodiscard]] std::vector<std::string> command_of_picture() const;

  // view_camera.cpp: what moves the camera, and what is pointed at
  bool act_on_camera(Action action);
  [[nodiscard]] viz::View view_now() const;
  void look_by(const viz::View& view);
  void zoom(double factor, std::optional<std::array<double, 2>> pixel);
  void next_camera();
  void ask_at(const std::array<double, 2>& fraction);
  [[nodiscard]] std::array<double, 2> middle_of_plate() const;
  bool move_crosshair(const KeyEvent& event);
  void press_mouse(const KeyEvent& event);

  /// Every run has ended by itself: no moment comes any more.
  [[nodiscard]] bool all_ended() const;
  void touch() { touched_ = Clock::now(); }

  viz::Request request_;
  std::optional<std::string> asked_chart_;  // by the user, before any key
  std::vector<viz::Shown> shown_;
  viz::Plan plan_;
  viz::FrameServer server_;
  BackgroundJobs jobs_;
  Player player_;
  PictureRoom room_;
  bool has_room_ = false;
  int width_ = 0, height_ = 0;  // of the screen, in cells
  ViewLayout layout_;

  std::string ordered_, shown_order_;  // without what was asked: the last order, that of the picture
  bool moves_ = false;                 // the picture is one of a few pixels, or came while something moved
  bool asking_ = false;                // it asks
  Area ordered_for_, image_for_;       // the places of that order and of the picture that is there
  std::uint64_t number_ = 0;           // of the picture
  std::vector<std::uint8_t> pixels_;   // with the crosshair
  double drawn_s_ = 0;                 // that a picture of all pixels took
  Clock::time_point touched_{}, followed_{};

  enum class Asks : std::uint8_t { moment, range, magnification } asks_ = Asks::moment;
  Prompt prompt_;
  std::string message_;
  std::vector<std::string>* commands_ = nullptr;
  std::optional<std::array<double, 2>> crosshair_, asked_;  // fractions of the picture from the lower left
  std::vector<viz::Picked> picked_;                         // the last two
  std::optional<std::array<int, 2>> pressed_;               // the cell where the button went down
  bool dragged_ = false;
  std::optional<results::Frame> cells_frame_;  // what cells show
  int cells_moment_ = -1;
};

}  // namespace rift::studio

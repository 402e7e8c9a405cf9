#include "studio/workbench/lesson_screen.hpp"

#include "engine/base/child_process.hpp"
#include "engine/base/world_error.hpp"
#include "engine/results/run_folder.hpp"
#include "engine/scene/issue.hpp"
#include "studio/screen/canvas.hpp"

#include <fmt/format.h>

#include <algorithm>

namespace rift::studio {
namespace fs = std::filesystem;
namespace {

constexpr const char* handout_name = "handout.html";

/// The first of lesson_NAME, lesson_NAME-2, ... that is free, or holds only a run that no handout refers to:
/// it gives way to the new one.
fs::path folder_of(const AppContext& context, const Lesson& lesson) {
  const std::string name = fmt::format("lesson_{}", lesson.name);
  fs::path folder = context.runs / name;
  for (int k = 2; fs::exists(folder / handout_name) || results::is_folder_being_written(folder); ++k)
    folder = context.runs / fmt::format("{}-{}", name, k);
  return folder;
}

/// The lesson's run, with a few frames for the picture of its handout, and more for one that is watched as a
/// picture.
RunRequest request_of(AppContext& context, const Lesson& lesson) {
  const scene::Preset preset =
      scene::read_preset(context.presets / fmt::format("{}.toml", lesson.preset),
                         {lesson.in_pixels ? "output.frames=48" : "output.frames=12"});
  if (!preset.issues.empty()) throw scene::InputError(preset.issues);
  RunRequest request = request_for(context, preset, folder_of(context, lesson));
  request.force = true;
  return request;
}

/// Lines of a text are easier to read when they are not too long.
Area readable(const Canvas& canvas, int top) {
  const int width = std::min(canvas.width() - 4, 76);
  return {(canvas.width() - width) / 2, top, width, canvas.height() - top - 2};
}

}  // namespace

LessonScreen::LessonScreen(AppContext& context, const Lesson& lesson)
    : context_(context),
      lesson_(lesson),
      panel_(std::make_unique<RunScreen>(context, request_of(context, lesson))) {
  panel_->show_velocity(true);
  panel_->run()->pause(true);  // until the page that shows it
  message_ = "the run is kept in " + panel_->run()->folder().string();
}

Navigation LessonScreen::look() {
  (void)panel_->look();
  if (run_has_ended() || panel_->run()->stage() != LiveRun::Stage::ended) return {};
  try {
    const auto recorded = panel_->run()->result();
    if (recorded && recorded->result.outcome == simulation::Outcome::finished)
      lanes_ = results::lane_summaries_of(recorded->summary.at("scenarios"));
    else
      message_ = "the run did not finish, so it gives no answer";
  } catch (const std::exception& error) {
    message_ = error.what();
  }
  return {};
}

void LessonScreen::draw(Canvas& canvas, Glyphs glyphs) {
  if (draw_too_small(canvas)) return;
  const int last = answer_page() + 1;
  canvas.text(2, 0, lesson_.title, {Ink::title, true}, canvas.width() - 4);
  canvas.text(canvas.width() - 8, 0, fmt::format("{} of {}", page_ + 1, last), {Ink::dim});
  if (page_ < watch_page())
    draw_paragraph(canvas, readable(canvas, 3), text_of_page());
  else if (page_ == watch_page())
    draw_watch(canvas, {0, 1, canvas.width(), canvas.height() - 2}, glyphs);
  else if (page_ == question_page())
    draw_question(canvas, readable(canvas, 3));
  else
    draw_answer(canvas, readable(canvas, 3));
  if (!message_.empty()) canvas.text(2, canvas.height() - 2, message_, {Ink::reference}, canvas.width() - 4);
  const Area foot{1, canvas.height() - 1, canvas.width() - 2, 1};
  if (leave_.typing())
    leave_.draw(canvas, foot, {Ink::reference, true});
  else if (page_ != watch_page() || !panel_->typing())
    canvas.text(foot.x, foot.y,
                foot_of(where(), foot.width, run_has_ended() ? Action::none : Action::handout), {Ink::dim});
}

std::string_view LessonScreen::text_of_page() const {
  const auto page = static_cast<std::size_t>(page_);
  return page < lesson_.before.size() ? lesson_.before[page] : theory_page();
}

void LessonScreen::draw_watch(Canvas& canvas, const Area& area, Glyphs glyphs) {
  const int text = draw_paragraph(canvas, {2, area.y, area.width - 4, 4}, lesson_.watch, {Ink::reference});
  panel_top_ = area.y + text;
  Canvas panel(area.width, std::max(least_height, area.height - text + 1));
  panel_->draw(panel, glyphs);
  for (int y = 0; y < panel.height() && area.y + text + y < canvas.height(); ++y)
    for (int x = 0; x < panel.width(); ++x)
      canvas.put(x, area.y + text + y, panel.at(x, y).glyph, panel.at(x, y).style);
  if (!panel_->typing()) clear(canvas, {0, canvas.height() - 1, canvas.width(), 1});
}

void LessonScreen::draw_question(Canvas& canvas, const Area& area) const {
  int y = area.y + draw_paragraph(canvas, area, lesson_.question, {Ink::title, true}) + 1;
  for (int k = 0; k < static_cast<int>(lesson_.choices.size()); ++k)
    canvas.text(area.x + 2, y++, fmt::format("{}  {}", k + 1, lesson_.choices[k]),
                {Ink::plain, false, k == chosen_}, area.width - 2);
  canvas.text(area.x, y + 1,
              run_has_ended() ? "Press the number of your answer."
                              : "The run continues; press the number of your answer.",
              {Ink::dim}, area.width);
}

void LessonScreen::draw_answer(Canvas& canvas, const Area& area) const {
  if (!run_has_ended()) {
    draw_paragraph(canvas, area, "The run has not finished yet. Its result gives the answer.", {Ink::dim});
    return;
  }
  const Answer answer = lesson_.answer(lanes_);
  int y = area.y;
  const auto paragraph = [&](std::string_view text, const Style& style) {
    y += draw_paragraph(canvas, {area.x, y, area.width, area.y + area.height - y}, text, style) + 1;
  };
  if (chosen_ >= 0)
    paragraph(
        chosen_ == answer.right ? "Right." : fmt::format("Your answer was: {}.", lesson_.choices[chosen_]),
        {chosen_ == answer.right ? Ink::good : Ink::bad, true});
  paragraph(fmt::format("The answer of this run: {}.", lesson_.choices[answer.right]), {Ink::title, true});
  paragraph(answer.why, {});
  paragraph(lesson_.after, {});
}

void LessonScreen::go_to(int page) {
  page_ = std::clamp(page, 0, answer_page());
  if (page_ >= watch_page()) panel_->run()->pause(false);
}

/// Drawn by another call of rift, which is waited for: a second or two.
LessonPicture LessonScreen::handout_picture() const try {
  const fs::path run = panel_->run()->folder(), png = run / "handout.png";
  base::ChildProcess render({context_.program.string(), "render", run.string(), "--field", "vy", "--at",
                             "0.3", "--picture", png.string(), "--quiet"},
                            {});
  const base::ChildProcess::End& end = render.wait();
  if (end.code == 0 && fs::exists(png)) return {png, {}};
  return {{}, end.words.empty() ? "rift render gave no reason" : end.words};
} catch (const base::WorldError& error) {
  return {{}, error.what()};
}

void LessonScreen::write() try {
  if (!run_has_ended()) {
    message_ = "the handout needs the results of the run: write it when the run has finished";
    return;
  }
  const fs::path file = panel_->run()->folder() / handout_name;
  write_handout(lesson_, lanes_, panel_->live(), handout_picture(), file);
  message_ = "handout: " + file.string();
} catch (const std::exception& error) {
  message_ = error.what();
}

bool LessonScreen::wants_picture() const {
  return page_ == watch_page() && (panel_->wants_picture() || (lesson_.in_pixels && !picture_begun_));
}

/// A lesson that is taught with the picture begins with it where the terminal has pixels.
void LessonScreen::take_room(const PictureRoom& room) {
  if (!picture_begun_ && lesson_.in_pixels && room.pictures && !room.symbols) panel_->show_picture();
  picture_begun_ = true;
  panel_->take_room(room);
}

std::optional<ScreenPicture> LessonScreen::picture() const {
  std::optional<ScreenPicture> picture;
  if (page_ == watch_page() && !leave_.typing()) picture = panel_->picture();
  if (picture) picture->area.y += panel_top_;
  return picture;
}

/// Asks where the run has not finished.
Navigation LessonScreen::leave() {
  if (panel_->run()->stage() == LiveRun::Stage::ended) return {Navigation::To::back, nullptr};
  leave_ = Prompt("the run has not finished, and without it there is no answer: leave? yes or no", "");
  return {};
}

Navigation LessonScreen::press(const KeyEvent& event) {
  if (leave_.typing()) {
    if (leave_.press(event) != Prompt::State::entered || leave_.text() != "yes") return {};
    panel_->run()->stop();
    return {Navigation::To::back, nullptr};
  }
  if (typing()) return panel_->press(event);
  message_.clear();
  const int asked = event.key - '1';
  if (page_ == question_page() && asked >= 0 && asked < static_cast<int>(lesson_.choices.size())) {
    chosen_ = asked;
    go_to(answer_page());
    return {};
  }
  switch (action_of(where(), event.key)) {
    case Action::next:
      go_to(page_ + 1);
      return {};
    case Action::previous:
      go_to(page_ - 1);
      return {};
    case Action::handout:
      write();
      return {};
    case Action::back:
      return leave();
    default:
      return page_ == watch_page() ? panel_->press(event) : Navigation{};
  }
}

}  // namespace rift::studio

#pragma once

#include "studio/screen/prompt.hpp"
#include "studio/workbench/lesson.hpp"
#include "studio/workbench/panel_screen.hpp"
#include "studio/workbench/screen.hpp"

#include <memory>
#include <optional>
#include <string>

namespace rift::studio {

/// A lesson page by page: texts, the ensemble live, the question, the answer out of the run.
class LessonScreen : public Screen {
 public:
  LessonScreen(AppContext& context, const Lesson& lesson);

  void draw(Canvas& canvas, Glyphs glyphs) override;
  Navigation press(const KeyEvent& event) override;
  Navigation look() override;
  [[nodiscard]] bool typing() const override {
    return leave_.typing() || (page_ == watch_page() && panel_->typing());
  }
  [[nodiscard]] Where where() const override {
    return page_ == watch_page() ? Where::lesson_run : Where::lesson;
  }
  [[nodiscard]] bool wants_picture() const override;
  void take_room(const PictureRoom& room) override;
  [[nodiscard]] std::optional<ScreenPicture> picture() const override;
  [[nodiscard]] int wakened_by() const override { return panel_->wakened_by(); }

 private:
  [[nodiscard]] int watch_page() const { return static_cast<int>(lesson_.before.size()) + 1; }
  [[nodiscard]] int question_page() const { return watch_page() + 1; }
  [[nodiscard]] int answer_page() const { return watch_page() + 2; }
  [[nodiscard]] bool run_has_ended() const { return !lanes_.empty(); }
  void draw_watch(Canvas& canvas, const Area& area, Glyphs glyphs);
  void draw_question(Canvas& canvas, const Area& area) const;
  void draw_answer(Canvas& canvas, const Area& area) const;
  void go_to(int page);
  [[nodiscard]] std::string_view text_of_page() const;
  [[nodiscard]] LessonPicture handout_picture() const;
  Navigation leave();
  void write();

  AppContext& context_;
  const Lesson& lesson_;
  std::unique_ptr<RunScreen> panel_;
  Lanes lanes_;  // none as long as it runs
  int page_ = 0, chosen_ = -1;
  int panel_top_ = 0;          // the row in which the panel begins
  bool picture_begun_ = false;  // the lesson's own choice of cells or picture has been made
  Prompt leave_;
  std::string message_;
};

}  // namespace rift::studio

#pragma once

#include "studio/screen/prompt.hpp"
#include "studio/text/catalogue.hpp"
#include "studio/workbench/background_jobs.hpp"
#include "studio/workbench/home_preview.hpp"
#include "studio/workbench/lesson.hpp"
#include "studio/workbench/screen.hpp"

#include <optional>
#include <set>
#include <string>
#include <vector>

namespace rift::studio {

/// Presets by what they are for, and what has been computed: the first screen.
class HomeScreen : public Screen {
 public:
  explicit HomeScreen(AppContext& context);

  void draw(Canvas& canvas, Glyphs glyphs) override;
  Navigation press(const KeyEvent& event) override;
  Navigation look() override;
  void resume() override { read(); }
  [[nodiscard]] bool typing() const override { return search_.typing() || question_.typing(); }
  [[nodiscard]] Where where() const override { return Where::home; }
  [[nodiscard]] bool wants_picture() const override { return preview_.on(); }
  void take_room(const PictureRoom& room) override { preview_.take_room(room); }
  [[nodiscard]] std::optional<ScreenPicture> picture() const override { return preview_.picture(); }
  [[nodiscard]] int wakened_by() const override { return preview_.descriptor(); }

 private:
  /// A line of the list: a group's name, a preset, a lesson or a run.
  struct Row {
    std::string group;
    std::optional<PresetEntry> preset;
    std::optional<RunEntry> run;
    const Lesson* lesson = nullptr;
    [[nodiscard]] bool heading() const { return !preset && !run && lesson == nullptr; }
    [[nodiscard]] std::string name() const {
      return preset ? preset->name : run ? run->name : lesson ? std::string(lesson->name) : group;
    }
    /// By which it is the same when the list is read again.
    [[nodiscard]] std::string place() const {
      return preset ? preset->path.string() : run ? run->path.string() : name();
    }
    [[nodiscard]] std::string shows() const {
      return preset ? preset->shows : lesson ? std::string(lesson->title) : std::string();
    }
  };

  void read();
  void add_presets();
  void filter();
  [[nodiscard]] const Row* chosen() const;
  void draw_row(Canvas& canvas, const Area& line, const Row& row, bool is_chosen) const;
  void draw_detail(Canvas& canvas, const Area& area) const;
  void skip_headings(int way);
  void next_group();
  void toggle_mark();
  Navigation take(const KeyEvent& event);
  Navigation act(Action action);
  Navigation open(bool as_form);
  Navigation compare_marked();
  Navigation resume_chosen();
  void answer_question();

  AppContext& context_;
  BackgroundJobs jobs_;
  HomePreview preview_;
  std::vector<Row> all_, rows_;
  std::set<std::filesystem::path> marked_;
  ListView list_;
  Prompt search_, question_;
  std::string wanted_;  // letters that a row must hold
  std::string message_;
  std::filesystem::path to_remove_;
  int list_rows_ = 10, list_width_ = 0, longest_name_ = 20;
};

}  // namespace rift::studio

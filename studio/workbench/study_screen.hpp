#pragma once

#include "engine/base/clock.hpp"
#include "engine/study/runner.hpp"
#include "engine/study/store.hpp"
#include "studio/screen/prompt.hpp"
#include "studio/workbench/screen.hpp"
#include "studio/workbench/study_table.hpp"

#include <atomic>
#include <mutex>
#include <string>
#include <thread>
#include <vector>

namespace rift::studio {

/// A study as it fills: its grid as a heat map, the ratio against velocity with the theory, and the
/// difference to Broberg against run time.
class StudyScreen : public Screen {
 public:
  /// Begins, or goes on, in a thread of its own.
  StudyScreen(AppContext& context, scene::Preset preset, std::filesystem::path folder);
  /// Shows what has been computed, and goes on only where it is asked to.
  StudyScreen(AppContext& context, study::StoredStudy stored, std::filesystem::path folder);
  /// Stops it: what has been computed is kept.
  ~StudyScreen() override;

  void draw(Canvas& canvas, Glyphs glyphs) override;
  Navigation press(const KeyEvent& event) override;
  Navigation look() override;
  [[nodiscard]] Where where() const override { return Where::study; }
  [[nodiscard]] std::string last_words() const override;

 private:
  void begin();
  void work();
  void follow_others();
  [[nodiscard]] bool in_colour(int row) const;
  [[nodiscard]] Ink ink_of_row(int row) const;
  [[nodiscard]] std::vector<int> rows_in_colour() const;
  void draw_chosen(Canvas& canvas, const Area& area) const;
  void draw_grid(Canvas& canvas, const Area& area);
  void draw_cell_of(Canvas& canvas, int x, int y, int wide, int row, int column) const;
  void draw_velocities(Canvas& canvas, const Area& area, Glyphs glyphs) const;
  void draw_errors(Canvas& canvas, const Area& area, Glyphs glyphs) const;

  AppContext& context_;
  scene::Preset preset_;
  std::filesystem::path folder_;
  StudyTable table_;
  ListView list_;  // rows of the table
  int list_rows_ = 10;
  std::atomic<bool> stop_ = false, ended_ = false;
  mutable std::mutex mutex_;
  std::string stage_ = "begins";
  double done_ = 0;
  StudyResults rows_;  // by their place in the study; none: not yet
  std::string message_;
  bool leaving_ = false;
  base::Clock::time_point followed_ = base::Clock::now();
  StudyResults shown_;  // the panel's own copy
  std::jthread thread_;
};

}  // namespace rift::studio

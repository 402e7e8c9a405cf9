#pragma once

#include "engine/results/lane_summary.hpp"
#include "studio/screen/live_of_run.hpp"
#include "studio/workbench/plate_switch.hpp"
#include "studio/workbench/screen.hpp"

#include <deque>
#include <filesystem>
#include <string>
#include <vector>

namespace rift::studio {

/// Runs beside each other: their numbers in columns, their release rates over one another, and their plates
/// at one moment.
class CompareScreen : public Screen {
 public:
  /// Throws WorldError where a run cannot be read. Up to eight lanes are shown.
  CompareScreen(const AppContext& context, const std::vector<std::filesystem::path>& runs);

  void draw(Canvas& canvas, Glyphs glyphs) override;
  Navigation press(const KeyEvent& event) override;
  Navigation look() override;
  [[nodiscard]] Where where() const override { return Where::compare; }
  [[nodiscard]] bool wants_picture() const override { return plates_shown_; }
  void take_room(const PictureRoom& room) override;
  [[nodiscard]] std::optional<ScreenPicture> picture() const override { return plates_.picture(); }
  [[nodiscard]] int wakened_by() const override { return plates_.descriptor(); }

 private:
  struct Column {
    std::string title;
    const Live& run;
    const LiveLane& lane;
    results::LaneSummary summary;  // undefined where the run has not ended
  };
  void draw_table(Canvas& canvas, const Area& area, Glyphs glyphs) const;
  void draw_rates(Canvas& canvas, const Area& area, Glyphs glyphs) const;
  void draw_plates(Canvas& canvas, const Area& area, Glyphs glyphs) const;
  [[nodiscard]] std::vector<std::filesystem::path> runs_with_plates() const;
  void act(Action action);

  std::vector<std::filesystem::path> folders_;
  std::deque<LiveOfRun> runs_;
  std::vector<Column> columns_;
  PlateSwitch plates_;
  bool plates_shown_ = false, velocity_ = false;
  double until_ = 1;  // of the stored moments
  Area place_;        // of the plates
  double length_ = 0;  // the longest plate [m]
  std::size_t left_out_ = 0;
  int first_row_ = 0;
};

}  // namespace rift::studio

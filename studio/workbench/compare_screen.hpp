#pragma once

#include "engine/results/lane_summary.hpp"
#include "studio/screen/live.hpp"
#include "studio/workbench/screen.hpp"

#include <string>
#include <vector>

namespace rift::studio {

/// Runs beside each other: their numbers in columns, their release rates over one another.
class CompareScreen : public Screen {
 public:
  /// Throws WorldError where a run cannot be read. Up to eight lanes are shown.
  explicit CompareScreen(const std::vector<std::filesystem::path>& runs);

  void draw(Canvas& canvas, Glyphs glyphs) override;
  Navigation press(const KeyEvent& event) override;
  [[nodiscard]] Where where() const override { return Where::compare; }

 private:
  struct Column {
    std::string title;
    LiveLane lane;
    results::LaneSummary summary;  // undefined where the run has not ended
  };
  void draw_table(Canvas& canvas, const Area& area, Glyphs glyphs) const;
  void draw_rates(Canvas& canvas, const Area& area, Glyphs glyphs) const;

  std::vector<Column> columns_;
  double length_ = 0;  // the longest plate [m]
  std::size_t left_out_ = 0;
  int first_row_ = 0;
};

}  // namespace rift::studio

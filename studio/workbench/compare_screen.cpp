#include "studio/workbench/compare_screen.hpp"

#include "engine/base/files.hpp"
#include "engine/results/archive.hpp"
#include "engine/results/json_input.hpp"
#include "studio/screen/canvas.hpp"
#include "studio/screen/curves.hpp"
#include "studio/screen/layouts.hpp"
#include "studio/screen/plate.hpp"
#include "studio/text/comparison.hpp"
#include "studio/text/table.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>

namespace rift::studio {
namespace {

constexpr std::size_t most_columns = 8;
constexpr std::size_t most_plates = 4;
constexpr std::array inks{Ink::fracture, Ink::elastic, Ink::kinetic, Ink::damping,
                          Ink::good,     Ink::bad,     Ink::plain,   Ink::reference};

/// The summaries of a run's lanes; none where it has not ended.
std::vector<results::LaneSummary> summaries_of(const std::filesystem::path& run) {
  const auto file = run / results::summary_name;
  if (!std::filesystem::exists(file)) return {};
  return results::lane_summaries_of(results::read_json(base::read_whole_file(file), file).at("scenarios"));
}

}  // namespace

CompareScreen::CompareScreen(const AppContext& context, const std::vector<std::filesystem::path>& runs)
    : folders_(runs), plates_(context.plate_picture) {
  for (const std::filesystem::path& path : runs) {
    const LiveOfRun& run = runs_.emplace_back(path);
    const std::vector<results::LaneSummary> summaries = summaries_of(path);
    length_ = std::max(length_, run.live().length);
    for (std::size_t k = 0; k < run.live().lanes.size(); ++k) {
      if (columns_.size() == most_columns) {
        ++left_out_;
        continue;
      }
      const LiveLane& lane = run.live().lanes[k];
      columns_.push_back({fmt::format("{}: {}", run.live().name, lane.title), run.live(), lane,
                          k < summaries.size() ? summaries[k] : results::LaneSummary{}});
    }
  }
}

void CompareScreen::draw(Canvas& canvas, Glyphs glyphs) {
  if (draw_too_small(canvas)) return;
  const int count = static_cast<int>(columns_.size());
  const CompareLayout layout = compare_layout(canvas.width(), canvas.height(), count, plates_shown_);
  std::string title = fmt::format("{} scenarios side by side", count);
  if (left_out_ > 0) title += fmt::format("; {} more do not fit", left_out_);
  canvas.text(layout.head.x, layout.head.y, title, {Ink::title, true}, layout.head.width);
  for (int k = 0; k < layout.titles.height; ++k)
    canvas.text(layout.titles.x, layout.titles.y + k, fmt::format("{} {}", k + 1, columns_[k].title),
                {inks[k], true}, layout.titles.width);
  if (!layout.table.empty()) draw_table(canvas, layout.table, glyphs);
  place_ = layout.plates;
  if (!place_.empty()) draw_plates(canvas, place_, glyphs);
  if (!layout.rates.empty()) draw_rates(canvas, layout.rates, glyphs);
  canvas.text(layout.foot.x, layout.foot.y, foot_of(Where::compare, layout.foot.width), {Ink::dim});
}

void CompareScreen::draw_table(Canvas& canvas, const Area& area, Glyphs glyphs) const {
  constexpr int names = 22, numbers = 9;
  for (int k = 0; k < static_cast<int>(columns_.size()); ++k)
    canvas.text(area.x + names + numbers * k, area.y, fmt::format("{:>{}}", k + 1, numbers - 1),
                {inks[k], true}, area.width - names - numbers * k);
  for (int y = 1; y < area.height; ++y) {
    const std::size_t row = static_cast<std::size_t>(y - 1 + first_row_);
    if (row >= compared_quantities().size()) return;
    canvas.text(area.x, area.y + y, letters_for(glyphs, compared_quantities()[row].name), {Ink::dim}, names);
    for (int k = 0; k < static_cast<int>(columns_.size()); ++k)
      canvas.text(area.x + names + numbers * k, area.y + y,
                  fmt::format("{:>{}}",
                              number_cell(columns_[k].summary.*compared_quantities()[row].number,
                                          compared_quantities()[row].format),
                              numbers - 1),
                  {}, area.width - names - numbers * k);
  }
}

void CompareScreen::draw_rates(Canvas& canvas, const Area& area, Glyphs glyphs) const {
  std::vector<Curve> curves;
  double most = 1.2;
  for (std::size_t k = 0; k < columns_.size(); ++k) {
    Curve& curve = curves.emplace_back();
    curve.style = {inks[k]};
    for (const results::RatePoint& p : columns_[k].lane.rates) {
      curve.points.push_back({1e3 * p.tip_m, p.ratio});
      most = std::max(most, std::min(p.ratio, 3.0));
    }
  }
  draw_curves(canvas, area, {{0, 1e3 * length_}, {0, most}, "tip [mm]", "G_ID/G_I0"}, curves, glyphs);
}

/// In cells the plates of the first two, one above the other.
void CompareScreen::draw_plates(Canvas& canvas, const Area& area, Glyphs glyphs) const {
  if (plates_.in_pixels()) return plates_.draw_trouble(canvas, area);
  const int count = std::min(2, static_cast<int>(columns_.size())), rows = area.height / count;
  for (int k = 0; k < count; ++k) {
    const Column& c = columns_[k];
    const int y = area.y + k * rows;
    canvas.text(area.x, y, fmt::format("{} {}", k + 1, c.title), {inks[k], true}, area.width);
    draw_plate(canvas, {area.x, y + 1, area.width, rows - 1}, *c.run.geometry, c.lane.displacement,
               {.length = c.run.length, .height = c.run.height, .pulled = c.run.pulled, .tips = c.lane.tips},
               glyphs);
  }
}

/// A picture has up to four: the lanes of all runs, or where those are more the first lane of each.
std::vector<std::filesystem::path> CompareScreen::runs_with_plates() const {
  return {folders_.begin(), folders_.begin() + std::min<std::ptrdiff_t>(most_plates, std::ssize(folders_))};
}

void CompareScreen::take_room(const PictureRoom& room) {
  plates_.take_room(room);
  if (plates_shown_ && room.pictures && plates_.can() && !plates_.on()) (void)plates_.show(runs_with_plates());
}

Navigation CompareScreen::look() {
  PlateView view{
      .lanes = {}, .velocity = velocity_, .titles = !plates_.room().symbols, .until = until_};
  if (columns_.size() + left_out_ > most_plates) view.lanes = {0};
  plates_.look(place_, view);
  return {};
}

void CompareScreen::act(Action action) {
  constexpr double moment = 0.025;
  const int last = static_cast<int>(compared_quantities().size()) - 1;
  switch (action) {
    case Action::down:
      first_row_ = std::min(first_row_ + 1, last);
      return;
    case Action::up:
      first_row_ = std::max(first_row_ - 1, 0);
      return;
    case Action::picture:
      plates_shown_ = !plates_shown_;
      plates_.show_cells();
      return;
    case Action::velocity:
      velocity_ = !velocity_;
      return;
    case Action::step:
      until_ = std::min(1.0, until_ + moment);
      return;
    case Action::previous:
      until_ = std::max(0.0, until_ - moment);
      return;
    default:
      return;
  }
}

Navigation CompareScreen::press(const KeyEvent& event) {
  const Action action = action_of(Where::compare, event.key);
  if (action == Action::back) return {Navigation::To::back, nullptr};
  act(action);
  return {};
}

}  // namespace rift::studio

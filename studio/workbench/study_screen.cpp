#include "studio/workbench/study_screen.hpp"

#include "engine/base/files.hpp"
#include "engine/theory/references.hpp"
#include "studio/reports/study_report.hpp"
#include "studio/reports/work_precision.hpp"
#include "studio/screen/canvas.hpp"
#include "studio/screen/curves.hpp"
#include "studio/screen/layouts.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>

namespace rift::studio {
namespace {

/// The axis whose values make the columns: the velocity where it is varied, else the last one.
std::size_t column_axis(const scene::Preset& preset) {
  const auto& axes = preset.study.front().axes;
  for (std::size_t k = 0; k < axes.size(); ++k)
    if (axes[k].first == "crack_velocity") return k;
  return axes.size() - 1;
}

/// "progressive linear r_l 4 seed 1": words speak for themselves, numbers by the name of their axis.
std::string row_name(const scene::StudyRow& row, std::size_t without) {
  std::string name;
  for (std::size_t k = 0; k < row.axes.size(); ++k) {
    const auto& [axis, value] = row.axes[k];
    if (k == without || value == "-") continue;
    const bool number = value.find_first_not_of("0123456789.e-+") == std::string::npos;
    const std::string label = axis == "damage_zone_ratio" ? "r_l" : axis == "damping_alpha" ? "alpha" : axis;
    name += (name.empty() ? "" : " ") + (number ? label + " " + value : value);
  }
  return name;
}

}  // namespace

StudyScreen::StudyScreen(AppContext& context, scene::Preset preset, std::filesystem::path folder)
    : context_(context), preset_(std::move(preset)), folder_(std::move(folder)), rows_(preset_.study.size()) {
  begin();
}

StudyScreen::StudyScreen(AppContext& context, study::StoredStudy stored, std::filesystem::path folder)
    : context_(context),
      preset_(std::move(stored.preset)),
      folder_(std::move(folder)),
      ended_(true),
      rows_(std::move(stored.rows)),
      shown_(rows_) {
  const bool complete =
      std::all_of(rows_.begin(), rows_.end(), [](const auto& row) { return row.has_value(); });
  message_ = !stored.notes.empty() ? stored.notes.front()
             : complete            ? fmt::format("{}/report.html", folder_.string())
                                   : "press u to resume it";
}

StudyScreen::~StudyScreen() { stop_ = true; }

/// Starts the thread that computes; the one before, if any, has ended.
void StudyScreen::begin() {
  stop_ = ended_ = false;
  thread_ = std::jthread([this] { work(); });
}

void StudyScreen::work() {
  study::StudyObserver observer;
  observer.progress = [this](std::string_view stage, double done) {
    const std::lock_guard lock(mutex_);
    stage_ = stage, done_ = done;
    return !stop_;
  };
  observer.finished = [this](const study::SummaryRow& row, int, int) {
    const std::lock_guard lock(mutex_);
    rows_[static_cast<std::size_t>(row.row)] = row;
  };
  std::string message;
  try {
    base::Cache cache = context_.cache;
    study::StudyResult result = study::run_study(preset_, {.folder = folder_, .threads = context_.threads},
                                                 cache, context_.build, observer);
    result.rows = with_converged_errors(std::move(result.rows));
    if (const std::string csv = study_csv(to_json(result.rows)); !csv.empty())
      base::write_whole_file(folder_ / "table.csv", csv);
    if (result.outcome != simulation::Outcome::stopped)
      write_study_report(preset_, {"rift studio " + preset_.name, context_.build, result.wall_s}, result,
                         folder_);
    message = result.outcome == simulation::Outcome::stopped
                  ? "stopped; press u to resume it"
                  : fmt::format("done: {}/report.html", folder_.string());
  } catch (const std::exception& error) {
    message = error.what();
  }
  const std::lock_guard lock(mutex_);
  message_ = message;
  ended_ = true;
}

Navigation StudyScreen::look() {
  const std::lock_guard lock(mutex_);
  shown_ = rows_;
  return leaving_ && ended_ ? Navigation{Navigation::To::back, nullptr} : Navigation{};
}

void StudyScreen::draw(Canvas& canvas, Glyphs glyphs) {
  if (draw_too_small(canvas)) return;
  const StudyLayout layout = study_layout(canvas.width(), canvas.height());
  {
    const std::lock_guard lock(mutex_);
    const auto computed =
        std::count_if(shown_.begin(), shown_.end(), [](const auto& row) { return row.has_value(); });
    int x = 1 + canvas.text(1, 0, folder_.filename().string(), {Ink::title, true}, layout.head.width) + 2;
    x += canvas.text(x, 0, fmt::format("{} of {} scenarios", computed, shown_.size()), {Ink::good, true}) + 2;
    canvas.text(x, 0, ended_ ? message_ : fmt::format("{}  {:.0f} %", stage_, 100 * done_), {Ink::dim},
                layout.head.width - x);
  }
  canvas.text(layout.foot.x, layout.foot.y, foot_of(Where::study, layout.foot.width), {Ink::dim});
  draw_grid(canvas, layout.grid);
  draw_velocities(canvas, layout.velocities, glyphs);
  draw_errors(canvas, layout.errors, glyphs);
}

/// Every scenario is a cell of its ratio, red above Broberg and blue below.
void StudyScreen::draw_grid(Canvas& canvas, const Area& area) const {
  const std::size_t axis = column_axis(preset_);
  std::vector<std::string> columns, names;
  std::map<std::pair<std::string, std::string>, std::size_t> cell;
  const auto add = [](std::vector<std::string>& all, const std::string& one) {
    if (std::find(all.begin(), all.end(), one) == all.end()) all.push_back(one);
  };
  for (std::size_t k = 0; k < preset_.study.size(); ++k) {
    const scene::StudyRow& row = preset_.study[k];
    add(columns, row.axes[axis].second);
    add(names, row_name(row, axis));
    cell[{row_name(row, axis), row.axes[axis].second}] = k;
  }
  std::size_t longest = 8;
  for (const std::string& name : names) longest = std::max(longest, letters_of(name).size());
  const int label = std::min(static_cast<int>(longest) + 1, area.width / 2);
  const int wide = std::clamp((area.width - label) / static_cast<int>(columns.size()), 3, 10);
  canvas.text(area.x, area.y, preset_.study.front().axes[axis].first, {Ink::dim}, label - 1);
  for (std::size_t c = 0; c < columns.size(); ++c)
    canvas.text(area.x + label + static_cast<int>(c) * wide, area.y,
                fmt::format("{:>{}}", columns[c], wide - 1), {Ink::dim},
                std::min(wide - 1, area.width - label - static_cast<int>(c) * wide));
  for (std::size_t r = 0; r < names.size() && static_cast<int>(r) + 1 < area.height; ++r) {
    const int y = area.y + 1 + static_cast<int>(r);
    canvas.text(area.x, y, names[r], {}, label - 1);
    for (std::size_t c = 0; c < columns.size(); ++c) {
      const auto found = cell.find({names[r], columns[c]});
      const int x = area.x + label + static_cast<int>(c) * wide;
      if (found == cell.end() || x + wide > area.x + area.width) continue;
      const std::optional<results::LaneSummary>& row = shown_[found->second];
      if (!row) {
        canvas.text(x, y, fmt::format("{:>{}}", ".", wide - 1), {Ink::dim});
      } else {
        const double off = row->error_broberg;
        const Ink ink = std::isnan(off) ? Ink::plain
                        : off > 0.05    ? Ink::bad
                        : off < -0.05   ? Ink::elastic
                                        : Ink::good;
        const std::string text = std::isnan(row->ratio) ? row->outcome : fmt::format("{:.3f}", row->ratio);
        canvas.text(x + 1, y, fmt::format("{:^{}}", text, wide - 1), {ink, true, true}, wide - 1);
      }
    }
  }
  if (static_cast<int>(names.size()) + 1 < area.height)
    canvas.text(area.x, area.y + static_cast<int>(names.size()) + 1,
                "G_ID/G_I0; green: within 0.05 of Broberg, red: above, blue: below", {Ink::dim}, area.width);
}

void StudyScreen::draw_velocities(Canvas& canvas, const Area& area, Glyphs glyphs) const {
  std::vector<Curve> curves;
  const scene::Scene::Material& m = preset_.study.front().scene.material;
  double fastest = 0.8, most = 1.2;
  std::map<std::string, std::vector<std::array<double, 2>>> by_name;
  const std::size_t axis = column_axis(preset_);
  for (std::size_t k = 0; k < shown_.size(); ++k) {
    if (!shown_[k]) continue;
    const double v = shown_[k]->crack_velocity_over_cr, ratio = shown_[k]->ratio;
    if (std::isnan(v) || std::isnan(ratio)) continue;
    by_name[row_name(preset_.study[k], axis)].push_back({v, ratio});
    fastest = std::max(fastest, v), most = std::max(most, std::min(ratio, 3.0));
  }
  Curve broberg{{}, {Ink::reference}}, strip{{}, {Ink::dim}};
  for (int k = 1; k <= 60; ++k) {
    const double v = std::min(fastest, 1.0) * k / 60.0;
    broberg.points.push_back({v, theory::broberg(v, m.poisson_ratio, m.plane).g});
    strip.points.push_back({v, theory::strip(v, m.poisson_ratio, m.plane).g});
  }
  curves.push_back(broberg), curves.push_back(strip);
  constexpr Ink inks[] = {Ink::fracture, Ink::elastic, Ink::kinetic, Ink::damping, Ink::good, Ink::bad};
  std::size_t next = 0;
  for (auto& [name, points] : by_name) {
    std::sort(points.begin(), points.end());
    curves.push_back({points, {inks[next++ % std::size(inks)], true}});
  }
  draw_curves(canvas, area, {{0, fastest}, {0, most}, "v [c_R]", "G_ID/G_I0; lines: Broberg, strip"}, curves,
              glyphs);
}

/// Points appear as the scenarios end: |difference to Broberg| against run time, both logarithmic.
void StudyScreen::draw_errors(Canvas& canvas, const Area& area, Glyphs glyphs) const {
  std::vector<Curve> curves;
  double low = 1e9, high = -1e9, small = 1e9, large = -1e9;
  for (const std::optional<results::LaneSummary>& row : shown_) {
    if (!row) continue;
    const double seconds = row->wall_fracture_s, error = std::abs(row->error_broberg);
    if (!(seconds > 0) || !(error > 0)) continue;
    const double x = std::log10(seconds), y = std::log10(error);
    low = std::min(low, x), high = std::max(high, x), small = std::min(small, y), large = std::max(large, y);
    curves.push_back({{{x, y}}, {Ink::fracture, true}});
  }
  if (curves.empty()) low = -1, high = 1, small = -3, large = 0;
  draw_curves(canvas, area,
              {{std::floor(low), std::ceil(high + 1e-9) + 0.0},
               {std::floor(small), std::ceil(large + 1e-9) + 0.0},
               "log10 (run time [s])",
               "log10 |difference to Broberg|"},
              curves, glyphs);
}

Navigation StudyScreen::press(const KeyEvent& event) {
  switch (action_of(Where::study, event.key)) {
    case Action::resume:
      if (ended_) begin();
      return {};
    case Action::stop:
      stop_ = true;
      return {};
    case Action::back:
      if (ended_) return {Navigation::To::back, nullptr};
      stop_ = leaving_ = true;
      return {};
    default:
      return {};
  }
}

std::string StudyScreen::last_words() const {
  return fmt::format(
      "the study is stored in {}: the workbench or 'rift study' with the same preset continues it\n",
      folder_.string());
}

}  // namespace rift::studio

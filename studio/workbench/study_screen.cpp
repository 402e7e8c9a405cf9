#include "studio/workbench/study_screen.hpp"

#include "engine/base/files.hpp"
#include "engine/base/text.hpp"
#include "engine/study/status.hpp"
#include "engine/theory/references.hpp"
#include "studio/reports/study_report.hpp"
#include "studio/reports/work_precision.hpp"
#include "studio/screen/canvas.hpp"
#include "studio/screen/curves.hpp"
#include "studio/screen/layouts.hpp"
#include "studio/text/progress.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <set>

namespace rift::studio {
namespace {

/// Inks that differ on every terminal, for as many curves at a time.
constexpr std::array curve_inks{Ink::fracture, Ink::elastic, Ink::kinetic, Ink::damping, Ink::plain};
constexpr int curves_at_a_time = static_cast<int>(curve_inks.size());

constexpr double near_broberg = 0.05;

/// What a cell of the table says beside its number: above, below or within near_broberg.
struct Verdict {
  Ink ink;
  const char* sign;
};
Verdict verdict_on(double difference) {
  if (std::isnan(difference)) return {Ink::plain, " "};
  if (difference > near_broberg) return {Ink::bad, "+"};
  if (difference < -near_broberg) return {Ink::elastic, "-"};
  return {Ink::good, " "};
}

/// "16 running on 2 nodes, 5 waiting; about 3 min left"
std::string elsewhere_text(const study::StudyStatus& status) {
  std::set<std::string> nodes;
  for (const study::Worker& worker : status.workers)
    if (worker.lives) nodes.insert(worker.host);
  std::string text =
      fmt::format("{} running on {} {}", status.running, nodes.size(), nodes.size() == 1 ? "node" : "nodes");
  if (status.waiting() > 0) text += fmt::format(", {} waiting", status.waiting());
  if (status.lost > 0) text += fmt::format(", {} lost", status.lost);
  if (std::isfinite(status.left_s)) text += fmt::format("; about {} left", duration_text(status.left_s));
  return text;
}

}  // namespace

StudyScreen::StudyScreen(AppContext& context, scene::Preset preset, std::filesystem::path folder)
    : context_(context),
      preset_(std::move(preset)),
      folder_(std::move(folder)),
      table_(preset_),
      rows_(preset_.study.size()) {
  begin();
}

StudyScreen::StudyScreen(AppContext& context, study::StoredStudy stored, std::filesystem::path folder)
    : context_(context),
      preset_(std::move(stored.preset)),
      folder_(std::move(folder)),
      table_(preset_),
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
    message =
        result.outcome == simulation::Outcome::stopped ? "stopped; press u to resume it"
        : result.not_made.empty()
            ? fmt::format("done: {}/report.html", folder_.string())
            : fmt::format("some scenarios could not be made: {}/report.html says why", folder_.string());
  } catch (const std::exception& error) {
    message = error.what();
  }
  const std::lock_guard lock(mutex_);
  message_ = message;
  ended_ = true;
}

/// What other processes, such as the tasks of a cluster, have computed meanwhile.
void StudyScreen::follow_others() try {
  constexpr double between_looks_s = 2.0;
  if (!ended_ || base::seconds_since(followed_) < between_looks_s) return;
  followed_ = base::Clock::now();
  const study::StudyStatus status = study::status_of(folder_);
  const auto there =
      std::count_if(rows_.begin(), rows_.end(), [](const auto& row) { return row.has_value(); });
  if (status.done > there) rows_ = study::read_study(folder_).rows;
  if (status.running > 0) {
    message_ = elsewhere_text(status);
  } else if (status.done > there) {
    message_ = "press u to resume it, or to write its report";
  }
} catch (const std::exception& error) {
  message_ = error.what();
}

Navigation StudyScreen::look() {
  const std::lock_guard lock(mutex_);
  follow_others();
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
  draw_chosen(canvas, layout.chosen);
  canvas.text(layout.foot.x, layout.foot.y,
              foot_of(Where::study, layout.foot.width, ended_ ? Action::stop : Action::resume), {Ink::dim});
  draw_grid(canvas, layout.grid);
  draw_velocities(canvas, layout.velocities, glyphs);
  draw_errors(canvas, layout.errors, glyphs);
}

/// Rows come into colour by the handful around the chosen one, so that no colour stands for two.
bool StudyScreen::in_colour(int row) const {
  return row / curves_at_a_time == list_.chosen / curves_at_a_time;
}

Ink StudyScreen::ink_of_row(int row) const {
  return in_colour(row) ? curve_inks[static_cast<std::size_t>(row % curves_at_a_time)] : Ink::dim;
}

/// The chosen one last: it lies over the others.
std::vector<int> StudyScreen::rows_in_colour() const {
  std::vector<int> rows;
  for (int row = 0; row < static_cast<int>(table_.rows.size()); ++row)
    if (in_colour(row) && row != list_.chosen) rows.push_back(row);
  rows.push_back(list_.chosen);
  return rows;
}

/// The chosen row, whose name the table may cut.
void StudyScreen::draw_chosen(Canvas& canvas, const Area& area) const {
  std::string text;
  base::append_letter(text, letter_of_row(list_.chosen));
  text += ": " + table_.rows[static_cast<std::size_t>(list_.chosen)];
  const int x = canvas.text(area.x, area.y, text, {ink_of_row(list_.chosen), true}, area.width) + 3;
  canvas.text(area.x + x, area.y, "(up and down choose whose curves are shown)", {Ink::dim}, area.width - x);
}

/// Every scenario is a cell of its ratio, in colour and by a sign above Broberg, below, or near.
void StudyScreen::draw_grid(Canvas& canvas, const Area& area) {
  const int rows = static_cast<int>(table_.rows.size()), columns = static_cast<int>(table_.columns.size());
  std::size_t longest = 8;
  for (const std::string& name : table_.rows) longest = std::max(longest, base::count_letters(name));
  const int label = std::min(static_cast<int>(longest) + 3, area.width / 2);
  const int wide = std::clamp((area.width - label) / columns, 3, 10);
  list_rows_ = area.height - 2;
  list_.keep(rows, list_rows_);
  canvas.text(area.x, area.y, table_.axis, {Ink::dim}, label - 1);
  for (int c = 0; c < columns; ++c)
    canvas.text(area.x + label + c * wide, area.y, fmt::format("{:>{}}", table_.columns[c], wide - 1),
                {Ink::dim}, std::min(wide - 1, area.width - label - c * wide));
  for (int k = 0; k < list_rows_ && list_.top + k < rows; ++k) {
    const int r = list_.top + k, y = area.y + 1 + k;
    const Style style{ink_of_row(r), in_colour(r), r == list_.chosen};
    canvas.put(area.x, y, letter_of_row(r), style);
    canvas.text(area.x + 1, y, " " + table_.rows[r], style, label - 2);
    for (int c = 0; c < columns; ++c)
      if (const int x = area.x + label + c * wide; x + wide <= area.x + area.width)
        draw_cell_of(canvas, x, y, wide, r, c);
  }
  canvas.text(area.x, area.y + area.height - 1,
              fmt::format("G_ID/G_I0: + above, - below, else within {} of Broberg", near_broberg), {Ink::dim},
              area.width);
}

void StudyScreen::draw_cell_of(Canvas& canvas, int x, int y, int wide, int row, int column) const {
  const auto found = table_.cells.find({row, column});
  if (found == table_.cells.end()) return;
  const std::optional<results::LaneSummary>& scenario = shown_[found->second];
  if (!scenario) {
    canvas.text(x, y, fmt::format("{:>{}}", ".", wide - 1), {Ink::dim});
    return;
  }
  const Verdict verdict = verdict_on(scenario->error_broberg);
  const std::string text = std::isnan(scenario->ratio)
                               ? scenario->outcome
                               : fmt::format("{:.3f}{}", scenario->ratio, verdict.sign);
  canvas.text(x + 1, y, fmt::format("{:^{}}", text, wide - 1), {verdict.ink, true, true}, wide - 1);
}

void StudyScreen::draw_velocities(Canvas& canvas, const Area& area, Glyphs glyphs) const {
  const scene::Scene::Material& m = preset_.study.front().scene.material;
  double fastest = 0.8, most = 1.2;
  std::map<int, std::vector<std::array<double, 2>>> by_row;
  for (std::size_t k = 0; k < shown_.size(); ++k) {
    if (!shown_[k]) continue;
    const double v = shown_[k]->crack_velocity_over_cr, ratio = shown_[k]->ratio;
    if (std::isnan(v) || std::isnan(ratio)) continue;
    by_row[table_.row_of[k]].push_back({v, ratio});
    fastest = std::max(fastest, v), most = std::max(most, std::min(ratio, 3.0));
  }
  Curve broberg{{}, {Ink::reference}, "Broberg", U'B', Marks::last},
      strip{{}, {Ink::dim}, "strip", U's', Marks::last};
  for (int k = 1; k <= 60; ++k) {
    const double v = std::min(fastest, 1.0) * k / 60.0;
    broberg.points.push_back({v, theory::broberg(v, m.poisson_ratio, m.plane).g});
    strip.points.push_back({v, theory::strip(v, m.poisson_ratio, m.plane).g});
  }
  std::vector<Curve> curves{broberg, strip};
  const auto add = [&](int row) {
    std::vector<std::array<double, 2>>& points = by_row[row];
    std::sort(points.begin(), points.end());
    curves.push_back({points, {ink_of_row(row), true}, {}, letter_of_row(row), Marks::each});
  };
  for (const int row : rows_in_colour()) add(row);
  draw_curves(canvas, area, {{0, fastest}, {0, most}, "v/c_R", "G_ID/G_I0"}, curves, glyphs);
}

/// Points appear as the scenarios end: those of the rows in colour by their letters, the others as dots.
void StudyScreen::draw_errors(Canvas& canvas, const Area& area, Glyphs glyphs) const {
  const std::vector<ErrorPoint> points = error_points(table_, shown_);
  double low = 1e9, high = -1e9, small = 1e9, large = -1e9;
  std::vector<Curve> curves{{efficient_front(points), {Ink::reference}, "efficient"}};
  for (const ErrorPoint& point : points) {
    const auto [x, y] = point.at;
    low = std::min(low, x), high = std::max(high, x), small = std::min(small, y), large = std::max(large, y);
    if (!in_colour(point.row)) curves.push_back({{point.at}, {Ink::dim}, {}, U'.', Marks::each, false});
  }
  for (const int row : rows_in_colour())
    for (const ErrorPoint& point : points)
      if (point.row == row)
        curves.push_back({{point.at}, {ink_of_row(row), true}, {}, letter_of_row(row), Marks::each, false});
  if (points.empty()) low = -1, high = 1, small = -3, large = 0;
  draw_curves(canvas, area,
              {{std::floor(low), std::ceil(high + 1e-9)},
               {std::floor(small), std::ceil(large + 1e-9)},
               "run time [s]",
               "|difference to Broberg|",
               true},
              curves, glyphs);
}

Navigation StudyScreen::press(const KeyEvent& event) {
  const Action action = action_of(Where::study, event.key);
  if (list_.move(action, static_cast<int>(table_.rows.size()), list_rows_)) return {};
  switch (action) {
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

#include "studio/workbench/home_screen.hpp"

#include "engine/base/text.hpp"
#include "engine/results/run_folder.hpp"
#include "engine/scene/preset.hpp"
#include "studio/screen/canvas.hpp"
#include "studio/screen/layouts.hpp"
#include "studio/workbench/screen.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cctype>
#include <utility>

namespace rift::studio {
namespace fs = std::filesystem;
namespace {

struct Group {
  std::string_view name;
  std::array<std::string_view, 3> prefixes;
};

constexpr std::array groups{
    Group{"Start here", {"quickstart", "plate_", "-"}},
    Group{"Demonstrations", {"teach_", "-", "-"}},
    Group{"Studies", {"study_", "-", "-"}},
    Group{"From a measured crack to its toughness", {"experiment_", "-", "-"}},
    Group{"Inclined, curved and pressed cracks", {"path_", "-", "-"}},
    Group{"Figures, tables and sections of the paper", {"fig", "table", "sec"}},
    Group{"Beyond the paper", {"beyond", "-", "-"}},
    Group{"Others", {"", "-", "-"}},
};

/// The group of a preset, and by which prefix.
std::pair<std::string_view, std::string_view> place_of(const std::string& preset) {
  for (const Group& group : groups)
    for (const std::string_view prefix : group.prefixes)
      if (preset.starts_with(prefix)) return {group.name, prefix};
  return {};
}

std::string lower(std::string text) {
  std::transform(text.begin(), text.end(), text.begin(), [](unsigned char c) { return std::tolower(c); });
  return text;
}

Ink ink_of(const std::string& outcome) {
  return outcome == "finished"                           ? Ink::good
         : outcome == "diverged" || outcome == "damaged" ? Ink::bad
                                                         : Ink::plain;
}

}  // namespace

HomeScreen::HomeScreen(AppContext& context) : context_(context), jobs_(context.program), preview_(context) {
  read();
  list_.chosen = 1;
}

/// What is one's own stands first.
void HomeScreen::read() {
  const std::string before = chosen() ? chosen()->place() : "";
  all_.clear();
  std::vector<RunEntry> runs = run_entries(context_.runs), studies = run_entries(context_.studies);
  runs.insert(runs.end(), studies.begin(), studies.end());
  if (!runs.empty()) all_.push_back({"Recent runs", {}, {}});
  for (const RunEntry& run : runs) all_.push_back({"Recent runs", {}, run});
  std::error_code none;
  if (fs::is_directory(context_.own_presets, none)) {
    const std::vector<PresetEntry> own = preset_entries(context_.own_presets);
    if (!own.empty()) all_.push_back({"Your presets", {}, {}});
    for (const PresetEntry& preset : own) all_.push_back({"Your presets", preset, {}});
  }
  add_presets();
  all_.push_back({"Lessons", {}, {}});
  for (const Lesson& lesson : lessons()) all_.push_back({"Lessons", {}, {}, &lesson});
  filter();
  const auto same = std::find_if(rows_.begin(), rows_.end(),
                                 [&](const Row& row) { return !row.heading() && row.place() == before; });
  if (same != rows_.end()) list_.chosen = static_cast<int>(same - rows_.begin());
}

void HomeScreen::add_presets() {
  const std::vector<PresetEntry> presets = preset_entries(context_.presets);
  for (const Group& group : groups) {
    const std::size_t heading = all_.size();
    for (const std::string_view prefix : group.prefixes)
      for (const PresetEntry& preset : presets) {
        if (place_of(preset.name) != std::pair{group.name, prefix}) continue;
        if (all_.size() == heading) all_.push_back({std::string(group.name), {}, {}});
        all_.push_back({std::string(group.name), preset, {}});
      }
  }
}

void HomeScreen::filter() {
  rows_.clear();
  const std::string wanted = lower(wanted_);
  for (const Row& row : all_) {
    const std::string text = lower(row.group + " " + row.name() + " " + row.shows());
    const bool shown = wanted.empty() || (!row.heading() && text.find(wanted) != std::string::npos);
    if (shown) rows_.push_back(row);
  }
  longest_name_ = 20;
  for (const Row& row : rows_)
    if (!row.heading())
      longest_name_ = std::max(longest_name_, static_cast<int>(base::count_letters(row.name())));
  list_.keep(static_cast<int>(rows_.size()), list_rows_);
  skip_headings(1);
}

const HomeScreen::Row* HomeScreen::chosen() const {
  return list_.chosen < static_cast<int>(rows_.size()) ? &rows_[list_.chosen] : nullptr;
}

/// The first row is a heading, and one never ends the list.
void HomeScreen::skip_headings(int way) {
  const int count = static_cast<int>(rows_.size());
  if (const Row* row = chosen(); row == nullptr || !row->heading()) return;
  list_.chosen += list_.chosen == 0 ? 1 : way;
  list_.keep(count, list_rows_);
  if (list_.chosen == 1) list_.top = 0;
}

void HomeScreen::next_group() {
  const int count = static_cast<int>(rows_.size());
  for (int k = 1; k < count; ++k) {
    const int at = (list_.chosen + k) % count;
    if (!rows_[at].heading()) continue;
    list_.chosen = at + 1;
    list_.keep(count, list_rows_);
    return;
  }
}

void HomeScreen::draw(Canvas& canvas, Glyphs glyphs) {
  if (draw_too_small(canvas)) return;
  const HomeLayout layout = home_layout(canvas.width(), canvas.height(), preview_.on());
  preview_.draw(canvas, layout.preview, glyphs);
  const int x = canvas.text(layout.head.x, layout.head.y, "rift", {Ink::title, true});
  canvas.text(layout.head.x + x + 2, layout.head.y, "a workbench for dynamic fracture", {Ink::dim});
  if (search_.typing()) {
    search_.draw(canvas, layout.search);
  } else if (!wanted_.empty()) {
    canvas.text(layout.search.x, layout.search.y,
                fmt::format("only entries with \"{}\"; press / and enter to show all", wanted_),
                {Ink::reference}, layout.search.width);
  }
  list_rows_ = layout.list.height, list_width_ = layout.list.x + layout.list.width;
  list_.keep(static_cast<int>(rows_.size()), list_rows_);
  for (int k = 0; k < list_rows_ && list_.top + k < static_cast<int>(rows_.size()); ++k)
    draw_row(canvas, {layout.list.x, layout.list.y + k, layout.list.width, 1}, rows_[list_.top + k],
             list_.top + k == list_.chosen);
  draw_detail(canvas, layout.detail);
  if (question_.typing())
    question_.draw(canvas, layout.foot);
  else
    canvas.text(layout.foot.x, layout.foot.y, foot_of(Where::home, layout.foot.width), {Ink::dim});
}

void HomeScreen::draw_row(Canvas& canvas, const Area& line, const Row& row, bool is_chosen) const {
  if (row.heading()) {
    canvas.text(line.x, line.y, row.group, {Ink::title, true}, line.width);
    return;
  }
  const Style style{Ink::plain, false, is_chosen}, dim{Ink::dim, false, is_chosen};
  if (is_chosen) clear(canvas, line, style);
  const auto text = [&](int from, const std::string& what, const Style& look, int width) {
    canvas.text(line.x + from, line.y, what, look, std::min(width, line.width - from));
  };
  const int names = std::min(longest_name_ + 4, line.width / 3);
  text(1, row.run && marked_.contains(row.run->path) ? "*" : " ", style, 1);
  text(3, row.name(), style, names - 4);
  if (row.run) {
    text(names, row.run->outcome, {ink_of(row.run->outcome), false, is_chosen}, 11);
    text(names + 12, row.run->result, style, 11);
    text(names + 24, row.run->path.string(), dim, line.width);
    return;
  }
  const int costs = line.width >= 150 ? 36 : 0;  // below, the description takes the whole line
  if (costs > 0 && row.preset) text(names, row.preset->cost, dim, costs - 1);
  text(names + costs, row.shows(), style, line.width);
}

void HomeScreen::draw_detail(Canvas& canvas, const Area& area) const {
  if (!message_.empty()) {
    draw_paragraph(canvas, area, message_, {Ink::reference});
    return;
  }
  const Row* row = chosen();
  if (row == nullptr) {
    canvas.text(area.x, area.y, "no entry contains these letters", {Ink::dim});
  } else if (row->preset) {
    const int lines =
        draw_paragraph(canvas, {area.x, area.y, area.width, area.height - 1}, row->preset->shows);
    canvas.text(area.x, area.y + lines, "cost: " + row->preset->cost, {Ink::dim}, area.width);
  } else if (row->lesson != nullptr) {
    canvas.text(area.x, area.y, row->lesson->title, {}, area.width);
    canvas.text(area.x, area.y + 1, "a few pages, a live run, and a question that the run answers",
                {Ink::dim}, area.width);
  } else if (row->run) {
    canvas.text(area.x, area.y, row->run->path.string(), {}, area.width);
    canvas.text(area.x, area.y + 1,
                row->run->result.empty() ? row->run->outcome : row->run->outcome + ", " + row->run->result,
                {ink_of(row->run->outcome)}, area.width);
  }
}

Navigation HomeScreen::press(const KeyEvent& event) {
  Navigation navigation = take(event);
  if (navigation.to == Navigation::To::forward) preview_.let_go();  // the next screen has the machine
  return navigation;
}

Navigation HomeScreen::take(const KeyEvent& event) try {
  message_.clear();
  if (question_.typing()) {
    if (question_.press(event) != Prompt::State::typing) answer_question();
    return {};
  }
  if (search_.typing()) {
    const Prompt::State state = search_.press(event);
    wanted_ = state == Prompt::State::cancelled ? std::string() : search_.text();
    list_.chosen = 0;
    filter();
    return {};
  }
  if (event.key == key_click) {
    const int at = list_.top + event.y - 2;
    if (event.x >= list_width_ || event.y < 2 || event.y >= 2 + list_rows_ || at >= static_cast<int>(rows_.size()) ||
        rows_[at].heading())
      return {};
    if (at == list_.chosen) return open(true);
    list_.chosen = at;
    return {};
  }
  if (event.key == key_wheel_up || event.key == key_wheel_down) {
    const Action way = event.key == key_wheel_up ? Action::up : Action::down;
    list_.move(way, static_cast<int>(rows_.size()), list_rows_);
    skip_headings(way == Action::up ? -1 : 1);
    return {};
  }
  return act(action_of(Where::home, event.key));
} catch (const std::exception& error) {
  message_ = error.what();
  return {};
}

Navigation HomeScreen::act(Action action) {
  if (list_.move(action, static_cast<int>(rows_.size()), list_rows_)) {
    const bool up = action == Action::up || action == Action::page_up || action == Action::last;
    skip_headings(up ? -1 : 1);
    return {};
  }
  const Row* row = chosen();
  switch (action) {
    case Action::open:
      return open(true);
    case Action::run:
      return open(false);
    case Action::next:
      next_group();
      return {};
    case Action::search:
      search_ = Prompt("search", wanted_);
      return {};
    case Action::mark:
      toggle_mark();
      return {};
    case Action::compare:
      return compare_marked();
    case Action::resume:
      return resume_chosen();
    case Action::film:
      message_ = row && row->run ? jobs_.film(row->run->path, {}) : "choose a run: only a run has a film";
      return {};
    case Action::picture:
      preview_.toggle();
      return {};
    case Action::remove:
      if (!row || !row->run) {
        message_ = "choose a run: presets cannot be deleted here";
        return {};
      }
      to_remove_ = row->run->path;
      question_ = Prompt(fmt::format("delete {} and all its files? yes or no", to_remove_.string()), "");
      return {};
    case Action::back:
      return {Navigation::To::back, nullptr};
    default:
      return {};
  }
}

void HomeScreen::toggle_mark() {
  const Row* row = chosen();
  if (!row || !row->run) {
    message_ = "choose a run: only runs can be compared";
  } else if (!marked_.erase(row->run->path)) {
    marked_.insert(row->run->path);
  }
}

Navigation HomeScreen::open(bool as_form) {
  const Row* row = chosen();
  if (!row || row->heading()) return {};
  if (row->lesson) return {Navigation::To::forward, lesson_screen(context_, std::string(row->lesson->name))};
  if (row->run) return {Navigation::To::forward, screen_of_run(context_, row->run->path)};
  return {Navigation::To::forward, as_form ? form_of_preset(context_, row->preset->path)
                                           : screen_of_preset(context_, row->preset->path)};
}

Navigation HomeScreen::resume_chosen() {
  const Row* row = chosen();
  if (!row || !row->run) {
    message_ = "choose a run that was stopped or killed";
    return {};
  }
  return {Navigation::To::forward, resumption_of(context_, row->run->path)};
}

Navigation HomeScreen::compare_marked() {
  if (marked_.size() < 2) {
    message_ = "first mark two or more runs with the space bar";
    return {};
  }
  return {Navigation::To::forward, comparison_of(context_, {marked_.begin(), marked_.end()})};
}

void HomeScreen::answer_question() {
  if (question_.text() != "yes") {
    message_ = "nothing was deleted";
    return;
  }
  if (results::is_folder_being_written(to_remove_)) {
    message_ = to_remove_.string() + " is being written by another process: nothing was deleted";
    return;
  }
  std::error_code error;
  fs::remove_all(to_remove_, error);
  message_ = error ? fmt::format("cannot delete {}: {}", to_remove_.string(), error.message())
                   : to_remove_.string() + " was deleted";
  marked_.erase(to_remove_);
  read();
}

Navigation HomeScreen::look() {
  const Row* row = chosen();
  const bool is_run = row != nullptr && row->run;
  preview_.look(is_run                              ? row->run->path
                : row != nullptr && row->preset ? row->preset->path
                                                : fs::path(),
                is_run);
  if (const std::string news = jobs_.report_ended(); !news.empty()) message_ = news;
  return {};
}

}  // namespace rift::studio

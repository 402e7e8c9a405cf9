#include "studio/workbench/form_screen.hpp"

#include "engine/base/files.hpp"
#include "engine/base/text.hpp"
#include "engine/scene/derived.hpp"
#include "engine/scene/needs.hpp"
#include "studio/screen/canvas.hpp"
#include "studio/screen/layouts.hpp"
#include "studio/workbench/screen.hpp"

#include <fmt/format.h>

#include <algorithm>

namespace rift::studio {
namespace fs = std::filesystem;
namespace {

constexpr auto before_dry_run = std::chrono::milliseconds(500);  // nothing was typed for so long

/// What follows from the scene at once, before any lattice.
DryRunThread::Rows at_once(const scene::Scene& scene) {
  return {{"c_R", fmt::format("{:.0f} m/s", scene::rayleigh_speed(scene))},
          {"density", fmt::format("{:.1f} kg/m³", scene::density(scene))},
          {"thickness", fmt::format("{:.4g} mm", 1e3 * scene::thickness_m(scene))},
          {"mean radius", fmt::format("about {:.3g} mm", 1e3 * scene::expected_mean_radius_m(scene))},
          {"damage zone", fmt::format("about {:.3g} mm", 1e3 * scene::expected_zone_m(scene))}};
}

/// The rows with those of step and cost before all others: where there is little room, they are seen.
DryRunThread::Rows what_it_costs_first(const DryRunThread::Rows& rows) {
  DryRunThread::Rows first, others;
  bool costs = false;  // a row without a label belongs to the one before
  for (const auto& row : rows) {
    if (!row.first.empty()) costs = row.first == "step" || row.first == "steps" || row.first == "cost";
    (costs ? first : others).push_back(row);
  }
  first.insert(first.end(), others.begin(), others.end());
  return first;
}

}  // namespace

FormScreen::FormScreen(AppContext& context, fs::path preset)
    : context_(context), path_(std::move(preset)), dry_run_(context.cache, context.threads) {
  list_rows();
  check();
}

void FormScreen::list_rows() {
  rows_.clear();
  std::string table;
  for (const scene::Parameter& row : scene::parameters()) {
    if (!wanted_.empty() && std::string(row.key).find(wanted_) == std::string::npos &&
        std::string(row.doc).find(wanted_) == std::string::npos)
      continue;
    if (scene::table_of(row) != table) rows_.push_back({nullptr, table = scene::table_of(row)});
    rows_.push_back({&row, table});
  }
  list_.chosen = 0, list_.top = 0;
  skip_tables(1);
}

std::vector<std::string> FormScreen::overrides() const {
  std::vector<std::string> texts;
  for (const Change& change : changes_) texts.push_back(change.key + "=" + change.value);
  return texts;
}

void FormScreen::check() {
  preset_ = scene::read_preset(path_, overrides());
  changed_ = Clock::now();
  dry_run_due_ = true;
  dry_run_.give_up();
}

Navigation FormScreen::look() {
  if (!dry_run_due_ || dry_run_.busy() || Clock::now() - changed_ < before_dry_run) return {};
  dry_run_due_ = false;
  if (preset_.issues.empty() && preset_.study.empty()) dry_run_.begin(preset_);
  return {};
}

const scene::Parameter* FormScreen::chosen() const {
  return list_.chosen < static_cast<int>(rows_.size()) ? rows_[list_.chosen].parameter : nullptr;
}

bool FormScreen::is_changed(std::string_view key) const {
  return std::any_of(changes_.begin(), changes_.end(), [&](const Change& c) { return c.key == key; });
}

void FormScreen::change(const std::string& key, const std::string& value) {
  const auto found =
      std::find_if(changes_.begin(), changes_.end(), [&](const Change& c) { return c.key == key; });
  if (found == changes_.end())
    changes_.push_back({key, value});
  else
    found->value = value;
  check();
}

void FormScreen::take_back(const std::string& key) {
  std::erase_if(changes_, [&](const Change& c) { return c.key == key; });
  check();
}

std::string FormScreen::shown_value(const scene::Parameter& row) const {
  for (const Change& change : changes_)
    if (change.key == row.key) return change.value;
  return base::without_quotes(scene::toml_value(preset_.scene, row));
}

std::string FormScreen::issue_of(const scene::Parameter& row) const {
  for (const scene::Issue& issue : preset_.issues)
    if (issue.key == row.key) return issue.text;
  return {};
}

void FormScreen::skip_tables(int way) {
  const int count = static_cast<int>(rows_.size());
  if (count == 0 || chosen() != nullptr) return;
  list_.chosen += list_.chosen == 0 ? 1 : way;
  list_.keep(count, list_rows_);
  if (list_.chosen == 1) list_.top = 0;
}

void FormScreen::draw(Canvas& canvas, Glyphs) {
  if (draw_too_small(canvas)) return;
  const FormLayout layout = form_layout(canvas.width(), canvas.height());
  draw_head(canvas, layout.head);
  if (search_.typing()) search_.draw(canvas, layout.search);
  list_rows_ = layout.rows.height;
  draw_rows(canvas, layout.rows);
  draw_derived(canvas, layout.derived);
  draw_detail(canvas, layout.detail);
  if (name_.typing())
    name_.draw(canvas, layout.foot);
  else
    canvas.text(layout.foot.x, layout.foot.y,
                value_.typing() ? "enter take it  escape leave it as it was"
                                : foot_of(Where::form, layout.foot.width),
                {Ink::dim}, layout.foot.width);
}

void FormScreen::draw_head(Canvas& canvas, const Area& area) const {
  const std::size_t wrong = preset_.issues.size();
  const std::string state =
      wrong == 0 ? "ready to run" : fmt::format("{} mistake{}", wrong, wrong > 1 ? "s" : "");
  const std::string holds = !preset_.study.empty()
                                ? fmt::format("a study of {} scenarios", preset_.study.size())
                            : !preset_.lanes.empty() ? fmt::format("{} lanes", preset_.lanes.size())
                                                     : std::string("one scenario");
  int x = area.x + canvas.text(area.x, area.y, path_.stem().string(), {Ink::title, true}, area.width) + 3;
  x += canvas.text(x, area.y, state, {wrong == 0 ? Ink::good : Ink::bad, true}) + 3;
  canvas.text(x, area.y, fmt::format("{}, {} changed", holds, changes_.size()), {Ink::dim},
              area.x + area.width - x);
}

void FormScreen::draw_rows(Canvas& canvas, const Area& area) {
  list_.keep(static_cast<int>(rows_.size()), list_rows_);
  for (int k = 0; k < area.height && list_.top + k < static_cast<int>(rows_.size()); ++k)
    draw_row(canvas, {area.x, area.y + k, area.width, 1}, rows_[list_.top + k],
             list_.top + k == list_.chosen);
}

void FormScreen::draw_row(Canvas& canvas, const Area& area, const Row& row, bool is_chosen) const {
  if (row.parameter == nullptr) {
    canvas.text(area.x, area.y, row.table, {Ink::title, true}, area.width);
    return;
  }
  const scene::Parameter& parameter = *row.parameter;
  const bool wrong = !issue_of(parameter).empty(), changed = is_changed(parameter.key);
  const bool typed = is_chosen && value_.typing();
  const Style style{wrong ? Ink::bad : Ink::plain, changed, is_chosen && !typed};
  if (is_chosen && !typed) clear(canvas, area, style);
  constexpr int names = 22;
  canvas.text(area.x + 1, area.y, changed ? "*" : " ", style);
  canvas.text(area.x + 3, area.y, scene::name_of(parameter), style, names - 1);
  const Area value{area.x + 3 + names, area.y, area.width - names - 3, 1};
  if (typed) {
    value_.draw(canvas, value, {wrong ? Ink::bad : Ink::good, true});
    return;
  }
  const std::string text = shown_value(parameter);
  const bool given = preset_.origins.contains(std::string(parameter.key));
  canvas.text(value.x, value.y, text.empty() ? "not given" : text,
              {wrong   ? Ink::bad
               : given ? Ink::plain
                       : Ink::dim,
               changed, is_chosen},
              value.width);
}

void FormScreen::draw_detail(Canvas& canvas, const Area& area) const {
  if (!message_.empty()) {
    draw_paragraph(canvas, area, message_, {Ink::reference});
    return;
  }
  const scene::Parameter* row = chosen();
  if (row == nullptr) return;
  canvas.text(area.x, area.y, fmt::format("{}  {}", row->key, row->doc), {}, area.width);
  canvas.text(area.x, area.y + 1, "allowed: " + scene::allowed(*row), {Ink::dim}, area.width);
  if (const std::string issue = issue_of(*row); !issue.empty())
    canvas.text(area.x, area.y + 2, issue, {Ink::bad, true}, area.width);
}

void FormScreen::draw_derived(Canvas& canvas, const Area& area) const {
  int y = area.y;
  const int end = area.y + area.height;
  const auto row = [&](const std::string& label, const std::string& text, const Style& style = {}) {
    if (y >= end) return;
    constexpr int labels = 13;
    canvas.text(area.x, y, label, {Ink::reference, true}, labels - 1);
    y += std::max(1, draw_paragraph(canvas, {area.x + labels, y, area.width - labels, end - y}, text, style));
  };
  const auto draw_left_out = [&] {
    const char* label = "left out";
    for (const std::string& line : scene::left_out_lines(preset_)) row(label, line, {Ink::dim}), label = "";
  };
  for (const scene::Issue& issue : preset_.issues)
    row(y == area.y ? "mistakes" : "",
        issue.key.empty() ? scene::to_text(issue) : issue.key + ": " + issue.text, {Ink::bad});
  if (!preset_.issues.empty()) return;
  const scene::Scene& scene = preset_.lanes.empty() ? preset_.scene : preset_.lanes.front();
  if (!preset_.study.empty()) {
    row("study", fmt::format("{} scenarios", preset_.study.size()));
    for (const auto& [label, text] : at_once(preset_.study.front().scene)) row(label, text);
    draw_left_out();
    return;
  }
  const DryRunThread::Found found = dry_run_.found();
  if (!found.rows.empty()) {
    for (const auto& [label, text] : what_it_costs_first(found.rows)) row(label, text);
    return;
  }
  for (const auto& [label, text] : at_once(scene)) row(label, text);
  draw_left_out();
  if (!found.trouble.empty())
    row("trouble", found.trouble, {Ink::bad});
  else
    row("exactly", found.doing.empty() ? "in a moment" : found.doing, {Ink::dim});
}

Navigation FormScreen::press(const KeyEvent& event) try {
  message_.clear();
  if (typing()) return type(event);
  const int count = static_cast<int>(rows_.size());
  if (event.key == key_click) {
    const int at = list_.top + event.y - 2;
    if (event.y < 2 || event.y >= 2 + list_rows_ || at >= count || rows_[at].parameter == nullptr) return {};
    if (at == list_.chosen) return act(Action::open);
    list_.chosen = at;
    return {};
  }
  Action action = action_of(Where::form, event.key);
  if (event.key == key_wheel_up) action = Action::up;
  if (event.key == key_wheel_down) action = Action::down;
  if (list_.move(action, count, list_rows_)) {
    skip_tables(action == Action::up || action == Action::page_up ? -1 : 1);
    return {};
  }
  return act(action);
} catch (const std::exception& error) {
  message_ = error.what();
  return {};
}

Navigation FormScreen::type(const KeyEvent& event) {
  if (value_.typing()) {
    const std::string key(chosen()->key);
    const Prompt::State state = value_.press(event);
    if (state == Prompt::State::cancelled) {
      if (had_change_)
        change(key, before_);
      else
        take_back(key);
    } else if (value_.text() ==
                   base::without_quotes(scene::toml_value(scene::read_preset(path_).scene, *chosen())) &&
               !had_change_) {
      take_back(key);  // as it stands in the file
    } else {
      change(key, value_.text());
    }
    return {};
  }
  if (search_.typing()) {
    wanted_ = search_.press(event) == Prompt::State::cancelled ? std::string() : search_.text();
    list_rows();
    return {};
  }
  if (name_.press(event) == Prompt::State::entered) save();
  return {};
}

Navigation FormScreen::act(Action action) {
  const scene::Parameter* row = chosen();
  switch (action) {
    case Action::open: {
      if (row == nullptr) return {};
      had_change_ = is_changed(row->key);
      before_ = shown_value(*row);
      value_ = Prompt("", before_);
      return {};
    }
    case Action::reset:
      if (row != nullptr) take_back(std::string(row->key));
      return {};
    case Action::run:
      return run();
    case Action::save:
      name_ = Prompt("save as", path_.stem().string() + "_mine");
      return {};
    case Action::search:
      search_ = Prompt("search", wanted_);
      return {};
    case Action::back:
      return {Navigation::To::back, nullptr};
    default:
      return {};
  }
}

Navigation FormScreen::run() {
  if (!preset_.issues.empty()) {
    message_ = "there are mistakes: nothing is run before they are mended";
    return {};
  }
  dry_run_.give_up();
  return {Navigation::To::forward, screen_of_preset(context_, path_, overrides())};
}

void FormScreen::save() {
  const std::string& name = name_.text();
  const bool valid = !name.empty() && name.find_first_of("/\\ ") == std::string::npos && name.front() != '.';
  if (!valid) {
    message_ = fmt::format("\"{}\" is no name of a preset: letters, digits, - and _", name);
  } else if (!preset_.issues.empty()) {
    message_ = "there are mistakes: a preset is saved when they are mended";
  } else if (const fs::path file = context_.own_presets / (name + ".toml"); fs::exists(file)) {
    message_ = file.string() + " is there already: choose another name";
  } else {
    base::make_folder(context_.own_presets);
    base::write_whole_file(file, fmt::format("# From {} with {} changed.\n# Cost: as that one\n{}",
                                             base::escaped(path_.stem().string()), changes_.size(),
                                             scene::preset_text(preset_)));
    message_ = "saved: " + file.string();
  }
}

}  // namespace rift::studio

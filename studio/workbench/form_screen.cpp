#include "studio/workbench/form_screen.hpp"

#include "engine/base/files.hpp"
#include "engine/base/text.hpp"
#include "engine/scene/scenarios.hpp"
#include "studio/screen/canvas.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <utility>

namespace rift::studio {
namespace fs = std::filesystem;
namespace {

constexpr auto before_dry_run = std::chrono::milliseconds(500);  // nothing was typed for so long

/// A digit typed on a value begins a new one.
bool begins_number(int key) { return (key >= '0' && key <= '9') || key == '-'; }

}  // namespace

FormScreen::FormScreen(AppContext& context, fs::path preset)
    : context_(context),
      path_(std::move(preset)),
      file_(scene::read_preset(path_)),
      grid_(file_.grid),
      kept_(edits()),
      preset_(file_),
      dry_run_(context.cache, context.threads) {
  list_rows();
  if (file_.study.empty()) choose(Row::Kind::parameter, {});
}

/// The axes of the study first: what a study is of.
void FormScreen::list_study(bool all) {
  using Kind = Row::Kind;
  if (!file_.lanes.empty()) return;  // a preset has lanes or a study
  const std::size_t heading = rows_.size();
  rows_.push_back({Kind::heading, "study"});
  const auto listed = std::count_if(preset_.study.begin(), preset_.study.end(),
                                    [](const scene::StudyRow& row) { return row.combinations.empty(); });
  if (listed > 0)
    rows_.back().name += fmt::format(": {} scenarios in [[study.rows]], and the grid of", listed);
  for (const EditedGrid::List& list : grid_.lists()) {
    const scene::Parameter& parameter = scene::parameter_of(*scene::find_axis(list.axis));
    if (all || ("study." + list.axis).find(wanted_) != std::string::npos ||
        parameter.doc.find(wanted_) != std::string_view::npos)
      rows_.push_back({Kind::axis, list.axis, &parameter});
  }
  if (all) rows_.push_back({Kind::add_axis, "add an axis"});
  if (rows_.size() == heading + 1) rows_.pop_back();
}

void FormScreen::list_rows() {
  rows_.clear();
  const bool all = wanted_.empty();
  list_study(all);
  std::string table;
  for (const scene::Parameter& row : scene::parameters()) {
    if (!all && row.key.find(wanted_) == std::string_view::npos &&
        row.doc.find(wanted_) == std::string_view::npos)
      continue;
    if (scene::table_of(row) != table) rows_.push_back({Row::Kind::heading, table = scene::table_of(row)});
    rows_.push_back({Row::Kind::parameter, std::string(row.key), &row});
  }
  list_.chosen = 0, list_.top = 0;
  skip_headings(1);
}

/// Goes to the row of an axis or a parameter; without a name to the first of its kind.
void FormScreen::choose(Row::Kind kind, std::string_view name) {
  const auto found = std::find_if(rows_.begin(), rows_.end(), [&](const Row& row) {
    return row.kind == kind && (name.empty() || row.name == name);
  });
  if (found == rows_.end()) return;
  list_.chosen = static_cast<int>(found - rows_.begin());
}

std::vector<std::string> FormScreen::overrides() const {
  std::vector<std::string> texts;
  for (const Change& change : changes_) texts.push_back(change.key + "=" + change.value);
  return texts;
}

void FormScreen::check() {
  preset_ = grid_.changed() > 0 ? scene::read_preset(path_, overrides(), grid_.grid())
                                : scene::read_preset(path_, overrides());
  changed_at_ = Clock::now();
  dry_run_due_ = true;
  dry_run_.give_up();
}

Navigation FormScreen::look() {
  if (!dry_run_due_ || dry_run_.busy() || Clock::now() - changed_at_ < before_dry_run) return {};
  dry_run_due_ = false;
  if (preset_.issues.empty()) dry_run_.begin(preset_);
  return {};
}

const FormScreen::Row* FormScreen::chosen() const {
  const bool none =
      list_.chosen >= static_cast<int>(rows_.size()) || rows_[list_.chosen].kind == Row::Kind::heading;
  return none ? nullptr : &rows_[list_.chosen];
}

std::optional<std::string> FormScreen::change_of(std::string_view key) const {
  const auto found =
      std::find_if(changes_.begin(), changes_.end(), [&](const Change& c) { return c.key == key; });
  return found == changes_.end() ? std::nullopt : std::optional(found->value);
}

std::string FormScreen::axis_of(const scene::Parameter& parameter) const {
  for (const scene::Axis& axis : scene::axes())
    if (axis.key == parameter.key && grid_.values_of(axis.name)) return std::string(axis.name);
  return {};
}

bool FormScreen::is_changed(const Row& row) const {
  if (row.kind == Row::Kind::axis) return grid_.is_changed(row.name);
  return row.kind == Row::Kind::parameter && change_of(row.name).has_value();
}

std::string FormScreen::value_of(const Row& row) const {
  if (row.kind == Row::Kind::axis) return grid_.values_of(row.name).value_or("");
  if (const auto change = change_of(row.name)) return *change;
  return base::without_quotes(scene::toml_value(preset_.scene, *row.parameter));
}

std::string FormScreen::issue_of(const Row& row) const {
  if (row.parameter == nullptr) return {};
  for (const scene::Issue& issue : preset_.issues)
    if (issue.key == row.parameter->key || issue.key == "study." + row.name) return issue.text;
  return {};
}

void FormScreen::set(const Row& row, const std::string& value) {
  const auto change =
      std::find_if(changes_.begin(), changes_.end(), [&](const Change& c) { return c.key == row.name; });
  if (row.kind == Row::Kind::axis)
    grid_.set(row.name, value);
  else if (is_of_file(*row.parameter, value))
    drop_change(row.name);
  else if (change != changes_.end())
    change->value = value;
  else
    changes_.push_back({row.name, value});
  check();
}

/// Whether the file says so itself; one with mistakes says nothing for certain.
bool FormScreen::is_of_file(const scene::Parameter& parameter, const std::string& value) const {
  return file_.issues.empty() && value == base::without_quotes(scene::toml_value(file_.scene, parameter));
}

void FormScreen::drop_change(std::string_view key) {
  std::erase_if(changes_, [&](const Change& change) { return change.key == key; });
}

void FormScreen::take_back(const Row& row) {
  drop_change(row.name);
  if (row.kind == Row::Kind::axis) grid_.take_back(row.name);
  check();
  if (row.kind != Row::Kind::axis) return;
  const int at = list_.chosen;
  list_rows();
  list_.chosen = at;
  skip_headings(1);
}

void FormScreen::skip_headings(int way) {
  const int count = static_cast<int>(rows_.size());
  if (count == 0 || chosen() != nullptr) return;
  list_.chosen += list_.chosen == 0 ? 1 : way;
  list_.keep(count, list_rows_);
  if (list_.chosen == 1) list_.top = 0;
}

Navigation FormScreen::press(const KeyEvent& event) try {
  message_.clear();
  if (typing()) return type(event);
  const int count = static_cast<int>(rows_.size());
  if (event.key == key_click) {
    const int at = list_.top + event.y - 2;
    if (event.y < 2 || event.y >= 2 + list_rows_ || at >= count || rows_[at].kind == Row::Kind::heading)
      return {};
    if (at == list_.chosen) return act(Action::open);
    list_.chosen = at;
    return {};
  }
  if (begins_number(event.key)) {
    open();
    if (!value_.typing()) return {};
    value_ = Prompt("", "");
    return type(event);
  }
  Action action = action_of(Where::form, event.key);
  if (event.key == key_wheel_up) action = Action::up;
  if (event.key == key_wheel_down) action = Action::down;
  if (list_.move(action, count, list_rows_)) {
    skip_headings(action == Action::up || action == Action::page_up ? -1 : 1);
    return {};
  }
  return act(action);
} catch (const std::exception& error) {
  message_ = error.what();
  return {};
}

Navigation FormScreen::type(const KeyEvent& event) {
  if (value_.typing()) {
    const Row row = *chosen();
    set(row, value_.press(event) == Prompt::State::cancelled ? before_ : value_.text());
  } else if (search_.typing()) {
    wanted_ = search_.press(event) == Prompt::State::cancelled ? std::string() : search_.text();
    list_rows();
  } else if (adding_) {
    choose_other(event);
  } else if (details_) {
    read_details(event);
  } else if (leave_.typing()) {
    if (leave_.press(event) != Prompt::State::typing) return answer_leave();
  } else if (const Prompt::State state = name_.press(event); state != Prompt::State::typing) {
    const bool saved = state == Prompt::State::entered && save();
    if (std::exchange(leaving_, false) && saved) return {Navigation::To::back, nullptr};
  }
  return {};
}

/// The details are read line by line.
void FormScreen::read_details(const KeyEvent& event) {
  const Action action = action_of(Where::form, event.key);
  if (action == Action::down || event.key == key_wheel_down) ++details_from_;
  if ((action == Action::up || event.key == key_wheel_up) && details_from_ > 0) --details_from_;
  if (action == Action::back || action == Action::details) details_ = false;
}

/// Which axis is to be added.
void FormScreen::choose_other(const KeyEvent& event) {
  const std::vector<std::string_view> others = grid_.others();
  const Action action = action_of(Where::anywhere, event.key);
  if (event.key == key_enter) {
    adding_ = false;
    add_axis(others[others_.chosen]);
  } else if (action == Action::back) {
    adding_ = false;
  } else {
    others_.move(action, static_cast<int>(others.size()), other_rows_);
  }
}

void FormScreen::begin_adding() {
  if (!file_.lanes.empty())
    message_ = "a preset has lanes or a study, not both";
  else if (grid_.others().empty())
    message_ = "every axis is varied already";
  else
    adding_ = true, others_ = {};
}

void FormScreen::remove_axis() {
  const Row* row = chosen();
  if (row == nullptr || row->kind != Row::Kind::axis) {
    message_ = "choose an axis of the study: it is varied no more then";
    return;
  }
  grid_.drop(row->name);
  check();
  list_rows();
}

void FormScreen::add_axis(std::string_view axis) {
  drop_change(scene::find_axis(axis)->key);
  grid_.add(axis, preset_.scene);
  check();
  wanted_.clear();
  list_rows();
  choose(Row::Kind::axis, axis);
  open();
}

Navigation FormScreen::answer_leave() {
  if (leave_.text() == "yes") return {Navigation::To::back, nullptr};
  if (leave_.text() == "save") {
    leaving_ = true;
    return act(Action::save);
  }
  message_ = "nothing was dropped";
  return {};
}

/// Begins to edit the chosen row; a parameter that an axis varies is edited there.
void FormScreen::open() {
  const Row* row = chosen();
  if (row == nullptr) return;
  if (row->kind == Row::Kind::add_axis) return begin_adding();
  if (const std::string axis = row->kind == Row::Kind::parameter ? axis_of(*row->parameter) : "";
      !axis.empty()) {
    wanted_.clear();
    list_rows();
    choose(Row::Kind::axis, axis);
    return;
  }
  before_ = value_of(*row);
  value_ = Prompt("", before_);
}

Navigation FormScreen::act(Action action) {
  const Row* row = chosen();
  switch (action) {
    case Action::open:
      open();
      return {};
    case Action::reset:
      if (row != nullptr && row->kind != Row::Kind::add_axis) take_back(Row(*row));
      return {};
    case Action::add:
      begin_adding();
      return {};
    case Action::remove:
      remove_axis();
      return {};
    case Action::details:
      details_ = true, details_from_ = 0;
      return {};
    case Action::run:
      return run();
    case Action::save:
      name_ = Prompt("save as", path_.stem().string() + "_mine");
      return {};
    case Action::search:
      search_ = Prompt("search", "");
      wanted_.clear();
      list_rows();
      return {};
    case Action::back:
      if (edits() == kept_) return {Navigation::To::back, nullptr};
      leave_ = Prompt(fmt::format("{} changed, not saved: leave? yes, no or save", changed()), "");
      return {};
    default:
      return {};
  }
}

Navigation FormScreen::run() {
  if (!preset_.issues.empty()) {
    message_ = "the preset has mistakes: correct them before running it";
    return {};
  }
  dry_run_.give_up();
  return {Navigation::To::forward, screen_of_preset(context_, preset_, path_.stem().string(), changed() > 0)};
}

bool FormScreen::save() {
  const std::string& name = name_.text();
  const bool valid = !name.empty() && name.find_first_of("/\\ ") == std::string::npos && name.front() != '.';
  const fs::path file = context_.own_presets / (name + ".toml");
  if (!valid) {
    message_ = fmt::format("\"{}\" is not a valid preset name: use letters, digits, - and _", name);
  } else if (!preset_.issues.empty()) {
    message_ = "the preset has mistakes: correct them before saving it";
  } else if (fs::exists(file)) {
    message_ = file.string() + " exists already: choose another name";
  } else {
    base::make_folder(context_.own_presets);
    const std::string cost =
        preset_.study.empty() ? "about the same" : fmt::format("{} scenarios", preset_.study.size());
    base::write_whole_file(
        file, fmt::format("# From {} with {} changed.\n# Cost: {}\n{}", base::escaped(path_.stem().string()),
                          changed(), cost, scene::preset_text(preset_)));
    message_ = "saved: " + file.string();
    kept_ = edits();
    return true;
  }
  return false;
}

}  // namespace rift::studio

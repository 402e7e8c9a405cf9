#include "engine/base/text.hpp"
#include "engine/scene/derived.hpp"
#include "engine/scene/layers_note.hpp"
#include "engine/scene/needs.hpp"
#include "engine/scene/scenarios.hpp"
#include "studio/screen/canvas.hpp"
#include "studio/screen/layouts.hpp"
#include "studio/workbench/form_screen.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <limits>

namespace rift::studio {
namespace {

/// Every scenario that the preset asks for.
std::vector<scene::Scene> scenes_of_form(const scene::Preset& preset) {
  if (!preset.lanes.empty()) return preset.lanes;
  std::vector<scene::Scene> scenes;
  for (const scene::StudyRow& row : preset.study) scenes.push_back(row.scene);
  if (scenes.empty()) scenes.push_back(preset.scene);
  return scenes;
}

/// "about 0.98 mm", or from the least to the largest of several.
std::string zone_text(const std::vector<scene::Scene>& scenes) {
  double least = std::numeric_limits<double>::infinity(), most = 0;
  for (const scene::Scene& scene : scenes) {
    const double zone = 1e3 * scene::expected_zone_m(scene);
    least = std::min(least, zone), most = std::max(most, zone);
  }
  return least == most ? fmt::format("about {:.3g} mm", most)
                       : fmt::format("about {:.3g} to {:.3g} mm", least, most);
}

/// What follows from the scenarios at once, before any lattice; the first stands for what they share.
DryRunThread::Rows at_once(const std::vector<scene::Scene>& scenes) {
  const scene::Scene& scene = scenes.front();
  DryRunThread::Rows rows{
      {"c_R", fmt::format("{:.0f} m/s", scene::rayleigh_speed(scene))},
      {"density", fmt::format("{:.1f} kg/m³", scene::density(scene))},
      {"thickness", fmt::format("{:.4g} mm", 1e3 * scene::thickness_m(scene))},
      {"mean radius", fmt::format("about {:.3g} mm", 1e3 * scene::expected_mean_radius_m(scene))},
      {"damage zone", zone_text(scenes)}};
  const char* label = "left out";
  for (const std::string& line : scene::left_out_by_scenarios(scenes))
    rows.emplace_back(label, line), label = "";
  return rows;
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

/// "72 scenarios; 36 of 108 combinations are the same as others": of the grid alone.
std::string count_text(const scene::Preset& preset) {
  std::size_t combinations = 0, scenarios = 0;
  for (const scene::StudyRow& row : preset.study) {
    combinations += row.combinations.size();
    scenarios += row.combinations.empty() ? 0 : 1;
  }
  std::string text = fmt::format("{} scenarios", preset.study.size());
  if (combinations > scenarios)
    text += fmt::format(
        "; {} of {} combinations are the same as others, for what means nothing in a "
        "scenario does not count",
        combinations - scenarios, combinations);
  return text;
}

}  // namespace

void FormScreen::draw(Canvas& canvas, Glyphs glyphs) {
  if (draw_too_small(canvas)) return;
  const FormLayout layout = form_layout(canvas.width(), canvas.height());
  draw_head(canvas, layout.head);
  if (search_.typing())
    search_.draw(canvas, layout.search);
  else if (!wanted_.empty())
    canvas.text(layout.search.x, layout.search.y, only_entries_with(wanted_), {Ink::reference},
                layout.search.width);
  list_rows_ = layout.rows.height;
  draw_rows(canvas, layout.rows);
  draw_derived(canvas, layout.derived, 0, "i");
  draw_detail(canvas, layout.detail);
  if (name_.typing())
    name_.draw(canvas, layout.foot);
  else if (leave_.typing())
    leave_.draw(canvas, layout.foot, {Ink::reference, true});
  else
    canvas.text(
        layout.foot.x, layout.foot.y,
        value_.typing() ? "enter accept  escape keep the old value" : foot_of(Where::form, layout.foot.width),
        {Ink::dim}, layout.foot.width);
  if (adding_) draw_others(canvas, glyphs);
  if (details_) draw_details(canvas, glyphs);
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
  canvas.text(x, area.y, fmt::format("{}, {} changed", holds, changed()), {Ink::dim},
              area.x + area.width - x);
}

void FormScreen::draw_rows(Canvas& canvas, const Area& area) {
  list_.keep(static_cast<int>(rows_.size()), list_rows_);
  for (int k = 0; k < area.height && list_.top + k < static_cast<int>(rows_.size()); ++k)
    draw_row(canvas, {area.x, area.y + k, area.width, 1}, rows_[list_.top + k],
             list_.top + k == list_.chosen);
}

void FormScreen::draw_row(Canvas& canvas, const Area& area, const Row& row, bool is_chosen) const {
  if (row.kind == Row::Kind::heading) {
    canvas.text(area.x, area.y, row.name, {Ink::title, true}, area.width);
    return;
  }
  const bool wrong = !issue_of(row).empty(), changed = is_changed(row);
  const bool typed = is_chosen && value_.typing();
  const Style style{wrong ? Ink::bad : Ink::plain, changed, is_chosen && !typed};
  if (is_chosen && !typed) clear(canvas, area, style);
  constexpr int names = 22;
  const bool parameter = row.kind == Row::Kind::parameter;
  canvas.text(area.x + 1, area.y, changed ? "*" : " ", style);
  canvas.text(area.x + 3, area.y, parameter ? scene::name_of(*row.parameter) : row.name, style, names - 1);
  const Area value{area.x + 3 + names, area.y, area.width - names - 3, 1};
  if (typed) {
    value_.draw(canvas, value, {wrong ? Ink::bad : Ink::good, true});
    return;
  }
  if (row.kind == Row::Kind::add_axis) return;
  const bool varied = parameter && !axis_of(*row.parameter).empty();
  const std::string text = varied ? "varied by the study" : value_of(row);
  const bool given = !varied && (!parameter || preset_.origins.contains(row.name));
  canvas.text(value.x, value.y, text.empty() ? "not given" : text,
              {wrong   ? Ink::bad
               : given ? Ink::plain
                       : Ink::dim,
               changed, is_chosen},
              value.width);
}

/// The axes that may be added; below them all that the chosen one says of itself.
void FormScreen::draw_others(Canvas& canvas, Glyphs glyphs) {
  constexpr int doc_lines = 2;
  const std::vector<std::string_view> others = grid_.others();
  const int count = static_cast<int>(others.size());
  const Area inside = draw_box(canvas, std::min(canvas.width() - 4, 100),
                               std::min(count + doc_lines + 1, canvas.height() - 4),
                               "add an axis to the study (enter; escape: none)", glyphs);
  other_rows_ = inside.height - doc_lines - 1;
  others_.keep(count, other_rows_);
  const auto doc_of = [](std::string_view axis) { return scene::parameter_of(*scene::find_axis(axis)).doc; };
  for (int k = 0; k < other_rows_ && others_.top + k < count; ++k) {
    const std::string_view axis = others[others_.top + k];
    const Style style{Ink::plain, false, others_.top + k == others_.chosen};
    clear(canvas, {inside.x, inside.y + k, inside.width, 1}, style);
    canvas.text(inside.x + 1, inside.y + k, fmt::format("{:<18} {}", axis, doc_of(axis)), style,
                inside.width - 2);
  }
  draw_paragraph(canvas, {inside.x + 1, inside.y + inside.height - doc_lines, inside.width - 2, doc_lines},
                 doc_of(others[others_.chosen]), {Ink::dim});
}

void FormScreen::draw_detail(Canvas& canvas, const Area& area) const {
  if (!message_.empty()) {
    draw_paragraph(canvas, area, message_, {Ink::reference});
    return;
  }
  const Row* row = chosen();
  if (row == nullptr) return;
  if (row->parameter == nullptr) {
    draw_paragraph(canvas, area,
                   "An axis varies a parameter over a list of values; the study has a scenario for every "
                   "combination of the lists.",
                   {Ink::dim});
    return;
  }
  const bool axis = row->kind == Row::Kind::axis;
  const std::string issue = issue_of(*row);
  const int lines =
      draw_paragraph(canvas, {area.x, area.y, area.width, area.height - (issue.empty() ? 1 : 2)},
                     fmt::format("{}  {}", row->parameter->key, row->parameter->doc));
  canvas.text(
      area.x, area.y + lines,
      fmt::format("allowed{}: {}", axis ? ", several with commas" : "", scene::allowed(*row->parameter)),
      {Ink::dim}, area.width);
  canvas.text(area.x, area.y + lines + 1, issue, {Ink::bad, true}, issue.empty() ? 0 : area.width);
}

/// As many lines as there is room for, from one of them on; the last line says how many do not fit, and which
/// key shows them.
/// @return the lines in all
int FormScreen::draw_derived(Canvas& canvas, const Area& area, int from, const char* key) const {
  constexpr int most_lines = 300;
  Canvas all(area.width, most_lines);
  const int lines = draw_all_derived(all, {0, 0, area.width, most_lines}), left = lines - from;
  const int shown = left > area.height ? area.height - 1 : left;
  for (int y = 0; y < shown; ++y)
    for (int x = 0; x < area.width; ++x)
      canvas.put(area.x + x, area.y + y, all.at(x, from + y).glyph, all.at(x, from + y).style);
  if (shown < left)
    canvas.text(area.x, area.y + shown,
                fmt::format("+{} ({})", base::counted(left - shown, "more line"), key), {Ink::dim},
                area.width);
  return lines;
}

/// All that follows from the values, over the form.
void FormScreen::draw_details(Canvas& canvas, Glyphs glyphs) {
  const Area inside = draw_box(canvas, canvas.width() - 4, canvas.height() - 4,
                               "what follows from these values (escape closes)", glyphs);
  const Area text{inside.x + 1, inside.y, inside.width - 2, inside.height};
  const int lines = draw_derived(canvas, text, details_from_, "down");
  details_from_ = std::min(details_from_, std::max(0, lines - text.height));
}

/// @return the lines it took
int FormScreen::draw_all_derived(Canvas& canvas, const Area& area) const {
  int y = area.y;
  const int end = area.y + area.height;
  const auto row = [&](const std::string& label, const std::string& text, const Style& style = {}) {
    if (y >= end) return;
    constexpr int labels = 13;
    canvas.text(area.x, y, label, {Ink::reference, true}, labels - 1);
    y += std::max(1, draw_paragraph(canvas, {area.x + labels, y, area.width - labels, end - y}, text, style));
  };
  for (const scene::Issue& issue : preset_.issues)
    row(y == area.y ? "mistakes" : "",
        issue.key.empty() ? scene::to_text(issue) : scene::without_place(issue), {Ink::bad});
  if (!preset_.issues.empty()) return y - area.y;
  if (const std::string note = scene::note_on_layers(preset_); !note.empty()) row("note", note);
  const DryRunThread::Found found = dry_run_.found();
  const bool study = !preset_.study.empty();
  const auto rows = [&](const DryRunThread::Rows& all) {
    for (const auto& [label, text] : all) row(label, text);
  };
  const auto expected = [&](const char* label) {
    if (found.rows.empty() && found.trouble.empty())
      row(label, found.doing.empty() ? "starting" : found.doing, {Ink::dim});
  };
  if (study) row("study", count_text(preset_)), expected("cost");
  rows(what_it_costs_first(found.rows));
  if (!found.rows.empty() && !study) return y - area.y;
  rows(at_once(scenes_of_form(preset_)));
  if (!study) expected("dry run");
  if (!found.trouble.empty()) row("failed", found.trouble, {Ink::bad});
  return y - area.y;
}

}  // namespace rift::studio

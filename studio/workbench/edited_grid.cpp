#include "studio/workbench/edited_grid.hpp"

#include "engine/base/text.hpp"
#include "engine/scene/issue.hpp"
#include "engine/scene/scenarios.hpp"

#include <algorithm>
#include <set>

namespace rift::studio {
namespace {

using List = EditedGrid::List;

/// A value without its quotes, where it needs none to be told from its neighbours.
std::string plain(const std::string& value) {
  return value.find(',') == std::string::npos ? base::without_quotes(value) : value;
}

std::string joined(const std::vector<std::string>& values) {
  std::string out;
  for (const std::string& value : values) out += (out.empty() ? "" : ", ") + plain(value);
  return out;
}

/// The values between the commas that stand in no brackets and no quotes: a path's points and a velocity in
/// pieces hold some themselves.
std::vector<std::string> parted(std::string_view text) {
  std::vector<std::string> values;
  int depth = 0;
  bool quoted = false;
  std::size_t from = 0;
  for (std::size_t k = 0; k <= text.size(); ++k) {
    const bool end = k == text.size();
    const char letter = end ? ',' : text[k];
    quoted = quoted != (letter == '"');
    depth += letter == '[' ? 1 : letter == ']' ? -1 : 0;
    if (letter != ',' || ((depth > 0 || quoted) && !end)) continue;
    if (const auto value = scene::trimmed(text.substr(from, k - from)); !value.empty())
      values.emplace_back(value);
    from = k + 1;
  }
  return values;
}

std::optional<std::string> values_in(const std::vector<List>& lists, std::string_view axis) {
  const auto found = std::find_if(lists.begin(), lists.end(), [&](const List& l) { return l.axis == axis; });
  return found == lists.end() ? std::nullopt : std::optional(found->values);
}

}  // namespace

EditedGrid::EditedGrid(const std::vector<scene::GridAxis>& of_file) {
  for (const scene::GridAxis& axis : of_file) of_file_.push_back({axis.name, joined(axis.values)});
  lists_ = of_file_;
}

std::optional<std::string> EditedGrid::values_of(std::string_view axis) const {
  return values_in(lists_, axis);
}

std::optional<std::string> EditedGrid::of_file(std::string_view axis) const {
  return values_in(of_file_, axis);
}

int EditedGrid::changed() const {
  std::set<std::string> names;
  for (const std::vector<List>* lists : {&lists_, &of_file_})
    for (const List& list : *lists)
      if (is_changed(list.axis)) names.insert(list.axis);
  return static_cast<int>(names.size());
}

std::vector<scene::GridAxis> EditedGrid::grid() const {
  std::vector<scene::GridAxis> grid;
  for (const List& list : lists_) grid.push_back({list.axis, parted(list.values)});
  return grid;
}

std::vector<std::string_view> EditedGrid::others() const {
  std::vector<std::string_view> names;
  for (const scene::Axis& axis : scene::axes())
    if (!values_of(axis.name)) names.push_back(axis.name);
  return names;
}

void EditedGrid::set(std::string_view axis, std::string values) {
  for (List& list : lists_)
    if (list.axis == axis) list.values = std::move(values);
}

void EditedGrid::add(std::string_view axis, const scene::Scene& scene) {
  const std::string now = scene::toml_value(scene, scene::parameter_of(*scene::find_axis(axis)));
  lists_.push_back({std::string(axis), of_file(axis).value_or(plain(now))});
}

void EditedGrid::drop(std::string_view axis) {
  std::erase_if(lists_, [&](const List& list) { return list.axis == axis; });
}

void EditedGrid::take_back(std::string_view axis) {
  if (const auto values = of_file(axis))
    set(axis, *values);
  else
    drop(axis);
}

}  // namespace rift::studio

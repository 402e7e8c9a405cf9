#include "studio/reports/report.hpp"

#include "engine/base/files.hpp"
#include "engine/base/process_limits.hpp"
#include "engine/scene/needs.hpp"
#include "engine/scene/parameters.hpp"
#include "studio/text/html.hpp"
#include "studio/text/progress.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <ctime>

namespace rift::studio {

namespace {

constexpr std::size_t longest_value = 60;  // of a parameter

/// This moment, as strftime formats it.
std::string now_text(const char* format) {
  const std::time_t now = std::time(nullptr);
  std::tm local{};
  localtime_r(&now, &local);
  std::array<char, 64> text{};
  std::strftime(text.data(), text.size(), format, &local);
  return text.data();
}

/// A value as it is shown: of rows, which may be many, how many there are and the first and the last.
std::string shown_value(const std::string& value) {
  if (value.size() <= longest_value) return value;
  const std::size_t first = value.find(']'), last = value.rfind('[');
  if (!value.starts_with("[[") || last <= first) return value.substr(0, longest_value) + " ...";
  return fmt::format("{} rows, {} to {}", std::count(value.begin(), value.end(), ']') - 1,
                     value.substr(1, first), value.substr(last, value.size() - last - 1));
}

/// The parameters of a preset that its scene uses, but those of pictures, in the order of presets.
std::vector<std::pair<std::string, std::string>> parameters_of(const scene::Scene& scene, bool marched) {
  std::vector<std::pair<std::string, std::string>> values;
  for (const scene::Parameter& row : scene::parameters()) {
    const std::string table = scene::table_of(row);
    if (!marched && table != "specimen" && table != "material" && table != "calibration") continue;
    if (table == "film" || (table == "calibration" && !scene::needs_calibration(scene))) continue;
    const std::string value = scene::toml_value(scene, row);
    if (!value.empty() && scene::is_used(scene, row.key)) values.emplace_back(row.key, shown_value(value));
  }
  return values;
}

/// Those of `kept` that the list has too.
template <class List>
void keep_common(List& kept, const List& list) {
  std::erase_if(kept,
                [&](const auto& one) { return std::find(list.begin(), list.end(), one) == list.end(); });
}

}  // namespace

std::string today_text() { return now_text("%Y-%m-%d"); }

std::string preset_in_titles(const std::string& preset) {
  return std::filesystem::path(preset).stem().string();
}

std::string html_made(const Made& made) {
  Table table{{}, {}};
  if (!made.command.empty()) table.rows.push_back({"command", made.command});
  table.rows.push_back(
      {"version", fmt::format("rift {}{}", made.build.version,
                              made.build.compiler.empty() ? "" : fmt::format(" ({})", made.build.compiler))});
  table.rows.push_back({"machine", base::machine_text()});
  table.rows.push_back(
      {"made", now_text("%Y-%m-%d %H:%M %Z") + (made.wall_s ? ", in " + duration_text(*made.wall_s) : "")});
  return html_facts(table);
}

SharedParts shared_parts(const std::vector<scene::Scene>& scenes, bool marched) {
  SharedParts shared;
  if (scenes.empty()) return shared;
  shared.parameters = parameters_of(scenes.front(), marched);
  for (const scene::Scene& scene : scenes) keep_common(shared.parameters, parameters_of(scene, marched));
  if (marched) shared.left_out = scene::left_out_by_scenarios(scenes);
  return shared;
}

std::string html_scenes(const std::vector<scene::Scene>& scenes, bool marched) {
  if (scenes.empty()) return {};
  const SharedParts shared = shared_parts(scenes, marched);
  Table table{{}, {}};
  for (const auto& [key, value] : shared.parameters) table.rows.push_back({key, value});
  std::string html =
      html_section("Fixed parameters",
                   html_paragraph("By their keys in a preset; numbers are in SI units.") + html_pairs(table));
  if (!shared.left_out.empty()) html += html_section("Left out", html_list(shared.left_out));
  return html;
}

std::string html_figures(const std::vector<NamedChart>& charts, const std::filesystem::path& folder,
                         std::optional<base::WorldError>& failure) {
  std::string html;
  for (const NamedChart& named : charts) {
    try {
      html += html_figure(draw_chart(named, folder).svg_text, named.caption);
    } catch (const base::WorldError& error) {
      failure.emplace(error);
      html += html_paragraph(error.what());
    }
  }
  return html;
}

void write_report(const Report& report, const std::filesystem::path& folder) {
  base::make_folder(folder);
  for (const auto& [name, text] : report.files) base::write_whole_file(folder / name, text);
  std::string body = html_made(report.made);
  for (const std::string& paragraph : report.opening) body += html_paragraph(paragraph);
  std::optional<base::WorldError> failure;
  for (const ReportSection& section : report.sections) {
    std::string html;
    if (const auto* text = std::get_if<std::string>(&section.content)) html = *text;
    if (const auto* table = std::get_if<Table>(&section.content); table && !table->rows.empty())
      html = html_table(*table);
    if (const auto* charts = std::get_if<std::vector<NamedChart>>(&section.content))
      html = html_figures(*charts, folder / "charts", failure);
    if (!section.note.empty()) html = html_paragraph(section.note) + html;
    if (!html.empty()) body += html_section(section.title, html);
  }
  body += html_scenes(report.scenes, report.marched);
  base::write_whole_file(folder / "report.html", html_page(report.title, body));
  if (failure) throw base::WorldError(*failure);
}

}  // namespace rift::studio

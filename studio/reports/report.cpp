#include "studio/reports/report.hpp"

#include "engine/base/files.hpp"
#include "studio/text/html.hpp"
#include "studio/text/progress.hpp"

#include <fmt/format.h>

namespace rift::studio {

std::string made_by(const std::string& command, const simulation::BuildInfo& build,
                    std::optional<double> wall_s) {
  return fmt::format("Made by `{}`, rift {}{}{}.", command, build.version,
                     build.compiler.empty() ? "" : fmt::format(" ({})", build.compiler),
                     wall_s ? ", in " + duration_text(*wall_s) : "");
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
  std::string body;
  for (const std::string& paragraph : report.opening) body += html_paragraph(paragraph);
  std::optional<base::WorldError> failure;
  for (const auto& [title, content] : report.sections) {
    std::string html;
    if (const auto* text = std::get_if<std::string>(&content)) html = *text;
    if (const auto* table = std::get_if<Table>(&content)) html = html_table(*table);
    if (const auto* charts = std::get_if<std::vector<NamedChart>>(&content))
      html = html_figures(*charts, folder / "charts", failure);
    body += html_section(title, html);
  }
  base::write_whole_file(folder / "report.html", html_page(report.title, body));
  if (failure) throw base::WorldError(*failure);
}

}  // namespace rift::studio

#include "studio/report/study_report.hpp"

#include "engine/base/files.hpp"
#include "engine/base/world_error.hpp"
#include "engine/study/store.hpp"
#include "studio/report/html.hpp"
#include "studio/report/progress.hpp"
#include "studio/report/study_charts.hpp"
#include "studio/report/study_table.hpp"

#include <fmt/format.h>

#include <optional>

namespace rift::studio {
namespace fs = std::filesystem;
namespace {

std::vector<fs::path> series_files(const scene::Preset& preset, const simulation::BuildInfo& build,
                                   const fs::path& folder) {
  std::vector<fs::path> files;
  for (const scene::Scene& scene : study::scenes_of_study(preset))
    files.push_back(
        study::result_file(folder, study::result_key(scene, build.version)).replace_extension(".csv"));
  return files;
}

std::string timings(const study::StudyResult& result) {
  double marching = 0.0;
  std::size_t there = 0;
  for (const study::SummaryRow& row : result.rows)
    if (!row.is_null()) marching += row.at("wall_fracture_s").get<double>(), ++there;
  return html_paragraph(
      fmt::format("{} of {} scenarios; the cracks took {} in all, the last call {} ({} computed, {} found).",
                  there, result.rows.size(), duration_text(marching), duration_text(result.wall_s),
                  result.computed, result.found));
}

std::string tables(const study::StudyResult& result) {
  std::string body;
  const Table seeds = seed_table(result.rows);
  if (!seeds.rows.empty()) body += html_section("Mean and scatter over seeds", html_table(seeds));
  return body + html_section("Scenarios", html_table(scenario_table(result.rows)));
}

}  // namespace

void write_study_report(const scene::Preset& preset, const simulation::BuildInfo& build,
                        const study::StudyResult& result, const fs::path& folder) {
  std::string figures;
  std::optional<base::WorldError> failure;
  std::vector<NamedChart> charts = velocity_charts(result.rows);
  for (NamedChart& chart : tip_charts(result.rows, series_files(preset, build, folder)))
    charts.push_back(std::move(chart));
  for (const NamedChart& named : charts) {
    try {
      figures += html_figure(draw_chart(named.chart, folder / "charts", named.name).svg_text, named.caption);
    } catch (const base::WorldError& error) {
      failure = error;
      figures += html_paragraph(fmt::format("{}: {}", named.name, error.what()));
    }
  }
  const std::string name = fs::path(preset.name).stem().string();
  std::string body =
      html_paragraph(fmt::format("Preset {}, rift {} ({}).", preset.name, build.version, build.compiler));
  body += timings(result) + tables(result) + html_section("Charts", figures);
  base::write_whole_file(folder / "report.html", html_page("Study " + name, body));
  if (failure) throw base::WorldError(*failure);
}

}  // namespace rift::studio

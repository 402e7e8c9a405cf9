#include "studio/reports/packing_report.hpp"

#include "engine/base/files.hpp"
#include "engine/base/text.hpp"
#include "engine/scene/parameters.hpp"
#include "studio/charts/chart.hpp"
#include "studio/text/html.hpp"
#include "studio/text/progress.hpp"

#include <fmt/format.h>

namespace rift::studio {

namespace fs = std::filesystem;
namespace {

using Json = nlohmann::ordered_json;
using Style = ChartSeries::Style;

std::string shape_name(const scene::Scene& scene) {
  const std::string quoted = scene::toml_value(scene, *scene::find_parameter("specimen.shape"));
  return quoted.substr(1, quoted.size() - 2);
}

Chart coordination_chart(const Json& summary) {
  Chart chart;
  chart.title = "Contacts of the elements";
  chart.x_label = "contacts [-]";
  chart.y_label = "share of the elements [-]";
  chart.y_range = {0.0, {}};
  ChartSeries series{"", {}, {}, {}, Style::line_points, 0};
  const Json& counts = summary.at("coordination_histogram");
  for (std::size_t k = 0; k < counts.size(); ++k) {
    series.x.push_back(static_cast<double>(k));
    series.y.push_back(counts[k].get<double>() / summary.at("elements").get<double>());
  }
  chart.series = {series};
  chart.marks = {{summary.at("coordination"), summary.at("coordination"), "mean"}};
  return chart;
}

Chart pair_chart(const Json& summary) {
  Chart chart;
  chart.title = "Pair correlation";
  chart.x_label = "distance over the mean diameter [-]";
  chart.y_label = "g [-]";
  chart.y_range = {0.0, {}};
  chart.series = {
      {"packing", summary.at("pair_distance"), summary.at("pair_correlation"), {}, Style::line, 0},
      {"points at random", {0.0, 2.5}, {1.0, 1.0}, {}, Style::dashed, -1}};
  return chart;
}

}  // namespace

Json packing_json(const PackedSpecimen& s) {
  const packing::PackingStatistics statistics = packing::statistics(s.packing, s.box);
  const packing::PackingStructure structure = packing::structure_of(s.packing, s.box);
  Json fabric = Json::array();
  for (int r = 0; r < 3; ++r)
    fabric.push_back({structure.fabric(r, 0), structure.fabric(r, 1), structure.fabric(r, 2)});
  return {{"version", s.build.version},
          {"shape", shape_name(s.scene)},
          {"length_m", s.box.length},
          {"height_m", s.box.height},
          {"thickness_m", s.box.thickness},
          {"volume_m3", s.box.volume()},
          {"seed", s.scene.specimen.seed},
          {"elements", s.packing.radius.size()},
          {"beams", s.beams},
          {"rattlers", s.rattlers},
          {"coordination", statistics.coordination},
          {"solid_fraction", statistics.solid_fraction},
          {"mean_overlap", statistics.mean_overlap},
          {"mean_radius_m", statistics.mean_radius},
          {"fabric", fabric},
          {"fabric_deviation", structure.fabric_deviation},
          {"coordination_histogram", structure.coordination},
          {"pair_distance", structure.distance},
          {"pair_correlation", structure.pair_correlation},
          {"from_cache", s.from_cache},
          {"wall_packing_s", s.wall_s}};
}

std::string packing_text(const Json& j, bool color) {
  std::string text =
      heading(fmt::format("{} of {} elements", j.at("shape").get<std::string>(), j.at("elements").get<int>()),
              color) +
      "\n";
  const auto row = [&](const char* label, const std::string& value) {
    text += fmt::format("  {:<16}{}\n", label, value);
  };
  row("size", fmt::format("{:.4g} x {:.4g} x {:.4g} mm", 1e3 * j.at("length_m").get<double>(),
                          1e3 * j.at("height_m").get<double>(), 1e3 * j.at("thickness_m").get<double>()));
  row("mean radius", fmt::format("{:.4g} mm", 1e3 * j.at("mean_radius_m").get<double>()));
  row("beams", fmt::format("{}, {} elements without any load path", j.at("beams").get<long>(),
                           j.at("rattlers").get<int>()));
  row("coordination", fmt::format("{:.3f}", j.at("coordination").get<double>()));
  row("solid fraction", fmt::format("{:.4f}", j.at("solid_fraction").get<double>()));
  row("mean overlap", fmt::format("{:.2f} %", 100.0 * j.at("mean_overlap").get<double>()));
  row("fabric", fmt::format("xx {:.4f}, yy {:.4f}, zz {:.4f}; off from isotropic by {:.4f}",
                            j.at("fabric")[0][0].get<double>(), j.at("fabric")[1][1].get<double>(),
                            j.at("fabric")[2][2].get<double>(), j.at("fabric_deviation").get<double>()));
  row("took", j.at("from_cache").get<bool>() ? std::string("found in the cache")
                                             : duration_text(j.at("wall_packing_s").get<double>()));
  return text;
}

void write_packing_report(const PackedSpecimen& s, const Json& summary, const fs::path& folder) {
  base::make_folder(folder);
  base::write_whole_file(folder / "summary.json", base::json_text(summary, 2) + "\n");
  std::string csv = "x_m,y_m,z_m,radius_m\n";
  for (std::size_t i = 0; i < s.packing.radius.size(); ++i) {
    const Eigen::Vector3d& p = s.packing.centre[i];
    csv += fmt::format("{:.9g},{:.9g},{:.9g},{:.9g}\n", p.x(), p.y(), p.z(), s.packing.radius[i]);
  }
  base::write_whole_file(folder / "elements.csv", csv);
  const std::string figures =
      html_figure(
          draw_chart(coordination_chart(summary), folder / "charts", "coordination").svg_text,
          "Shares of the elements by their number of contacts; contacts with walls are not counted.") +
      html_figure(draw_chart(pair_chart(summary), folder / "charts", "pair_correlation").svg_text,
                  "Pairs of elements by their distance, over pairs of points at random in the same space.");
  base::write_whole_file(
      folder / "report.html",
      html_page("Packing",
                html_section("Specimen", "<pre>" + html_escape(packing_text(summary, false)) + "</pre>") +
                    html_section("Charts", figures)));
}

}  // namespace rift::studio

#include "studio/reports/packing_report.hpp"

#include "engine/base/text.hpp"
#include "engine/scene/parameters.hpp"
#include "studio/reports/report.hpp"
#include "studio/text/html.hpp"
#include "studio/text/progress.hpp"

#include <fmt/format.h>

namespace rift::studio {

namespace {

using Json = nlohmann::ordered_json;
using Style = ChartSeries::Style;

NamedChart coordination_chart(const Json& summary) {
  ChartSeries series{.style = Style::line_points, .name = "packing"};
  for (const Json& count : summary.at("coordination_histogram"))
    series.add(static_cast<double>(series.x.size()),
               count.get<double>() / summary.at("elements").get<double>());
  return {"coordination",
          "Fraction of the elements by number of contacts; contacts with walls are not counted.",
          Chart{.title = "Contacts of the elements",
                .x_label = "contacts [-]",
                .y_label = "fraction of the elements [-]",
                .y_range = {.min = 0.0},
                .series = {std::move(series)},
                .marks = {{summary.at("coordination"), summary.at("coordination"), "mean"}}}};
}

NamedChart pair_chart(const Json& summary) {
  return {
      "pair_correlation",
      "Number of element pairs by distance, over the number of pairs of random points in the same space.",
      Chart{.title = "Pair correlation",
            .x_label = "distance over the mean diameter [-]",
            .y_label = "g [-]",
            .y_range = {.min = 0.0},
            .series = {
                {.label = "packing", .x = summary.at("pair_distance"), .y = summary.at("pair_correlation")},
                level("random points", 1.0, 0.0, 2.5)}}};
}

}  // namespace

Json packing_json(const PackedSpecimen& s) {
  const packing::PackingStatistics statistics = packing::statistics(s.packing, s.box);
  const packing::PackingStructure structure = packing::structure_of(s.packing, s.box);
  Json fabric = Json::array();
  for (int r = 0; r < 3; ++r)
    fabric.push_back({structure.fabric(r, 0), structure.fabric(r, 1), structure.fabric(r, 2)});
  return {{"version", s.build.version},
          {"shape", scene::word_of("specimen.shape", s.scene.specimen.shape)},
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
  const auto row = [&](const char* label, const std::string& value) { text += label_line(label, value, 16); };
  row("size", fmt::format("{:.4g} x {:.4g} x {:.4g} mm", 1e3 * j.at("length_m").get<double>(),
                          1e3 * j.at("height_m").get<double>(), 1e3 * j.at("thickness_m").get<double>()));
  row("mean radius", fmt::format("{:.4g} mm", 1e3 * j.at("mean_radius_m").get<double>()));
  row("beams", fmt::format("{}, {} without a load path", j.at("beams").get<long>(),
                           base::counted(j.at("rattlers").get<int>(), "element")));
  row("coordination", fmt::format("{:.3f}", j.at("coordination").get<double>()));
  row("solid fraction", fmt::format("{:.4f}", j.at("solid_fraction").get<double>()));
  row("mean overlap", fmt::format("{:.2f} %", 100.0 * j.at("mean_overlap").get<double>()));
  row("fabric", fmt::format("xx {:.4f}, yy {:.4f}, zz {:.4f}; deviation from isotropy {:.4f}",
                            j.at("fabric")[0][0].get<double>(), j.at("fabric")[1][1].get<double>(),
                            j.at("fabric")[2][2].get<double>(), j.at("fabric_deviation").get<double>()));
  row("time", j.at("from_cache").get<bool>() ? std::string("from the cache")
                                             : duration_text(j.at("wall_packing_s").get<double>()));
  return text;
}

void write_packing_report(const PackedSpecimen& s, const Json& summary, const std::filesystem::path& folder) {
  std::string csv = "x_m,y_m,z_m,radius_m\n";
  for (std::size_t i = 0; i < s.packing.radius.size(); ++i) {
    const Eigen::Vector3d& p = s.packing.centre[i];
    csv += fmt::format("{:.9g},{:.9g},{:.9g},{:.9g}\n", p.x(), p.y(), p.z(), s.packing.radius[i]);
  }
  write_report({.title = fmt::format("Packing of a {} of {} elements", summary.at("shape").get<std::string>(),
                                     summary.at("elements").get<std::size_t>()),
                .made = {s.command, s.build, s.wall_s},
                .scenes = {s.scene},
                .marched = false,
                .files = {{"summary.json", base::json_text(summary, 2) + "\n"}, {"elements.csv", csv}},
                .sections = {{"Specimen", html_lines(packing_text(summary, false))},
                             {"Charts", std::vector{coordination_chart(summary), pair_chart(summary)}}}},
               folder);
}

}  // namespace rift::studio

#include "studio/reports/calibration_report.hpp"

#include "engine/base/text.hpp"
#include "engine/calibration/calibrate.hpp"
#include "engine/claims/curve.hpp"
#include "engine/lattice/lattice.hpp"
#include "studio/reports/report.hpp"
#include "studio/reports/study_report.hpp"
#include "studio/text/html.hpp"

#include <fmt/format.h>

#include <map>

namespace rift::studio {

namespace {

using Json = nlohmann::ordered_json;

constexpr const char* left_out =
    "Left out: a scan of E_µ, because every modulus is proportional to it; a scan of ν_µ, which changes E "
    "and ν by less than 0.5 %.";

Json json_of(const calibration::Scattered& s) { return {{"mean", s.mean}, {"deviation", s.deviation}}; }

/// Means over the packings of each size, and the boxes, in GPa with the paper's beams.
Table table_of(const calibration::CalibrationStudy& study) {
  constexpr double micro = lattice::bulk_micro_material.young_modulus / 1e9;
  Table table{{"specimens", "elements", "packings", "core coordination", "solid fraction", "E [GPa]",
               "E, ends [GPa]", "ν", "anisotropy"},
              {}};
  const auto mean_of = [](const auto& all, const auto& of) {
    std::vector<double> values;
    for (const auto& one : all) values.push_back(of(one));
    return calibration::scattered(values);
  };
  const auto text = [](const calibration::Scattered& s, int digits) {
    return scatter_cell(s.mean, s.deviation, digits);
  };
  for (const auto& packings : study.by_size)
    table.rows.push_back(
        {"cylinders", fmt::format("{}", packings.front().packing.elements),
         fmt::format("{}", packings.size()),
         text(mean_of(packings, [](const auto& c) { return c.core_coordination; }), 3),
         text(mean_of(packings, [](const auto& c) { return c.solid_fraction; }), 4),
         text(mean_of(packings, [](const auto& c) { return micro * c.responses[0].young_over_micro; }), 2),
         text(mean_of(packings, [](const auto& c) { return micro * c.responses[0].ends_over_micro; }), 2),
         text(mean_of(packings, [](const auto& c) { return c.responses[0].poisson_ratio; }), 3), "-"});
  const std::size_t half = study.boxes.size() / 2;
  for (const std::vector<calibration::BoxResult>& boxes :
       {std::vector<calibration::BoxResult>(study.boxes.begin(), study.boxes.begin() + half),
        std::vector<calibration::BoxResult>(study.boxes.begin() + half, study.boxes.end())})
    table.rows.push_back(
        {"periodic boxes", fmt::format("{}", boxes.front().packing.elements), fmt::format("{}", boxes.size()),
         text(mean_of(boxes, [](const auto& b) { return b.coordination; }), 3),
         text(mean_of(boxes, [](const auto& b) { return b.solid_fraction; }), 4),
         text(mean_of(boxes, [](const auto& b) { return micro * b.isotropic().young_modulus; }), 2), "-",
         text(mean_of(boxes, [](const auto& b) { return b.isotropic().poisson_ratio; }), 3),
         text(mean_of(boxes, [](const auto& b) { return b.isotropic().anisotropy; }), 4)});
  return table;
}

Table scan_table(const calibration::CalibrationStudy& study) {
  Table table{{"r_µ", "ν_µ", "E_M / E_µ", "ν"}, {}};
  const auto add = [&](const std::vector<calibration::CylinderResult>& cylinders) {
    const auto young = calibration::young_of(cylinders), nu = calibration::poisson_of(cylinders);
    for (std::size_t k = 0; k < young.size(); ++k)
      table.rows.push_back({fmt::format("{:g}", cylinders.front().beams[k].radius_ratio),
                            fmt::format("{:g}", cylinders.front().beams[k].poisson_ratio),
                            fmt::format("{:.5f} ± {:.5f}", young[k].mean, young[k].deviation),
                            scatter_cell(nu[k].mean, nu[k].deviation, 4)});
  };
  add(study.scan);
  add(study.twisted);
  return table;
}

/// The tensor of the largest core coordination's first box, in GPa.
Table tensor_table(const calibration::CalibrationStudy& study) {
  Table table{{"[GPa]", "xx", "yy", "zz", "yz", "xz", "xy"}, {}};
  const calibration::BoxResult& box = study.boxes.back();
  for (int r = 0; r < 6; ++r) {
    table.rows.push_back({table.head[r + 1]});
    for (int c = 0; c < 6; ++c)
      table.rows.back().push_back(
          fmt::format("{:.3f}", lattice::bulk_micro_material.young_modulus / 1e9 * box.stiffness(r, c)));
  }
  return table;
}

}  // namespace

std::string material_block(const Calibration& c) {
  const lattice::MicroMaterial& m = c.beams.micro;
  return fmt::format(
      "# Calibrated by {} cylinders of {} elements at a coordination of {:g}: E = {:.4g} GPa, ν = "
      "{:.4f}\n[material]\nyoung_modulus = \"{:.10g} GPa\"\npoisson_ratio = {:.10g}\nstiffness = "
      "\"explicit\"\nmicro_young_modulus = \"{:.10g} GPa\"\nmicro_poisson_ratio = "
      "{:.10g}\nmicro_radius_ratio = {:.10g}\n",
      c.scene.calibration.packings, c.scene.calibration.elements, c.scene.specimen.coordination,
      c.beams.young_modulus.mean / 1e9, c.beams.poisson_ratio.mean, c.scene.material.young_modulus / 1e9,
      c.scene.material.poisson_ratio, m.young_modulus / 1e9, m.poisson_ratio, m.radius_ratio);
}

std::string calibration_text(const Calibration& c, bool color) {
  const calibration::Calibrated& b = c.beams;
  std::string text = heading(fmt::format("E = {:.4g} GPa, ν = {:g}", c.scene.material.young_modulus / 1e9,
                                         c.scene.material.poisson_ratio),
                             color) +
                     "\n";
  text += fmt::format("  E_µ         {} GPa between packings\n",
                      scatter_cell(b.micro.young_modulus / 1e9, b.micro_young_deviation / 1e9, 2));
  text += fmt::format("  ν_µ         {:g}\n", b.micro.poisson_ratio);
  text += fmt::format("  r_µ         {} between packings\n",
                      scatter_cell(b.micro.radius_ratio, b.radius_ratio_deviation, 4));
  text += fmt::format(
      "  ± is the standard deviation between {} cylinders of {} elements, whose measured constants are\n",
      c.scene.calibration.packings, c.scene.calibration.elements);
  text += fmt::format("  E           {} GPa between packings\n",
                      scatter_cell(b.young_modulus.mean / 1e9, b.young_modulus.deviation / 1e9, 3));
  text += fmt::format("  ν           {} between packings\n",
                      scatter_cell(b.poisson_ratio.mean, b.poisson_ratio.deviation, 4));
  text += fmt::format("  attainable  ν from {:.3f} to {:.3f}\n", b.attainable[0], b.attainable[1]);
  return text + fmt::format("  {}\n\n", left_out) + material_block(c);
}

Json calibration_json(const Calibration& c) {
  const calibration::Calibrated& b = c.beams;
  Json j{{"version", c.build.version},
         {"young_modulus_pa", c.scene.material.young_modulus},
         {"poisson_ratio", c.scene.material.poisson_ratio},
         {"micro_young_modulus_pa", b.micro.young_modulus},
         {"micro_young_modulus_deviation_pa", b.micro_young_deviation},
         {"micro_poisson_ratio", b.micro.poisson_ratio},
         {"micro_radius_ratio", b.micro.radius_ratio},
         {"micro_radius_ratio_deviation", b.radius_ratio_deviation},
         {"measured_young_modulus_pa", json_of(b.young_modulus)},
         {"measured_poisson_ratio", json_of(b.poisson_ratio)},
         {"attainable_poisson_ratio", b.attainable},
         {"elements", c.scene.calibration.elements},
         {"packings", c.scene.calibration.packings},
         {"left_out", left_out},
         {"material", material_block(c)}};
  if (c.study) j["rows"] = calibration::rows_of(*c.study);
  return j;
}

void write_calibration_report(const Calibration& c, const std::filesystem::path& folder) {
  const std::vector<Json> rows = calibration::rows_of(*c.study);
  write_report(
      {.title = fmt::format("Beams of a material of E = {:.4g} GPa and Poisson's ratio {:g}",
                            c.scene.material.young_modulus / 1e9, c.scene.material.poisson_ratio),
       .made = {c.command, c.build, c.wall_s},
       .scenes = {c.scene},
       .marched = false,
       .files = {{"summary.json", base::json_text(calibration_json(c), 2) + "\n"},
                 {"table.csv", rows_csv(rows)},
                 {"material.toml", material_block(c)}},
       .sections = {{"Answer", html_lines(calibration_text(c, false))},
                    {"Specimens with the paper's beams (E_µ = 356 GPa, ν_µ = 0.3, r_µ = 0.3); ± is the "
                     "scatter between packings",
                     table_of(*c.study)},
                    {"Scan of the beams; ± is the scatter between packings", scan_table(*c.study)},
                    {"Stiffness tensor of a periodic box", tensor_table(*c.study)},
                    {"Charts", calibration_charts(rows, lattice::bulk_micro_material.young_modulus)}}},
      folder);
}

namespace {

using Style = ChartSeries::Style;

/// Rows of one kind of specimen, and what of them is drawn.
struct Drawn {
  const char *series, *label, *x, *y;
  double scale;
  int colour;
};

/// Mean and deviation of one number over the rows that share another.
ChartSeries means_of(const std::vector<Json>& rows, const Drawn& d) {
  std::map<double, std::vector<double>> values;
  for (const Json& row : rows)
    if (row.at("series") == d.series && row.at(d.y).is_number())
      values[row.at(d.x).get<double>()].push_back(d.scale * row.at(d.y).get<double>());
  return series_of(d.label, Style::line_points, d.colour, values, [](const auto& at) {
    const calibration::Scattered s = calibration::scattered(at.second);
    return ChartPoint{at.first, s.mean, s.deviation};
  });
}

/// One point a packing, for what has no two packings of the same abscissa.
ChartSeries cloud_of(const std::vector<Json>& rows, const Drawn& d) {
  ChartSeries series{.label = d.label, .style = Style::points, .colour = d.colour};
  for (const Json& row : rows)
    if (row.at("series") == d.series)
      series.add(row.at(d.x).get<double>(), d.scale * row.at(d.y).get<double>());
  return series;
}

/// Cylinders against their number of elements, beside the paper's value.
Chart against_size(const std::vector<Json>& rows, std::string title, std::string y_label,
                   std::vector<ChartSeries> series, double paper) {
  double low = 1e300, high = 0.0;
  for (const Json& row : rows)
    if (row.at("series") == "size")
      low = std::min(low, row.at("elements").get<double>()),
      high = std::max(high, row.at("elements").get<double>());
  low *= 0.8, high *= 1.25;
  series.push_back(level("paper, Table 2", paper, low, high));
  return {.title = std::move(title),
          .x_label = "elements N [-]",
          .y_label = std::move(y_label),
          .x_range = {low, high},
          .log_x = true,
          .series = std::move(series)};
}

NamedChart young_against_size(const std::vector<Json>& rows, double micro) {
  return {"calibration_young",
          "E of compressed cylinders against their number of elements; bars: standard deviation between "
          "packings.",
          against_size(rows,
                       fmt::format("Young's modulus of cylinders, E_µ = {:.0f} GPa, r_µ = 0.3", micro / 1e9),
                       "E_M [GPa]",
                       {means_of(rows, {"size", "strain of the middle half", "elements", "young_over_micro",
                                        micro / 1e9, 0}),
                        means_of(rows, {"size", "shortening between the ends", "elements",
                                        "young_ends_over_micro", micro / 1e9, 1})},
                       10.3)};
}

NamedChart poisson_against_size(const std::vector<Json>& rows) {
  return {"calibration_poisson",
          "ν of compressed cylinders against their number of elements; bars: standard deviation between "
          "packings.",
          against_size(rows, "Poisson's ratio of cylinders, r_µ = 0.3", "ν_M [-]",
                       {means_of(rows, {"size", "cylinders", "elements", "poisson_ratio", 1.0, 0})}, 0.3)};
}

NamedChart young_against_core(const std::vector<Json>& rows, double micro) {
  return {"calibration_core",
          "Elements at the walls have fewer contacts. At a mean coordination of 6 the core of a smaller "
          "cylinder therefore has a higher coordination, on which E depends, not on the number of elements.",
          Chart{.title = "Young's modulus against the coordination of the core",
                .x_label = "coordination away from the walls [-]",
                .y_label = "E_M [GPa]",
                .series = {cloud_of(rows, {"size", "cylinders", "core_coordination", "young_over_micro",
                                           micro / 1e9, 0}),
                           cloud_of(rows, {"box", "periodic boxes", "core_coordination", "young_over_micro",
                                           micro / 1e9, 1})}}};
}

NamedChart young_of_scan(const std::vector<Json>& rows) {
  return {"calibration_scan_young",
          "Every modulus is proportional to E_µ, which is not scanned: E_M is E_µ times what is shown; ν_µ = "
          "0.3.",
          Chart{.title = "Scan of the beams' radius: modulus",
                .x_label = "radius ratio r_µ [-]",
                .y_label = "E_M / E_µ [-]",
                .log_x = true,
                .log_y = true,
                .series = {means_of(rows, {"scan", "cylinders, ν_µ = 0.3", "micro_radius_ratio",
                                           "young_over_micro", 1.0, 0})}}};
}

NamedChart poisson_of_scan(const std::vector<Json>& rows) {
  return {
      "calibration_scan_poisson",
      "ν follows r_µ and hardly depends on ν_µ, which acts on the twist of the beams only.",
      Chart{.title = "Scan of the beams' radius: Poisson's ratio",
            .x_label = "radius ratio r_µ [-]",
            .y_label = "ν_M [-]",
            .series = {means_of(rows, {"scan", "ν_µ = 0.3", "micro_radius_ratio", "poisson_ratio", 1.0, 0}),
                       cloud_of(rows, {"twisted", "ν_µ = 0 and 0.45", "micro_radius_ratio", "poisson_ratio",
                                       1.0, 1}),
                       {"paper, Table 2", {0.3}, {0.3}, {}, Style::points, -1}}}};
}

}  // namespace

std::vector<NamedChart> calibration_charts(const std::vector<Json>& rows, double micro_young_modulus) {
  return {young_against_size(rows, micro_young_modulus), poisson_against_size(rows),
          young_against_core(rows, micro_young_modulus), young_of_scan(rows), poisson_of_scan(rows)};
}

}  // namespace rift::studio

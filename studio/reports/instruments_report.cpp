#include "studio/reports/instruments_report.hpp"

#include "engine/base/files.hpp"
#include "engine/base/text.hpp"
#include "engine/base/world_error.hpp"
#include "studio/charts/chart_script.hpp"
#include "studio/reports/instruments_charts.hpp"
#include "studio/text/html.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <optional>
#include <utility>

namespace rift::studio {
namespace {

using Json = nlohmann::ordered_json;

std::string with_unit(double value, scene::Dimension dimension) {
  const TraceScale scale = scale_of(dimension);
  return fmt::format("{:.4g}{}{}", scale.factor * value, scale.unit.empty() ? "" : " ",
                     plain_text(scale.unit));
}

const measurement::Trace& trace_named(const InstrumentsReport& report, const std::string& name) {
  return *std::find_if(report.trace.begin(), report.trace.end(),
                       [&](const measurement::Trace& t) { return t.name == name; });
}

std::string distance_text(const measurement::Trace& measured, const measurement::TraceDistance& d) {
  std::string text =
      fmt::format("off by {} (rms), {} at most, at {} of its {} points", with_unit(d.rms, measured.dimension),
                  with_unit(d.largest, measured.dimension), d.points, measured.time.size());
  if (d.span > 0.0) text += fmt::format("; {:.1f} % of its span", 100.0 * d.rms / d.span);
  return text;
}

/// Why moments have no K, the most frequent reason first.
std::string without_intensity(const std::vector<measurement::IntensityPoint>& points) {
  std::map<measurement::NoFit, int> count;
  for (const measurement::IntensityPoint& p : points)
    if (!p.k) ++count[p.why];
  std::vector<std::pair<measurement::NoFit, int>> reasons(count.begin(), count.end());
  std::stable_sort(reasons.begin(), reasons.end(),
                   [](const auto& a, const auto& b) { return a.second > b.second; });
  std::string text;
  for (const auto& [why, moments] : reasons)
    text += fmt::format("{}{} {}", text.empty() ? "" : "; ", moments, measurement::reason_of(why));
  return text;
}

std::string span_text(const measurement::Trace& trace) {
  return trace.time.empty()
             ? std::string("no time")
             : fmt::format("{:.6g} to {:.6g} us", 1e6 * trace.time.front(), 1e6 * trace.time.back());
}

std::vector<std::pair<std::string, std::string>> conclusions(const InstrumentsReport& report) {
  const measurement::Instruments& seen = report.seen;
  std::vector<std::pair<std::string, std::string>> rows{
      {"camera", fmt::format("{} x {} points, each read over a circle of {:.3g} mm", seen.grid.columns,
                             seen.grid.rows, 2e3 * seen.subset)}};
  const bool blind =
      std::none_of(report.field.begin(), report.field.end(), [](const measurement::SeenField& field) {
        return std::any_of(field.motion.begin(), field.motion.end(),
                           [](const auto& m) { return m.has_value(); });
      });
  if (blind) rows.emplace_back("", "no subset holds enough elements: widen --subset");
  if (!seen.finished)
    rows.emplace_back("unfinished", fmt::format("the run has come to {:.6g} us so far",
                                                seen.books.empty() ? 0.0 : 1e6 * seen.books.back().time_s));
  if (!seen.no_intensity.empty()) rows.emplace_back("stress intensities", "none: " + seen.no_intensity);
  const FieldAgainstBooks against = field_against_books(report);
  if (seen.no_intensity.empty())
    rows.emplace_back("ring", fmt::format("{:.3g} to {:.3g} mm around the tip, less at an edge",
                                          1e3 * seen.ring.inner, 1e3 * seen.ring.outer));
  if (const std::string why = without_intensity(seen.intensity); !why.empty())
    rows.emplace_back("moments without K", why);
  if (seen.grip_moves)
    rows.emplace_back("G_I0", "of the displacement as the crack starts, from which the grip moves on");
  if (against.moments > 0)
    rows.emplace_back(
        "field against books",
        fmt::format("G of the field is {:.3f} G_I0, the damage zone takes {:.3f} of it (mean of {} moments)",
                    against.over_g_i0, against.taken, against.moments));
  const auto closed =
      std::count_if(seen.intensity.begin(), seen.intensity.end(),
                    [](const measurement::IntensityPoint& p) { return p.k && p.k->opening < 0.0; });
  if (closed > 0)
    rows.emplace_back("closed faces",
                      fmt::format("K_I is below 0 at {} moments: faces that press are not those of "
                                  "the fit, K_II alone means something",
                                  closed));
  if (seen.clock != 0.0)
    rows.emplace_back("clock",
                      fmt::format("the measured history's: the run's plus {:.8g} us", 1e6 * seen.clock));
  for (const measurement::Trace& measured : report.measured) {
    const auto d = measurement::distance_between(trace_named(report, measured.name), measured);
    rows.emplace_back(measured.name,
                      d ? distance_text(measured, *d)
                        : fmt::format("lies at {}, the run at {}: no time is in both", span_text(measured),
                                      span_text(trace_named(report, measured.name))));
  }
  return rows;
}

std::string intensity_csv(const measurement::Instruments& seen) {
  std::string csv =
      "time_s,tip_m,crack_velocity_over_cr,k_i_pa_m1_2,k_ii_pa_m1_2,g_field_j_m2,tip_ahead_m,misfit,"
      "points,g_id_j_m2\n";
  for (const measurement::IntensityPoint& p : seen.intensity) {
    csv += fmt::format("{},{},{},", p.time, p.tip, p.over_cr);
    csv += p.k ? fmt::format("{},{},{},{},{},{},", p.k->opening, p.k->sliding, p.k->release_rate, p.k->ahead,
                             p.k->misfit, p.k->points)
               : std::string(",,,,,0,");
    csv += std::isfinite(p.g_id) ? fmt::format("{}\n", p.g_id) : "\n";
  }
  return csv;
}

}  // namespace

FieldAgainstBooks field_against_books(const InstrumentsReport& report) {
  FieldAgainstBooks mean;
  for (const measurement::IntensityPoint& p : report.seen.intensity) {
    if (!p.k || !std::isfinite(p.g_id)) continue;
    ++mean.moments;
    mean.over_g_i0 += p.k->release_rate / (report.seen.g_i0 + report.seen.g_i0_slope * p.tip);
    mean.taken += p.g_id / p.k->release_rate;
  }
  mean.over_g_i0 /= mean.moments, mean.taken /= mean.moments;
  return mean;
}

std::string field_csv_header() {
  return "time_s,tip_m,x_m,y_m,ux_m,uy_m,uz_m,strain_xx,strain_yy,strain_xy\n";
}

std::string field_csv_rows(const measurement::Grid& grid, const measurement::SeenField& field) {
  std::string csv;
  for (std::size_t p = 0; p < field.motion.size(); ++p) {
    if (!field.motion[p]) continue;
    const lattice::PlaneMotion& m = *field.motion[p];
    csv += fmt::format("{},{},{:.7g},{:.7g},{:.7g},{:.7g},{:.7g},{:.7g},{:.7g},{:.7g}\n", field.time,
                       field.tip, grid.point[p].x(), grid.point[p].y(), m.u.x(), m.u.y(), m.u.z(),
                       m.strain_xx(), m.strain_yy(), m.strain_xy());
  }
  return csv;
}

Table intensity_table(const InstrumentsReport& report) {
  Table table{{"time [us]", "tip [mm]", "v [c_R]", "K_I [MPa m½]", "K_II", "G, field [kJ/m²]", "G_ID, books",
               "taken", "misfit"},
              {}};
  const std::vector<measurement::IntensityPoint>& points = report.seen.intensity;
  const std::size_t apart = std::max<std::size_t>(1, points.size() / 12);
  for (std::size_t k = 0; k < points.size(); k += apart) {
    const measurement::IntensityPoint& p = points[k];
    const measurement::StressIntensity none{
        .opening = NAN, .sliding = NAN, .release_rate = NAN, .misfit = NAN};
    const measurement::StressIntensity i = p.k.value_or(none);
    table.rows.push_back({number_cell(1e6 * (p.time + report.seen.clock), "{:.1f}"),
                          number_cell(1e3 * p.tip, "{:.1f}"), number_cell(p.over_cr, "{:.3f}"),
                          number_cell(1e-6 * i.opening, "{:.3f}"), number_cell(1e-6 * i.sliding, "{:.3f}"),
                          number_cell(1e-3 * i.release_rate), number_cell(1e-3 * p.g_id),
                          number_cell(p.g_id / i.release_rate, "{:.3f}"), number_cell(i.misfit, "{:.3f}")});
  }
  return table;
}

std::string instruments_text(const InstrumentsReport& report, bool color) {
  std::string text;
  if (!report.seen.intensity.empty()) text += plain_table(intensity_table(report), color) + "\n";
  for (const auto& [label, content] : conclusions(report))
    text += fmt::format("  {:<22}{}\n", label, content);
  return text;
}

Json instruments_json(const InstrumentsReport& report) {
  const auto or_null = [](double v) { return std::isfinite(v) ? Json(v) : Json(nullptr); };
  const FieldAgainstBooks against = field_against_books(report);
  Json along = Json::array(), measured = Json::array();
  for (const measurement::IntensityPoint& p : report.seen.intensity) {
    const auto of = [&](double measurement::StressIntensity::*value) {
      return p.k ? Json((*p.k).*value) : Json(nullptr);
    };
    along.push_back({{"time_s", p.time},
                     {"tip_m", p.tip},
                     {"crack_velocity_over_cr", p.over_cr},
                     {"k_i_pa_m1_2", of(&measurement::StressIntensity::opening)},
                     {"k_ii_pa_m1_2", of(&measurement::StressIntensity::sliding)},
                     {"g_field_j_m2", of(&measurement::StressIntensity::release_rate)},
                     {"tip_ahead_m", of(&measurement::StressIntensity::ahead)},
                     {"misfit", of(&measurement::StressIntensity::misfit)},
                     {"g_id_j_m2", or_null(p.g_id)}});
  }
  for (const measurement::Trace& trace : report.measured) {
    const auto d = measurement::distance_between(trace_named(report, trace.name), trace);
    measured.push_back({{"name", trace.name},
                        {"points", d ? d->points : 0},
                        {"rms", d ? Json(d->rms) : Json(nullptr)},
                        {"largest", d ? Json(d->largest) : Json(nullptr)},
                        {"span", d ? Json(d->span) : Json(nullptr)}});
  }
  return {{"run", report.run},
          {"lane", report.lane},
          {"version", report.version},
          {"clock_s", report.seen.clock},
          {"subset_radius_m", report.seen.subset},
          {"ring_m", {report.seen.ring.inner, report.seen.ring.outer}},
          {"field_over_g_i0", or_null(against.over_g_i0)},
          {"g_id_over_field", or_null(against.taken)},
          {"measured", measured},
          {"along", along}};
}

void write_instruments_report(const InstrumentsReport& report, const std::filesystem::path& folder) {
  base::write_whole_file(folder / "summary.json", base::json_text(instruments_json(report), 2) + "\n");
  base::write_whole_file(folder / "stress_intensity.csv", intensity_csv(report.seen));
  std::string curves, maps;
  std::optional<base::WorldError> failure;
  const auto draw = [&](std::string& figures, const auto& chart, const std::string& name,
                        const std::string& caption) {
    try {
      figures += html_figure(draw_chart(chart, folder / "charts", name).svg_text, caption);
    } catch (const base::WorldError& error) {
      failure = error;
      figures += html_paragraph(error.what());
    }
  };
  for (const NamedChart& named : instrument_charts(report))
    draw(curves, named.chart, named.name, named.caption);
  for (const NamedMap& named : field_maps(report)) draw(maps, named.map, named.name, named.caption);
  Table said{{"", ""}, {}};
  for (const auto& [label, content] : conclusions(report)) said.rows.push_back({label, content});
  std::string body = html_paragraph(fmt::format("Made by `{}`, rift {}.", report.command, report.version)) +
                     html_section("What was seen", html_table(said)) + html_section("Instruments", curves) +
                     html_section("Field", maps);
  if (!report.seen.intensity.empty())
    body += html_section("Stress intensities along the crack", html_table(intensity_table(report)));
  base::write_whole_file(folder / "report.html",
                         html_page("What a test's instruments would have shown: " + report.run, body));
  if (failure) throw base::WorldError(*failure);
}

}  // namespace rift::studio

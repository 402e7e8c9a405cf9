#include "studio/reports/instruments_report.hpp"

#include "engine/base/csv.hpp"
#include "engine/base/text.hpp"
#include "studio/charts/label.hpp"
#include "studio/reports/instruments_charts.hpp"
#include "studio/reports/report.hpp"
#include "studio/text/run_table.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>
#include <map>
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
  std::string text = fmt::format("difference {} rms, {} at most, compared at {} of {} points",
                                 with_unit(d.rms, measured.dimension),
                                 with_unit(d.largest, measured.dimension), d.points, measured.time.size());
  if (d.span > 0.0) text += fmt::format("; rms {:.1f} % of the measured span", 100.0 * d.rms / d.span);
  return text;
}

/// Of a moment without any.
constexpr measurement::StressIntensity no_intensity{NAN, NAN, NAN, NAN, NAN, 0};

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
    text += fmt::format("{}{}: {}", text.empty() ? "" : "; ", moments, measurement::reason_of(why));
  return text;
}

std::string span_text(const measurement::Trace& trace) {
  return trace.time.empty()
             ? std::string("no times")
             : fmt::format("{:.6g} to {:.6g} µs", 1e6 * trace.time.front(), 1e6 * trace.time.back());
}

/// Mean over the moments that have both, weights alike; NaN where there are none.
struct FieldAgainstBooks {
  int moments = 0;
  double over_g_i0 = 0;  // G of the field over G_I0
  double taken = 0;      // G_ID by the energy balance over G of the field
};

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

/// G of the field over stretches of the way, beside what a continuum computation of the same strip has there.
std::string arriving_text(const measurement::ArrivingStretch& s) {
  return fmt::format(
      "{:.3f} times G_I0 from {:.4g} to {:.4g} mm; an independent finite-element strip: {:.3f}", s.over_g_i0,
      1e3 * s.from, 1e3 * s.to, s.expected);
}

/// What was seen, a label and a text a row.
Table conclusions(const InstrumentsReport& report) {
  const measurement::Instruments& seen = report.seen;
  Table table{{"", ""}, {}};
  const auto say = [&](const std::string& label, const std::string& text) {
    table.rows.push_back({label, text});
  };
  say("plate",
      fmt::format("{:.4g} x {:.4g} x {:.4g} mm, {} elements: forces and energies go with the thickness{}",
                  1e3 * seen.plate.x(), 1e3 * seen.plate.y(), 1e3 * seen.plate.z(), seen.elements,
                  seen.of_layers ? ", which follows from layers and elements" : ""));
  say("camera", fmt::format("{} x {} points, subset diameter {:.3g} mm", seen.grid.columns, seen.grid.rows,
                            2e3 * seen.subset));
  const bool blind =
      std::none_of(report.field.begin(), report.field.end(), [](const measurement::SeenField& field) {
        return std::any_of(field.motion.begin(), field.motion.end(),
                           [](const auto& m) { return m.has_value(); });
      });
  if (blind) say("", "no subset holds enough elements: enlarge --subset");
  if (!seen.finished)
    say("unfinished", fmt::format("the run has reached {:.6g} µs",
                                  seen.samples.empty() ? 0.0 : 1e6 * seen.samples.back().time_s));
  if (!seen.no_intensity.empty()) say("K_I and K_II", "none: " + seen.no_intensity);
  const FieldAgainstBooks against = field_against_books(report);
  if (seen.no_intensity.empty())
    say("ring", fmt::format("{:.3g} to {:.3g} mm around the tip, smaller near an edge", 1e3 * seen.ring.inner,
                            1e3 * seen.ring.outer));
  if (const std::string why = without_intensity(seen.intensity); !why.empty()) say("moments without K", why);
  const bool never_fits =
      !seen.intensity.empty() && std::all_of(seen.intensity.begin(), seen.intensity.end(),
                                             [](const auto& p) { return p.why == measurement::NoFit::edge; });
  if (report.seen.own.young_modulus > 0.0)
    say("plate's own", fmt::format("E {:.3f} GPa, ν {:.3f}, by static pulls: K is fitted with these",
                                   1e-9 * report.seen.own.young_modulus, report.seen.own.poisson_ratio));
  if (never_fits)
    say("", "the ring fits at no moment: raise specimen.elements, or lower --inner and --outer");
  if (seen.grip_moves) say("G_I0", "refers to the displacement when the crack starts; the grip moves later");
  if (against.moments > 0)
    say("G from K", fmt::format("{:.3f} times G_I0; G_ID (energy balance) is {:.3f} of it (means over {})",
                                against.over_g_i0, against.taken, base::counted(against.moments, "moment")));
  for (const measurement::ArrivingStretch& stretch : seen.arriving) say("", arriving_text(stretch));
  const auto closed =
      std::count_if(seen.intensity.begin(), seen.intensity.end(),
                    [](const measurement::IntensityPoint& p) { return p.k && p.k->opening < 0.0; });
  if (closed > 0)
    say("closed faces",
        fmt::format(
            "K_I is negative at {} moments: the fit assumes free faces, so only K_II is meaningful there",
            closed));
  if (seen.clock != 0.0) say("clock", history_clock_text(seen.clock));
  if (report.offset != 0.0)
    say("measured curves", fmt::format("{:.6g} µs added to their times", 1e6 * report.offset));
  for (const measurement::Trace& measured : report.measured) {
    const auto d = measurement::distance_between(trace_named(report, measured.name), measured);
    say(measured.name, d ? distance_text(measured, *d)
                         : fmt::format("covers {}, the run {}: they have no time in common",
                                       span_text(measured), span_text(trace_named(report, measured.name))));
  }
  return table;
}

std::string intensity_csv(const measurement::Instruments& seen) {
  std::string csv =
      "time_s,tip_m,crack_velocity_over_cr,k_i_pa_m1_2,k_ii_pa_m1_2,g_field_j_m2,tip_ahead_m,misfit,points,g_"
      "id_j_m2\n";
  for (const measurement::IntensityPoint& p : seen.intensity) {
    const measurement::StressIntensity k = p.k.value_or(no_intensity);
    csv += base::csv_row(p.time, p.tip, p.over_cr, k.opening, k.sliding, k.release_rate, k.ahead, k.misfit,
                         k.points, p.g_id);
  }
  return csv;
}

/// A dozen moments: stress intensities, and the release rate by the energy balance beside them.
Table intensity_table(const InstrumentsReport& report) {
  Table table{{"time [µs]", "tip [mm]", "v [nominal c_R]", "K_I [MPa m½]", "K_II", "G from K [kJ/m²]",
               "G_ID (balance)", "G_ID/G", "misfit"},
              {}};
  const std::vector<measurement::IntensityPoint>& points = report.seen.intensity;
  const std::size_t apart = std::max<std::size_t>(1, points.size() / 12);
  for (std::size_t k = 0; k < points.size(); k += apart) {
    const measurement::IntensityPoint& p = points[k];
    const measurement::StressIntensity i = p.k.value_or(no_intensity);
    table.rows.push_back({number_cell(1e6 * (p.time + report.seen.clock), "{:.1f}"),
                          number_cell(1e3 * p.tip, "{:.1f}"), number_cell(p.over_cr, "{:.3f}"),
                          number_cell(1e-6 * i.opening, "{:.3f}"), number_cell(1e-6 * i.sliding, "{:.3f}"),
                          number_cell(1e-3 * i.release_rate), number_cell(1e-3 * p.g_id),
                          number_cell(p.g_id / i.release_rate, "{:.3f}"), number_cell(i.misfit, "{:.3f}")});
  }
  return table;
}

}  // namespace

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

std::string instruments_text(const InstrumentsReport& report, bool color) {
  std::string text;
  if (!report.seen.intensity.empty()) text += plain_table(intensity_table(report), color) + "\n";
  for (const auto& row : conclusions(report).rows) text += label_line(row[0], row[1]);
  return text;
}

std::string no_intensity_text(const measurement::Instruments& seen,
                              const measurement::InstrumentOptions& options) {
  const auto has_k = [](const measurement::IntensityPoint& p) { return p.k.has_value(); };
  if (seen.intensity.empty() || std::any_of(seen.intensity.begin(), seen.intensity.end(), has_k)) return {};
  const std::string fits = measurement::ring_that_fits(seen, options);
  return fmt::format("no stress intensity at any moment: {}{}", without_intensity(seen.intensity),
                     fits.empty() ? "" : ". " + fits);
}

Json instruments_json(const InstrumentsReport& report) {
  const FieldAgainstBooks against = field_against_books(report);
  Json along = Json::array(), measured = Json::array(), arriving = Json::array();
  for (const measurement::IntensityPoint& p : report.seen.intensity) {
    const measurement::StressIntensity k = p.k.value_or(no_intensity);
    along.push_back({{"time_s", p.time},
                     {"tip_m", p.tip},
                     {"crack_velocity_over_cr", p.over_cr},
                     {"k_i_pa_m1_2", k.opening},
                     {"k_ii_pa_m1_2", k.sliding},
                     {"g_field_j_m2", k.release_rate},
                     {"tip_ahead_m", k.ahead},
                     {"misfit", k.misfit},
                     {"g_id_j_m2", p.g_id}});
  }
  for (const measurement::Trace& trace : report.measured) {
    const auto d = measurement::distance_between(trace_named(report, trace.name), trace);
    measured.push_back({{"name", trace.name},
                        {"points", d ? d->points : 0},
                        {"rms", d ? Json(d->rms) : Json(nullptr)},
                        {"largest", d ? Json(d->largest) : Json(nullptr)},
                        {"span", d ? Json(d->span) : Json(nullptr)}});
  }
  for (const measurement::ArrivingStretch& s : report.seen.arriving)
    arriving.push_back({{"from_m", s.from},
                        {"to_m", s.to},
                        {"moments", s.moments},
                        {"field_over_g_i0", s.over_g_i0},
                        {"finite_elements_over_g_i0", s.expected}});
  return {{"run", report.run},
          {"lane", report.lane},
          {"version", report.build.version},
          {"clock_s", report.seen.clock},
          {"subset_radius_m", report.seen.subset},
          {"ring_m", {report.seen.ring.inner, report.seen.ring.outer}},
          {"own_young_modulus_pa", report.seen.own.young_modulus},
          {"own_poisson_ratio", report.seen.own.poisson_ratio},
          {"field_over_g_i0", against.over_g_i0},
          {"g_id_over_field", against.taken},
          {"arriving", arriving},
          {"measured", measured},
          {"offset_s", report.offset},
          {"along", along}};
}

void write_instruments_report(const InstrumentsReport& report, const std::filesystem::path& folder) {
  Report page{.title = "What the instruments of a test would have shown of the run " + report.run,
              .made = {report.command, report.build},
              .scenes = report.scenes,
              .files = {{"summary.json", base::json_text(instruments_json(report), 2) + "\n"},
                        {"stress_intensity.csv", intensity_csv(report.seen)}},
              .sections = {{"Results", conclusions(report)},
                           {"Instruments", those_with_points(instrument_charts(report))},
                           {"Field", those_with_points(field_maps(report))}}};
  if (!report.seen.intensity.empty())
    page.sections.push_back({"Stress intensity factors along the crack", intensity_table(report)});
  write_report(page, folder);
}

}  // namespace rift::studio

#include "studio/view/words.hpp"

#include "viz/field.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <cmath>
#include <numbers>
#include <string_view>

namespace rift::studio {
namespace {

using Three = std::array<double, 3>;

/// "ux 0.0012 uy 0.2 uz 0 mm", or nothing where the run stores none.
std::string three(std::string_view name, const Three& v, double unit_in_si, std::string_view unit) {
  if (std::isnan(v[0])) return {};
  return fmt::format("   {0}x {1:.4g} {0}y {2:.4g} {0}z {3:.4g} {4}", name, v[0] / unit_in_si,
                     v[1] / unit_in_si, v[2] / unit_in_si, unit);
}

std::string one(std::string_view name, double value, double unit_in_si, std::string_view unit) {
  return std::isnan(value) ? std::string{} : fmt::format("   {} {:.4g}{}", name, value / unit_in_si, unit);
}

/// The nearest history that was recorded, at this moment.
std::string gauge_text(const viz::Picked& picked) {
  const results::GaugeRow& row = picked.gauge;
  if (row.gauge < 0) return {};
  constexpr double mm = 1e-3;
  return fmt::format("   gauge {}, {:.3g} mm away: uy {:.4g} mm vy {:.4g} m/s strain yy {:.4g}", row.gauge,
                     std::hypot(row.x_m - picked.position_m[0], row.y_m - picked.position_m[1]) / mm,
                     row.uy_m / mm, row.vy_m_s, row.strain_yy);
}

double apart(const Three& a, const Three& b) { return std::hypot(a[0] - b[0], a[1] - b[1], a[2] - b[2]); }

Three sum(const Three& a, const Three& b) { return {a[0] + b[0], a[1] + b[1], a[2] + b[2]}; }

/// A range by the field's unit, as --range reads it.
std::string range_text(const viz::Look& look) {
  if (look.range_of_moment) return "moment";
  const double unit = viz::find_field(look.field)->unit_in_si;
  return fmt::format("{},{}", look.range[0] / unit, look.range[1] / unit);
}

std::string view_text(const viz::View& view) {
  constexpr double mm = 1e-3, degree = std::numbers::pi / 180;
  return fmt::format("{:.8g},{:.8g},{:.8g},{:.8g},{:.8g}", view.x / mm, view.y / mm, view.height / mm,
                     view.turn / degree, view.tilt / degree);
}

bool is_plain(char c) {
  return std::isalnum(static_cast<unsigned char>(c)) != 0 ||
         std::string_view("-_./,=+:%@").find(c) != std::string_view::npos;
}

}  // namespace

std::string colours_of(const viz::Look& look) {
  const viz::ColourMap* named = viz::find_colour_map(look.colours);
  return std::string((named != nullptr ? *named : viz::colour_map_of(*viz::find_field(look.field))).name);
}

std::string numbers_of(const viz::Answer& answer, const viz::Look& look, int moment, int moments, bool whole,
                       double rayleigh_m_s) {
  const viz::PaneAnswer& pane = answer.pane[0];
  const viz::Field& field = *viz::find_field(look.field);
  std::string text = fmt::format("frame {} of {}{}   t = {:.1f} µs   tip {:.1f} mm", moment + 1, moments,
                                 whole ? "" : " so far", pane.since_start_s * 1e6, pane.tip_m * 1e3);
  if (rayleigh_m_s > 0) text += fmt::format("   v {:.2f} c_R", pane.velocity_m_s / rayleigh_m_s);
  text += fmt::format("   {} {:.3g} to {:.3g}{}{}", look.field, answer.range[0] / field.unit_in_si,
                      answer.range[1] / field.unit_in_si, field.unit == "1" ? "" : " ",
                      field.unit == "1" ? "" : field.unit);
  if (look.magnification != 1) text += fmt::format("   displacements x {:g}", look.magnification);
  return text;
}

std::string text_of(const viz::Picked& picked) {
  using Kind = viz::Picked::Kind;
  if (picked.kind == Kind::nothing) return "nothing is drawn there";
  std::string text = picked.kind == Kind::element ? fmt::format("element {}", picked.index)
                                                  : fmt::format("beam {} of elements {} and {}", picked.index,
                                                                picked.first, picked.second);
  text += fmt::format("   at {:.3f} {:.3f} {:.3f} mm", picked.position_m[0] * 1e3, picked.position_m[1] * 1e3,
                      picked.position_m[2] * 1e3);
  text += three("u", picked.displacement_m, 1e-3, "mm") + three("v", picked.velocity_m_s, 1, "m/s");
  text += one("energy", picked.elastic_j, 1e-3, " mJ") + one("damage", picked.damage, 1, "");
  text += one("released at", picked.released_s, 1e-6, " µs");
  return text + gauge_text(picked);
}

std::string distance_between(const viz::Picked& a, const viz::Picked& b) {
  std::string text = fmt::format("distance {:.4g} mm unloaded", apart(a.position_m, b.position_m) * 1e3);
  if (!std::isnan(a.displacement_m[0]) && !std::isnan(b.displacement_m[0]))
    text +=
        fmt::format(", {:.4g} mm now",
                    apart(sum(a.position_m, a.displacement_m), sum(b.position_m, b.displacement_m)) * 1e3);
  return text;
}

std::vector<std::string> render_arguments(const viz::Job& job, const std::vector<int>& lanes) {
  std::vector<std::string> words{"render"};
  for (const viz::Pane& pane : job.panes) {
    const std::string run = pane.run.string();
    if (std::find(words.begin() + 1, words.end(), run) == words.end()) words.push_back(run);
  }
  const viz::Look& look = job.look;
  const auto add = [&](const char* option, std::string value) {
    words.insert(words.end(), {option, std::move(value)});
  };
  for (const int lane : lanes) add("--lane", fmt::format("{}", lane));
  add("--field", look.field);
  add("--colours", colours_of(look));
  add("--range", range_text(look));
  if (look.camera == viz::Camera::free)
    add("--view", view_text(look.view));
  else
    add("--camera", viz::word_of(look.camera));
  if (look.camera == viz::Camera::tip) add("--close-up", fmt::format("{}", look.close_up_m));
  add("--beams", viz::word_of(look.beams));
  add("--magnification", fmt::format("{}", look.magnification));
  add("--chart", viz::word_of(look.chart));
  if (!look.texts) words.emplace_back("--no-text");
  if (look.large_text) words.emplace_back("--large-text");
  add("--title", look.title);
  add("--size", fmt::format("{}x{}", job.width, job.height));
  return words;
}

std::string shell_line(const std::vector<std::string>& words) {
  std::string line;
  for (const std::string& word : words) {
    if (!line.empty()) line += ' ';
    if (!word.empty() && std::all_of(word.begin(), word.end(), is_plain)) {
      line += word;
      continue;
    }
    line += '\'';
    for (const char c : word) line += c == '\'' ? std::string("'\\''") : std::string(1, c);
    line += '\'';
  }
  return line;
}

}  // namespace rift::studio

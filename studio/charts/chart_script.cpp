#include "studio/charts/chart_script.hpp"

#include "engine/base/text.hpp"
#include "studio/charts/chart_layout.hpp"
#include "studio/charts/label.hpp"
#include "studio/charts/point_texts.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

namespace rift::studio {
namespace {

constexpr std::array palette{"#0072b2", "#d55e00", "#009e73", "#cc79a7", "#e69f00", "#56b4e9"};
constexpr std::array shapes{7, 5, 9, 13, 11, 15};  // filled; one less is the open one
constexpr std::array dashes{1, 2, 4, 5, 3};        // solid, dashed, dash-dot, dash-dot-dot, dotted
constexpr std::array greys{"#000000", "#666666", "#333333", "#888888"};
constexpr std::array grey_dashes{2, 4, 3, 5};

constexpr std::array<std::array<int, 3>, 5> sequence{
    {{0x44, 0x01, 0x54}, {0x41, 0x44, 0x87}, {0x2a, 0x78, 0x8e}, {0x22, 0xa8, 0x84}, {0x7a, 0xd1, 0x51}}};

template <class Array>
auto cycled(const Array& values, int k) {
  return values[static_cast<std::size_t>(k) % values.size()];
}

}  // namespace

SeriesLook series_look(int colour, int reference) {
  if (colour < 0) return {cycled(greys, reference), cycled(grey_dashes, reference), 7, 1.5};
  const int round = colour / static_cast<int>(palette.size());
  // The shape moves on by the round, so that a colour comes back with another one.
  const int shape = cycled(shapes, colour + round) - round % 2;
  return {cycled(palette, colour), cycled(dashes, colour), shape, 2.0};
}

SeriesLook look_of(const ChartSeries& series, int reference) {
  SeriesLook look = series_look(series.colour, reference);
  if (!std::isfinite(series.shade)) return look;
  const double at = std::clamp(series.shade, 0.0, 1.0) * (sequence.size() - 1);
  const auto low = std::min(static_cast<std::size_t>(at), sequence.size() - 2);
  const auto mixed = [&](std::size_t channel) {
    return static_cast<int>(std::lround(
        std::lerp(sequence[low][channel], sequence[low + 1][channel], at - static_cast<double>(low))));
  };
  look.colour = fmt::format("#{:02x}{:02x}{:02x}", mixed(0), mixed(1), mixed(2));
  look.dash = 1;
  return look;
}

namespace {

/// "set xrange [0:*]", or nothing where both ends follow the data.
std::string range_line(char axis, const AxisRange& range) {
  if (!range.min && !range.max) return {};
  const auto end = [](const std::optional<double>& v) {
    return v ? fmt::format("{}", *v) : std::string("*");
  };
  return fmt::format("set {}range [{}:{}]\n", axis, end(range.min), end(range.max));
}

}  // namespace

std::string script_head(const std::string& title, const std::string& name, int height) {
  std::string words = base::escaped(plain_text(title), "\n\r");
  for (char& c : words)
    if (c == '\n' || c == '\r' || c == '\\') c = ' ';  // a backslash would go on with the comment
  std::string out = fmt::format("# {}\n# In this folder `gnuplot {}.gp` draws {}.svg and {}.png.\n", words,
                                name, name, name);
  out += fmt::format("data = '{}.csv'\n", name);
  for (const char* ending : {"svg", "png"})
    out += fmt::format("if (!exists('{0}')) {0} = '{1}.{0}'\n", ending, name);
  out += "set encoding utf8\nset datafile separator ','\nset datafile columnheaders\n";
  out +=
      fmt::format("set terminal svg size {},{} enhanced font 'sans-serif,14' background 'white' name '{}'\n",
                  chart_width, height, name);
  out += "set output svg\n";
  return out +
         "set border 3 lc rgb '#444444'\n"
         "set format '%h'\n"
         "set tics nomirror out tc rgb '#222222'\n"
         "set grid lt 1 lw 0.7 lc rgb '#e2e2e2'\n"
         "set errorbars 0.8\n"
         "set title font ',16'\n"
         "set rmargin 3\n";
}

std::string png_terminal(int height) {
  return fmt::format(
      "set terminal pngcairo size {},{} enhanced font 'sans-serif,14' fontscale 1.5 linewidth 2 "
      "dashlength 0.6 pointscale 2.8 background 'white'\n",
      2 * chart_width, 2 * height);
}

std::string script_end(const std::string& plot, int height) {
  return plot + png_terminal(height) + "set output png\nreplot\nset output\n";
}

namespace {

/// A function of the script that picks the rows of a series.
constexpr std::string_view functions =
    "of(s) = strcol(1) eq s ? $2 : NaN            # x in the rows of a series\n"
    "bar(s) = strcol(4) eq '' ? NaN : of(s)       # the same where the row has an error\n";

/// Ticks of a logarithmic axis too short for powers of ten: 1, 2 and 5 of each, or evenly spaced ones.
std::vector<double> short_log_ticks(double low, double high) {
  std::vector<double> ticks;
  const double decade = std::pow(10.0, std::floor(std::log10(low)));
  if (high / low > 5.0) {
    for (double power = decade; power <= high; power *= 10.0)
      for (const int digit : {1, 2, 5}) ticks.push_back(digit * power);
    return ticks;
  }
  double step = std::pow(10.0, std::floor(std::log10((high - low) / 3.0)));
  for (const double more : {2.0, 2.5, 2.0})
    if ((high - low) / step > 6.0) step *= more;
  constexpr double nearest = 0.155;  // parts of the axis: their texts have room in a narrow panel too
  for (double k = std::ceil(low / step); k * step <= high; ++k)
    if (ticks.empty() || std::log(k * step / ticks.back()) > nearest * std::log(high / low))
      ticks.push_back(k * step);
  return ticks;
}

/// Ends a little beyond the data, not at the next power of ten.
std::string log_axis(char axis, const AxisRange& range, const Span& span) {
  const auto [low, high] = axis_ends(range, span, true);
  const std::string out = fmt::format("set logscale {}\n", axis) + range_line(axis, {low, high});
  if (high / low > 100.0) return out + fmt::format("set format {} '10^{{%L}}'\n", axis);
  std::string ticks;
  for (const double tick : short_log_ticks(low, high))
    ticks += fmt::format("{}{:.12g}", ticks.empty() ? "" : ", ", tick);
  return out + fmt::format("set {}tics ({})\n", axis, ticks);
}

}  // namespace

std::string axis_lines(char which, const std::string& label, const AxisRange& range, bool log,
                       const Span& span) {
  return fmt::format("set {}label {}\n", which, label_string(label)) +
         (log ? log_axis(which, range, span) : range_line(which, range));
}

namespace {

std::string mark_lines(const ChartMark& m, const MarkLabel& label, bool log_x) {
  const double middle = log_x ? std::sqrt(m.from * m.to) : 0.5 * (m.from + m.to);
  const std::string at = label.side == MarkLabel::Side::left    ? "left at graph 0"
                         : label.side == MarkLabel::Side::right ? "right at graph 1"
                                                                : fmt::format("center at {}", middle);
  const std::string extent = fmt::format("from {}, graph 0 to {}, graph 1", m.from, m.to);
  const std::string mark =
      m.from == m.to
          ? fmt::format("set arrow {} nohead dt 3 lw 1.5 lc rgb '#777777' back\n", extent)
          : fmt::format("set object rectangle {} fc rgb '#efefef' fs solid noborder behind\n", extent);
  return mark + fmt::format("set label {} {}, graph 1 offset 0, {:.1f} tc rgb '#555555' font ',12'\n",
                            label_string(m.label), at, 0.6 + 1.1 * label.row);
}

/// The title, above as many rows of marks' labels as there are.
std::string title_and_marks(const Chart& chart, const Span& x_span) {
  const std::vector<MarkLabel> labels = mark_labels(chart, x_span);
  int rows = 0;
  std::string out;
  for (std::size_t k = 0; k < labels.size(); ++k) {
    out += mark_lines(chart.marks[k], labels[k], chart.log_x);
    rows = std::max(rows, labels[k].row + 1);
  }
  return out + fmt::format("set title {} offset 0, {:.1f}\n", label_string(chart.title), 1.1 * rows);
}

std::string line_of(const ChartSeries& s, const SeriesLook& look) {
  const bool dashed = s.style == ChartSeries::Style::dashed && s.colour >= 0;  // references are anyhow
  const int dash = !dashed ? look.dash : look.dash == 1 ? 2 : 3;
  return fmt::format("lw {} dt {}", look.width, dash);
}

std::string points_of(const SeriesLook& look) { return fmt::format("pt {} ps 0.8", look.shape); }

std::string plot_of(const ChartSeries& s, const std::string& name, const SeriesLook& look) {
  const std::string rows = fmt::format("data using (of({}))", script_string(name));
  const std::string colour = fmt::format("lc rgb '{}' notitle", look.colour);
  const std::size_t count = drawable_points(s).size();
  const std::string spread = count > 30 ? fmt::format(" pi {}", count / 15) : "";  // no shape upon shape
  switch (s.style) {
    case ChartSeries::Style::line:
    case ChartSeries::Style::dashed:
      return fmt::format("{}:3 with lines {} {}", rows, line_of(s, look), colour);
    case ChartSeries::Style::points:
      return fmt::format("{}:3 with points {} lw 1.5 {}", rows, points_of(look), colour);
    case ChartSeries::Style::line_points:
      return fmt::format("{}:3 with linespoints {} {}{} {}", rows, line_of(s, look), points_of(look), spread,
                         colour);
    case ChartSeries::Style::band:
      return fmt::format("{}:($3-$4):($3+$4) with filledcurves fs transparent solid 0.2 noborder {}", rows,
                         colour);
  }
  return {};
}

std::string bars_of(const std::string& name, const SeriesLook& look) {
  return fmt::format("data using (bar({})):3:4 with yerrorbars pt -1 lw 1.2 lc rgb '{}' notitle",
                     script_string(name), look.colour);
}

}  // namespace

std::vector<std::string> plot_parts(const std::vector<ChartSeries>& series) {
  const std::vector<std::string> names = series_names(series);
  std::vector<std::string> bands, others;
  int references = 0;
  for (std::size_t k = 0; k < series.size(); ++k) {
    const ChartSeries& s = series[k];
    const SeriesLook look = look_of(s, s.colour < 0 ? references++ : 0);
    if (drawable_points(s).empty()) continue;
    const bool band = s.style == ChartSeries::Style::band;
    if (!band && has_error(s)) others.push_back(bars_of(names[k], look));
    (band ? bands : others).push_back(plot_of(s, names[k], look));
  }
  bands.insert(bands.end(), others.begin(), others.end());
  return bands;
}

std::string plot_line(const std::vector<std::string>& parts) {
  std::string plot = "plot ";
  for (const std::string& part : parts) plot += (plot.size() > 5 ? ", \\\n     " : "") + part;
  return plot + "\n";
}

std::string key_sample(const KeyEntry& entry, const std::string& from, const std::string& to,
                       const std::string& middle, const std::string& low, const std::string& high) {
  const ChartSeries& s = entry.series;
  const SeriesLook look = look_of(s, entry.reference);
  const std::string line =
      fmt::format("set arrow from {} to {} nohead {} lc rgb '{}'\n", from, to, line_of(s, look), look.colour);
  const std::string points =
      fmt::format("set label '' at {} point {} lw 1.5 lc rgb '{}'\n", middle, points_of(look), look.colour);
  switch (s.style) {
    case ChartSeries::Style::line:
    case ChartSeries::Style::dashed:
      return line;
    case ChartSeries::Style::points:
      return points;
    case ChartSeries::Style::line_points:
      return line + points;
    case ChartSeries::Style::band:
      return fmt::format("set object rectangle from {} to {} fc rgb '{}' fs transparent solid 0.2 noborder\n",
                         low, high, look.colour);
  }
  return {};
}

std::vector<std::size_t> drawable_points(const ChartSeries& series) {
  std::vector<std::size_t> points;
  for (std::size_t k = 0; k < series.x.size(); ++k)
    if (std::isfinite(series.x[k]) && std::isfinite(series.y[k])) points.push_back(k);
  return points;
}

std::vector<std::string> series_names(const std::vector<ChartSeries>& series) {
  std::vector<std::string> names;
  for (const ChartSeries& s : series) {
    std::string name = gnuplot_field(plain_text(s.name.empty() ? s.label : s.name));
    if (name.empty()) name = fmt::format("series {}", names.size() + 1);
    if (std::find(names.begin(), names.end(), name) != names.end())
      name += fmt::format(" ({})", names.size() + 1);
    names.push_back(name);
  }
  return names;
}

namespace {

/// The rows of series, with a column of texts where `texts`, each row ending with `last`.
std::string rows_of(const std::vector<ChartSeries>& series, bool texts, const std::string& last) {
  const std::vector<std::string> names = series_names(series);
  std::string out;
  for (std::size_t i = 0; i < names.size(); ++i) {
    const ChartSeries& s = series[i];
    for (const std::size_t k : drawable_points(s)) {
      const bool error = !s.error.empty() && std::isfinite(s.error[k]);
      out += fmt::format("{},{},{},{}", names[i], s.x[k], s.y[k], error ? fmt::format("{}", s.error[k]) : "");
      if (texts) out += "," + (has_text(s) ? gnuplot_field(s.text[k]) : "");
      out += last + "\n";
    }
  }
  return out;
}

}  // namespace

std::string chart_data(const Chart& chart) {
  const bool texts = std::any_of(chart.series.begin(), chart.series.end(), has_text);
  return (texts ? "series,x,y,error,text\n" : "series,x,y,error\n") + rows_of(chart.series, texts, "");
}

std::string chart_data(const ChartGrid& grid) {
  bool texts = false;
  for (const ChartPanel& panel : grid.panels)
    texts = texts || std::any_of(panel.series.begin(), panel.series.end(), has_text);
  std::string out = texts ? "series,x,y,error,text,panel\n" : "series,x,y,error,panel\n";
  for (std::size_t k = 0; k < grid.panels.size(); ++k)
    out += rows_of(grid.panels[k].series, texts, fmt::format(",{}", k + 1));
  return out;
}

namespace {

/// Texts beside points, within axes that are fixed for them.
std::string texts_of(const Chart& chart, const PlotArea& area, int height) {
  if (std::none_of(chart.series.begin(), chart.series.end(), has_text)) return {};
  const TextSpace space{.area = area,
                        .x = axis_ends(chart.x_range, x_span(chart), chart.log_x),
                        .y = axis_ends(chart.y_range, y_span(chart), chart.log_y),
                        .log_x = chart.log_x,
                        .log_y = chart.log_y};
  return fmt::format("set lmargin at screen {:.4f}\nset xrange [{}:{}]\nset yrange [{}:{}]\n",
                     area.left / chart_width, space.x.min, space.x.max, space.y.min, space.y.max) +
         text_lines(placed_texts(chart.series, space), space, height);
}

}  // namespace

std::string chart_script(const Chart& chart, const std::string& name) {
  const Span x = x_span(chart);
  const int height = picture_height(chart);
  const PlotArea area = plot_area(chart);
  const KeyLayout key = key_layout(chart);
  std::string out = script_head(chart.title, name, height);
  out += functions;
  out += axis_lines('x', chart.x_label, chart.x_range, chart.log_x, x);
  out += axis_lines('y', chart.y_label, range_below_levels(chart), chart.log_y, y_span(chart));
  out += fmt::format(
      "set rmargin at screen {:.4f}\nset bmargin at screen {:.4f}\nset tmargin at screen {:.4f}\n",
      area.right / chart_width, area.bottom / height, area.top / height);
  const bool below = key.place == KeyPlace::below;
  out += key_lines(key_entries(chart.series), key, below ? area.left : area.right + 16,
                   below ? key.height_px() : area.top, height);
  out += title_and_marks(chart, x) + texts_of(chart, area, height);
  return out + script_end(plot_line(plot_parts(chart.series)), height);
}

}  // namespace rift::studio

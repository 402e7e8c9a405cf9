#include "studio/charts/chart_script.hpp"

#include "engine/base/text.hpp"
#include "studio/charts/chart_layout.hpp"

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

template <class Array>
auto cycled(const Array& values, int k) {
  return values[static_cast<std::size_t>(k) % values.size()];
}

}  // namespace

SeriesLook series_look(int colour, int reference) {
  if (colour < 0) return {cycled(greys, reference), cycled(grey_dashes, reference), 1, 1.5};
  const int round = colour / static_cast<int>(palette.size());
  // The shape moves on by the round, so that a colour comes back with another one.
  const int shape = cycled(shapes, colour + round) - round % 2;
  return {cycled(palette, colour), cycled(dashes, colour), shape, 2.0};
}

std::string range_line(char axis, const AxisRange& range) {
  if (!range.min && !range.max) return {};
  const auto end = [](const std::optional<double>& v) {
    return v ? fmt::format("{}", *v) : std::string("*");
  };
  return fmt::format("set {}range [{}:{}]\n", axis, end(range.min), end(range.max));
}

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

std::string script_end(const std::string& plot, int height) {
  return plot +
         fmt::format(
             "set terminal pngcairo size {},{} enhanced font 'sans-serif,14' fontscale 1.5 linewidth 2 "
             "dashlength 0.6 pointscale 2.8 background 'white'\nset output png\nreplot\nset output\n",
             2 * chart_width, 2 * height);
}

std::string escape_label(std::string_view text) {
  std::string out;
  for (const char c : base::escaped(text)) {
    if (std::string_view("\\_^{}@&~").find(c) != std::string_view::npos) out += '\\';
    out += c;
  }
  return out;
}

std::string plain_text(std::string_view label) {
  std::string out;
  for (std::size_t k = 0; k < label.size(); ++k) {
    if (label[k] == '\\' && k + 1 < label.size())
      out += label[++k];
    else if (label[k] != '{' && label[k] != '}')
      out += label[k];
  }
  return out;
}

std::string script_string(std::string_view label) {
  std::string out = "'";
  for (const char c : base::escaped(label, "\n\r")) {
    out += c == '\n' || c == '\r' ? ' ' : c;
    if (c == '\'') out += '\'';
  }
  return out + "'";
}

std::size_t letters(std::string_view label) { return base::count_letters(plain_text(label)); }

std::string gnuplot_field(std::string text) {
  text = base::escaped(text, "\n\r");
  for (char& c : text) {
    if (c == ',') c = ';';
    if (c == '"') c = '\'';
    if (c == '\n' || c == '\r') c = ' ';
  }
  return text;
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
  for (double k = std::ceil(low / step); k * step <= high; ++k) ticks.push_back(k * step);
  return ticks;
}

/// Ends a little beyond the data, not at the next power of ten.
std::string log_axis(char axis, const AxisRange& range, const Span& span) {
  const double low = range.min.value_or(span.min / 1.25), high = range.max.value_or(span.max * 1.25);
  const std::string out = fmt::format("set logscale {}\n", axis) + range_line(axis, {low, high});
  if (high / low > 100.0) return out + fmt::format("set format {} '10^{{%L}}'\n", axis);
  std::string ticks;
  for (const double tick : short_log_ticks(low, high))
    ticks += fmt::format("{}{:.12g}", ticks.empty() ? "" : ", ", tick);
  return out + fmt::format("set {}tics ({})\n", axis, ticks);
}

std::string axis(char which, const std::string& label, const AxisRange& range, bool log, const Span& span) {
  return fmt::format("set {}label {}\n", which, script_string(label)) +
         (log ? log_axis(which, range, span) : range_line(which, range));
}

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
                            script_string(m.label), at, 0.6 + 1.1 * label.row);
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
  return out + fmt::format("set tmargin {:.1f}\nset title {} offset 0, {:.1f}\n", 2.8 + 1.1 * rows,
                           script_string(chart.title), 1.1 * rows);
}

std::string plot_of(const ChartSeries& s, const std::string& name, int reference) {
  const SeriesLook look = series_look(s.colour, reference);
  const std::string rows = fmt::format("data using (of({}))", script_string(name));
  const std::string title = s.label.empty() ? "notitle" : fmt::format("title {}", script_string(s.label));
  const std::string colour = fmt::format("lc rgb '{}'", look.colour);
  const int dash = s.style == ChartSeries::Style::dashed && look.dash == 1 ? 2 : look.dash;
  const std::string line = fmt::format("lw {} dt {}", look.width, dash);
  const std::string points = fmt::format("pt {} ps 0.8", look.shape);
  const std::size_t count = drawable_points(s).size();
  const std::string spread = count > 30 ? fmt::format(" pi {}", count / 15) : "";  // no shape upon shape
  switch (s.style) {
    case ChartSeries::Style::line:
    case ChartSeries::Style::dashed:
      return fmt::format("{}:3 with lines {} {} {}", rows, line, colour, title);
    case ChartSeries::Style::points:
      return fmt::format("{}:3 with points {} lw 1.5 {} {}", rows, points, colour, title);
    case ChartSeries::Style::line_points:
      return fmt::format("{}:3 with linespoints {} {}{} {} {}", rows, line, points, spread, colour, title);
    case ChartSeries::Style::band:
      return fmt::format("{}:($3-$4):($3+$4) with filledcurves fs transparent solid 0.2 noborder {} {}", rows,
                         colour, title);
  }
  return {};
}

std::string bars_of(const ChartSeries& s, const std::string& name, int reference) {
  const SeriesLook look = series_look(s.colour, reference);
  return fmt::format("data using (bar({})):3:4 with yerrorbars pt -1 lw 1.2 lc rgb '{}' notitle",
                     script_string(name), look.colour);
}

/// Bands behind all else, error bars behind the points of their series.
std::vector<std::string> plots(const Chart& chart) {
  const std::vector<std::string> names = series_names(chart);
  std::vector<std::string> bands, others;
  int references = 0;
  for (std::size_t k = 0; k < chart.series.size(); ++k) {
    const ChartSeries& s = chart.series[k];
    const int reference = s.colour < 0 ? references++ : 0;
    if (drawable_points(s).empty()) continue;
    const bool band = s.style == ChartSeries::Style::band;
    if (!band && has_error(s)) others.push_back(bars_of(s, names[k], reference));
    (band ? bands : others).push_back(plot_of(s, names[k], reference));
  }
  bands.insert(bands.end(), others.begin(), others.end());
  return bands;
}

}  // namespace

std::vector<std::size_t> drawable_points(const ChartSeries& series) {
  std::vector<std::size_t> points;
  for (std::size_t k = 0; k < series.x.size(); ++k)
    if (std::isfinite(series.x[k]) && std::isfinite(series.y[k])) points.push_back(k);
  return points;
}

std::vector<std::string> series_names(const Chart& chart) {
  std::vector<std::string> names;
  for (const ChartSeries& s : chart.series) {
    std::string name = gnuplot_field(plain_text(s.label));
    if (name.empty()) name = fmt::format("series {}", names.size() + 1);
    if (std::find(names.begin(), names.end(), name) != names.end())
      name += fmt::format(" ({})", names.size() + 1);
    names.push_back(name);
  }
  return names;
}

std::string chart_data(const Chart& chart) {
  const std::vector<std::string> names = series_names(chart);
  std::string out = "series,x,y,error\n";
  for (std::size_t i = 0; i < names.size(); ++i) {
    const ChartSeries& s = chart.series[i];
    for (const std::size_t k : drawable_points(s)) {
      const bool error = !s.error.empty() && std::isfinite(s.error[k]);
      out +=
          fmt::format("{},{},{},{}\n", names[i], s.x[k], s.y[k], error ? fmt::format("{}", s.error[k]) : "");
    }
  }
  return out;
}

std::string chart_script(const Chart& chart, const std::string& name) {
  const Span x = x_span(chart);
  const int height = picture_height(chart);
  std::string out = script_head(chart.title, name, height);
  out += functions;
  out += axis('x', chart.x_label, chart.x_range, chart.log_x, x);
  out += axis('y', chart.y_label, chart.y_range, chart.log_y, y_span(chart));
  out += key_lines(chart);
  out += title_and_marks(chart, x);
  std::string plot = "plot ";
  for (const std::string& part : plots(chart)) plot += (plot.size() > 5 ? ", \\\n     " : "") + part;
  return out + script_end(plot + "\n", height);
}

namespace {

constexpr std::size_t most_ticks = 14;

/// The values of an axis at their cells; only every so many where there are more than fit.
std::string ticks(char axis, const std::vector<double>& values) {
  const std::size_t stride = 1 + (values.size() - 1) / most_ticks;
  std::string out;
  for (std::size_t k = 0; k < values.size(); k += stride)
    out += fmt::format("{}'{:.4g}' {}", out.empty() ? "" : ", ", values[k], k);
  return fmt::format("set {0}tics ({1})\nset {0}range [-0.5:{2}.5]\n", axis, out, values.size() - 1);
}

AxisRange value_range(const HeatMap& map) {
  double low = std::numeric_limits<double>::infinity(), high = -low;
  for (const double v : map.value)
    if (std::isfinite(v)) low = std::min(low, v), high = std::max(high, v);
  low = map.value_range.min.value_or(low), high = map.value_range.max.value_or(high);
  if (low == high) low -= 0.5, high += 0.5;  // one colour needs an extent too
  return {low, high};
}

}  // namespace

std::string chart_data(const HeatMap& map) {
  std::string out = "column,row,x,y,value,text\n";
  for (std::size_t k = 0; k < map.value.size(); ++k) {
    if (!std::isfinite(map.value[k])) continue;
    const std::size_t column = k % map.x.size(), row = k / map.x.size();
    out += fmt::format("{},{},{},{},{},{}\n", column, row, map.x[column], map.y[row], map.value[k],
                       map.text.empty() ? "" : gnuplot_field(map.text[k]));
  }
  return out;
}

std::string chart_script(const HeatMap& map, const std::string& name) {
  const AxisRange range = value_range(map);
  std::string out = script_head(map.title, name, chart_height);
  out += fmt::format("set title {}\nset xlabel {}\nset ylabel {}\nset cblabel {} offset 1.5, 0\n",
                     script_string(map.title), script_string(map.x_label), script_string(map.y_label),
                     script_string(map.value_label));
  out += ticks('x', map.x) + ticks('y', map.y);
  out += fmt::format("set cbrange [{}:{}]\n", *range.min, *range.max);
  out += "set rmargin 12\nset tics scale 0.3\nunset grid\nset border 0\nset key off\nset colorbox noborder\n";
  // Cividis: reads the same with and without colour blindness, and in grey.
  out +=
      "set palette defined (0 '#00224e', 1 '#2a3f6d', 2 '#575d6d', 3 '#7d7c78', 4 '#a59c74', 5 '#d2c060', 6 "
      "'#fee838')\n";
  std::string plot = "plot data using 1:2:(0.51):(0.51):5 with boxxyerror fs solid noborder fc palette";
  if (!map.text.empty()) {
    out += fmt::format("ink(v) = v > {} ? 0x000000 : 0xffffff   # black upon light cells\n",
                       *range.min + 0.5 * (*range.max - *range.min));
    plot += ", \\\n     data using 1:2:6:(ink($5)) with labels noenhanced tc rgb variable font ',13'";
  }
  return out + script_end(plot + "\n", chart_height);
}

}  // namespace rift::studio

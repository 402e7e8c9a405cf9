#include "studio/charts/chart_script.hpp"
#include "studio/charts/label.hpp"
#include "studio/charts/point_texts.hpp"

#include <fmt/format.h>

namespace rift::studio {
namespace {

/// As for a chart, of the panel that is drawn.
constexpr std::string_view functions_of_panels =
    "here(s) = strcol('panel') eq panel && strcol(1) eq s\n"
    "of(s) = here(s) ? $2 : NaN                    # x in the rows of a series of this panel\n"
    "bar(s) = strcol(4) eq '' ? NaN : of(s)        # the same where the row has an error\n";

/// Labels that stand once for all panels, in the picture's own coordinates.
std::string outer_labels(const ChartGrid& grid, const GridLayout& layout, double above_key) {
  const double height = layout.height;
  const auto at = [&](double x, double y) {
    return fmt::format("screen {:.4f}, screen {:.4f}", x / chart_width, y / height);
  };
  const double centre = 0.5 * (layout.panels.front().left + layout.panels[layout.columns - 1].right);
  const double middle = 0.5 * (layout.panels.front().top + layout.panels.back().bottom);
  return fmt::format("  set label {} at {} center font ',16' tc rgb '#000000'\n", label_string(grid.title),
                     at(centre, height - 20)) +
         fmt::format("  set label {} at {} center\n", label_string(grid.x_label),
                     at(centre, above_key + 20)) +
         fmt::format("  set label {} at {} center rotate by 90\n", label_string(grid.y_label),
                     at(18, middle));
}

std::string panel_titles(const GridLayout& layout) {
  std::string out;
  for (std::size_t k = 0; k < layout.panels.size(); ++k) {
    const PlotArea& area = layout.panels[k];
    for (std::size_t line = 0; line < layout.titles[k].size(); ++line)
      out += fmt::format(
          "  set label {} at screen {:.4f}, screen {:.4f} left font ',{:g}' tc rgb '#222222'\n",
          label_string(layout.titles[k][line]), area.left / chart_width,
          (area.top + 8 + 16 * static_cast<double>(layout.titles[k].size() - 1 - line)) / layout.height,
          panel_title_px);
  }
  return out;
}

/// Ticks are labelled at the left and where no panel stands below.
std::string panel_lines(const ChartGrid& grid, const GridLayout& layout, std::size_t k,
                        const std::string& x_format, const std::string& y_format, const Span& x,
                        const Span& y) {
  const PlotArea& area = layout.panels[k];
  const auto columns = static_cast<std::size_t>(layout.columns);
  std::string out = fmt::format(
      "  set lmargin at screen {:.4f}; set rmargin at screen {:.4f}\n"
      "  set bmargin at screen {:.4f}; set tmargin at screen {:.4f}\n",
      area.left / chart_width, area.right / chart_width, area.bottom / layout.height,
      area.top / layout.height);
  out += fmt::format("  set format x '{}'; set format y '{}'\n",
                     k + columns < layout.panels.size() ? "" : x_format, k % columns == 0 ? y_format : "");
  const TextSpace space{.area = area, .x = x, .y = y, .log_x = grid.log_x, .log_y = grid.log_y};
  out += text_lines(placed_texts(grid.panels[k].series, space), space, layout.height);
  out += fmt::format("  panel = '{}'\n", k + 1);
  const std::vector<std::string> parts = plot_parts(grid.panels[k].series);
  out += parts.empty() ? std::string("  plot NaN notitle\n") : "  " + plot_line(parts);
  return out + "  unset label; unset arrow; unset object\n";
}

std::string tick_format(bool log, const Span& span) {
  return log && span.max * 1.25 > 100.0 * span.min / 1.25 ? "10^{%L}" : "%h";
}

}  // namespace

std::string chart_script(const ChartGrid& grid, const std::string& name) {
  const GridLayout layout = grid_layout(grid);
  const KeyLayout key = key_layout(grid);
  const Span x = x_span(grid), y = y_span(grid);
  // All panels have the same axes, whatever each of them holds.
  const Span x_ends = axis_ends(grid.x_range, x, grid.log_x), y_ends = axis_ends(grid.y_range, y, grid.log_y);
  std::string out = script_head(grid.title, name, layout.height);
  out += functions_of_panels;
  out += axis_lines('x', "", {x_ends.min, x_ends.max}, grid.log_x, x);
  out += axis_lines('y', "", {y_ends.min, y_ends.max}, grid.log_y, y);
  out += "set tics font ',12'\nunset title\n";
  out += "do for [picture in 'svg png'] {\n";
  out += "  if (picture eq 'png') { " + png_terminal(layout.height);
  out.back() = ';';
  out += " set output png }\n  set multiplot\n";
  out += outer_labels(grid, layout, key.height_px()) + panel_titles(layout);
  out += key_lines(key_entries(grid), key, layout.panels.front().left, key.height_px(), layout.height);
  for (std::size_t k = 0; k < layout.panels.size(); ++k)
    out +=
        panel_lines(grid, layout, k, tick_format(grid.log_x, x), tick_format(grid.log_y, y), x_ends, y_ends);
  return out + "  unset multiplot\n}\nset output\n";
}

}  // namespace rift::studio

#include "studio/report/chart_look.hpp"

#include "engine/base/text.hpp"
#include "studio/report/label.hpp"

#include <fmt/format.h>

#include <array>

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
  return plot + fmt::format(
                    "set terminal pngcairo size {},{} enhanced font 'sans-serif,14' fontscale 1.5 linewidth "
                    "2 dashlength 0.6 "
                    "pointscale 2.8 "
                    "background 'white'\nset output png\nreplot\nset output\n",
                    2 * chart_width, 2 * height);
}

}  // namespace rift::studio

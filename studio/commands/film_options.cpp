#include "studio/commands/film_options.hpp"

#include "viz/colour_map.hpp"

#include <CLI/CLI.hpp>
#include <fmt/format.h>

#include <algorithm>
#include <charconv>

namespace rift::studio {
namespace {

template <typename Rows>
std::vector<std::string> names_of(const Rows& rows) {
  std::vector<std::string> names;
  for (const auto& row : rows) names.emplace_back(row.name);
  return names;
}

/// Two numbers with one of `between` between them; false where the text is anything else.
template <typename Number>
bool read_two(const std::string& text, char between, Number& a, Number& b) {
  const char* end = text.data() + text.size();
  const auto first = std::from_chars(text.data(), end, a);
  if (first.ec != std::errc{} || first.ptr == end || *first.ptr != between) return false;
  const auto second = std::from_chars(first.ptr + 1, end, b);
  return second.ec == std::errc{} && second.ptr == end;
}

void read_size(FilmOptions& options, std::vector<std::string>& notes) {
  constexpr int least_width = 320, least_height = 180, most = 8192;
  int &width = options.wish.width, &height = options.wish.height;
  if (!read_two(options.size, 'x', width, height))
    throw viz::BadWish(
        fmt::format("--size {}: expected a width and a height in pixels such as 1280x720", options.size));
  if (width < least_width || height < least_height || width > most || height > most)
    throw viz::BadWish(fmt::format("--size {}: must lie between {}x{} and {}x{}", options.size, least_width,
                                   least_height, most, most));
  if (width % 2 == 0 && height % 2 == 0) return;
  width += width % 2;
  height += height % 2;
  notes.push_back(
      fmt::format("--size {}: drawn as {}x{}, for films need even numbers", options.size, width, height));
}

}  // namespace

void add_film_options(CLI::App& command, FilmOptions& options) {
  viz::Wish& wish = options.wish;
  const std::string group = "How it looks (what is not said is as the preset's [film] has it)";
  const auto add = [&](const char* name, auto& value, const char* text) {
    return command.add_option(name, value, text)->group(group);
  };
  add("--field", wish.field, "Field of the colours")->check(CLI::IsMember(names_of(viz::fields())));
  add("--colours", wish.colours, "Colour map")->check(CLI::IsMember(names_of(viz::colour_maps())));
  add("--range", options.range, "Ends of the colours in the shown unit, such as 0,2 (default: of all panes)");
  add("--camera", wish.camera,
      "plate: all of it; tip: a close-up that follows the tip; side: what leaves the plane")
      ->check(CLI::IsMember({"plate", "tip", "side"}));
  add("--beams", wish.beams, "Beams drawn: none, those on the crack's path, all")
      ->check(CLI::IsMember({"none", "crossing", "all"}));
  add("--magnification", wish.magnification, "Of the displacements")->check(CLI::Range(0.0, 1000.0));
  add("--close-up", wish.close_up_m, "Height of a close-up [m]")->check(CLI::Range(1e-6, 100.0));
  add("--title", wish.title, "Title over the picture");
  command.add_flag("--no-chart", options.no_chart, "No energy budget under the picture")->group(group);
  command.add_flag("--large-text", wish.large_text, "For lecture halls")->group(group);
  add("--size", options.size, "Width and height in pixels")->capture_default_str();
  add("--fps", options.fps, "Frames a second (default: a film of about 8 s)")->check(CLI::Range(0.1, 240.0));
  add("--gl", options.gl, "OpenGL: osmesa, egl, or auto for the first that works")
      ->check(CLI::IsMember({"auto", "osmesa", "egl"}))
      ->capture_default_str();
}

std::vector<std::string> read_wish(FilmOptions& options) {
  std::vector<std::string> notes;
  read_size(options, notes);
  if (options.no_chart) options.wish.chart = false;
  if (!options.range.empty()) {
    std::array<double, 2> range{};
    if (!read_two(options.range, ',', range[0], range[1]) || !(range[0] < range[1]))
      throw viz::BadWish(
          fmt::format("--range {}: expected two numbers that rise, such as 0,2", options.range));
    options.wish.range = range;
  }
  return notes;
}

viz::Gl gl_of(const FilmOptions& options) {
  return options.gl == "osmesa" ? viz::Gl::osmesa : options.gl == "egl" ? viz::Gl::egl : viz::Gl::any;
}

double rate_of(const FilmOptions& options, std::size_t frames) {
  constexpr double lasts_s = 8;
  return options.fps > 0 ? options.fps : std::clamp(static_cast<double>(frames) / lasts_s, 5.0, 30.0);
}

}  // namespace rift::studio

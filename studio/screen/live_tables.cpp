#include "studio/screen/live_parts.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>

namespace rift::studio {
namespace {

constexpr double millimetre = 1e-3;

double kinetic_of(const results::Sample& s) { return s.kinetic_translation_j + s.kinetic_rotation_j; }

constexpr std::array energies{
    EnergyEntry{"elastic", Ink::elastic, [](const results::Sample& s) { return s.elastic_j; }},
    EnergyEntry{"kinetic", Ink::kinetic, kinetic_of},
    EnergyEntry{"fracture", Ink::fracture, [](const results::Sample& s) { return s.fracture_j; }},
    EnergyEntry{"damping", Ink::damping,
                [](const results::Sample& s) { return s.damping_j + s.numerical_damping_j; }},
    EnergyEntry{"contact", Ink::damping, [](const results::Sample& s) { return s.contact_j; }, false},
    EnergyEntry{"external", Ink::reference, [](const results::Sample& s) { return s.work_external_j; }},
};

}  // namespace

std::span<const EnergyEntry> energy_entries() { return energies; }

double largest_energy(const LiveLane& lane) {
  double most = 0;
  for (const EnergyEntry& entry : energies)
    for (const results::Sample& s : lane.samples) most = std::max(most, std::abs(entry.value(s)));
  return most > 0 ? most : 1;
}

std::optional<RatioSoFar> ratio_so_far(const LiveLane& lane) {
  if (lane.samples.empty()) return std::nullopt;
  const double to = std::min(lane.samples.back().tip_m, lane.window[1]);
  if (!(to > lane.window[0])) return std::nullopt;
  const fracture::Plateau passed = fracture::plateau_of(lane.samples, {lane.window[0], to}, lane.scale);
  if (!passed.reached) return std::nullopt;
  return RatioSoFar{passed.mean.ratio, passed.scatter, to == lane.window[1]};
}

void draw_bar(Canvas& canvas, int x, int y, int width, double part, const Style& style, Glyphs glyphs) {
  const int eighths = static_cast<int>(std::lround(std::clamp(part, 0.0, 1.0) * width * 8));
  for (int k = 0; k < eighths / 8; ++k) canvas.put(x + k, y, glyphs == Glyphs::unicode ? U'█' : U'#', style);
  if (eighths % 8 > 0 && glyphs == Glyphs::unicode)
    canvas.put(x + eighths / 8, y, static_cast<char32_t>(U'█' + (8 - eighths % 8)), style);
}

void draw_balance(Canvas& canvas, const Area& area, const LiveLane& lane, double limit, Glyphs glyphs) {
  if (area.empty() || lane.samples.empty()) return;
  const results::Sample& last = lane.samples.back();
  const double most = largest_energy(lane);
  constexpr int names = 9, numbers = 11;
  const int end = area.y + area.height - 1;
  int y = area.y;
  for (const EnergyEntry& entry : energies) {
    if (y >= end) break;
    const double value = entry.value(last);
    if (!entry.always && value == 0.0) continue;
    canvas.text(area.x, y, entry.name, {entry.ink, true}, area.width);
    canvas.text(area.x + names, y, fmt::format("{:>9.4g} J", value), {}, area.width - names);
    draw_bar(canvas, area.x + names + numbers + 1, y, area.width - names - numbers - 1,
             std::abs(value) / most, {entry.ink}, glyphs);
    ++y;
  }
  const bool closes = std::abs(last.residual) <= limit;
  const int label =
      canvas.text(area.x, end, "balance error ", {closes ? Ink::good : Ink::bad, true}, area.width);
  canvas.text(area.x + label, end,
              fmt::format("{:.0e}{} {:.0e}", std::abs(last.residual), closes ? ", limit" : " ABOVE", limit),
              {closes ? Ink::plain : Ink::bad, !closes}, area.width - label);
}

namespace {

/// "0.566 +- 0.088": over the whole window as its summary has it, else over what has been passed of it.
std::string ratio_text(const LiveLane& lane, Glyphs glyphs) {
  const char* plus_minus = glyphs == Glyphs::unicode ? "±" : "+-";
  if (lane.ended && std::isnan(lane.ended->ratio))
    return ratio_so_far(lane).value_or(RatioSoFar{}).complete ? "none: steered in the window"
                                                              : "none: window not passed";
  if (lane.ended) return fmt::format("{:.3f} {} {:.3f}", lane.ended->ratio, plus_minus, lane.ended->scatter);
  const std::optional<RatioSoFar> passed = ratio_so_far(lane);
  if (!passed) return "-";
  return passed->complete ? fmt::format("{:.3f} {} {:.3f}", passed->mean, plus_minus, passed->scatter)
                          : fmt::format("{:.3f} so far", passed->mean);
}

std::string theory_text(const std::optional<double>& value) {
  return value ? fmt::format("{:.3f}", *value) : "-";
}

}  // namespace

void draw_result(Canvas& canvas, const Area& area, const LiveLane& lane, Glyphs glyphs) {
  struct Line {
    const char* label;
    std::string text;
    bool bold = false;
  };
  const std::string here = lane.rates.empty() ? "-"
                                              : fmt::format("{:.3f} at {:.1f} mm", lane.rates.back().ratio,
                                                            lane.rates.back().tip_m / millimetre);
  const std::array lines{
      Line{"G_ID/G_I0", ratio_text(lane, glyphs), true},
      Line{"at the tip", here},
      Line{"window", fmt::format("{:.4g} to {:.4g} mm; {} along it", lane.window[0] / millimetre,
                                 lane.window[1] / millimetre, glyphs == Glyphs::unicode ? "±" : "+-")},
      Line{"Broberg", theory_text(lane.broberg)},
      Line{"Freund", theory_text(lane.freund)},
      Line{"strip", theory_text(lane.strip)}};
  constexpr int labels = 12;
  for (int k = 0; k < std::min(area.height, static_cast<int>(lines.size())); ++k) {
    canvas.text(area.x, area.y + k, lines[k].label, {Ink::fracture, lines[k].bold}, area.width);
    canvas.text(area.x + labels, area.y + k, lines[k].text, {Ink::plain, lines[k].bold}, area.width - labels);
  }
}

namespace {

/// A column of the table of lanes: what it says of one.
struct LaneColumn {
  const char* name;
  int width;
  std::string (*text)(const LiveLane& lane);
};

std::string mean_of(const LiveLane& lane) {
  if (lane.ended) return std::isnan(lane.ended->ratio) ? "none" : fmt::format("{:.3f}", lane.ended->ratio);
  const std::optional<RatioSoFar> passed = ratio_so_far(lane);
  return passed ? fmt::format("{:.3f}", passed->mean) : "";
}

const LaneColumn columns[] = {
    {"tip mm", 8,
     [](const LiveLane& lane) {
       return lane.samples.empty() ? "" : fmt::format("{:.1f}", lane.samples.back().tip_m / millimetre);
     }},
    {"G/G0", 7,
     [](const LiveLane& lane) {
       return lane.rates.empty() ? "" : fmt::format("{:.3f}", lane.rates.back().ratio);
     }},
    {"mean", 7, mean_of},
    {"kinetic J", 11,
     [](const LiveLane& lane) {
       return lane.samples.empty() ? "" : fmt::format("{:.3g}", kinetic_of(lane.samples.back()));
     }},
    {"fracture J", 11,
     [](const LiveLane& lane) {
       return lane.samples.empty() ? "" : fmt::format("{:.3g}", lane.samples.back().fracture_j);
     }},
    {"bal. error", 11,
     [](const LiveLane& lane) {
       return lane.samples.empty() ? "" : fmt::format("{:.0e}", std::abs(lane.samples.back().residual));
     }},
};

/// How many letters of the titles it takes to tell them apart.
int letters_that_tell_apart(const std::vector<LiveLane>& lanes) {
  std::vector<std::u32string> titles;
  for (const LiveLane& lane : lanes) titles.push_back(letters_of(lane.title));
  std::ranges::sort(titles);
  std::ptrdiff_t needed = 0;
  for (std::size_t k = 1; k < titles.size(); ++k) {
    const auto common = std::ranges::mismatch(titles[k - 1], titles[k]).in2 - titles[k].begin();
    needed = std::max(needed, common + 1);
  }
  return static_cast<int>(needed);
}

}  // namespace

void draw_lanes(Canvas& canvas, const Area& area, const Live& live, const LiveLook& look) {
  if (area.empty()) return;
  int title = area.width, shown = 0;  // as many columns as leave room for the title
  const int number = static_cast<int>(std::to_string(live.lanes.size()).size()) + 1;
  const int needed = std::max(20, number + letters_that_tell_apart(live.lanes) + 1);
  for (const LaneColumn& column : columns) {
    if (title - column.width < needed && shown > 0) break;
    title -= column.width, ++shown;
  }
  const auto line = [&](int y, const std::string& name, const Style& style, auto&& text_of) {
    std::u32string padded = letters_of(name).substr(0, title);
    padded.resize(title, U' ');
    for (int x = 0; x < title; ++x) canvas.put(area.x + x, y, padded[x], style);
    int x = area.x + title;
    for (int c = 0; c < shown; ++c) {
      canvas.text(x, y, fmt::format("{:>{}}", text_of(columns[c]), columns[c].width), style,
                  columns[c].width);
      x += columns[c].width;
    }
  };
  line(area.y, "lane", {Ink::dim}, [](const LaneColumn& column) { return std::string(column.name); });
  for (int k = 0; k < static_cast<int>(live.lanes.size()) && k + 1 < area.height; ++k) {
    Style style{k == look.beside ? Ink::elastic : Ink::plain};
    style.reverse = k == look.shown;
    line(area.y + 1 + k, fmt::format("{} {}", k + 1, live.lanes[k].title), style,
         [&](const LaneColumn& column) { return column.text(live.lanes[k]); });
  }
}

}  // namespace rift::studio

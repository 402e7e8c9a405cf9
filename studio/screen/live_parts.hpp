#pragma once

#include "studio/screen/live.hpp"

#include <span>

namespace rift::studio {

// The parts of the screen of a run; an empty area draws nothing.

/// A bar of full blocks and one of eighths   [Unicode 15, block elements].
void draw_bar(Canvas& canvas, int x, int y, int width, double part, const Style& style, Glyphs glyphs);

/// An entry of the energy balance: its name, colour and value.
struct EnergyEntry {
  const char* name;
  Ink ink;
  double (*value)(const results::Sample&);
  bool always = true;  // else only where there is any
};
[[nodiscard]] std::span<const EnergyEntry> energy_entries();

/// The largest of all entries so far, 1 where there is none [J].
[[nodiscard]] double largest_energy(const LiveLane& lane);

/// The mean ratio over the part of the window that the tip has passed; none before.
struct RatioSoFar {
  double mean = 0, scatter = 0;
  bool complete = false;  // the whole window
};
[[nodiscard]] std::optional<RatioSoFar> ratio_so_far(const LiveLane& lane);

/// The entries as bars, and in the last line whether the balance closes.
void draw_balance(Canvas& canvas, const Area& area, const LiveLane& lane, double limit, Glyphs glyphs);
/// The ratio of one lane beside the theory.
void draw_result(Canvas& canvas, const Area& area, const LiveLane& lane, Glyphs glyphs);
/// A line per lane.
void draw_lanes(Canvas& canvas, const Area& area, const Live& live, const LiveLook& look);
void draw_energies(Canvas& canvas, const Area& area, const LiveLane& lane, Glyphs glyphs);
void draw_rates(Canvas& canvas, const Area& area, const Live& live, const LiveLook& look, Glyphs glyphs);

}  // namespace rift::studio

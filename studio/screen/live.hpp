#pragma once

#include "engine/results/schema.hpp"
#include "studio/screen/canvas.hpp"

#include <array>
#include <optional>
#include <string>
#include <vector>

/// The screen of a run that goes on, or went.
namespace rift::studio {

/// What is known of one lane.
struct LiveLane {
  std::string title;                               // "simple release, 0.1 c_r"
  std::vector<results::Sample> books;              // of the crack, in time
  std::vector<results::RatePoint> rates;           // against tip position
  std::optional<double> broberg, strip;            // to compare with
  std::vector<std::array<float, 3>> displacement;  // of the last frame; may be empty
  std::vector<std::array<double, 2>> tips;         // of that frame [m]
};

/// All that the screen shows.
struct Live {
  std::string name;          // of the run
  std::string state;         // "running", "finished", "damaged at byte ..."
  double done = 0;           // [0, 1]
  double seconds_left = -1;  // negative: not known
  double steps_per_s = 0;
  std::int64_t step = 0, steps = 0;
  const results::Geometry* geometry = nullptr;
  double length = 0, height = 0, pulled = 0;  // of the plate [m]
  double ledger_limit = 1e-9;                 // residuals beyond are told
  std::vector<LiveLane> lanes;
};

/// Where the parts of the screen are; empty ones have no room.
struct LiveLayout {
  Area head, plate, budget, energies, rates, table, foot;
};

/// Pure arithmetic for any size. @param lanes  of the run
[[nodiscard]] LiveLayout live_layout(int width, int height, int lanes);

/// The least size on which it makes sense.
inline constexpr int least_width = 60, least_height = 16;

/// Draws the screen. @param shown  the lane that plate, bars and curves are of;  @param keys  what the foot
/// says
void draw_live(Canvas& canvas, const Live& live, int shown, std::string_view keys, Glyphs glyphs);

}  // namespace rift::studio

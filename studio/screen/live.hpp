#pragma once

#include "engine/fracture/release_rate.hpp"
#include "engine/results/schema.hpp"
#include "studio/screen/canvas.hpp"

#include <array>
#include <optional>
#include <string>
#include <vector>

namespace rift::studio {

// The screen of a run that goes on, or went.

/// What is known of one lane.
struct LiveLane {
  std::string title;                      // "simple release, 0.1 c_r"
  fracture::RateScale scale;              // of its release rate
  std::vector<results::Sample> samples;   // of the crack, in time
  std::vector<results::RatePoint> rates;  // against tip position
  std::array<double, 2> window{};         // in which the ratio is measured [m]
  struct Ratio {
    double ratio, scatter;  // NaN: none
  };
  std::optional<Ratio> ended;                                // of its summary, once there is one
  std::optional<double> broberg, freund, strip;              // to compare with
  std::vector<std::array<float, 3>> displacement, velocity;  // of the last frame; may be empty
  std::vector<std::array<double, 2>> tips;                   // of that frame [m]
};

/// All that the screen shows.
struct Live {
  std::string name;          // of the run
  std::string state;         // "running", "finished", "damaged at byte ..."
  std::string message;       // the last thing to be said
  double done = 0;           // [0, 1]
  double seconds_left = -1;  // negative: not known
  double steps_per_s = 0;
  std::int64_t step = 0, steps = 0;
  const results::Geometry* geometry = nullptr;
  double length = 0, height = 0, pulled = 0;  // of the plate [m]
  double fastest = 0;                         // that colours of the velocity tell apart [m/s]
  double ledger_limit = 1e-9;                 // residuals beyond are marked
  std::vector<LiveLane> lanes;
};

/// What of it is shown.
struct LiveLook {
  int shown = 0;          // the lane that plate, bars and curves are of
  int beside = -1;        // a second one, or none
  bool velocity = false;  // the plates' colours are of the vertical velocity, not of the displacement
  bool picture = false;   // a picture is shown where the plates are
  std::string_view foot;  // the last line
};

/// Where the parts of the screen are; empty ones have no room.
struct LiveLayout {
  Area head, plate, plate_beside, colours, balance, result, table, energies, rates, message, foot;
};

/// Pure arithmetic for any size. @param lanes  of the run: of one there is a result, of several a table;
/// @param two  plates beside each other; @param aspect  length over height of a plate
[[nodiscard]] LiveLayout live_layout(int width, int height, int lanes, bool two, double aspect);

/// The layout of this screen, and where its plates are below their titles, one beside the other.
[[nodiscard]] LiveLayout layout_of(const Live& live, const LiveLook& look, int width, int height);
[[nodiscard]] Area place_of_plates(const Live& live, const LiveLook& look, int width, int height);

/// Draws the screen.
void draw_live(Canvas& canvas, const Live& live, const LiveLook& look, Glyphs glyphs);

}  // namespace rift::studio

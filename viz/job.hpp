#pragma once

#include <array>
#include <cstdint>
#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

/// What is to be drawn, as plain data: the order that the program gives to the renderer, a process of its
/// own.
namespace rift::viz {

/// From where the plate is seen.
enum class Camera : std::uint8_t {
  plate,  // the whole plate from its front
  tip,    // a close-up that follows the tip
  side,   // along the crack's plane, from below: what moves out of the plate's plane
  free,   // as a View says
};

/// Which beams are drawn.
enum class Beams : std::uint8_t { none, crossing, all };

/// What stands under the picture.
enum class Chart : std::uint8_t {
  none,
  growing,  // the energy budget up to the moment: for films
  whole,    // the energy budget and G_ID/G_I0 of the run as far as it is stored, the moment as a line
};

/// A camera by numbers: which point of the plate's plane is in the middle, how much is shown, and from where.
struct View {
  double x = 0, y = 0;        // the point [m]
  double height = 0;          // of what is shown [m]
  double turn = 0, tilt = 0;  // about the vertical and then about the horizontal axis of the picture [rad]
  bool operator==(const View&) const = default;
};

/// One lane of one run, in a place of its own in the frame.
struct Pane {
  std::filesystem::path run;
  std::int32_t lane = 0;
  std::string title;
};

struct Look {
  std::string field = "uy";       // a name of viz/field.hpp
  std::array<double, 2> range{};  // of the colours, in the field's SI unit; the same for all panes
  bool range_of_moment = false;   // each moment has the range of its own values instead
  std::string colours;            // a name of viz/field.hpp
  Camera camera = Camera::plate;
  View view{};  // of the free camera
  Beams beams = Beams::none;
  bool spheres = true;       // elements; false leaves the beams alone
  double magnification = 1;  // of displacements
  double close_up_m = 0.02;  // height of what a close-up shows [m]
  Chart chart = Chart::growing;
  bool boundaries = false;   // grips, free faces and measures drawn around the plate
  bool texts = true;         // titles, colour bars and scales; without them the plates have the whole frame
  bool large_text = false;   // for lecture halls
  std::string title;
  std::string scheme;  // what all panes have in common: "linear relaxation, damage zone 1 R, no damping"
};

/// Frames of up to four panes on one clock. The renderer reads it as the first line of its input, then a time
/// [s] a line, and answers each time with one frame: width · height · 3 bytes, RGB, rows from the top. At a
/// time each pane shows its last stored moment until then. (viz/order.hpp has the other way to ask.)
struct Job {
  std::vector<Pane> panes;
  Look look;
  int width = 1280, height = 720;
};

/// The value of a word as presets and options have it ("plate", "crossing"). Throws std::invalid_argument.
[[nodiscard]] Camera camera_named(const std::string& word);
[[nodiscard]] Beams beams_named(const std::string& word);
[[nodiscard]] Chart chart_named(const std::string& word);
/// And back.
[[nodiscard]] std::string word_of(Camera camera);
[[nodiscard]] std::string word_of(Beams beams);
[[nodiscard]] std::string word_of(Chart chart);

/// As JSON text of one line and back. Throws std::invalid_argument where the text is no job.
[[nodiscard]] std::string to_json(const Job& job);
[[nodiscard]] Job job_from_json(std::string_view text);

}  // namespace rift::viz

#pragma once

#include "engine/results/schema.hpp"
#include "viz/job.hpp"
#include "viz/layout.hpp"

#include <array>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <optional>
#include <string>
#include <string_view>
#include <type_traits>

/// How a drawing program is asked when it serves: an order is a line of JSON on its input, the answer lies in
/// the memory that both share, and one byte on its output says that it is there.
namespace rift::viz {

/// One picture, and what is to be said of it.
struct Order {
  Job job;
  double time_s = 0;                           // since the crack's start
  std::optional<std::array<double, 2>> asked;  // pixel from the lower left corner: what is there?
};

/// What is at a pixel. Numbers of which the run stores nothing are NaN.
struct Picked {
  enum class Kind : std::int32_t { nothing, element, beam } kind = Kind::nothing;
  std::int32_t pane = -1;                            // in whose picture the pixel lies, or none
  std::int32_t index = -1, first = -1, second = -1;  // the element or beam; a beam's elements
  std::array<double, 3> position_m{};                // unloaded; of a beam its middle
  std::array<double, 3> displacement_m{}, velocity_m_s{};
  double elastic_j = 0, damage = 0;
  double released_s = std::numeric_limits<double>::quiet_NaN();  // of a beam, since the crack's start
  results::GaugeRow gauge{.gauge = -1};                          // the nearest one at this moment; -1 where the run has none
};

/// One lane of the picture.
struct PaneAnswer {
  Box picture;
  Window window;
  double since_start_s = 0, tip_m = 0, velocity_m_s = 0;
  bool is_last = false;
};

inline constexpr std::size_t most_panes = 4;

/// Plain data at the beginning of the shared memory; the picture's bytes begin at `pixels_at`: width · height
/// · 3, RGB, rows from the top.
struct Answer {
  std::int32_t width = 0, height = 0, panes = 0;
  std::array<double, 2> range{};  // of the colours [SI]
  double seconds = 0;             // that it took
  std::array<PaneAnswer, most_panes> pane{};
  Picked picked;
};
inline constexpr std::size_t pixels_at = 4096;
static_assert(std::is_trivially_copyable_v<Answer> && sizeof(Answer) <= pixels_at);

/// The shared memory that a frame of this size needs.
[[nodiscard]] constexpr std::size_t bytes_for(int width, int height) {
  return pixels_at + std::size_t{3} * static_cast<std::size_t>(width) * static_cast<std::size_t>(height);
}

/// As JSON text of one line and back. Throws std::invalid_argument where the text is no order.
[[nodiscard]] std::string to_json(const Order& order);
[[nodiscard]] Order order_from_json(std::string_view text);

/// What the program is started with to serve, and the descriptor of the shared memory.
inline constexpr const char* serve_option = "--serve";
inline constexpr int shared_descriptor = 3;

}  // namespace rift::viz

#include "engine/history/crack_history.hpp"
#include "engine/scene/crack_text.hpp"
#include "tests/fuzz/bytes.hpp"

#include <cmath>
#include <cstdlib>

// A text of [crack] velocity. What can be read is written back to the same pieces, and its history never goes
// backward and arrives where it says.
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace rift;
  const std::string_view text = fuzz::bytes_of(data, size).left;
  (void)read_path(text);
  (void)read_relaxation(text);
  const auto velocity = read_velocity(text);
  if (!velocity.value) return velocity.problem.empty() ? (std::abort(), 0) : 0;
  if (read_velocity(velocity_text(*velocity.value)).value != velocity.value) std::abort();

  std::vector<SpeedUntil> pieces;
  for (const VelocityPiece& piece : *velocity.value)
    pieces.push_back({piece.speed.value, piece.until.value_or(0.0)});
  const CrackHistory history = history_of(0.0, pieces);
  double before = 0.0;
  for (const CrackStretch& stretch : history.stretch) {
    const double tip = tip_at(history, stretch.time);
    if (!(tip >= before)) std::abort();
    if (!(time_of_arrival(history, tip) <= stretch.time * (1.0 + 1e-9))) std::abort();
    before = tip;
  }
  return 0;
}

#include "engine/history/crack_history.hpp"
#include "engine/scene/contradictions_rows.hpp"
#include "engine/scene/crack_text.hpp"
#include "engine/scene/csv_table.hpp"
#include "engine/scene/preset.hpp"
#include "tests/fuzz/bytes.hpp"

#include <array>
#include <cmath>
#include <cstdlib>

namespace {

/// A text of measured rows. What has no issue becomes a course that never goes backward.
void measured(std::string_view text) {
  using namespace rift;
  constexpr std::array columns{CsvColumn{"time", Dimension::time}, CsvColumn{"position", Dimension::length},
                               CsvColumn{"uncertainty", Dimension::length, CsvNeed::optional}};
  const CsvTable table = read_csv(text, columns);
  if (!table.problems.empty() || table.line.empty()) return;
  Preset preset;
  preset.scene = read_preset_text("", "fuzz").scene;
  for (std::size_t k = 0; k < table.line.size(); ++k)
    preset.scene.crack.history.push_back(
        {table.column[0][k], table.column[1][k], table.column[2].empty() ? 0.0 : table.column[2][k]});
  preset.scene.crack.start = preset.scene.crack.history.front().position;
  for (const Smoothing smoothing : {Smoothing::monotone, Smoothing::none}) {
    preset.scene.crack.smoothing = smoothing;
    if (!history_issues(preset).empty()) continue;
    const Course course = course_of(preset.scene.crack.history, preset.scene.crack.start, smoothing);
    for (const CrackStretch& s : course.history.stretch)
      if (!(s.speed >= 0.0) || !std::isfinite(s.position)) std::abort();
  }
}

}  // namespace

// A text of [crack] velocity, or the rows of a measured history. What can be read is written back to the same
// pieces, and its history never goes backward and arrives where it says.
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace rift;
  const std::string_view text = fuzz::bytes_of(data, size).left;
  measured(text);
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

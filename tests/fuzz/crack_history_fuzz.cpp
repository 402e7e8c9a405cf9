#include "engine/history/crack_history.hpp"
#include "engine/scene/csv_table.hpp"
#include "engine/scene/preset.hpp"
#include "engine/scene/rows_text.hpp"
#include "engine/scene/validation.hpp"
#include "tests/fuzz/bytes.hpp"

#include <array>
#include <cmath>
#include <cstdlib>

namespace {

/// A text of measured rows. What has no issue becomes a course that never goes backward.
void measured(std::string_view text) {
  using namespace rift;
  constexpr std::array columns{
      scene::CsvColumn{"time", scene::Dimension::time},
      scene::CsvColumn{"position", scene::Dimension::length},
      scene::CsvColumn{"uncertainty", scene::Dimension::length, scene::CsvNeed::optional}};
  const scene::CsvTable table = scene::read_csv(text, columns);
  if (!table.problems.empty() || table.line.empty()) return;
  scene::Preset preset;
  preset.scene = scene::read_preset_text("", "fuzz").scene;
  for (std::size_t k = 0; k < table.line.size(); ++k)
    preset.scene.crack.history.push_back(
        {table.column[0][k], table.column[1][k], table.column[2].empty() ? 0.0 : table.column[2][k]});
  preset.scene.crack.start = preset.scene.crack.history.front().position;
  for (const history::Smoothing smoothing : {history::Smoothing::monotone, history::Smoothing::none}) {
    preset.scene.crack.smoothing = smoothing;
    if (!scene::history_issues(preset).empty()) continue;
    const history::SmoothedHistory course =
        history::smoothed_history(preset.scene.crack.history, preset.scene.crack.start, smoothing);
    for (const history::CrackStretch& s : course.history.stretch)
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
  (void)scene::read_path(text);
  (void)scene::read_relaxation(text);
  const auto velocity = scene::read_velocity(text);
  if (!velocity.value) return velocity.problem.empty() ? (std::abort(), 0) : 0;
  if (scene::read_velocity(scene::velocity_text(*velocity.value)).value != velocity.value) std::abort();

  std::vector<history::SpeedUntil> pieces;
  for (const scene::VelocityPiece& piece : *velocity.value)
    pieces.push_back({piece.speed.value, piece.until.value_or(0.0)});
  const history::CrackHistory history = history::history_of(0.0, pieces);
  double before = 0.0;
  for (const history::CrackStretch& stretch : history.stretch) {
    const double tip = history::tip_at(history, stretch.time);
    if (!(tip >= before)) std::abort();
    if (!(history::time_of_arrival(history, tip) <= stretch.time * (1.0 + 1e-9))) std::abort();
    before = tip;
  }
  return 0;
}

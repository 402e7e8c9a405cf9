#pragma once

#include "engine/results/archive.hpp"
#include "engine/results/journal.hpp"
#include "engine/results/run_folder.hpp"
#include "engine/results/schema.hpp"
#include "tests/temporary_folder.hpp"

#include <cstdint>
#include <string>
#include <vector>

/// A run small enough to check by hand: 4 elements in a chain of 3 beams, of which the path crosses the last
/// two.
namespace rift::results::small_run {

inline Geometry geometry() {
  return {{{0, 0, 0}, {1, 0, 0}, {2, 0, 0}, {3, 0.5F, 0.25F}},
          {0.5F, 0.4F, 0.3F, 0.2F},
          {{0, 1}, {1, 2}, {2, 3}},
          {1, 2}};
}

inline Sample sample(std::int64_t step, std::int32_t lane, double tip_m) {
  return {step,
          1e-8 * static_cast<double>(step),
          Phase::fracture,
          lane,
          tip_m,
          1100.1,
          0.1 + 0.2,
          1.0 / 3,
          2e-300,
          -3e-9,
          0.25,
          0.125,
          0.0625,
          1e22,
          5e-12};
}

/// All fields, with values that tell step, lane and place apart.
inline Frame frame(std::int64_t step, std::int32_t lane) {
  Frame frame{step, 1e-6 * static_cast<double>(step), lane, 0.1, {}, {}, {}, {}, {}};
  for (int i = 0; i < 4; ++i) {
    const auto base = static_cast<float>(step) * 100 + static_cast<float>(lane) * 10 + static_cast<float>(i);
    frame.displacement.push_back({base, base + 0.25F, base + 0.5F});
    frame.velocity.push_back({-base, 0, 1});
  }
  frame.elastic_energy = {0.5F, 0.25F * static_cast<float>(step), 0, 1e-6F};
  frame.damage_factor = {1, 0.5F};
  if (step > 0) frame.damage_factor = {0.25F, 0};
  return frame;
}

/// A run's journal that holds these records.
inline void write_journal(const std::filesystem::path& folder, const std::vector<Record>& records) {
  JournalWriter writer(folder / journal_name);
  for (const Record& record : records) writer.write(record);
  writer.close();
}

}  // namespace rift::results::small_run
